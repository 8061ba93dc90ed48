// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the built-in lessons (assets/lessons).
#include <array>

#include "ui/core_sentences.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr std::array sentences_built_in_lessons{
    Words::id("First steps"),
    Words::id("Look around"),
    Words::id("Gentle pull"),
    Words::id("Probe a branch free"),
    Words::id("Selective injection"),
    Words::id("Hold a bleeding vessel"),
    Words::id("The cut line"),
    Words::id("Embolization"),
    Words::id("Find three places with the tip of a probe, one after the other, without pushing the "
              "vessels, and stay at each for half a second. The mouse leads the tip across the "
              "picture, the wheel in depth. Turning the view helps to judge the depth, but is not "
              "scored: a recording holds what is done to the patient, not where somebody looks."),
    Words::id("Take the probe and bring its tip near the first mark."),
    Words::id("Key 4 takes the probe. The mouse leads it, the wheel moves it in depth; a click "
              "brings it nowhere here. The picture says how far it is to the mark and which way. "
              "Look from the side (L) to judge the depth."),
    Words::id("Now near the second mark, around the vessels between."),
    Words::id("Move the probe towards you with the wheel first."),
    Words::id("And near the third."),
    Words::id("the first mark"),
    Words::id("the second mark"),
    Words::id("the third mark"),
    Words::id("the mark"),
    Words::id("the branch"),
    Words::id("the target's vessel"),
    Words::id("the stump"),
    Words::id("the line"),
    Words::id("the hold"),
    Words::id("Pull a vessel aside, hold it there, and let it go. Veins bear little: stay below a "
              "stretch of 1.25, and do not jerk: 2000 mN end it."),
    Words::id("Take hold of the vessel at the mark."),
    Words::id("Press the left mouse button on the vessel and keep it down."),
    Words::id("Pull it 8 mm aside and hold it there for a second."),
    Words::id(
        "Move slowly: what is stretched pulls back, in one direction more than in another. If the "
        "stretch is too large too soon, begin again and pull another way. The number at the "
        "held point shows the force."),
    Words::id("Let go and wait until it has swung back."),
    Words::id("Release the button."),
    Words::id(
        "Lift a branch with a rod so that a way opens behind it, and leave it whole. The tissue "
        "around is springs: it gives way and pulls back, but nothing is glued to the branch."),
    Words::id("Touch the marked branch with the rod."),
    Words::id("Key 5 takes the rod; T turns it."),
    Words::id("Move the branch by 4 mm and keep it there for half a second."),
    Words::id("Push across the branch, not along it."),
    Words::id("Take the rod away and let the branch come back."),
    Words::id("Draw back the way you came; Esc puts the tool away."),
    Words::id("Bring 3 g of drug into the left territory and as little as possible elsewhere. The "
              "tip lies free in the vessel: what it injects also runs back, the more the nearer it "
              "is to the root."),
    Words::id("Inject so that 3 g reach the target's tissue."),
    Words::id("Far beyond the mark: point at a vessel to see what lies downstream of it. A double "
              "click injects there; after key 2, one click does."),
    Words::id("A branch was cut and bleeds. Press on its stump with the probe, then take it with "
              "the forceps: where a tool presses harder than the blood does, the vessel narrows "
              "and bleeds less. Scored is how soon and how gently you stem it."),
    Words::id("Press on the stump with the probe until it bleeds less than the goal says, for half "
              "a second."),
    Words::id(
        "Key 4 takes the probe. Come from the side of the root, and press some millimetres in."),
    Words::id("Take the stump with the forceps until it bleeds less than the goal says, for half a "
              "second."),
    Words::id("Key 6 takes the forceps; they come in front of the vessels. Push them away from you "
              "with the wheel until the picture says that the mark is between the jaws, then C "
              "closes them. Limited is the force with which a tool pushes or pulls the vessels, "
              "not the grip between the jaws."),
    Words::id("Draw a cut line across a branch and pull it off along the line. Without the line "
              "the pull would stretch the branch long before it tears."),
    Words::id("Draw a cut line across the branch at the first mark, take the branch at the second "
              "and pull until it comes off."),
    Words::id("Key 9 draws cut lines; key 1 pulls again. \"Along a line\" in the panel Tool is "
              "what the line leaves of the strength: 0.05, unless you changed it."),
    Words::id("Fill the target's vessels with an emulsion of lipiodol and stop before it runs back "
              "into the others. A pump drives the emulsion; where the pump stops, the emulsion "
              "stays. You see by the filled target when it is enough."),
    Words::id("Lower the flow in the panel Injection, then inject the emulsion until nine tenths "
              "of the target are full."),
    Words::id("A little beyond the mark, slowly: a flow of 0.5 g/s, which is about 25 mL/min. At "
              "2 g/s the emulsion runs back within seconds."),
    Words::id("Stop the pump (Space) and leave the emulsion in the target."),
    Words::id("Pause in the panel Injection stops the pump too. Del would take the emulsion out "
              "again, and the target would be empty."),
};

}  // namespace

std::span<const char* const> sentences_of_built_in_lessons() {
    return sentences_built_in_lessons;
}

}  // namespace hepatica

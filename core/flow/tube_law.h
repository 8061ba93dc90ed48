// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a vessel's lumen is left where something presses on it from outside: the tube law of
// thin walls, p_outside - p_inside = K (a^-3/2 - a^10) for the share a of the area, with
// K = E (h/R)^3 / (12 (1 - nu^2)), what the wall resists being bent with (Shapiro 1977; exponents
// of veins as in Brook, Falle and Pedley 1999).
#pragma once

namespace hepatica {

struct TubeWall {
    double young_modulus_pa = 0.62e6;  // > 0
    // Of a portal vein about 0.6 mm at a radius of 5.5 mm; a guess for others.
    double thickness_per_radius = 0.1;  // > 0
    double poisson_ratio = 0.5;
};

// In (0, 1]: 1 where nothing presses harder than the blood does. `excess_pa`: the pressure outside
// less that of the blood. No vessel closes wholly; the share falls as excess^-2/3.
double open_share(double excess_pa, const TubeWall& wall);

// The loss of a jet that comes out of an opening of this share and fills the vessel again, as a
// share of the dynamic pressure in the opening: (1/c - a)^2 by Borda and Carnot, with Weisbach's
// contraction c = 0.62 + 0.38 a^3 before it. 0 at a = 1.
double jet_loss(double share);

}  // namespace hepatica

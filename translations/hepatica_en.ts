<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Words</name>
    <message numerus="yes">
        <source>&lt;b&gt;%1&lt;/b&gt;: %n attempt(s). Tick those of an instructor: they are the band in the learning curve.</source>
        <translation>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;: %n attempt. Tick those of an instructor: they are the band in the learning curve.</numerusform>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;: %n attempts. Tick those of an instructor: they are the band in the learning curve.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n branch(es)</source>
        <translation>
            <numerusform>%n branch</numerusform>
            <numerusform>%n branches</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n gap(s) were bridged by the reconstruction, %L1 mm in all.</source>
        <translation>
            <numerusform>%n gap was bridged by the reconstruction, %L1 mm in all.</numerusform>
            <numerusform>%n gaps were bridged by the reconstruction, %L1 mm in all.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) at lessons, %1 passed; the last: %2, %3</source>
        <translation>
            <numerusform>%n attempt at lessons, %1 passed; the last: %2, %3</numerusform>
            <numerusform>%n attempts at lessons, %1 passed; the last: %2, %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %L2 mm, %n root(s)</source>
        <translation>
            <numerusform>%1: %L2 mm, %n root</numerusform>
            <numerusform>%1: %L2 mm, %n roots</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, and %n more</source>
        <translation>
            <numerusform>, and %n more</numerusform>
            <numerusform>, and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more under All messages.</source>
        <translation>
            <numerusform>%n more under All messages.</numerusform>
            <numerusform>%n more under All messages.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) at the vessels of %1 are not made into vessels yet.</source>
        <translation>
            <numerusform>%n stroke at the vessels of %1 is not made into vessels yet.</numerusform>
            <numerusform>%n strokes at the vessels of %1 are not made into vessels yet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(%n pass mark(s))</source>
        <translation>
            <numerusform>(%n pass mark)</numerusform>
            <numerusform>(%n pass marks)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es) of the solver a step</source>
        <translation>
            <numerusform>%n pass of the solver a step</numerusform>
            <numerusform>%n passes of the solver a step</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Vessels rebuilt with %n stroke(s)</source>
        <translation>
            <numerusform>Vessels rebuilt with %n stroke</numerusform>
            <numerusform>Vessels rebuilt with %n strokes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) for this patient fit his vessels no more:</source>
        <translation>
            <numerusform>%n lesson for this patient fits his vessels no more:</numerusform>
            <numerusform>%n lessons for this patient fit his vessels no more:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n measurement(s) removed.</source>
        <translation>
            <numerusform>%n measurement removed.</numerusform>
            <numerusform>%n measurements removed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n diameter(s) are not shown any more: the vessel that they were measured on is gone. Where it comes back, as by Undo, they do.</source>
        <translation>
            <numerusform>%n diameter is not shown any more: the vessel that it was measured on is gone. Where it comes back, as by Undo, so does the diameter.</numerusform>
            <numerusform>%n diameters are not shown any more: the vessels that they were measured on are gone. Where they come back, as by Undo, so do the diameters.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Saved: %1. It holds the case and %n lesson(s) for this patient, not the CT.</source>
        <translation>
            <numerusform>Saved: %1. It holds the case and %n lesson for this patient, not the CT.</numerusform>
            <numerusform>Saved: %1. It holds the case and %n lessons for this patient, not the CT.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) for this patient came with the case and lie beside it: %1</source>
        <translation>
            <numerusform>%n lesson for this patient came with the case and lies beside it: %1</numerusform>
            <numerusform>%n lessons for this patient came with the case and lie beside it: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) for this patient are in his file: %1. To play them, take the case into the library.</source>
        <translation>
            <numerusform>%n lesson for this patient is in his file: %1. To play it, take the case into the library.</numerusform>
            <numerusform>%n lessons for this patient are in his file: %1. To play them, take the case into the library.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) for this patient are in his file: %1. To play them, take them out: they then lie beside it in the library.</source>
        <translation>
            <numerusform>%n lesson for this patient is in his file: %1. To play it, take it out: it then lies beside it in the library.</numerusform>
            <numerusform>%n lessons for this patient are in his file: %1. To play them, take them out: they then lie beside it in the library.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n gap(s) and doubtful branch(es) taken</source>
        <translation>
            <numerusform>%n gap or doubtful branch taken</numerusform>
            <numerusform>%n gaps and doubtful branches taken</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n correction(s) taken back; Redo makes them again</source>
        <translation>
            <numerusform>%n correction taken back; Redo makes it again</numerusform>
            <numerusform>%n corrections taken back; Redo makes them again</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n correction(s) taken back; Redo makes them again. The Undo before them goes on: Cancel once more ends it, too</source>
        <translation>
            <numerusform>%n correction taken back; Redo makes it again. The Undo before it goes on: Cancel once more ends it, too</numerusform>
            <numerusform>%n corrections taken back; Redo makes them again. The Undo before them goes on: Cancel once more ends it, too</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Cancelled: what was undone is there again. %n correction(s) made after that Undo cannot be made again</source>
        <translation>
            <numerusform>Cancelled: what was undone is there again. %n correction made after that Undo cannot be made again</numerusform>
            <numerusform>Cancelled: what was undone is there again. %n corrections made after that Undo cannot be made again</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tumour mask(s)</source>
        <translation>
            <numerusform>%n tumour mask</numerusform>
            <numerusform>%n tumour masks</numerusform>
        </translation>
    </message>
</context>
</TS>

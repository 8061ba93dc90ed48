<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Words</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open case…</source>
        <translation>Fall ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open a patient that was reconstructed</source>
        <translation>Einen rekonstruierten Patienten öffnen</translation>
    </message>
    <message>
        <source>&amp;Library of cases…</source>
        <translation>Fallsamm&amp;lung …</translation>
    </message>
    <message>
        <source>The cases of a folder: what each holds, what is doubted, how lessons went</source>
        <translation>Die Fälle eines Ordners: was jeder enthält, was zweifelhaft ist, wie die Lektionen liefen</translation>
    </message>
    <message>
        <source>Open CT &amp;folder…</source>
        <translation>CT-&amp;Ordner öffnen …</translation>
    </message>
    <message>
        <source>Reconstruct the vessels of a DICOM series</source>
        <translation>Die Gefäße einer DICOM-Serie rekonstruieren</translation>
    </message>
    <message>
        <source>Open CT f&amp;ile…</source>
        <translation>CT-Date&amp;i öffnen …</translation>
    </message>
    <message>
        <source>Reconstruct the vessels of a volume: NIfTI, MetaImage or NRRD</source>
        <translation>Die Gefäße eines Volumens rekonstruieren: NIfTI, MetaImage oder NRRD</translation>
    </message>
    <message>
        <source>Open &amp;unsaved work</source>
        <translation>&amp;Ungespeicherte Arbeit öffnen</translation>
    </message>
    <message>
        <source>Open what an earlier run of the program left without having saved it</source>
        <translation>Öffnen, was ein früherer Lauf des Programms ungespeichert zurückließ</translation>
    </message>
    <message>
        <source>Open recor&amp;ding…</source>
        <translation>Auf&amp;zeichnung öffnen …</translation>
    </message>
    <message>
        <source>Look back on a play: its time line, what happened, notes</source>
        <translation>Auf einen Verlauf zurückblicken: Zeitleiste, Ereignisse, Notizen</translation>
    </message>
    <message>
        <source>&amp;Reconstruct with options…</source>
        <translation>Mit Optionen re&amp;konstruieren …</translation>
    </message>
    <message>
        <source>Choose liver mask, seeds and window before reconstructing</source>
        <translation>Vor der Rekonstruktion Lebermaske, Startpunkte und Fenster wählen</translation>
    </message>
    <message>
        <source>&amp;Built-in patient</source>
        <translation>&amp;Eingebauter Patient</translation>
    </message>
    <message>
        <source>Open the synthetic patient that comes with the program</source>
        <translation>Den synthetischen Patienten öffnen, der zum Programm gehört</translation>
    </message>
    <message>
        <source>&amp;Save case</source>
        <translation>Fall &amp;speichern</translation>
    </message>
    <message>
        <source>Keep the patient with all corrections where the case lies</source>
        <translation>Den Patienten mit allen Korrekturen dort speichern, wo der Fall liegt</translation>
    </message>
    <message>
        <source>Save case &amp;as…</source>
        <translation>Fall speichern u&amp;nter …</translation>
    </message>
    <message>
        <source>Keep the patient as another case: NAME.hep, a folder of open formats, or NAME.hepz, one file</source>
        <translation>Den Patienten als weiteren Fall speichern: NAME.hep, ein Ordner offener Formate, oder NAME.hepz, eine einzige Datei</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>Bil&amp;d speichern …</translation>
    </message>
    <message>
        <source>Save the three-dimensional view as PNG</source>
        <translation>Die dreidimensionale Ansicht als PNG speichern</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Leave the program</source>
        <translation>Das Programm verlassen</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Üben</translation>
    </message>
    <message>
        <source>&amp;Pull</source>
        <translation>&amp;Ziehen</translation>
    </message>
    <message>
        <source>Left drag on a vessel pulls it</source>
        <translation>Linksziehen an einem Gefäß zieht es</translation>
    </message>
    <message>
        <source>&amp;Inject</source>
        <translation>&amp;Injizieren</translation>
    </message>
    <message>
        <source>Left click on a vessel injects there</source>
        <translation>Linksklick auf ein Gefäß injiziert dort</translation>
    </message>
    <message>
        <source>&amp;Edit the vessels</source>
        <translation>Gefäße b&amp;earbeiten</translation>
    </message>
    <message>
        <source>Left click on a vessel corrects the tree there</source>
        <translation>Linksklick auf ein Gefäß korrigiert dort den Gefäßbaum</translation>
    </message>
    <message>
        <source>P&amp;robe</source>
        <translation>&amp;Sonde</translation>
    </message>
    <message>
        <source>Probe: the mouse leads a ball that pushes the vessels</source>
        <translation>Sonde: Die Maus führt eine Kugel, die die Gefäße wegdrückt</translation>
    </message>
    <message>
        <source>Rod pro&amp;be</source>
        <translation>S&amp;tabsonde</translation>
    </message>
    <message>
        <source>Probe: the mouse leads a rod that pushes the vessels</source>
        <translation>Sonde: Die Maus führt einen Stab, der die Gefäße wegdrückt</translation>
    </message>
    <message>
        <source>&amp;Forceps</source>
        <translation>&amp;Pinzette</translation>
    </message>
    <message>
        <source>Forceps: the mouse leads two jaws that hold a vessel and pull it</source>
        <translation>Pinzette: Die Maus führt zwei Backen, die ein Gefäß halten und ziehen</translation>
    </message>
    <message>
        <source>Hoo&amp;k</source>
        <translation>&amp;Haken</translation>
    </message>
    <message>
        <source>Hook: the mouse leads it, and it holds a vessel aside</source>
        <translation>Haken: Die Maus führt ihn, und er hält ein Gefäß beiseite</translation>
    </message>
    <message>
        <source>&amp;Blade</source>
        <translation>S&amp;kalpell</translation>
    </message>
    <message>
        <source>Blade: a line drawn across a vessel cuts through it</source>
        <translation>Skalpell: Eine Linie quer über ein Gefäß durchtrennt es</translation>
    </message>
    <message>
        <source>Cut &amp;line</source>
        <translation>Sch&amp;wächungslinie</translation>
    </message>
    <message>
        <source>Cut line: along a line drawn across a vessel it tears more easily when pulled</source>
        <translation>Schwächungslinie: Entlang einer Linie quer über ein Gefäß reißt es leichter, wenn man daran zieht</translation>
    </message>
    <message>
        <source>&amp;Turn the tool</source>
        <translation>Werkzeug &amp;drehen</translation>
    </message>
    <message>
        <source>Turn the tool in hand against the clock, by 15°</source>
        <translation>Das Werkzeug um 15° gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Turn the tool bac&amp;k</source>
        <translation>Werkzeug zurückdrehe&amp;n</translation>
    </message>
    <message>
        <source>Turn the tool in hand with the clock, by 15°</source>
        <translation>Das Werkzeug um 15° im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>&amp;Close or open the forceps</source>
        <translation>Pinzette s&amp;chließen oder öffnen</translation>
    </message>
    <message>
        <source>The jaws close until they hold, or open again</source>
        <translation>Die Backen schließen sich, bis sie halten, oder öffnen sich wieder</translation>
    </message>
    <message>
        <source>Put the tool a&amp;way</source>
        <translation>Werkzeug we&amp;glegen</translation>
    </message>
    <message>
        <source>Take the tool out of the picture, or end measuring, and pull with the mouse again; once more takes measurements away</source>
        <translation>Das Werkzeug aus dem Bild nehmen oder das Messen beenden und wieder mit der Maus ziehen; noch einmal entfernt die Messungen</translation>
    </message>
    <message>
        <source>&amp;Undo the last edit</source>
        <translation>Letzte Korrektur &amp;rückgängig machen</translation>
    </message>
    <message>
        <source>Take back the last correction of the tree</source>
        <translation>Die letzte Korrektur des Gefäßbaums zurücknehmen</translation>
    </message>
    <message>
        <source>Red&amp;o the edit</source>
        <translation>K&amp;orrektur wiederholen</translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation>Das Zurückgenommene noch einmal tun</translation>
    </message>
    <message>
        <source>Run the &amp;drug</source>
        <translation>Wirkstoff l&amp;aufen lassen</translation>
    </message>
    <message>
        <source>Start and stop the drug&apos;s front</source>
        <translation>Die Front des Wirkstoffs starten und anhalten</translation>
    </message>
    <message>
        <source>Re&amp;move the drug</source>
        <translation>Wirkstoff ent&amp;fernen</translation>
    </message>
    <message>
        <source>Take the drug out again</source>
        <translation>Den Wirkstoff wieder herausnehmen</translation>
    </message>
    <message>
        <source>&amp;Hold the clock</source>
        <translation>&amp;Uhr anhalten</translation>
    </message>
    <message>
        <source>Stop the simulation; the view stays alive</source>
        <translation>Die Simulation anhalten; die Ansicht bleibt bedienbar</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Zur&amp;ücksetzen</translation>
    </message>
    <message>
        <source>Back to the rest shape: no pull, no tool, no drug</source>
        <translation>Zurück zur Ruheform: kein Zug, kein Werkzeug, kein Wirkstoff</translation>
    </message>
    <message>
        <source>Back to the last &amp;good state</source>
        <translation>Zum &amp;letzten guten Zustand</translation>
    </message>
    <message>
        <source>After the simulation diverged: take back the last moments and go on</source>
        <translation>Nachdem die Simulation divergiert ist: die letzten Augenblicke zurücknehmen und weitermachen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation>&amp;Anterior</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Blick von vorn</translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation>P&amp;osterior</translation>
    </message>
    <message>
        <source>Look from the back</source>
        <translation>Blick von hinten</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s left</source>
        <translation>Blick von der linken Seite des Patienten</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s right</source>
        <translation>Blick von der rechten Seite des Patienten</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>&amp;Superior</translation>
    </message>
    <message>
        <source>Look from the head</source>
        <translation>Blick vom Kopf her</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>&amp;Inferior</translation>
    </message>
    <message>
        <source>Look from the feet</source>
        <translation>Blick von den Füßen her</translation>
    </message>
    <message>
        <source>Le&amp;gend and scale</source>
        <translation>Legende und &amp;Maßstab</translation>
    </message>
    <message>
        <source>Show legend, scale bar and orientation</source>
        <translation>Legende, Maßstabsbalken und Orientierung zeigen</translation>
    </message>
    <message>
        <source>Rims at &amp;crossings</source>
        <translation>Ränder an Kreu&amp;zungen</translation>
    </message>
    <message>
        <source>Set off the nearer of two crossing vessels by a thin rim</source>
        <translation>Das vordere zweier sich kreuzender Gefäße durch einen dünnen Rand absetzen</translation>
    </message>
    <message>
        <source>Li&amp;ver</source>
        <translation>Le&amp;ber</translation>
    </message>
    <message>
        <source>Show the surface of the liver around the vessels</source>
        <translation>Die Oberfläche der Leber um die Gefäße zeigen</translation>
    </message>
    <message>
        <source>&amp;Open the view</source>
        <translation>A&amp;nsicht öffnen</translation>
    </message>
    <message>
        <source>Take away what lies in front of a plane across the line of sight</source>
        <translation>Wegnehmen, was vor einer Ebene quer zur Blickrichtung liegt</translation>
    </message>
    <message>
        <source>Open it &amp;deeper</source>
        <translation>Tie&amp;fer öffnen</translation>
    </message>
    <message>
        <source>Move that plane 2 mm away from where it was put</source>
        <translation>Diese Ebene um 2 mm weiter in die Tiefe schieben</translation>
    </message>
    <message>
        <source>Open it less dee&amp;p</source>
        <translation>&amp;Weniger tief öffnen</translation>
    </message>
    <message>
        <source>Move that plane 2 mm back</source>
        <translation>Diese Ebene um 2 mm zurückschieben</translation>
    </message>
    <message>
        <source>Slices of the C&amp;T</source>
        <translation>S&amp;chichten des CTs</translation>
    </message>
    <message>
        <source>Axial, coronal and sagittal slices of the CT beside the vessels</source>
        <translation>Axiale, koronale und sagittale Schichten des CTs neben den Gefäßen</translation>
    </message>
    <message>
        <source>Table of &amp;branches</source>
        <translation>Tabelle der Äst&amp;e</translation>
    </message>
    <message>
        <source>Length, radius, generation, system, liver segment and flow of every branch</source>
        <translation>Länge, Radius, Generation, System, Lebersegment und Fluss jedes Astes</translation>
    </message>
    <message>
        <source>&amp;Curves</source>
        <translation>K&amp;urven</translation>
    </message>
    <message>
        <source>Show the curves of the last injection</source>
        <translation>Die Kurven der letzten Injektion zeigen</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Be&amp;dienfelder</translation>
    </message>
    <message>
        <source>Show the panels beside the view</source>
        <translation>Die Bedienfelder neben der Ansicht zeigen</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>The window fills the screen, and back</source>
        <translation>Das Fenster füllt den Bildschirm, und zurück</translation>
    </message>
    <message>
        <source>Dar&amp;k</source>
        <translation>Dun&amp;kel</translation>
    </message>
    <message>
        <source>Dark, as in a reading room</source>
        <translation>Dunkel, wie in einem Befundungsraum</translation>
    </message>
    <message>
        <source>L&amp;ight</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Light, for lecture rooms and print</source>
        <translation>Hell, für Hörsäle und Druck</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Hoher Kon&amp;trast</translation>
    </message>
    <message>
        <source>Black and white, for eyes that need more contrast</source>
        <translation>Schwarz und weiß, für Augen, die mehr Kontrast brauchen</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Abstand</translation>
    </message>
    <message>
        <source>Distance between two clicks on vessels, or in the slices</source>
        <translation>Abstand zweier Klicks auf Gefäße oder in den Schichten</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>Angle of three clicks on vessels, its vertex second</source>
        <translation>Winkel aus drei Klicks auf Gefäße, der zweite ist der Scheitel</translation>
    </message>
    <message>
        <source>D&amp;iameter and stenosis</source>
        <translation>&amp;Durchmesser und Stenose</translation>
    </message>
    <message>
        <source>Diameter at the centreline of the vessel that is clicked, with its stenosis</source>
        <translation>Durchmesser an der Mittellinie des angeklickten Gefäßes, mit seiner Stenose</translation>
    </message>
    <message>
        <source>&amp;Take the last back</source>
        <translation>&amp;Letzten Schritt zurück</translation>
    </message>
    <message>
        <source>Remove the last point or measurement</source>
        <translation>Den letzten Punkt oder die letzte Messung entfernen</translation>
    </message>
    <message>
        <source>&amp;Remove all</source>
        <translation>Alle &amp;entfernen</translation>
    </message>
    <message>
        <source>Remove everything that was measured</source>
        <translation>Alles Gemessene entfernen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Anleitung</translation>
    </message>
    <message>
        <source>How to load a patient, correct the vessels, practise and make lessons</source>
        <translation>Wie man einen Patienten lädt, die Gefäße korrigiert, übt und Lektionen macht</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>All keys and mouse gestures</source>
        <translation>Alle Tasten und Mausgesten</translation>
    </message>
    <message>
        <source>&amp;Messages</source>
        <translation>&amp;Meldungen</translation>
    </message>
    <message>
        <source>What was warned of and what failed since the program began</source>
        <translation>Wovor gewarnt wurde und was fehlschlug, seit das Programm begann</translation>
    </message>
    <message>
        <source>&amp;About Hepatica</source>
        <translation>&amp;Über Hepatica</translation>
    </message>
    <message>
        <source>Version, renderer and licence</source>
        <translation>Version, Grafiktreiber und Lizenz</translation>
    </message>
    <message>
        <source>Left drag on a vessel</source>
        <translation>Linksziehen an einem Gefäß</translation>
    </message>
    <message>
        <source>pull it (in Pull mode)</source>
        <translation>es ziehen (im Modus Ziehen)</translation>
    </message>
    <message>
        <source>Left drag beside the vessels, right drag</source>
        <translation>Linksziehen neben den Gefäßen, Rechtsziehen</translation>
    </message>
    <message>
        <source>orbit</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>Middle drag, Shift + left drag</source>
        <translation>Ziehen mit der mittleren Taste, Umschalt + Linksziehen</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>vergrößern und verkleinern</translation>
    </message>
    <message>
        <source>Click in Inject mode, Ctrl + click, double-click on a vessel</source>
        <translation>Klick im Modus Injizieren, Strg + Klick, Doppelklick auf ein Gefäß</translation>
    </message>
    <message>
        <source>inject there</source>
        <translation>dort injizieren</translation>
    </message>
    <message>
        <source>Click in Edit mode</source>
        <translation>Klick im Modus Bearbeiten</translation>
    </message>
    <message>
        <source>what the panel says: cut, link, delete, root, system</source>
        <translation>was das Bedienfeld sagt: durchtrennen, verbinden, löschen, Wurzel, System</translation>
    </message>
    <message>
        <source>Mouse with a tool in hand</source>
        <translation>Maus mit einem Werkzeug</translation>
    </message>
    <message>
        <source>lead its tip, in the plane of the picture</source>
        <translation>seine Spitze führen, in der Bildebene</translation>
    </message>
    <message>
        <source>Wheel with a tool in hand</source>
        <translation>Mausrad mit einem Werkzeug</translation>
    </message>
    <message>
        <source>move it in depth; Ctrl + wheel zooms</source>
        <translation>es in die Tiefe bewegen; Strg + Mausrad vergrößert</translation>
    </message>
    <message>
        <source>Left drag with blade or cut line</source>
        <translation>Linksziehen mit Skalpell oder Schwächungslinie</translation>
    </message>
    <message>
        <source>across a vessel: cut it, or let it tear there</source>
        <translation>quer über ein Gefäß: es durchtrennen oder dort reißen lassen</translation>
    </message>
    <message>
        <source>Click on vessels while measuring</source>
        <translation>Klick auf Gefäße beim Messen</translation>
    </message>
    <message>
        <source>set the points of a distance, an angle or a diameter</source>
        <translation>die Punkte eines Abstands, eines Winkels oder eines Durchmessers setzen</translation>
    </message>
    <message>
        <source>Click on a dashed line</source>
        <translation>Klick auf eine gestrichelte Linie</translation>
    </message>
    <message>
        <source>bridge that gap</source>
        <translation>diese Lücke überbrücken</translation>
    </message>
    <message>
        <source>Hover</source>
        <translation>Zeigen auf ein Gefäß</translation>
    </message>
    <message>
        <source>show what lies downstream, and its share of the flow</source>
        <translation>zeigen, was stromabwärts liegt, und seinen Anteil am Fluss</translation>
    </message>
    <message>
        <source>Shift + hover with slices beside</source>
        <translation>Umschalt + Zeigen, mit Schichten daneben</translation>
    </message>
    <message>
        <source>the slices go there</source>
        <translation>die Schichten gehen dorthin</translation>
    </message>
    <message>
        <source>Left drag on a slice</source>
        <translation>Linksziehen auf einer Schicht</translation>
    </message>
    <message>
        <source>move the crosshair; wheel: the slice, with Shift ten of them</source>
        <translation>das Fadenkreuz bewegen; Mausrad: die Schicht, mit Umschalt zehn davon</translation>
    </message>
    <message>
        <source>Right drag on a slice</source>
        <translation>Rechtsziehen auf einer Schicht</translation>
    </message>
    <message>
        <source>grey window: its width to the right, its level down</source>
        <translation>Fensterung: nach rechts die Breite, nach unten die Mitte</translation>
    </message>
    <message>
        <source>Double-click on a slice</source>
        <translation>Doppelklick auf eine Schicht</translation>
    </message>
    <message>
        <source>enlarge it, and back; Ctrl + wheel zooms, middle drag pans</source>
        <translation>sie vergrößern, und zurück; Strg + Mausrad vergrößert, Ziehen mit der mittleren Taste verschiebt</translation>
    </message>
    <message>
        <source>Alt + wheel with the view open</source>
        <translation>Alt + Mausrad bei geöffneter Ansicht</translation>
    </message>
    <message>
        <source>move the plane that opens it</source>
        <translation>die Ebene bewegen, die sie öffnet</translation>
    </message>
    <message>
        <source>Drop a file or folder</source>
        <translation>Eine Datei oder einen Ordner ablegen</translation>
    </message>
    <message>
        <source>open it</source>
        <translation>öffnen</translation>
    </message>
    <message>
        <source>Learning curve</source>
        <translation>Lernkurve</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>its least</source>
        <translation>ihr Mindestwert</translation>
    </message>
    <message>
        <source>Look &amp;back on it</source>
        <translation>Darauf &amp;zurückblicken</translation>
    </message>
    <message>
        <source>Save as &amp;CSV…</source>
        <translation>Als &amp;CSV speichern …</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Quantity of the learning curve</source>
        <translation>Messgröße der Lernkurve</translation>
    </message>
    <message>
        <source>Learning curve of</source>
        <translation>Lernkurve für</translation>
    </message>
    <message numerus="yes">
        <source>&lt;b&gt;%1&lt;/b&gt;: %n attempt(s). Tick those of an instructor: they are the band in the learning curve.</source>
        <translation>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;: %n Versuch. Kreuzen Sie die eines Lehrenden an: Sie sind das Band in der Lernkurve.</numerusform>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;: %n Versuche. Kreuzen Sie die eines Lehrenden an: Sie sind das Band in der Lernkurve.</numerusform>
        </translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>Ausgelassen: %1</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>✓ passed</source>
        <translation>✓ bestanden</translation>
    </message>
    <message>
        <source>✗ not passed</source>
        <translation>✗ nicht bestanden</translation>
    </message>
    <message>
        <source>not enough memory</source>
        <translation>Der Speicher reicht nicht aus</translation>
    </message>
    <message>
        <source>close other programs, or use a smaller image</source>
        <translation>Schließen Sie andere Programme, oder nehmen Sie ein kleineres Bild</translation>
    </message>
    <message>
        <source>please report it with what you did before</source>
        <translation>Bitte melden Sie ihn mit dem, was Sie vorher getan haben</translation>
    </message>
    <message>
        <source>internal error</source>
        <translation>Interner Fehler</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ast</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Generation</source>
        <translation>Generation</translation>
    </message>
    <message>
        <source>Length (mm)</source>
        <translation>Länge (mm)</translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation>Radius (mm)</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>Share of flow (%)</source>
        <translation>Anteil am Fluss (%)</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Äste</translation>
    </message>
    <message>
        <source>Colour by liver segment</source>
        <translation>Nach Lebersegment einfärben</translation>
    </message>
    <message>
        <source>Branches of the portal vein in the colours of Couinaud&apos;s segments</source>
        <translation>Äste der Pfortader in den Farben der Couinaud-Segmente</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern …</translation>
    </message>
    <message>
        <source>Branches of the vessels</source>
        <translation>Äste der Gefäße</translation>
    </message>
    <message>
        <source>Of what flows into the root of its own tree: a system may have several</source>
        <translation>Von dem, was in die Wurzel des eigenen Baums fließt: Ein System kann mehrere haben</translation>
    </message>
    <message>
        <source>No liver segments: they need a liver mask and a portal vein</source>
        <translation>Keine Lebersegmente: Sie brauchen eine Lebermaske und eine Pfortader</translation>
    </message>
    <message numerus="yes">
        <source>%n branch(es)</source>
        <translation>
            <numerusform>%n Ast</numerusform>
            <numerusform>%n Äste</numerusform>
        </translation>
    </message>
    <message>
        <source>Vessel cut</source>
        <translation>Gefäß durchtrennt</translation>
    </message>
    <message>
        <source>Vessels linked</source>
        <translation>Gefäße verbunden</translation>
    </message>
    <message>
        <source>Gap bridged</source>
        <translation>Lücke überbrückt</translation>
    </message>
    <message>
        <source>Branch deleted</source>
        <translation>Ast gelöscht</translation>
    </message>
    <message>
        <source>Tree deleted</source>
        <translation>Baum gelöscht</translation>
    </message>
    <message>
        <source>Root set</source>
        <translation>Wurzel gesetzt</translation>
    </message>
    <message>
        <source>Vessel drawn</source>
        <translation>Gefäß gezeichnet</translation>
    </message>
    <message>
        <source>Seed: %1</source>
        <translation>Startpunkt: %1</translation>
    </message>
    <message>
        <source>Given to: %1</source>
        <translation>Zugeordnet: %1</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%L1 %, gap of %L2 mm</source>
        <translation>%L1 %, Lücke von %L2 mm</translation>
    </message>
    <message>
        <source>The body of the corrected tree is being made; the view shows the one before.</source>
        <translation>Der Körper des korrigierten Baums entsteht gerade; die Ansicht zeigt den vorherigen.</translation>
    </message>
    <message numerus="yes">
        <source>%n gap(s) were bridged by the reconstruction, %L1 mm in all.</source>
        <translation>
            <numerusform>%n Lücke wurde von der Rekonstruktion überbrückt, %L1 mm insgesamt.</numerusform>
            <numerusform>%n Lücken wurden von der Rekonstruktion überbrückt, %L1 mm insgesamt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Now click the vessel that it shall be linked with</source>
        <translation>Klicken Sie nun auf das Gefäß, mit dem es verbunden werden soll</translation>
    </message>
    <message>
        <source>No vessel there: click on one</source>
        <translation>Dort ist kein Gefäß: Klicken Sie auf eines</translation>
    </message>
    <message>
        <source>Not drawn: why stands above</source>
        <translation>Nicht gezeichnet: Der Grund steht oben</translation>
    </message>
    <message>
        <source>A vessel of %L1 mm, radius %L2 mm</source>
        <translation>Ein Gefäß von %L1 mm, Radius %L2 mm</translation>
    </message>
    <message>
        <source>For this patient</source>
        <translation>Für diesen Patienten</translation>
    </message>
    <message>
        <source>For any patient</source>
        <translation>Für jeden Patienten</translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation>Nicht lesbar</translation>
    </message>
    <message>
        <source>&amp;Begin the lesson</source>
        <translation>&amp;Lektion beginnen</translation>
    </message>
    <message>
        <source>Lessons that go with the case</source>
        <translation>Lektionen zu diesem Fall</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>No lesson in this folder goes with it</source>
        <translation>Keine Lektion in diesem Ordner gehört dazu</translation>
    </message>
    <message>
        <source>Lesson &gt; Edit lessons makes one; save it in this folder</source>
        <translation>Lektion &gt; Lektionen bearbeiten macht eine; speichern Sie sie in diesem Ordner</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) at lessons, %1 passed; the last: %2, %3</source>
        <translation>
            <numerusform>%n Versuch an Lektionen, %1 bestanden; der letzte: %2, %3</numerusform>
            <numerusform>%n Versuche an Lektionen, %1 bestanden; der letzte: %2, %3</numerusform>
        </translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message numerus="yes">
        <source>%1: %L2 mm, %n root(s)</source>
        <translation>
            <numerusform>%1: %L2 mm, %n Wurzel</numerusform>
            <numerusform>%1: %L2 mm, %n Wurzeln</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 branches, %2 tetrahedra</source>
        <translation>%1 Äste, %2 Tetraeder</translation>
    </message>
    <message>
        <source>It cannot be opened: %1. %2</source>
        <translation>Er lässt sich nicht öffnen: %1. %2</translation>
    </message>
    <message>
        <source>Reading the cases</source>
        <translation>Die Fälle werden gelesen</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ist nicht lesbar: %1</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>hepatic veins</source>
        <translation>Lebervenen</translation>
    </message>
    <message>
        <source>artery</source>
        <translation>Leberarterie</translation>
    </message>
    <message>
        <source>unknown system</source>
        <translation>unbekanntes System</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Pass marks of the course</source>
        <translation>Bestehensgrenzen des Kurses</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>the lesson&apos;s own</source>
        <translation>die der Lektion selbst</translation>
    </message>
    <message>
        <source>✗ not passed yet</source>
        <translation>✗ noch nicht bestanden</translation>
    </message>
    <message>
        <source>not tried yet</source>
        <translation>noch nicht versucht</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Lessons of the course</source>
        <translation>Lektionen des Kurses</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: %2 of %3 lessons passed</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: %2 von %3 Lektionen bestanden</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Cut the vessel</source>
        <translation>Gefäß durchtrennen</translation>
    </message>
    <message>
        <source>Click where it shall part</source>
        <translation>Klicken Sie, wo es sich teilen soll</translation>
    </message>
    <message>
        <source>Link two vessels</source>
        <translation>Zwei Gefäße verbinden</translation>
    </message>
    <message>
        <source>Click the one, then the other</source>
        <translation>Klicken Sie auf das eine, dann auf das andere</translation>
    </message>
    <message>
        <source>Delete a branch</source>
        <translation>Ast löschen</translation>
    </message>
    <message>
        <source>Click it; all that hangs on it goes with it</source>
        <translation>Klicken Sie darauf; alles, was daran hängt, geht mit</translation>
    </message>
    <message>
        <source>Delete a whole tree</source>
        <translation>Ganzen Baum löschen</translation>
    </message>
    <message>
        <source>Click any branch of it; all that hangs on its root goes</source>
        <translation>Klicken Sie auf irgendeinen Ast; alles an seiner Wurzel geht mit</translation>
    </message>
    <message>
        <source>Set the root</source>
        <translation>Wurzel setzen</translation>
    </message>
    <message>
        <source>Click near the end where blood comes in</source>
        <translation>Klicken Sie nahe dem Ende, an dem Blut eintritt</translation>
    </message>
    <message>
        <source>Give to a system</source>
        <translation>Einem System zuordnen</translation>
    </message>
    <message>
        <source>Click a branch; all that hangs on it goes with it</source>
        <translation>Klicken Sie auf einen Ast; alles, was daran hängt, geht mit</translation>
    </message>
    <message>
        <source>Say what a vessel is</source>
        <translation>Sagen, was ein Gefäß ist</translation>
    </message>
    <message>
        <source>Click a vessel; all that belongs with it takes the system below, however far it reaches</source>
        <translation>Klicken Sie auf ein Gefäß; alles, was dazugehört, nimmt das System unten an, so weit es reicht</translation>
    </message>
    <message>
        <source>A click in Edit mode</source>
        <translation>Ein Klick im Modus Bearbeiten</translation>
    </message>
    <message>
        <source>Tool of the edit</source>
        <translation>Werkzeug der Bearbeitung</translation>
    </message>
    <message>
        <source>does</source>
        <translation>bewirkt</translation>
    </message>
    <message>
        <source>A vessel that is missing is drawn in the slices (F7)</source>
        <translation>Ein fehlendes Gefäß wird in den Schichten gezeichnet (F7)</translation>
    </message>
    <message>
        <source>System that a branch is given to</source>
        <translation>System, dem ein Ast zugeordnet wird</translation>
    </message>
    <message>
        <source>Gaps that might be bridged</source>
        <translation>Lücken, die überbrückt werden könnten</translation>
    </message>
    <message>
        <source>Dashed in the view, with the confidence that it is one vessel. A click on the dashed line bridges it, too.</source>
        <translation>In der Ansicht gestrichelt, mit der Sicherheit, dass es ein Gefäß ist. Ein Klick auf die gestrichelte Linie überbrückt sie auch.</translation>
    </message>
    <message>
        <source>Bridge it</source>
        <translation>Überbrücken</translation>
    </message>
    <message>
        <source>Bridge all of them</source>
        <translation>Alle überbrücken</translation>
    </message>
    <message>
        <source>All gaps that are listed, best first; what another one made needless is left out</source>
        <translation>Alle aufgeführten Lücken, die besten zuerst; was dadurch überflüssig wurde, entfällt</translation>
    </message>
    <message>
        <source>Least confidence of the gaps that are shown</source>
        <translation>Mindestsicherheit der gezeigten Lücken</translation>
    </message>
    <message>
        <source>of %1 % or more</source>
        <translation>ab %1 %</translation>
    </message>
    <message>
        <source>Done so far</source>
        <translation>Bisher getan</translation>
    </message>
    <message>
        <source>Edits</source>
        <translation>Korrekturen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>Page of the guide</source>
        <translation>Seite der Anleitung</translation>
    </message>
    <message>
        <source>First page</source>
        <translation>Erste Seite</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>About Hepatica</source>
        <translation>Über Hepatica</translation>
    </message>
    <message>
        <source>&lt;b&gt;Hepatica %1&lt;/b&gt;&lt;p&gt;Practise on a patient&apos;s own liver vessels.&lt;/p&gt;&lt;p&gt;Renderer: %2&lt;/p&gt;&lt;p&gt;Licence: GPL-3.0-or-later. Not a medical device.&lt;/p&gt;</source>
        <translation>&lt;b&gt;Hepatica %1&lt;/b&gt;&lt;p&gt;Üben an den Lebergefäßen eines Patienten.&lt;/p&gt;&lt;p&gt;Grafiktreiber: %2&lt;/p&gt;&lt;p&gt;Lizenz: GPL-3.0-or-later. Kein Medizinprodukt.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Water-soluble carrier</source>
        <translation>Wasserlösliche Trägerflüssigkeit</translation>
    </message>
    <message>
        <source>Flows like blood: 3.5 mPa s, 1060 kg/m³.</source>
        <translation>Fließt wie Blut: 3,5 mPa s, 1060 kg/m³.</translation>
    </message>
    <message>
        <source>Lipiodol emulsion, 2 to 1</source>
        <translation>Lipiodol-Emulsion, 2 zu 1</translation>
    </message>
    <message>
        <source>Iodised oil, 25 mPa s and 1280 kg/m³ at 37 °C: the usual choice in chemoembolization.</source>
        <translation>Iodiertes Öl, 25 mPa s und 1280 kg/m³ bei 37 °C: das Übliche bei der Chemoembolisation.</translation>
    </message>
    <message>
        <source>Gas, as in the paper</source>
        <translation>Gas, wie in der Veröffentlichung</translation>
    </message>
    <message>
        <source>Void fraction 0.386 to 0.433 in the paper. In blood this would be an air embolus.</source>
        <translation>Gasanteil 0,386 bis 0,433 in der Veröffentlichung. Im Blut wäre das eine Luftembolie.</translation>
    </message>
    <message>
        <source>Regime: wall friction once, laminar to turbulent</source>
        <translation>Regime: einmal Wandreibung, laminar bis turbulent</translation>
    </message>
    <message>
        <source>Consistent: equation (10) with the flux along the cone</source>
        <translation>Konsistent: Gleichung (10) mit dem Strom entlang des Kegels</translation>
    </message>
    <message>
        <source>Published: equations (5) to (10) as printed</source>
        <translation>Veröffentlicht: Gleichungen (5) bis (10) wie gedruckt</translation>
    </message>
    <message>
        <source>Under the mouse</source>
        <translation>Unter der Maus</translation>
    </message>
    <message>
        <source>Next injection</source>
        <translation>Nächste Injektion</translation>
    </message>
    <message>
        <source>Drug</source>
        <translation>Wirkstoff</translation>
    </message>
    <message>
        <source>Mass flow at the catheter&apos;s tip</source>
        <translation>Massenstrom an der Katheterspitze</translation>
    </message>
    <message>
        <source>Mass flow</source>
        <translation>Massenstrom</translation>
    </message>
    <message>
        <source>Share of the volume that the second phase (gas, oil) takes</source>
        <translation>Volumenanteil der zweiten Phase (Gas, Öl)</translation>
    </message>
    <message>
        <source>Void fraction</source>
        <translation>Anteil 2. Phase</translation>
    </message>
    <message>
        <source>of the mixture</source>
        <translation>der Mischung</translation>
    </message>
    <message>
        <source>Viscosity of what is injected; 0 takes that of the mixture</source>
        <translation>Viskosität des Injizierten; 0 nimmt die der Mischung</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viskosität</translation>
    </message>
    <message>
        <source>Form of the pressure law</source>
        <translation>Form des Druckgesetzes</translation>
    </message>
    <message>
        <source>Pressure law</source>
        <translation>Druckgesetz</translation>
    </message>
    <message>
        <source>g/s, Pa</source>
        <translation>g/s, Pa</translation>
    </message>
    <message>
        <source>mL/min, mmHg</source>
        <translation>mL/min, mmHg</translation>
    </message>
    <message>
        <source>Of flows and pressures in the panels and curves</source>
        <translation>Der Flüsse und Drücke in Bedienfeldern und Kurven</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Drug front</source>
        <translation>Wirkstofffront</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Time of the drug front</source>
        <translation>Zeit der Wirkstofffront</translation>
    </message>
    <message>
        <source>Seconds of the drug&apos;s clock per second of the simulation</source>
        <translation>Sekunden auf der Uhr des Wirkstoffs je Sekunde der Simulation</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Volume flow</source>
        <translation>Volumenstrom</translation>
    </message>
    <message>
        <source>Volume flow at the catheter&apos;s tip</source>
        <translation>Volumenstrom an der Katheterspitze</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>nothing injected</source>
        <translation>nichts injiziert</translation>
    </message>
    <message>
        <source>%L1 of %L2 s</source>
        <translation>%L1 von %L2 s</translation>
    </message>
    <message>
        <source>Point at a vessel to see what lies downstream.</source>
        <translation>Zeigen Sie auf ein Gefäß, um zu sehen, was stromabwärts liegt.</translation>
    </message>
    <message>
        <source>Mark an attempt</source>
        <translation>Einen Versuch bewerten</translation>
    </message>
    <message>
        <source>&amp;Course…</source>
        <translation>&amp;Kurs …</translation>
    </message>
    <message>
        <source>&amp;Open lesson…</source>
        <translation>Lektion &amp;öffnen …</translation>
    </message>
    <message>
        <source>Open co&amp;urse…</source>
        <translation>K&amp;urs öffnen …</translation>
    </message>
    <message>
        <source>&amp;Edit lessons…</source>
        <translation>Lektionen &amp;bearbeiten …</translation>
    </message>
    <message>
        <source>Open lesson</source>
        <translation>Lektion öffnen</translation>
    </message>
    <message>
        <source>Lessons (*.json)</source>
        <translation>Lektionen (*.json)</translation>
    </message>
    <message>
        <source>Open course</source>
        <translation>Kurs öffnen</translation>
    </message>
    <message>
        <source>Courses (*.json)</source>
        <translation>Kurse (*.json)</translation>
    </message>
    <message>
        <source>Try the lesson</source>
        <translation>Lektion ausprobieren</translation>
    </message>
    <message>
        <source>Begin the lesson</source>
        <translation>Lektion beginnen</translation>
    </message>
    <message>
        <source>Keep the result</source>
        <translation>Ergebnis aufheben</translation>
    </message>
    <message>
        <source>Pull by hand</source>
        <translation>Ziehen von Hand</translation>
    </message>
    <message>
        <source>Round probe</source>
        <translation>Runde Sonde</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>Forceps</source>
        <translation>Pinzette</translation>
    </message>
    <message>
        <source>Hook</source>
        <translation>Haken</translation>
    </message>
    <message>
        <source>Blade</source>
        <translation>Skalpell</translation>
    </message>
    <message>
        <source>Cut line</source>
        <translation>Schwächungslinie</translation>
    </message>
    <message>
        <source>Injection</source>
        <translation>Injektion</translation>
    </message>
    <message>
        <source>Gravity, tissue, tearing, drug&apos;s clock</source>
        <translation>Schwerkraft, Gewebe, Reißen, Uhr des Wirkstoffs</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>What &amp;for</source>
        <translation>&amp;Wozu</translation>
    </message>
    <message>
        <source>For the trainee, before it begins. May be empty.</source>
        <translation>Für den Übenden, bevor sie beginnt. Darf leer sein.</translation>
    </message>
    <message>
        <source>&amp;Patient</source>
        <translation>&amp;Patient</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>Die Szene</translation>
    </message>
    <message>
        <source>The vessels &amp;move</source>
        <translation>Die Gefäße &amp;bewegen sich</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>&amp;Tools touch them</source>
        <translation>Werkzeuge berühren &amp;sie</translation>
    </message>
    <message>
        <source>They touch &amp;each other</source>
        <translation>Sie berühren &amp;einander</translation>
    </message>
    <message>
        <source>They te&amp;ar and bleed</source>
        <translation>Sie &amp;reißen und bluten</translation>
    </message>
    <message>
        <source>A &amp;drug can be injected</source>
        <translation>Ein Wirkstoff kann &amp;injiziert werden</translation>
    </message>
    <message>
        <source>times as fast as it flows</source>
        <translation>mal so schnell, wie er fließt</translation>
    </message>
    <message>
        <source>Its clock runs</source>
        <translation>Seine Uhr läuft</translation>
    </message>
    <message>
        <source>What the trainee may use</source>
        <translation>Was der Übende benutzen darf</translation>
    </message>
    <message>
        <source>Any patient</source>
        <translation>Jeder Patient</translation>
    </message>
    <message>
        <source>The built-in patient</source>
        <translation>Der eingebaute Patient</translation>
    </message>
    <message>
        <source>The one that is shown: %1</source>
        <translation>Der gezeigte: %1</translation>
    </message>
    <message>
        <source>which mark?</source>
        <translation>welche Marke?</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add: %1</source>
        <translation>Hinzufügen: %1</translation>
    </message>
    <message>
        <source>What is measured</source>
        <translation>Was gemessen wird</translation>
    </message>
    <message>
        <source>Of which mark</source>
        <translation>An welcher Marke</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>mindestens</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>höchstens</translation>
    </message>
    <message>
        <source>At least or at most</source>
        <translation>Mindestens oder höchstens</translation>
    </message>
    <message>
        <source>The bound</source>
        <translation>Die Grenze</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove this bound</source>
        <translation>Diese Grenze entfernen</translation>
    </message>
    <message>
        <source>This lesson</source>
        <translation>Diese Lektion</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>What is missing stands at its foot</source>
        <translation>Was fehlt, steht unten</translation>
    </message>
    <message>
        <source>&amp;Lesson</source>
        <translation>&amp;Lektion</translation>
    </message>
    <message>
        <source>&amp;Places</source>
        <translation>&amp;Orte</translation>
    </message>
    <message>
        <source>&amp;Steps</source>
        <translation>S&amp;chritte</translation>
    </message>
    <message>
        <source>Limits and pass &amp;marks</source>
        <translation>Grenzen und Bestehens&amp;marken</translation>
    </message>
    <message>
        <source>What is doubtful in this lesson</source>
        <translation>Was an dieser Lektion zweifelhaft ist</translation>
    </message>
    <message>
        <source>&amp;Begin with</source>
        <translation>&amp;Beginnen mit</translation>
    </message>
    <message>
        <source>A new lesson</source>
        <translation>Neue Lektion</translation>
    </message>
    <message>
        <source>A file…</source>
        <translation>Eine Datei …</translation>
    </message>
    <message>
        <source>A copy of: %1</source>
        <translation>Kopie von: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Red&amp;o</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Try it</source>
        <translation>&amp;Ausprobieren</translation>
    </message>
    <message>
        <source>Sa&amp;ve</source>
        <translation>S&amp;peichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Sch&amp;ließen</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>noch nicht gespeichert</translation>
    </message>
    <message>
        <source>%1[*] (%2) - Lesson editor</source>
        <translation>%1[*] (%2) - Lektionen bearbeiten</translation>
    </message>
    <message>
        <source>This lesson was left unsaved by an earlier run of the program.</source>
        <translation>Diese Lektion blieb bei einem früheren Lauf des Programms ungespeichert.</translation>
    </message>
    <message>
        <source>Keep the unsaved lesson</source>
        <translation>Ungespeicherte Lektion aufheben</translation>
    </message>
    <message>
        <source>Save lesson</source>
        <translation>Lektion speichern</translation>
    </message>
    <message>
        <source>This lesson cannot be saved yet</source>
        <translation>Diese Lektion kann noch nicht gespeichert werden</translation>
    </message>
    <message>
        <source>This lesson cannot be tried yet</source>
        <translation>Diese Lektion kann noch nicht ausprobiert werden</translation>
    </message>
    <message>
        <source>at %L1, %L2, %L3 mm</source>
        <translation>bei %L1, %L2, %L3 mm</translation>
    </message>
    <message>
        <source>&amp;Give it a target</source>
        <translation>Mit &amp;Ziel</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Yellow balls on the vessels that goals speak of; they move with them. A share of the longest path (0 % the root, 100 % its end) is found on every patient; a point that is clicked on belongs to the patient who is shown.</source>
        <translation>Gelbe Kugeln auf den Gefäßen, von denen die Ziele handeln; sie bewegen sich mit. Ein Anteil am längsten Weg (0 % die Wurzel, 100 % sein Ende) findet sich bei jedem Patienten; ein angeklickter Punkt gehört zu dem Patienten, der gezeigt wird.</translation>
    </message>
    <message>
        <source>&amp;Add a mark</source>
        <translation>Marke &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Target of the drug</source>
        <translation>Ziel des Wirkstoffs</translation>
    </message>
    <message>
        <source>The vessels beyond this place. What is delivered there is the dose in the target, all other is elsewhere.</source>
        <translation>Die Gefäße jenseits dieses Orts. Was dort ankommt, ist die Dosis im Ziel, alles andere geht daneben.</translation>
    </message>
    <message>
        <source>Name of the mark</source>
        <translation>Name der Marke</translation>
    </message>
    <message>
        <source>As a share</source>
        <translation>Als Anteil</translation>
    </message>
    <message>
        <source>% of the longest path</source>
        <translation>% des längsten Wegs</translation>
    </message>
    <message>
        <source>Share of the longest path</source>
        <translation>Anteil am längsten Weg</translation>
    </message>
    <message>
        <source>Click on it</source>
        <translation>Anklicken</translation>
    </message>
    <message>
        <source>The next click on a vessel in the view sets the place</source>
        <translation>Der nächste Klick auf ein Gefäß in der Ansicht setzt den Ort</translation>
    </message>
    <message>
        <source>Limits all the time: the first one broken ends the attempt</source>
        <translation>Grenzen zu jeder Zeit: Die erste verletzte beendet den Versuch</translation>
    </message>
    <message>
        <source>Pass marks: looked at in the end alone</source>
        <translation>Bestehensgrenzen: Nur am Ende geprüft</translation>
    </message>
    <message>
        <source>Goal: all of these at once</source>
        <translation>Ziel: alles davon zugleich</translation>
    </message>
    <message>
        <source>Limits while it lasts</source>
        <translation>Grenzen, solange er dauert</translation>
    </message>
    <message>
        <source>Steps of the lesson</source>
        <translation>Schritte der Lektion</translation>
    </message>
    <message>
        <source>&amp;Add a step</source>
        <translation>Schritt &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Earlie&amp;r</source>
        <translation>&amp;Früher</translation>
    </message>
    <message>
        <source>Lat&amp;er</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>Say</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>On demand. May be empty.</source>
        <translation>Auf Wunsch gezeigt. Darf leer sein.</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Held for</source>
        <translation>Gehalten für</translation>
    </message>
    <message>
        <source>How long the goal has been held</source>
        <translation>Wie lange das Ziel gehalten wurde</translation>
    </message>
    <message>
        <source>&amp;Hint</source>
        <translation>&amp;Hinweis</translation>
    </message>
    <message>
        <source>Write a &amp;report…</source>
        <translation>Be&amp;richt schreiben …</translation>
    </message>
    <message>
        <source>All &amp;attempts…</source>
        <translation>Alle &amp;Versuche …</translation>
    </message>
    <message>
        <source>&amp;Begin again</source>
        <translation>Von &amp;vorn beginnen</translation>
    </message>
    <message>
        <source>&amp;Leave</source>
        <translation>Ver&amp;lassen</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>✓ Passed</source>
        <translation>✓ Bestanden</translation>
    </message>
    <message>
        <source>✗ Not passed</source>
        <translation>✗ Nicht bestanden</translation>
    </message>
    <message>
        <source>Pass marks</source>
        <translation>Bestehensgrenzen</translation>
    </message>
    <message>
        <source>%1, path %2, peak force %3</source>
        <translation>%1, Weg %2, größte Kraft %3</translation>
    </message>
    <message>
        <source>Library of cases</source>
        <translation>Fallsammlung</translation>
    </message>
    <message>
        <source>&amp;Another folder…</source>
        <translation>&amp;Anderer Ordner …</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Fälle</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Take in a case…</source>
        <translation>Fall über&amp;nehmen …</translation>
    </message>
    <message>
        <source>&amp;Save as one file…</source>
        <translation>Als eine Datei &amp;speichern …</translation>
    </message>
    <message>
        <source>Take in a case</source>
        <translation>Fall übernehmen</translation>
    </message>
    <message>
        <source>Cases in one file (*.hepz)</source>
        <translation>Fälle in einer Datei (*.hepz)</translation>
    </message>
    <message>
        <source>Save as one file</source>
        <translation>Als eine Datei speichern</translation>
    </message>
    <message>
        <source>Folder with cases</source>
        <translation>Ordner mit Fällen</translation>
    </message>
    <message>
        <source>Read the library</source>
        <translation>Fallsammlung lesen</translation>
    </message>
    <message>
        <source>Reading the cases…</source>
        <translation>Die Fälle werden gelesen …</translation>
    </message>
    <message>
        <source>There is no case in this folder. Choose another one, or save a patient here: File &amp;gt; Save case as.</source>
        <translation>In diesem Ordner liegt kein Fall. Wählen Sie einen anderen, oder speichern Sie hier einen Patienten: Datei &amp;gt; Fall speichern unter.</translation>
    </message>
    <message>
        <source>Copy the case</source>
        <translation>Fall kopieren</translation>
    </message>
    <message>
        <source>Copying the case</source>
        <translation>Der Fall wird kopiert</translation>
    </message>
    <message>
        <source>there is a case of this name already</source>
        <translation>Es gibt schon einen Fall dieses Namens</translation>
    </message>
    <message>
        <source>Give the file another name, or take the other case away</source>
        <translation>Geben Sie der Datei einen anderen Namen, oder nehmen Sie den anderen Fall weg</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Korrekturen</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Liver segments</source>
        <translation>Lebersegmente</translation>
    </message>
    <message>
        <source>Keeping a copy of unsaved work</source>
        <translation>Sicherungskopie ungespeicherter Arbeit</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Wirkstoff</translation>
    </message>
    <message>
        <source>%1 is not there any more; it was taken off the list of recent files.</source>
        <translation>%1 ist nicht mehr da; der Eintrag wurde aus der Liste der zuletzt benutzten Dateien genommen.</translation>
    </message>
    <message>
        <source>Open case (a folder NAME.hep)</source>
        <translation>Fall öffnen (ein Ordner NAME.hep)</translation>
    </message>
    <message>
        <source>The CT of this patient: a volume, or any one file of its DICOM folder</source>
        <translation>Das CT dieses Patienten: ein Volumen oder eine beliebige Datei seines DICOM-Ordners</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Save curves</source>
        <translation>Kurven speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>Ordner für den Bericht</translation>
    </message>
    <message>
        <source>The report is in %1</source>
        <translation>Der Bericht liegt in %1</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>the program could not be started again</source>
        <translation>das Programm ließ sich nicht noch einmal starten</translation>
    </message>
    <message>
        <source>Writing the report: the play is gone through once more…</source>
        <translation>Der Bericht wird geschrieben: Der Verlauf wird noch einmal durchlaufen …</translation>
    </message>
    <message>
        <source>The program ended without saving %1 (%2)%3. The work is not lost: it stays under File &gt; Open unsaved work until it is saved or let go.</source>
        <translation>Das Programm endete, ohne %1 zu speichern (%2)%3. Die Arbeit ist nicht verloren: Sie bleibt unter Datei &gt; Ungespeicherte Arbeit öffnen, bis sie gespeichert oder verworfen wird.</translation>
    </message>
    <message numerus="yes">
        <source>, and %n more</source>
        <translation>
            <numerusform>, und %n weitere</numerusform>
            <numerusform>, und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>No earlier run left unsaved work.</source>
        <translation>Kein früherer Lauf hat ungespeicherte Arbeit zurückgelassen.</translation>
    </message>
    <message>
        <source>Open CT folder (DICOM)</source>
        <translation>CT-Ordner öffnen (DICOM)</translation>
    </message>
    <message>
        <source>Open CT file</source>
        <translation>CT-Datei öffnen</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Recordings (*.hrec)</source>
        <translation>Aufzeichnungen (*.hrec)</translation>
    </message>
    <message>
        <source>the picture cannot be written</source>
        <translation>Das Bild lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>choose a folder you may write to, on a disk with room</source>
        <translation>Wählen Sie einen Ordner, in den Sie schreiben dürfen, auf einem Datenträger mit freiem Platz</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Folder for the pictures of the film (ffmpeg is not installed)</source>
        <translation>Ordner für die Bilder des Films (ffmpeg ist nicht installiert)</translation>
    </message>
    <message>
        <source>Save a film</source>
        <translation>Film speichern</translation>
    </message>
    <message>
        <source>Films (*.mp4)</source>
        <translation>Filme (*.mp4)</translation>
    </message>
    <message>
        <source>Saving the film…</source>
        <translation>Der Film wird gespeichert …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>the review ended before the film did</source>
        <translation>Der Rückblick endete vor dem Film</translation>
    </message>
    <message>
        <source>Open the recording again</source>
        <translation>Öffnen Sie die Aufzeichnung noch einmal</translation>
    </message>
    <message>
        <source>only files and folders of this computer can be opened</source>
        <translation>Nur Dateien und Ordner dieses Rechners lassen sich öffnen</translation>
    </message>
    <message>
        <source>save it to a folder and drop that</source>
        <translation>Speichern Sie es in einen Ordner, und legen Sie diesen ab</translation>
    </message>
    <message>
        <source>the built-in patient</source>
        <translation>der eingebaute Patient</translation>
    </message>
    <message>
        <source>The lesson&apos;s own patient is shown. Before it, it was %1.</source>
        <translation>Gezeigt wird der Patient der Lektion. Vorher war es %1.</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Edit lesson</source>
        <translation>Lektion bearbeiten</translation>
    </message>
    <message>
        <source>The lesson holds changes that are not saved. Let them go?</source>
        <translation>Die Lektion enthält ungespeicherte Änderungen. Sollen sie verworfen werden?</translation>
    </message>
    <message>
        <source>Look back on a recording</source>
        <translation>Auf eine Aufzeichnung zurückblicken</translation>
    </message>
    <message>
        <source>All messages</source>
        <translation>Alle Meldungen</translation>
    </message>
    <message>
        <source>Back to the last good state</source>
        <translation>Zum letzten guten Zustand</translation>
    </message>
    <message>
        <source>The line meets no vessel: draw it across one</source>
        <translation>Die Linie trifft kein Gefäß: Ziehen Sie sie quer über eines</translation>
    </message>
    <message>
        <source>Drag a vessel to pull it</source>
        <translation>Ziehen Sie an einem Gefäß</translation>
    </message>
    <message>
        <source>Click on a vessel to inject there</source>
        <translation>Klicken Sie auf ein Gefäß, um dort zu injizieren</translation>
    </message>
    <message>
        <source>Click on a vessel to correct the tree</source>
        <translation>Klicken Sie auf ein Gefäß, um den Gefäßbaum zu korrigieren</translation>
    </message>
    <message>
        <source>Click on a vessel: the place is there</source>
        <translation>Klicken Sie auf ein Gefäß: Dort ist der Ort</translation>
    </message>
    <message>
        <source>Draw a line across a vessel to cut it</source>
        <translation>Ziehen Sie eine Linie quer über ein Gefäß, um es zu durchtrennen</translation>
    </message>
    <message>
        <source>Draw a line across a vessel: it tears there when pulled</source>
        <translation>Ziehen Sie eine Linie quer über ein Gefäß: Dort reißt es unter Zug</translation>
    </message>
    <message>
        <source>The mouse leads the tool, the wheel moves it in depth</source>
        <translation>Die Maus führt das Werkzeug, das Mausrad bewegt es in die Tiefe</translation>
    </message>
    <message>
        <source>Reading the CT</source>
        <translation>Das CT wird gelesen</translation>
    </message>
    <message>
        <source>Not drawn: end the review first</source>
        <translation>Nicht gezeichnet: Beenden Sie erst den Rückblick</translation>
    </message>
    <message>
        <source>Nothing is corrected during a review: end it first</source>
        <translation>Während eines Rückblicks wird nichts korrigiert: Beenden Sie ihn erst</translation>
    </message>
    <message>
        <source>Nothing is rebuilt during a review: end it first</source>
        <translation>Während eines Rückblicks wird nichts neu gebaut: Beenden Sie ihn erst</translation>
    </message>
    <message>
        <source>Drawing a vessel</source>
        <translation>Ein Gefäß wird gezeichnet</translation>
    </message>
    <message>
        <source>This case knows no liver. Reconstruct the CT, with a mask of the liver where the program does not find it by itself.</source>
        <translation>Dieser Fall kennt keine Leber. Rekonstruieren Sie das CT, mit einer Lebermaske, wo das Programm die Leber nicht selbst findet.</translation>
    </message>
    <message>
        <source>The liver&apos;s surface</source>
        <translation>Die Oberfläche der Leber</translation>
    </message>
    <message>
        <source>The window speaks the other language from its next start on.</source>
        <translation>Von seinem nächsten Start an spricht das Fenster die andere Sprache.</translation>
    </message>
    <message>
        <source>Start it anew now</source>
        <translation>Jetzt neu starten</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Betrifft</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Alles kopieren</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Failure</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>QT_QPA_PLATFORM asks for Wayland, where the three-dimensional view cannot draw: it needs GLX. Unset QT_QPA_PLATFORM; the window then comes through Xwayland, which the package xwayland installs.</source>
        <translation>QT_QPA_PLATFORM verlangt Wayland, wo die dreidimensionale Ansicht nicht zeichnen kann: Sie braucht GLX. Entfernen Sie QT_QPA_PLATFORM; das Fenster kommt dann über Xwayland, welches das Paket xwayland installiert.</translation>
    </message>
    <message>
        <source>hepatica-cli makes pictures without any display.</source>
        <translation>hepatica-cli macht Bilder ohne jede Anzeige.</translation>
    </message>
    <message>
        <source>This is a Wayland session without an X server, and the three-dimensional view needs one. Install the package xwayland and log in again; %1</source>
        <translation>Dies ist eine Wayland-Sitzung ohne X-Server, und die dreidimensionale Ansicht braucht einen. Installieren Sie das Paket xwayland, und melden Sie sich neu an; %1</translation>
    </message>
    <message>
        <source>There is no display: the variable DISPLAY is not set. Start the program in a graphical session, or under xvfb-run; %1</source>
        <translation>Es gibt keine Anzeige: Die Variable DISPLAY ist nicht gesetzt. Starten Sie das Programm in einer grafischen Sitzung oder unter xvfb-run; %1</translation>
    </message>
    <message>
        <source>The display %1 cannot be reached. Set DISPLAY to that of your graphical session, allow this user there (xhost), or start under xvfb-run; %2</source>
        <translation>Die Anzeige %1 ist nicht erreichbar. Setzen Sie DISPLAY auf die Ihrer grafischen Sitzung, erlauben Sie diesen Benutzer dort (xhost), oder starten Sie unter xvfb-run; %2</translation>
    </message>
    <message>
        <source>Install libgl1-mesa-dri (software rendering) or your graphics card&apos;s driver, and start the program on an X11 display with GLX. hepatica-cli makes pictures without any display.</source>
        <translation>Installieren Sie libgl1-mesa-dri (Darstellung durch den Prozessor) oder den Treiber Ihrer Grafikkarte, und starten Sie das Programm auf einer X11-Anzeige mit GLX. hepatica-cli macht Bilder ohne jede Anzeige.</translation>
    </message>
    <message>
        <source>No OpenGL context can be made. %1</source>
        <translation>Es lässt sich kein OpenGL-Kontext herstellen. %1</translation>
    </message>
    <message>
        <source>OpenGL does not come through GLX here, which the three-dimensional view needs. Unset QT_QPA_PLATFORM and QT_XCB_GL_INTEGRATION, and start the program on an X11 display with GLX (under Wayland: install xwayland).</source>
        <translation>OpenGL kommt hier nicht über GLX, das die dreidimensionale Ansicht braucht. Entfernen Sie QT_QPA_PLATFORM und QT_XCB_GL_INTEGRATION, und starten Sie das Programm auf einer X11-Anzeige mit GLX (unter Wayland: xwayland installieren).</translation>
    </message>
    <message>
        <source>OpenGL cannot draw on this display. %1</source>
        <translation>OpenGL kann auf dieser Anzeige nicht zeichnen. %1</translation>
    </message>
    <message>
        <source>OpenGL %1.%2 is too old; %3.%4 is needed. %5</source>
        <translation>OpenGL %1.%2 ist zu alt; nötig ist %3.%4. %5</translation>
    </message>
    <message>
        <source>Volumes (*.nii *.nii.gz *.mha *.mhd *.nrrd *.nhdr);;All files (*)</source>
        <translation>Volumen (*.nii *.nii.gz *.mha *.mhd *.nrrd *.nhdr);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Volumes and cases in one file (*.nii *.nii.gz *.mha *.mhd *.nrrd *.nhdr *.hepz);;All files (*)</source>
        <translation>Volumen und Fälle in einer Datei (*.nii *.nii.gz *.mha *.mhd *.nrrd *.nhdr *.hepz);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Opening the built-in patient</source>
        <translation>Der eingebaute Patient wird geöffnet</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>The vessels are being rebuilt: undo and redo wait for that</source>
        <translation>Die Gefäße werden gerade neu gebaut: Rückgängig und Wiederholen warten darauf</translation>
    </message>
    <message>
        <source>Correcting the tree</source>
        <translation>Der Gefäßbaum wird korrigiert</translation>
    </message>
    <message>
        <source>The correction was taken back</source>
        <translation>Die Korrektur wurde zurückgenommen</translation>
    </message>
    <message>
        <source>Rebuilding the vessels</source>
        <translation>Die Gefäße werden neu gebaut</translation>
    </message>
    <message>
        <source>Not rebuilt: what was painted is still there</source>
        <translation>Nicht neu gebaut: Das Gemalte ist noch da</translation>
    </message>
    <message>
        <source>Reading the voxels</source>
        <translation>Die Voxel werden gelesen</translation>
    </message>
    <message>
        <source>Taking the rebuilding back</source>
        <translation>Der Neubau wird zurückgenommen</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>Writing the case</source>
        <translation>Der Fall wird geschrieben</translation>
    </message>
    <message>
        <source>Preparing the play</source>
        <translation>Die Simulation wird vorbereitet</translation>
    </message>
    <message>
        <source>a seed is three numbers</source>
        <translation>Ein Startpunkt besteht aus drei Zahlen</translation>
    </message>
    <message>
        <source>write x y z in mm for each seed, or leave it empty</source>
        <translation>Schreiben Sie für jeden Startpunkt x y z in mm, oder lassen Sie das Feld leer</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>separate numbers by blanks or semicolons</source>
        <translation>Trennen Sie Zahlen durch Leerzeichen oder Semikolons</translation>
    </message>
    <message>
        <source>Reconstruct a patient</source>
        <translation>Einen Patienten rekonstruieren</translation>
    </message>
    <message>
        <source>CT (folder or file)</source>
        <translation>CT (Ordner oder Datei)</translation>
    </message>
    <message>
        <source>Of the folder; the first shows the liver&apos;s vessels best</source>
        <translation>Des Ordners; die erste zeigt die Lebergefäße am besten</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Liver mask</source>
        <translation>Lebermaske</translation>
    </message>
    <message>
        <source>optional: speeds up and steadies the segmentation</source>
        <translation>freiwillig: macht die Segmentierung schneller und sicherer</translation>
    </message>
    <message>
        <source>Vessel mask</source>
        <translation>Gefäßmaske</translation>
    </message>
    <message>
        <source>optional: replaces the segmentation</source>
        <translation>freiwillig: ersetzt die Segmentierung</translation>
    </message>
    <message>
        <source>optional: lowest and highest HU of the vessels, as 140 260</source>
        <translation>freiwillig: kleinster und größter HU-Wert der Gefäße, etwa 140 260</translation>
    </message>
    <message>
        <source>Window (HU)</source>
        <translation>Fenster (HU)</translation>
    </message>
    <message>
        <source>Portal vein seeds</source>
        <translation>Startpunkte Pfortader</translation>
    </message>
    <message>
        <source>Hepatic vein seeds</source>
        <translation>Startpunkte Lebervenen</translation>
    </message>
    <message>
        <source>optional: x y z in LPS mm; next seed after a semicolon</source>
        <translation>freiwillig: x y z in LPS-mm; der nächste Startpunkt nach einem Semikolon</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Rekonstruieren</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner …</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei …</translation>
    </message>
    <message>
        <source>%1: %2, %3 images</source>
        <translation>%1: %2, %3 Bilder</translation>
    </message>
    <message>
        <source>, %L1 mm apart</source>
        <translation>, Abstand %L1 mm</translation>
    </message>
    <message>
        <source>nothing is chosen</source>
        <translation>nichts ist gewählt</translation>
    </message>
    <message>
        <source>choose a DICOM folder or a volume file</source>
        <translation>Wählen Sie einen DICOM-Ordner oder eine Volumendatei</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>a window is two numbers, the lower one first</source>
        <translation>Ein Fenster besteht aus zwei Zahlen, die kleinere zuerst</translation>
    </message>
    <message>
        <source>write for example 140 260, or leave it empty</source>
        <translation>Schreiben Sie etwa 140 260, oder lassen Sie das Feld leer</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>Tabelle speichern …</translation>
    </message>
    <message>
        <source>Pressure at the catheter</source>
        <translation>Druck am Katheter</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Pressure at the catheter (Pa)</source>
        <translation>Druck am Katheter (Pa)</translation>
    </message>
    <message>
        <source>Delivery</source>
        <translation>Abgabe</translation>
    </message>
    <message>
        <source>Drug that has passed the ends (%)</source>
        <translation>Wirkstoff jenseits der Enden (%)</translation>
    </message>
    <message>
        <source>the plots cannot be written</source>
        <translation>Die Kurven lassen sich nicht schreiben</translation>
    </message>
    <message numerus="yes">
        <source>%n more to do</source>
        <translation>
            <numerusform>%n weitere Aufgabe</numerusform>
            <numerusform>%n weitere Aufgaben</numerusform>
        </translation>
    </message>
    <message>
        <source>(%1 of %2)</source>
        <translation>(%1 von %2)</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>Speed or accuracy</source>
        <translation>Schnell oder genau</translation>
    </message>
    <message>
        <source>Automatic: as accurate as this computer can</source>
        <translation>Automatisch: so genau, wie dieser Rechner kann</translation>
    </message>
    <message>
        <source>Picks the most accurate setting whose frames are in time; moving the dial ends it</source>
        <translation>Wählt die genaueste Einstellung, deren Bilder rechtzeitig kommen; der Regler beendet das</translation>
    </message>
    <message>
        <source>fastest</source>
        <translation>am schnellsten</translation>
    </message>
    <message>
        <source>most accurate</source>
        <translation>am genauesten</translation>
    </message>
    <message>
        <source>The vessels, and what acts on them</source>
        <translation>Die Gefäße, und was auf sie wirkt</translation>
    </message>
    <message>
        <source>Gravity (patient on the back)</source>
        <translation>Schwerkraft (Patient in Rückenlage)</translation>
    </message>
    <message>
        <source>Tissue holds the vessels</source>
        <translation>Gewebe hält die Gefäße</translation>
    </message>
    <message>
        <source>Thickness of the vessels&apos; wall</source>
        <translation>Dicke der Gefäßwand</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>massiv</translation>
    </message>
    <message>
        <source>Vessels bend like pipes with a wall this thick, from %L1 to %L2 mm; 0, or more than the radius, is solid</source>
        <translation>Die Gefäße biegen sich wie Rohre mit einer Wand dieser Dicke, von %L1 bis %L2 mm; 0 oder mehr als der Radius ist massiv</translation>
    </message>
    <message>
        <source>Vessel wall</source>
        <translation>Gefäßwand</translation>
    </message>
    <message>
        <source>Expected error %1</source>
        <translation>Erwarteter Fehler %1</translation>
    </message>
    <message>
        <source>Expected error %1 against %2</source>
        <translation>Erwarteter Fehler %1 gegen %2</translation>
    </message>
    <message>
        <source>Expected error: not measured for this scene</source>
        <translation>Erwarteter Fehler: für diese Szene nicht gemessen</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n iteration(s) a step</source>
        <translation>
            <numerusform>%1; %n Iteration je Schritt</numerusform>
            <numerusform>%1; %n Iterationen je Schritt</numerusform>
        </translation>
    </message>
    <message>
        <source>, degraded</source>
        <translation>, vereinfacht</translation>
    </message>
    <message>
        <source>%1 holds changes that are not saved.</source>
        <translation>%1 enthält ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Save them as a case? Corrections that are still being made are waited for.</source>
        <translation>Als Fall speichern? Auf Korrekturen, die noch entstehen, wird gewartet.</translation>
    </message>
    <message>
        <source>There is a case %1 already. Replace it?</source>
        <translation>Es gibt schon einen Fall %1. Soll er ersetzt werden?</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Zuletz&amp;t benutzt</translation>
    </message>
    <message>
        <source>(missing)</source>
        <translation>(fehlt)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Rückblick</translation>
    </message>
    <message>
        <source>Co&amp;mpare with…</source>
        <translation>&amp;Vergleichen mit …</translation>
    </message>
    <message>
        <source>Show another recording of this patient beside it</source>
        <translation>Eine andere Aufzeichnung dieses Patienten daneben zeigen</translation>
    </message>
    <message>
        <source>Save a &amp;film…</source>
        <translation>&amp;Film speichern …</translation>
    </message>
    <message>
        <source>As one MP4 file where ffmpeg is installed, else as a folder of pictures</source>
        <translation>Als eine MP4-Datei, wo ffmpeg installiert ist, sonst als Ordner mit Bildern</translation>
    </message>
    <message>
        <source>It is still being gone through.</source>
        <translation>Sie wird noch durchlaufen.</translation>
    </message>
    <message>
        <source>&amp;Leave the review</source>
        <translation>&amp;Rückblick verlassen</translation>
    </message>
    <message>
        <source>To what happened before</source>
        <translation>Zum vorigen Ereignis</translation>
    </message>
    <message>
        <source>Play or stop</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>To what happens next</source>
        <translation>Zum nächsten Ereignis</translation>
    </message>
    <message>
        <source>How fast it is played; 1 is as it was</source>
        <translation>Wie schnell abgespielt wird; 1 ist wie es war</translation>
    </message>
    <message>
        <source>A note at this moment; Enter keeps it beside the recording</source>
        <translation>Eine Notiz zu diesem Augenblick; die Eingabetaste speichert sie neben der Aufzeichnung</translation>
    </message>
    <message>
        <source>A note at this moment</source>
        <translation>Notiz zu diesem Augenblick</translation>
    </message>
    <message>
        <source>Remove the note</source>
        <translation>Notiz entfernen</translation>
    </message>
    <message>
        <source>a lesson is being played, which this would end</source>
        <translation>Es läuft eine Lektion, die das beenden würde</translation>
    </message>
    <message>
        <source>Leave the lesson first</source>
        <translation>Verlassen Sie erst die Lektion</translation>
    </message>
    <message>
        <source>Reading the recording…</source>
        <translation>Die Aufzeichnung wird gelesen …</translation>
    </message>
    <message>
        <source>was played on another patient, of whom no case lies beside it</source>
        <translation>wurde an einem anderen Patienten gespielt, von dem kein Fall daneben liegt</translation>
    </message>
    <message>
        <source>Open the case that was played on first</source>
        <translation>Öffnen Sie erst den Fall, an dem gespielt wurde</translation>
    </message>
    <message>
        <source>No &amp;more beside it</source>
        <translation>&amp;Nichts mehr daneben</translation>
    </message>
    <message>
        <source>was played on another patient</source>
        <translation>wurde an einem anderen Patienten gespielt</translation>
    </message>
    <message>
        <source>Choose a recording of the patient who is shown</source>
        <translation>Wählen Sie eine Aufzeichnung des gezeigten Patienten</translation>
    </message>
    <message>
        <source>This is a recording. Leave the review to play yourself.</source>
        <translation>Dies ist eine Aufzeichnung. Verlassen Sie den Rückblick, um selbst zu üben.</translation>
    </message>
    <message>
        <source>%1, and beside it %2</source>
        <translation>%1, und daneben %2</translation>
    </message>
    <message>
        <source>%1: %2 % gone through</source>
        <translation>%1: %2 % durchlaufen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>What happened, and notes</source>
        <translation>Ereignisse und Notizen</translation>
    </message>
    <message>
        <source>beside: %1</source>
        <translation>daneben: %1</translation>
    </message>
    <message>
        <source>Save case as</source>
        <translation>Fall speichern unter</translation>
    </message>
    <message>
        <source>Cases (*.hep *.hepz)</source>
        <translation>Fälle (*.hep *.hepz)</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>the best for the liver&apos;s vessels</source>
        <translation>die beste für die Lebergefäße</translation>
    </message>
    <message>
        <source>of the best, %1</source>
        <translation>statt der besten, %1</translation>
    </message>
    <message>
        <source>Choose a series</source>
        <translation>Serie wählen</translation>
    </message>
    <message>
        <source>The folder holds several CT series. Which one is to be read?</source>
        <translation>Der Ordner enthält mehrere CT-Serien. Welche soll gelesen werden?</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Kernel</source>
        <translation>Kern</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>kein Bild</translation>
    </message>
    <message>
        <source>The slice in the middle cannot be shown</source>
        <translation>Die mittlere Schicht lässt sich nicht zeigen</translation>
    </message>
    <message>
        <source>The slice in the middle, in a window for soft tissue (L 40, W 400)</source>
        <translation>Die mittlere Schicht, in einem Weichteilfenster (L 40, W 400)</translation>
    </message>
    <message>
        <source>, %L1 % wider</source>
        <translation>, %L1 % weiter</translation>
    </message>
    <message>
        <source>, stenosis %L1 %</source>
        <translation>, Stenose %L1 %</translation>
    </message>
    <message>
        <source>There is no vessel. Click on one, or measure a distance</source>
        <translation>Dort ist kein Gefäß. Klicken Sie auf eines, oder messen Sie einen Abstand</translation>
    </message>
    <message>
        <source>%1, too near its end to judge a stenosis</source>
        <translation>%1, zu nah am Ende, um eine Stenose zu beurteilen</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Grey window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Which Hounsfield units are grey; right drag on a slice sets your own</source>
        <translation>Welche Hounsfield-Einheiten grau sind; Rechtsziehen auf einer Schicht stellt eigene ein</translation>
    </message>
    <message>
        <source>Opacity of the vessels over the CT</source>
        <translation>Deckkraft der Gefäße über dem CT</translation>
    </message>
    <message>
        <source>How strongly the vessels&apos; voxels are drawn over the CT</source>
        <translation>Wie kräftig die Voxel der Gefäße über dem CT gezeichnet werden</translation>
    </message>
    <message>
        <source>Centrelines</source>
        <translation>Mittellinien</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Couinaud&apos;s segments of the liver over the CT</source>
        <translation>Couinaud-Segmente der Leber über dem CT</translation>
    </message>
    <message>
        <source>Couinaud&apos;s segments 1 to 8, in the colours of the branches that supply them (F6)</source>
        <translation>Couinaud-Segmente 1 bis 8, in den Farben der Äste, die sie versorgen (F6)</translation>
    </message>
    <message>
        <source>What a click in a slice does</source>
        <translation>Was ein Klick in einer Schicht tut</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Draw a vessel</source>
        <translation>Gefäß zeichnen</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Korrigieren</translation>
    </message>
    <message>
        <source>Paint vessels</source>
        <translation>Gefäße malen</translation>
    </message>
    <message>
        <source>Erase vessels</source>
        <translation>Gefäße radieren</translation>
    </message>
    <message>
        <source>Distance: two clicks. Angle: three, its vertex second. Diameter: a click on a vessel, at whose centreline it is taken, with the stenosis against the vessel beside. Draw a vessel: clicks along one that is missing, in any slices, from where its blood comes in; Enter draws it. Delete takes the last away, Escape ends it. Correct: a click on a vessel does what the panel of corrections says. Paint, erase: a drag leads a ball through the vessels&apos; voxels; Rebuild makes the vessels anew of them</source>
        <translation>Abstand: zwei Klicks. Winkel: drei, der zweite ist der Scheitel. Durchmesser: ein Klick auf ein Gefäß, an dessen Mittellinie er gemessen wird, mit der Stenose gegen das Gefäß daneben. Gefäß zeichnen: Klicks entlang eines fehlenden Gefäßes, in beliebigen Schichten, von dort an, wo sein Blut eintritt; die Eingabetaste zeichnet es. Entf nimmt den letzten weg, Esc beendet es. Korrigieren: Ein Klick auf ein Gefäß tut, was das Bedienfeld der Korrekturen sagt. Malen, radieren: Ziehen führt eine Kugel durch die Voxel der Gefäße; Neu bauen macht die Gefäße daraus neu</translation>
    </message>
    <message>
        <source>Click where the distance begins, then where it ends</source>
        <translation>Klicken Sie, wo der Abstand beginnt, dann, wo er endet</translation>
    </message>
    <message>
        <source>Click on one arm, on the vertex, on the other arm</source>
        <translation>Klicken Sie auf einen Schenkel, den Scheitel, den anderen Schenkel</translation>
    </message>
    <message>
        <source>Click on a vessel</source>
        <translation>Klicken Sie auf ein Gefäß</translation>
    </message>
    <message>
        <source>A click on a vessel: %1 (panel Corrections); Escape ends it</source>
        <translation>Ein Klick auf ein Gefäß: %1 (Bedienfeld Korrekturen); Esc beendet es</translation>
    </message>
    <message>
        <source>Drag over what is vessel (+ and - size the brush), then Rebuild</source>
        <translation>Ziehen Sie über das, was Gefäß ist (+ und - ändern die Größe), dann Neu bauen</translation>
    </message>
    <message>
        <source>Drag over what is no vessel (+ and - size the brush), then Rebuild</source>
        <translation>Ziehen Sie über das, was kein Gefäß ist (+ und - ändern die Größe), dann Neu bauen</translation>
    </message>
    <message>
        <source>Click where the missing vessel begins, then along it</source>
        <translation>Klicken Sie, wo das fehlende Gefäß beginnt, dann an ihm entlang</translation>
    </message>
    <message>
        <source>Click on along the vessel</source>
        <translation>Klicken Sie weiter am Gefäß entlang</translation>
    </message>
    <message>
        <source>Click on along the vessel, or draw it (Enter)</source>
        <translation>Klicken Sie weiter am Gefäß entlang, oder zeichnen Sie es (Eingabetaste)</translation>
    </message>
    <message>
        <source>Draw it</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Follows the vessel through the places that were clicked (Enter)</source>
        <translation>Folgt dem Gefäß durch die angeklickten Orte (Eingabetaste)</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radius des Pinsels</translation>
    </message>
    <message>
        <source>Radius of the ball that is led through the voxels</source>
        <translation>Radius der Kugel, die durch die Voxel geführt wird</translation>
    </message>
    <message>
        <source>Rebuild</source>
        <translation>Neu bauen</translation>
    </message>
    <message>
        <source>Makes the vessels anew of their voxels as they are painted now. Corrections are made again where they still can be</source>
        <translation>Macht die Gefäße aus ihren Voxeln neu, wie sie jetzt gemalt sind. Korrekturen werden wiederholt, wo sie noch möglich sind</translation>
    </message>
    <message>
        <source>This case knows no voxels of its vessels</source>
        <translation>Dieser Fall kennt keine Voxel seiner Gefäße</translation>
    </message>
    <message>
        <source>Too far from the liver: the vessels&apos; voxels end before</source>
        <translation>Zu weit von der Leber: Die Voxel der Gefäße enden vorher</translation>
    </message>
    <message>
        <source>segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>%1, radius %L2 mm</source>
        <translation>%1, Radius %L2 mm</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>Schicht: %1</translation>
    </message>
    <message>
        <source>Not drawn: it was stopped. Enter draws it, Escape drops its places</source>
        <translation>Nicht gezeichnet: Es wurde angehalten. Die Eingabetaste zeichnet es, Esc verwirft seine Orte</translation>
    </message>
    <message>
        <source>A vessel needs two places at least: click on the next one</source>
        <translation>Ein Gefäß braucht mindestens zwei Orte: Klicken Sie auf den nächsten</translation>
    </message>
    <message>
        <source>Following the vessel; Escape stops it</source>
        <translation>Dem Gefäß wird gefolgt; Esc hält an</translation>
    </message>
    <message>
        <source>This case holds no segments of the liver: they are known where there are a liver mask and a portal vein</source>
        <translation>Dieser Fall enthält keine Lebersegmente: Bekannt sind sie, wo es eine Lebermaske und eine Pfortader gibt</translation>
    </message>
    <message>
        <source>The segments cannot be read: %1</source>
        <translation>Die Segmente lassen sich nicht lesen: %1</translation>
    </message>
    <message>
        <source>Choose the CT…</source>
        <translation>CT wählen …</translation>
    </message>
    <message>
        <source>The segments are being read</source>
        <translation>Die Segmente werden gelesen</translation>
    </message>
    <message>
        <source>Reading the CT…</source>
        <translation>Das CT wird gelesen …</translation>
    </message>
    <message>
        <source>Open a patient to see slices of the CT.</source>
        <translation>Öffnen Sie einen Patienten, um Schichten des CTs zu sehen.</translation>
    </message>
    <message>
        <source>Wall time of one step of the simulation</source>
        <translation>Echtzeit eines Schritts der Simulation</translation>
    </message>
    <message>
        <source>Simulated time over wall time: 1 is real time, less is slower</source>
        <translation>Simulierte Zeit durch Echtzeit: 1 ist Echtzeit, weniger ist langsamer</translation>
    </message>
    <message>
        <source>Time of the last picture, until it was on the screen</source>
        <translation>Zeit des letzten Bildes, bis es auf dem Bildschirm war</translation>
    </message>
    <message>
        <source>The OpenGL renderer</source>
        <translation>Der OpenGL-Grafiktreiber</translation>
    </message>
    <message>
        <source>step %L1 ms</source>
        <translation>Schritt %L1 ms</translation>
    </message>
    <message>
        <source>held</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>real time × %L1</source>
        <translation>Echtzeit × %L1</translation>
    </message>
    <message>
        <source>expected error %1</source>
        <translation>erwarteter Fehler %1</translation>
    </message>
    <message>
        <source>Of the present setting of the dial, measured against %1</source>
        <translation>Der gegenwärtigen Einstellung des Reglers, gemessen gegen %1</translation>
    </message>
    <message>
        <source>picture %1 ms</source>
        <translation>Bild %1 ms</translation>
    </message>
    <message>
        <source>Time line of the recording</source>
        <translation>Zeitleiste der Aufzeichnung</translation>
    </message>
    <message>
        <source>Click or drag to go to a moment; the coloured ticks are what happened</source>
        <translation>Klicken oder ziehen Sie, um zu einem Augenblick zu gehen; die farbigen Striche sind die Ereignisse</translation>
    </message>
    <message>
        <source>; bleeds %L1 g/s, %L2 g so far</source>
        <translation>; blutet %L1 g/s, bisher %L2 g</translation>
    </message>
    <message>
        <source>; bleeds %L1 mL/min, %L2 mL so far</source>
        <translation>; blutet %L1 mL/min, bisher %L2 mL</translation>
    </message>
    <message>
        <source>What it feels</source>
        <translation>Was es spürt</translation>
    </message>
    <message>
        <source>Force on the tool</source>
        <translation>Kraft auf das Werkzeug</translation>
    </message>
    <message>
        <source>Force with which the jaws hold</source>
        <translation>Kraft, mit der die Backen halten</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>%1 of the tool</source>
        <translation>%1 des Werkzeugs</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Tearing</source>
        <translation>Reißen</translation>
    </message>
    <message>
        <source>Vessels tear</source>
        <translation>Gefäße reißen</translation>
    </message>
    <message>
        <source>Vessels that are pulled beyond their strength tear; off makes them whole</source>
        <translation>Gefäße, an denen über ihre Festigkeit hinaus gezogen wird, reißen; aus macht sie wieder heil</translation>
    </message>
    <message>
        <source>Tear factor: share of the tissue&apos;s strength</source>
        <translation>Reißfaktor: Anteil an der Festigkeit des Gewebes</translation>
    </message>
    <message>
        <source>Share of the tissue&apos;s strength at which it tears: the tear factor</source>
        <translation>Anteil an der Festigkeit des Gewebes, bei dem es reißt: der Reißfaktor</translation>
    </message>
    <message>
        <source>Tear factor</source>
        <translation>Reißfaktor</translation>
    </message>
    <message>
        <source>Strength along a cut line</source>
        <translation>Festigkeit entlang einer Schwächungslinie</translation>
    </message>
    <message>
        <source>What is left of the strength along a cut line that you draw</source>
        <translation>Was entlang einer gezeichneten Schwächungslinie von der Festigkeit übrig bleibt</translation>
    </message>
    <message>
        <source>Along a line</source>
        <translation>Entlang Linie</translation>
    </message>
    <message>
        <source>Warning colours</source>
        <translation>Warnfarben</translation>
    </message>
    <message>
        <source>Yellow: loaded to more than half of what the vessel bears; red: about to tear</source>
        <translation>Gelb: über die Hälfte dessen belastet, was das Gefäß trägt; rot: kurz vor dem Reißen</translation>
    </message>
    <message>
        <source>How the vessels are torn</source>
        <translation>Wie die Gefäße gerissen sind</translation>
    </message>
    <message>
        <source>whole</source>
        <translation>heil</translation>
    </message>
    <message>
        <source>nothing torn</source>
        <translation>nichts gerissen</translation>
    </message>
    <message>
        <source>%1 joints torn, %2 pieces, entropy produced %L3 nats</source>
        <translation>%1 Verbindungen gerissen, %2 Stücke, erzeugte Entropie %L3 nat</translation>
    </message>
    <message>
        <source>; stopped by the %1 budget</source>
        <translation>; angehalten vom Budget für %1</translation>
    </message>
    <message>
        <source>Take a tool from the bar above the view.</source>
        <translation>Nehmen Sie ein Werkzeug aus der Leiste über der Ansicht.</translation>
    </message>
    <message>
        <source>The mouse leads its tip, the wheel moves it in depth (Ctrl + wheel zooms), T and Shift + T turn it, C closes and opens forceps. Esc puts it away.</source>
        <translation>Die Maus führt seine Spitze, das Mausrad bewegt es in die Tiefe (Strg + Mausrad vergrößert), T und Umschalt + T drehen es, C schließt und öffnet die Pinzette. Esc legt es weg.</translation>
    </message>
    <message>
        <source>no tool</source>
        <translation>kein Werkzeug</translation>
    </message>
    <message>
        <source>pulls at nothing</source>
        <translation>zieht an nichts</translation>
    </message>
    <message>
        <source>touches nothing</source>
        <translation>berührt nichts</translation>
    </message>
    <message>
        <source>Pull %1</source>
        <translation>Zug %1</translation>
    </message>
    <message>
        <source>Force %1</source>
        <translation>Kraft %1</translation>
    </message>
    <message>
        <source>, the most it has</source>
        <translation>, mehr hat es nicht</translation>
    </message>
    <message>
        <source>Grip %1</source>
        <translation>Griff %1</translation>
    </message>
    <message>
        <source>at the tip</source>
        <translation>an der Spitze</translation>
    </message>
    <message>
        <source>past the ends</source>
        <translation>jenseits der Enden</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>Choose a disk with more room</source>
        <translation>Wählen Sie einen Datenträger mit mehr Platz</translation>
    </message>
    <message>
        <source>holds the pictures of another film</source>
        <translation>enthält die Bilder eines anderen Films</translation>
    </message>
    <message>
        <source>Choose an empty folder</source>
        <translation>Wählen Sie einen leeren Ordner</translation>
    </message>
    <message>
        <source>ffmpeg could not make it: %1</source>
        <translation>ffmpeg konnte ihn nicht machen: %1</translation>
    </message>
    <message>
        <source>Save a folder of pictures instead</source>
        <translation>Speichern Sie stattdessen einen Ordner mit Bildern</translation>
    </message>
    <message>
        <source>needs the program ffmpeg, which is not installed</source>
        <translation>braucht das Programm ffmpeg, das nicht installiert ist</translation>
    </message>
    <message>
        <source>Install it (apt install ffmpeg), or save a folder of pictures</source>
        <translation>Installieren Sie es (apt install ffmpeg), oder speichern Sie einen Ordner mit Bildern</translation>
    </message>
    <message>
        <source>%1 (at rest)</source>
        <translation>%1 (in Ruhe)</translation>
    </message>
    <message>
        <source>Click on a vessel where the distance begins</source>
        <translation>Klicken Sie auf ein Gefäß, wo der Abstand beginnt</translation>
    </message>
    <message>
        <source>Click where it ends</source>
        <translation>Klicken Sie, wo er endet</translation>
    </message>
    <message>
        <source>Click on one arm of the angle</source>
        <translation>Klicken Sie auf einen Schenkel des Winkels</translation>
    </message>
    <message>
        <source>Click on its vertex</source>
        <translation>Klicken Sie auf seinen Scheitel</translation>
    </message>
    <message>
        <source>Click on the other arm</source>
        <translation>Klicken Sie auf den anderen Schenkel</translation>
    </message>
    <message>
        <source>Click on a vessel: its diameter there, and the stenosis against the vessel beside</source>
        <translation>Klicken Sie auf ein Gefäß: sein Durchmesser dort, und die Stenose gegen das Gefäß daneben</translation>
    </message>
    <message>
        <source>Practise on a patient&apos;s own liver vessels.
Drop a CT folder, a volume file or a case here, or begin with</source>
        <translation>Üben an den Lebergefäßen eines Patienten.
Legen Sie einen CT-Ordner, eine Volumendatei oder einen Fall hier ab, oder beginnen Sie mit</translation>
    </message>
    <message>
        <source>A CT folder (DICOM)…</source>
        <translation>CT-Ordner (DICOM) …</translation>
    </message>
    <message>
        <source>A CT file (NIfTI, MetaImage, NRRD)…</source>
        <translation>CT-Datei (NIfTI, MetaImage, NRRD) …</translation>
    </message>
    <message>
        <source>A case that was reconstructed before…</source>
        <translation>Früher rekonstruierter Fall …</translation>
    </message>
    <message numerus="yes">
        <source>%n more under All messages.</source>
        <translation>
            <numerusform>%n weitere unter Alle Meldungen.</numerusform>
            <numerusform>%n weitere unter Alle Meldungen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Lang&amp;uage</source>
        <translation>S&amp;prache</translation>
    </message>
</context>
</TS>

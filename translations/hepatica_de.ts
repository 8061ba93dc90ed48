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
        <source>Take back the last correction of the tree</source>
        <translation>Die letzte Korrektur des Gefäßbaums zurücknehmen</translation>
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
        <translation>Vor&amp;n</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Blick von vorn</translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation>H&amp;inten</translation>
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
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Look from the head</source>
        <translation>Blick vom Kopf her</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>Un&amp;ten</translation>
    </message>
    <message>
        <source>Look from the feet</source>
        <translation>Blick von den Füßen her</translation>
    </message>
    <message>
        <source>Show legend, scale bar and orientation</source>
        <translation>Legende, Maßstabsbalken und Orientierung zeigen</translation>
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
        <source>Take away what lies in front of a plane across the line of sight</source>
        <translation>Wegnehmen, was vor einer Ebene quer zur Blickrichtung liegt</translation>
    </message>
    <message>
        <source>Move that plane 2 mm away from where it was put</source>
        <translation>Diese Ebene um 2 mm weiter in die Tiefe schieben</translation>
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
        <translation>Tabelle der &amp;Äste</translation>
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
        <source>Light, for lecture rooms and print</source>
        <translation>Hell, für Hörsäle und Druck</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Hoher Kontra&amp;st</translation>
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
        <source>Hover</source>
        <translation>Zeigen auf ein Gefäß</translation>
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
        <source>Given to: %1</source>
        <translation>Zugeordnet: %1</translation>
    </message>
    <message>
        <source>Nothing to do: it is of this system already (%1)</source>
        <translation>Nichts zu tun: Das Gefäß gehört schon zu diesem System (%1)</translation>
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
        <source>Now click the vessel to link it with</source>
        <translation>Klicken Sie nun auf das Gefäß, mit dem es verbunden werden soll</translation>
    </message>
    <message>
        <source>No vessel there: click on one (by keys: Enter with the cross on it)</source>
        <translation>Dort ist kein Gefäß: Klicken Sie auf eines (mit Tasten: Eingabe, wenn das Kreuz auf einem liegt)</translation>
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
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Cut the vessel</source>
        <translation>Gefäß durchtrennen</translation>
    </message>
    <message>
        <source>Click where to cut it</source>
        <translation>Klicken Sie, wo es durchtrennt werden soll</translation>
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
        <translation>ohne Wert</translation>
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
        <source>Gas, as in the paper</source>
        <translation>Gas, wie in der Veröffentlichung</translation>
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
        <translation>Grenzen und &amp;Bestehensgrenzen</translation>
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
        <translation>Wiederh&amp;olen</translation>
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
        <source>&amp;Give it a target</source>
        <translation>&amp;Zielgebiet angeben</translation>
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
        <translation>Zielgebiet des Wirkstoffs</translation>
    </message>
    <message>
        <source>The vessels beyond this place. What is delivered there is the dose in the target, all other is elsewhere.</source>
        <translation>Die Gefäße jenseits dieses Orts. Was dort ankommt, ist die Dosis im Zielgebiet, alles andere geht daneben.</translation>
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
        <source>Write a &amp;report…</source>
        <translation>Be&amp;richt schreiben …</translation>
    </message>
    <message>
        <source>All &amp;attempts…</source>
        <translation>Alle &amp;Versuche …</translation>
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
        <source>&amp;Save as one file…</source>
        <translation>Als eine Datei &amp;speichern …</translation>
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
        <source>Reading the case…</source>
        <translation>Der Fall wird gelesen …</translation>
    </message>
    <message>
        <source>Copying the case into this folder…</source>
        <translation>Der Fall wird in diesen Ordner kopiert …</translation>
    </message>
    <message>
        <source>Writing the case into one file…</source>
        <translation>Der Fall wird in eine Datei geschrieben …</translation>
    </message>
    <message>
        <source>%1 These buttons wait for it.</source>
        <translation>%1 Darauf warten diese Schaltflächen.</translation>
    </message>
    <message>
        <source>“%1” lies in this folder already, and was not copied.</source>
        <translation>„%1“ liegt schon in diesem Ordner und wurde nicht kopiert.</translation>
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
        <translation>Start</translation>
    </message>
    <message>
        <source>%1 is not there any more; it was taken off the list of recent files.</source>
        <translation>%1 ist nicht mehr da; der Eintrag wurde aus der Liste der zuletzt benutzten Dateien genommen.</translation>
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
        <source>the program that writes the report ended without a word</source>
        <translation>das Programm, das den Bericht schreibt, endete ohne ein Wort</translation>
    </message>
    <message>
        <source>close other programs and write it again</source>
        <translation>Schließen Sie andere Programme und schreiben Sie ihn noch einmal</translation>
    </message>
    <message>
        <source>the program could not be started again</source>
        <translation>das Programm ließ sich nicht noch einmal starten</translation>
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
        <source>Drag a vessel to pull it (by keys: Enter at the cross, then arrows)</source>
        <translation>Ziehen Sie an einem Gefäß (mit Tasten: Eingabe am Kreuz, dann Pfeile)</translation>
    </message>
    <message>
        <source>Click on a vessel to inject there (by keys: Enter at the cross)</source>
        <translation>Klicken Sie auf ein Gefäß, um dort zu injizieren (mit Tasten: Eingabe am Kreuz)</translation>
    </message>
    <message>
        <source>Click on a vessel to correct the tree (by keys: Enter at the cross)</source>
        <translation>Klicken Sie auf ein Gefäß, um den Gefäßbaum zu korrigieren (mit Tasten: Eingabe am Kreuz)</translation>
    </message>
    <message>
        <source>Click on a vessel: the place is there</source>
        <translation>Klicken Sie auf ein Gefäß: Dort ist der Ort</translation>
    </message>
    <message>
        <source>Click on a vessel: the place is there (by keys: Enter at the cross)</source>
        <translation>Klicken Sie auf ein Gefäß: Dort ist der Ort (mit Tasten: Eingabe am Kreuz)</translation>
    </message>
    <message>
        <source>Draw a line across a vessel to cut it (by keys: Enter, arrows, Enter)</source>
        <translation>Ziehen Sie eine Linie quer über ein Gefäß, um es zu durchtrennen (mit Tasten: Eingabe, Pfeile, Eingabe)</translation>
    </message>
    <message>
        <source>Draw a line across a vessel: it tears there when pulled (by keys: Enter, arrows, Enter)</source>
        <translation>Ziehen Sie eine Linie quer über ein Gefäß: Dort reißt es unter Zug (mit Tasten: Eingabe, Pfeile, Eingabe)</translation>
    </message>
    <message>
        <source>The mouse leads the tool, the wheel moves it in depth, a click brings it to a vessel (by keys: arrows, Page Up/Down, Enter)</source>
        <translation>Die Maus führt das Werkzeug, das Rad bewegt es in die Tiefe, ein Klick bringt es an ein Gefäß (Tasten: Pfeile, Bild auf/ab, Eingabe)</translation>
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
        <source>The language changes at the next start.</source>
        <translation>Die Sprache wechselt beim nächsten Start.</translation>
    </message>
    <message>
        <source>Restart now</source>
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
        <source>Cancelled: %1</source>
        <translation>Abgebrochen: %1</translation>
    </message>
    <message>
        <source>Cancels this alone: %1</source>
        <translation>Bricht nur dies ab: %1</translation>
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
        <source>The window closes as soon as the report is written. Cancel closes it without the report.</source>
        <translation>Das Fenster schließt sich, sobald der Bericht geschrieben ist. „Abbrechen“ schließt es ohne den Bericht.</translation>
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
        <translation>optional: schneller und sicherer</translation>
    </message>
    <message>
        <source>Vessel mask</source>
        <translation>Gefäßmaske</translation>
    </message>
    <message>
        <source>optional: replaces the segmentation</source>
        <translation>optional: ersetzt die Segmentierung</translation>
    </message>
    <message>
        <source>optional: lowest and highest HU of the vessels, as 140 260</source>
        <translation>optional: kleinster und größter HU-Wert, etwa 140 260</translation>
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
        <source>Expected error: not measured for this scene</source>
        <translation>Erwarteter Fehler: für diese Szene nicht gemessen</translation>
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
        <source>(missing)</source>
        <translation>(fehlt)</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Rückblick</translation>
    </message>
    <message>
        <source>Show another recording of this patient beside it</source>
        <translation>Eine andere Aufzeichnung dieses Patienten daneben zeigen</translation>
    </message>
    <message>
        <source>As one MP4 file where ffmpeg is installed, else as a folder of pictures</source>
        <translation>Als eine MP4-Datei, wo ffmpeg installiert ist, sonst als Ordner mit Bildern</translation>
    </message>
    <message>
        <source>The recording is still being read.</source>
        <translation>Die Aufzeichnung wird noch gelesen.</translation>
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
        <translation>wurde an einem anderen Patienten geübt, von dem kein Fall daneben liegt</translation>
    </message>
    <message>
        <source>was played on another patient</source>
        <translation>wurde an einem anderen Patienten geübt</translation>
    </message>
    <message>
        <source>Choose a recording of the patient who is shown</source>
        <translation>Wählen Sie eine Aufzeichnung des gezeigten Patienten</translation>
    </message>
    <message>
        <source>The play from before is shown again</source>
        <translation>Die Übung von vorhin ist wieder da</translation>
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
        <source>%1: %2 % of the recording read</source>
        <translation>%1: %2 % der Aufzeichnung gelesen</translation>
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
        <source>Click where the distance begins, then where it ends</source>
        <translation>Klicken Sie auf Anfang und Ende</translation>
    </message>
    <message>
        <source>Click on one arm, on the vertex, on the other arm</source>
        <translation>Klicken Sie auf Schenkel, Scheitel, Schenkel</translation>
    </message>
    <message>
        <source>Click on a vessel</source>
        <translation>Klicken Sie auf ein Gefäß</translation>
    </message>
    <message>
        <source>A click on a vessel: %1 (panel Corrections); Escape ends it</source>
        <translation>Klick auf ein Gefäß: %1 (Korrekturen); Esc beendet</translation>
    </message>
    <message>
        <source>Drag over what is vessel (+ and - size the brush), then Rebuild</source>
        <translation>Ziehen Sie über Gefäße (+, -: Größe), dann Neu bauen</translation>
    </message>
    <message>
        <source>Drag over what is no vessel (+ and - size the brush), then Rebuild</source>
        <translation>Ziehen Sie über Falsches (+, -: Größe), dann Neu bauen</translation>
    </message>
    <message>
        <source>Click where the missing vessel begins, then along it</source>
        <translation>Klicken Sie vom Anfang des Gefäßes an ihm entlang</translation>
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
        <source>; bleeds %1, %L2 g so far</source>
        <translation>; blutet %1, bisher %L2 g</translation>
    </message>
    <message>
        <source>; bleeds %1, %L2 mL so far</source>
        <translation>; blutet %1, bisher %L2 mL</translation>
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
        <source>; stopped by the %1 budget</source>
        <translation>; angehalten vom Budget für %1</translation>
    </message>
    <message>
        <source>Take a tool from the bar above the view.</source>
        <translation>Nehmen Sie ein Werkzeug aus der Leiste über der Ansicht.</translation>
    </message>
    <message>
        <source>The mouse leads its tip, the wheel moves it in depth (Ctrl + wheel zooms), a click brings it to a vessel, T and Shift + T turn it, C closes and opens forceps. By keys: Enter brings it to the cross, arrows lead it, Page Up and Page Down move it in depth. Esc puts it away.</source>
        <translation>Die Maus führt seine Spitze, das Mausrad bewegt es in die Tiefe (Strg + Mausrad vergrößert), ein Klick bringt es an ein Gefäß, T und Umschalt + T drehen es, C schließt und öffnet die Pinzette. Mit Tasten: Die Eingabetaste bringt es an das Kreuz, Pfeile führen es, Bild auf und Bild ab bewegen es in die Tiefe. Esc legt es weg.</translation>
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
        <source>Click where it ends</source>
        <translation>Klicken Sie, wo er endet</translation>
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
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Look around</source>
        <translation>Sich umsehen</translation>
    </message>
    <message>
        <source>Gentle pull</source>
        <translation>Sanft ziehen</translation>
    </message>
    <message>
        <source>Probe a branch free</source>
        <translation>Einen Ast freilegen</translation>
    </message>
    <message>
        <source>Selective injection</source>
        <translation>Selektive Injektion</translation>
    </message>
    <message>
        <source>Hold a bleeding vessel</source>
        <translation>Ein blutendes Gefäß halten</translation>
    </message>
    <message>
        <source>The cut line</source>
        <translation>Die Schwächungslinie</translation>
    </message>
    <message>
        <source>Embolization</source>
        <translation>Embolisation</translation>
    </message>
    <message>
        <source>Take the probe and bring its tip near the first mark.</source>
        <translation>Nehmen Sie die Sonde, und führen Sie ihre Spitze an die erste Marke heran.</translation>
    </message>
    <message>
        <source>Now near the second mark, around the vessels between.</source>
        <translation>Nun an die zweite Marke heran, um die Gefäße dazwischen herum.</translation>
    </message>
    <message>
        <source>Move the probe towards you with the wheel first.</source>
        <translation>Bewegen Sie die Sonde mit dem Mausrad erst auf sich zu.</translation>
    </message>
    <message>
        <source>And near the third.</source>
        <translation>Und an die dritte heran.</translation>
    </message>
    <message>
        <source>the first mark</source>
        <translation>erste Marke</translation>
    </message>
    <message>
        <source>the second mark</source>
        <translation>zweite Marke</translation>
    </message>
    <message>
        <source>the third mark</source>
        <translation>dritte Marke</translation>
    </message>
    <message>
        <source>the mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>the branch</source>
        <translation>Ast</translation>
    </message>
    <message>
        <source>the target&apos;s vessel</source>
        <translation>Gefäß des Zielgebiets</translation>
    </message>
    <message>
        <source>the stump</source>
        <translation>Stumpf</translation>
    </message>
    <message>
        <source>the line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>the hold</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>Take hold of the vessel at the mark.</source>
        <translation>Fassen Sie das Gefäß an der Marke.</translation>
    </message>
    <message>
        <source>Press the left mouse button on the vessel and keep it down.</source>
        <translation>Drücken Sie auf dem Gefäß die linke Maustaste, und halten Sie sie gedrückt.</translation>
    </message>
    <message>
        <source>Pull it 8 mm aside and hold it there for a second.</source>
        <translation>Ziehen Sie es 8 mm beiseite, und halten Sie es dort eine Sekunde lang.</translation>
    </message>
    <message>
        <source>Let go and wait until it has swung back.</source>
        <translation>Lassen Sie los, und warten Sie, bis es zurückgeschwungen ist.</translation>
    </message>
    <message>
        <source>Release the button.</source>
        <translation>Lassen Sie die Taste los.</translation>
    </message>
    <message>
        <source>Lift a branch with a rod so that a way opens behind it, and leave it whole. The tissue around is springs: it gives way and pulls back, but nothing is glued to the branch.</source>
        <translation>Heben Sie einen Ast mit einem Stab an, sodass sich dahinter ein Weg öffnet, und lassen Sie ihn heil. Das Gewebe ringsum besteht aus Federn: Es gibt nach und zieht zurück, aber nichts klebt am Ast.</translation>
    </message>
    <message>
        <source>Touch the marked branch with the rod.</source>
        <translation>Berühren Sie den markierten Ast mit dem Stab.</translation>
    </message>
    <message>
        <source>Key 5 takes the rod; T turns it.</source>
        <translation>Taste 5 nimmt den Stab; T dreht ihn.</translation>
    </message>
    <message>
        <source>Move the branch by 4 mm and keep it there for half a second.</source>
        <translation>Bewegen Sie den Ast um 4 mm, und halten Sie ihn dort eine halbe Sekunde lang.</translation>
    </message>
    <message>
        <source>Push across the branch, not along it.</source>
        <translation>Drücken Sie quer zum Ast, nicht längs.</translation>
    </message>
    <message>
        <source>Take the rod away and let the branch come back.</source>
        <translation>Nehmen Sie den Stab weg, und lassen Sie den Ast zurückkommen.</translation>
    </message>
    <message>
        <source>Draw back the way you came; Esc puts the tool away.</source>
        <translation>Ziehen Sie sich auf demselben Weg zurück; Esc legt das Werkzeug weg.</translation>
    </message>
    <message>
        <source>Bring 3 g of drug into the left territory and as little as possible elsewhere. The tip lies free in the vessel: what it injects also runs back, the more the nearer it is to the root.</source>
        <translation>Bringen Sie 3 g Wirkstoff in das linke Gebiet und möglichst wenig anderswohin. Die Spitze liegt frei im Gefäß: Was sie injiziert, läuft auch zurück, umso mehr, je näher sie der Wurzel ist.</translation>
    </message>
    <message>
        <source>Inject so that 3 g reach the target&apos;s tissue.</source>
        <translation>Injizieren Sie so, dass 3 g das Gewebe des Zielgebiets erreichen.</translation>
    </message>
    <message>
        <source>Draw a cut line across a branch and pull it off along the line. Without the line the pull would stretch the branch long before it tears.</source>
        <translation>Ziehen Sie eine Schwächungslinie quer über einen Ast, und ziehen Sie ihn entlang der Linie ab. Ohne die Linie würde der Zug den Ast weit dehnen, ehe er reißt.</translation>
    </message>
    <message>
        <source>Draw a cut line across the branch at the first mark, take the branch at the second and pull until it comes off.</source>
        <translation>Ziehen Sie an der ersten Marke eine Schwächungslinie quer über den Ast, fassen Sie den Ast an der zweiten, und ziehen Sie, bis er abgeht.</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>Hepatic veins</source>
        <translation>Lebervenen</translation>
    </message>
    <message>
        <source>Artery</source>
        <translation>Leberarterie</translation>
    </message>
    <message>
        <source>Unknown system</source>
        <translation>Unbekanntes System</translation>
    </message>
    <message>
        <source>Built-in patient</source>
        <translation>Eingebauter Patient</translation>
    </message>
    <message>
        <source>internal error: %1</source>
        <translation>Interner Fehler: %1</translation>
    </message>
    <message>
        <source>%1, %2, %3 mm</source>
        <translation>%1; %2; %3 mm</translation>
    </message>
    <message>
        <source>cannot be written (%1)</source>
        <translation>lässt sich nicht schreiben (%1)</translation>
    </message>
    <message>
        <source>cannot be written to its end</source>
        <translation>lässt sich nicht bis zum Ende schreiben</translation>
    </message>
    <message>
        <source>Check that the folder exists, may be written and has free space</source>
        <translation>Prüfen Sie, ob der Ordner existiert, beschreibbar ist und freien Platz hat</translation>
    </message>
    <message>
        <source>was in the folder and could not be put back into it</source>
        <translation>war im Ordner und ließ sich nicht zurücklegen</translation>
    </message>
    <message>
        <source>Move it to %1 by hand</source>
        <translation>Verschieben Sie es von Hand nach %1</translation>
    </message>
    <message>
        <source>cannot be started (%1)</source>
        <translation>lässt sich nicht starten (%1)</translation>
    </message>
    <message>
        <source>End other programs, and try again</source>
        <translation>Beenden Sie andere Programme, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>lässt sich nicht lesen (%1)</translation>
    </message>
    <message>
        <source>cannot be read; check its permissions</source>
        <translation>lässt sich nicht lesen; prüfen Sie die Zugriffsrechte</translation>
    </message>
    <message>
        <source>Check that it exists</source>
        <translation>Prüfen Sie, ob die Datei existiert</translation>
    </message>
    <message>
        <source>Check that it exists and may be read</source>
        <translation>Prüfen Sie, ob die Datei existiert und lesbar ist</translation>
    </message>
    <message>
        <source>must be a whole number in range, but is %1</source>
        <translation>muss eine ganze Zahl im erlaubten Bereich sein, ist aber %1</translation>
    </message>
    <message>
        <source>is damaged (%1)</source>
        <translation>ist beschädigt (%1)</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>ist beschädigt</translation>
    </message>
    <message>
        <source>%1 mm, which is farther than %2 m from the origin of its coordinates</source>
        <translation>%1 mm, weiter als %2 m vom Ursprung der Koordinaten</translation>
    </message>
    <message>
        <source>Check the unit of its positions and export it again in millimetres</source>
        <translation>Prüfen Sie die Einheit der Positionen, und exportieren Sie noch einmal in Millimetern</translation>
    </message>
    <message>
        <source>a file of the program itself is missing</source>
        <translation>Eine Datei des Programms selbst fehlt</translation>
    </message>
    <message>
        <source>Install Hepatica again, or run it where it was built</source>
        <translation>Installieren Sie Hepatica neu, oder starten Sie es dort, wo es gebaut wurde</translation>
    </message>
    <message>
        <source>is no folder for temporary files</source>
        <translation>ist kein Ordner für temporäre Dateien</translation>
    </message>
    <message>
        <source>Make that folder, or let TMPDIR name one that is there</source>
        <translation>Legen Sie diesen Ordner an, oder nennen Sie mit TMPDIR einen vorhandenen</translation>
    </message>
    <message>
        <source>no temporary folder can be made</source>
        <translation>Es lässt sich kein temporärer Ordner anlegen</translation>
    </message>
    <message>
        <source>Free some space there</source>
        <translation>Schaffen Sie dort Platz</translation>
    </message>
    <message>
        <source>Free some space there, or set TMPDIR to a folder with more</source>
        <translation>Schaffen Sie dort Platz, oder setzen Sie TMPDIR auf einen Ordner mit mehr Platz</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>existiert nicht</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>is a pipe, a socket or a device, not a file</source>
        <translation>ist eine Pipe, ein Socket oder ein Gerät, keine Datei</translation>
    </message>
    <message>
        <source>nests lists and objects deeper than any file of this program</source>
        <translation>verschachtelt Listen und Objekte tiefer als jede Datei dieses Programms</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>is not finite</source>
        <translation>ist nicht endlich</translation>
    </message>
    <message>
        <source>is not known, and no key is</source>
        <translation>ist nicht bekannt, und kein Schlüssel ist es</translation>
    </message>
    <message>
        <source>is not known; choose from %1</source>
        <translation>ist nicht bekannt; wählen Sie aus %1</translation>
    </message>
    <message>
        <source>is not known; the nearest key is &quot;%1&quot;</source>
        <translation>ist nicht bekannt; der ähnlichste Schlüssel ist „%1“</translation>
    </message>
    <message>
        <source>is not known</source>
        <translation>ist nicht bekannt</translation>
    </message>
    <message>
        <source>is not an object</source>
        <translation>ist kein Objekt</translation>
    </message>
    <message>
        <source>Choose one of: %1</source>
        <translation>Wählen Sie eines von: %1</translation>
    </message>
    <message>
        <source>Give a value from %1</source>
        <translation>Geben Sie einen Wert von %1 an</translation>
    </message>
    <message>
        <source>Reconstruct the patient first</source>
        <translation>Rekonstruieren Sie zuerst den Patienten</translation>
    </message>
    <message>
        <source>Reconstruct the patient again</source>
        <translation>Rekonstruieren Sie den Patienten noch einmal</translation>
    </message>
    <message>
        <source>the vessel tree has no segments</source>
        <translation>Der Gefäßbaum hat keine Segmente</translation>
    </message>
    <message>
        <source>Choose a value from 0 to 1</source>
        <translation>Wählen Sie einen Wert von 0 bis 1</translation>
    </message>
    <message>
        <source>Looking for images</source>
        <translation>Bilder werden gesucht</translation>
    </message>
    <message>
        <source>Reading the images</source>
        <translation>Die Bilder werden gelesen</translation>
    </message>
    <message>
        <source>Reading the mask</source>
        <translation>Die Maske wird gelesen</translation>
    </message>
    <message>
        <source>Reading the label map</source>
        <translation>Die Labelkarte wird gelesen</translation>
    </message>
    <message>
        <source>Writing the DICOM series</source>
        <translation>Die DICOM-Serie wird geschrieben</translation>
    </message>
    <message>
        <source>Writing the segmentation</source>
        <translation>Die Segmentierung wird geschrieben</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>lässt sich nicht bis zum Ende lesen</translation>
    </message>
    <message>
        <source>Check the disk</source>
        <translation>Prüfen Sie den Datenträger</translation>
    </message>
    <message>
        <source>holds damaged compressed data after %1</source>
        <translation>enthält nach %1 beschädigte komprimierte Daten</translation>
    </message>
    <message>
        <source>Copy or export the file again</source>
        <translation>Kopieren oder exportieren Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Wählen Sie eine Datei</translation>
    </message>
    <message>
        <source>cannot be opened (%1)</source>
        <translation>lässt sich nicht öffnen (%1)</translation>
    </message>
    <message>
        <source>ends too early, after %1 of data</source>
        <translation>endet zu früh, nach %1 Daten</translation>
    </message>
    <message>
        <source>cannot be split into its frames: %1</source>
        <translation>lässt sich nicht in seine Einzelbilder zerlegen: %1</translation>
    </message>
    <message>
        <source>Export it again as classic CT slices, one file a slice (a segmentation: as NIfTI or NRRD)</source>
        <translation>Exportieren Sie noch einmal als klassische CT-Schichten, eine Datei je Schicht (eine Segmentierung: als NIfTI oder NRRD)</translation>
    </message>
    <message>
        <source>Check that the file is still there</source>
        <translation>Prüfen Sie, ob die Datei noch da ist</translation>
    </message>
    <message>
        <source>needs %1 for its frames, and %2 are free in %3</source>
        <translation>braucht %1 für seine Einzelbilder, und in %3 sind %2 frei</translation>
    </message>
    <message>
        <source>that took longer than %1 s</source>
        <translation>es dauerte länger als %1 s</translation>
    </message>
    <message>
        <source>the helper that reads it was ended by signal %1, which a damaged file can cause</source>
        <translation>das Hilfsprogramm dafür wurde durch Signal %1 beendet, was eine beschädigte Datei bewirken kann</translation>
    </message>
    <message>
        <source>the helper that reads it ended with %1</source>
        <translation>das Hilfsprogramm dafür endete mit %1</translation>
    </message>
    <message>
        <source>frame %1 is missing</source>
        <translation>Einzelbild %1 fehlt</translation>
    </message>
    <message>
        <source>Copy or export the series again</source>
        <translation>Kopieren oder exportieren Sie die Serie noch einmal</translation>
    </message>
    <message>
        <source>lies in the same place as %1 but shows something else</source>
        <translation>liegt am selben Ort wie %1, zeigt aber etwas anderes</translation>
    </message>
    <message>
        <source>Put each phase of the contrast into a folder of its own</source>
        <translation>Legen Sie jede Kontrastmittelphase in einen eigenen Ordner</translation>
    </message>
    <message>
        <source>is no DICOM image</source>
        <translation>ist kein DICOM-Bild</translation>
    </message>
    <message>
        <source>Give the DICOM folder of the CT, or a file in it</source>
        <translation>Geben Sie den DICOM-Ordner des CTs an oder eine Datei darin</translation>
    </message>
    <message>
        <source>has %1 of %2 bits a pixel</source>
        <translation>hat %1 von %2 Bit je Pixel</translation>
    </message>
    <message>
        <source>has compressed pixels of another size than its header</source>
        <translation>hat komprimierte Pixel anderer Größe als im Kopf angegeben</translation>
    </message>
    <message>
        <source>has compressed pixels that cannot be decoded</source>
        <translation>hat komprimierte Pixel, die sich nicht entschlüsseln lassen</translation>
    </message>
    <message>
        <source>has compressed pixels that do not begin at the lowest bit (high bit %1, 0028,0102)</source>
        <translation>hat komprimierte Pixel, die nicht beim niedrigsten Bit beginnen (höchstes Bit %1, 0028,0102)</translation>
    </message>
    <message>
        <source>has %1 bits below the high bit %2 (0028,0102), which is impossible in %3</source>
        <translation>hat %1 Bit unter dem höchsten Bit %2 (0028,0102), was in %3 unmöglich ist</translation>
    </message>
    <message>
        <source>has a rescale slope of %1</source>
        <translation>hat eine Skalierung (Rescale Slope) von %1</translation>
    </message>
    <message>
        <source>has damaged run-length encoded pixels</source>
        <translation>hat beschädigte lauflängenkodierte Pixel</translation>
    </message>
    <message>
        <source>has fewer pixels than its header claims</source>
        <translation>hat weniger Pixel, als sein Kopf angibt</translation>
    </message>
    <message>
        <source>has no pixels</source>
        <translation>hat keine Pixel</translation>
    </message>
    <message>
        <source>has pixels in the unknown encoding %1</source>
        <translation>hat Pixel in der unbekannten Kodierung %1</translation>
    </message>
    <message>
        <source>holds several frames in one file</source>
        <translation>enthält mehrere Einzelbilder in einer Datei</translation>
    </message>
    <message>
        <source>is a colour picture</source>
        <translation>ist ein Farbbild</translation>
    </message>
    <message>
        <source>%1 slices state no rescale slope and intercept: their stored values were taken as Hounsfield units</source>
        <translation>%1 Schichten nennen weder Rescale Slope noch Intercept: Ihre Werte wurden als Hounsfield-Einheiten genommen</translation>
    </message>
    <message>
        <source>%1 slices stood there twice and were read once</source>
        <translation>%1 Schichten lagen doppelt vor und wurden einmal gelesen</translation>
    </message>
    <message>
        <source>%1 of %2 voxels are padding around the scan (0028,0120) and became %3</source>
        <translation>%1 von %2 Voxeln sind Auffüllung um die Aufnahme (0028,0120) und wurden zu %3</translation>
    </message>
    <message>
        <source>The series is stored for display with low values bright (MONOCHROME1): its values were read as Hounsfield units all the same, as the standard has it</source>
        <translation>Die Serie ist so gespeichert, dass kleine Werte hell erscheinen (MONOCHROME1): Ihre Werte wurden dennoch als Hounsfield-Einheiten gelesen, wie es der Standard will</translation>
    </message>
    <message>
        <source>The series states a gantry tilt of %1 (0018,1120), but its slices are stacked %2: it was read by their positions, as the standard has it</source>
        <translation>Die Serie nennt eine Gantry-Neigung von %1 (0018,1120), ihre Schichten liegen aber %2: Gelesen wurde nach ihren Positionen, wie es der Standard will</translation>
    </message>
    <message>
        <source>Its slices are stacked aslant by %1 (a tilted gantry): each was moved within its plane onto an upright grid</source>
        <translation>Ihre Schichten sind um %1 schräg gestapelt (geneigte Gantry): Jede wurde in ihrer Ebene auf ein aufrechtes Gitter verschoben</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 Grad</translation>
    </message>
    <message>
        <source>Export the segmentation as NIfTI or NRRD</source>
        <translation>Exportieren Sie die Segmentierung als NIfTI oder NRRD</translation>
    </message>
    <message>
        <source>has one slice and no spacing of slices (0018,0088)</source>
        <translation>hat eine Schicht und keinen Schichtabstand (0018,0088)</translation>
    </message>
    <message>
        <source>has slices %1 apart where %2 lie between others</source>
        <translation>hat Schichten im Abstand %1, wo sonst %2 dazwischen liegen</translation>
    </message>
    <message>
        <source>has slices whose distance changes: slice %1 lies more than half a step from its place</source>
        <translation>hat Schichten, deren Abstand sich ändert: Schicht %1 liegt mehr als einen halben Abstand neben ihrem Platz</translation>
    </message>
    <message>
        <source>lies %1 beside the first frame: the segmentation of a series that a tilted gantry has sheared is not read</source>
        <translation>liegt %1 neben dem ersten Einzelbild: Die Segmentierung einer Serie mit geneigter Gantry wird nicht gelesen</translation>
    </message>
    <message>
        <source>its slices are stacked aslant by %1 degrees, which is more than any gantry tilts</source>
        <translation>ihre Schichten sind um %1 Grad schräg gestapelt, mehr als jede Gantry geneigt wird</translation>
    </message>
    <message>
        <source>Ask for the series reformatted to straight axial slices</source>
        <translation>Lassen Sie die Serie in gerade axiale Schichten umrechnen</translation>
    </message>
    <message>
        <source>%1 slice is missing %2 (at %3 to %4)</source>
        <translation>%1 Schicht fehlt %2 (bei %3 bis %4)</translation>
    </message>
    <message>
        <source>%1 slices are missing %2 (at %3 to %4)</source>
        <translation>%1 Schichten fehlen %2 (bei %3 bis %4)</translation>
    </message>
    <message>
        <source>the gap %1 is %2, elsewhere it is %3</source>
        <translation>die Lücke %1 beträgt %2, sonst %3</translation>
    </message>
    <message>
        <source>lies where the distance between slices changes: it is %1 on average up to there, and %2 in the whole series</source>
        <translation>liegt dort, wo sich der Abstand der Schichten ändert: Bis dahin beträgt er im Mittel %1, in der ganzen Serie %2</translation>
    </message>
    <message>
        <source>Export the series again, complete, as axial slices of one size</source>
        <translation>Exportieren Sie die Serie noch einmal vollständig als axiale Schichten gleicher Größe</translation>
    </message>
    <message>
        <source>has a pixel spacing of %1</source>
        <translation>hat einen Pixelabstand von %1</translation>
    </message>
    <message>
        <source>has an orientation that is no pair of perpendicular directions</source>
        <translation>hat eine Orientierung, die kein Paar rechtwinkliger Richtungen ist</translation>
    </message>
    <message>
        <source>has no position, orientation or pixel spacing</source>
        <translation>hat keine Position, Orientierung oder keinen Pixelabstand</translation>
    </message>
    <message>
        <source>has %1 frames in one file and is no enhanced CT, the only kind of many frames that this program reads</source>
        <translation>hat %1 Einzelbilder in einer Datei und ist kein Enhanced CT, die einzige mehrbildrige Art, die dieses Programm liest</translation>
    </message>
    <message>
        <source>has %1 pixels, but %2 has %3</source>
        <translation>hat %1 Pixel, %2 aber %3</translation>
    </message>
    <message>
        <source>has pixels of %1, but %2 of %3</source>
        <translation>hat Pixel von %1, %2 aber von %3</translation>
    </message>
    <message>
        <source>is oriented otherwise than %1</source>
        <translation>ist anders orientiert als %1</translation>
    </message>
    <message>
        <source>is shifted sideways by %1</source>
        <translation>ist um %1 seitlich verschoben</translation>
    </message>
    <message>
        <source>its series has only one slice</source>
        <translation>die Serie hat nur eine Schicht</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>zwischen %1 und %2</translation>
    </message>
    <message>
        <source>is a colour picture (0028,0004 is &quot;%1&quot;)</source>
        <translation>ist ein Farbbild (0028,0004 ist „%1“)</translation>
    </message>
    <message>
        <source>is a picture in the colours of a palette (0028,0004), not a CT image</source>
        <translation>ist ein Bild in den Farben einer Palette (0028,0004), kein CT-Bild</translation>
    </message>
    <message>
        <source>maps its values to Hounsfield units by a table (Modality LUT Sequence, 0028,3000), which this program does not read</source>
        <translation>rechnet seine Werte durch eine Tabelle in Hounsfield-Einheiten um (Modality LUT Sequence, 0028,3000), die dieses Programm nicht liest</translation>
    </message>
    <message>
        <source>has a rescale %1 (0028,%2) of &quot;%3&quot;, which is not one number</source>
        <translation>hat eine Skalierung %1 (0028,%2) „%3“, die keine einzelne Zahl ist</translation>
    </message>
    <message>
        <source>%1 DICOM files hold no image and were passed over</source>
        <translation>%1 DICOM-Dateien enthalten kein Bild und wurden übergangen</translation>
    </message>
    <message>
        <source>The folder %1 could not be listed (%2): files in it may be left out</source>
        <translation>Der Ordner %1 ließ sich nicht auflisten (%2): Dateien darin fehlen vielleicht</translation>
    </message>
    <message>
        <source>The linked folder %1 was not entered</source>
        <translation>Der verknüpfte Ordner %1 wurde nicht betreten</translation>
    </message>
    <message>
        <source>%1 was passed over (%2)</source>
        <translation>%1 wurde übergangen (%2)</translation>
    </message>
    <message>
        <source>%1 is a damaged DICOM file and was passed over</source>
        <translation>%1 ist eine beschädigte DICOM-Datei und wurde übergangen</translation>
    </message>
    <message>
        <source>a link to nothing</source>
        <translation>eine Verknüpfung ins Leere</translation>
    </message>
    <message>
        <source>Check that the folder exists and may be read</source>
        <translation>Prüfen Sie, ob der Ordner existiert und lesbar ist</translation>
    </message>
    <message>
        <source>Choose the folder that holds the CT slices</source>
        <translation>Wählen Sie den Ordner mit den CT-Schichten</translation>
    </message>
    <message>
        <source>holds %1 files, but no DICOM images</source>
        <translation>enthält %1 Dateien, aber keine DICOM-Bilder</translation>
    </message>
    <message>
        <source>cannot hold %1 pixels in a row</source>
        <translation>fasst keine %1 Pixel in einer Reihe</translation>
    </message>
    <message>
        <source>cannot hold %1 voxels along an axis</source>
        <translation>fasst keine %1 Voxel entlang einer Achse</translation>
    </message>
    <message>
        <source>Check that the disk has free space</source>
        <translation>Prüfen Sie, ob der Datenträger freien Platz hat</translation>
    </message>
    <message>
        <source>Check that the disk has free space and the folder may be written</source>
        <translation>Prüfen Sie, ob der Datenträger freien Platz hat und der Ordner beschreibbar ist</translation>
    </message>
    <message>
        <source>Crop the image first</source>
        <translation>Schneiden Sie das Bild erst zu</translation>
    </message>
    <message>
        <source>Crop the image, or write .nrrd</source>
        <translation>Schneiden Sie das Bild zu, oder schreiben Sie .nrrd</translation>
    </message>
    <message>
        <source>Choose a region inside the image</source>
        <translation>Wählen Sie einen Bereich im Bild</translation>
    </message>
    <message>
        <source>crop box</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>holds no voxel of the image</source>
        <translation>enthält kein Voxel des Bildes</translation>
    </message>
    <message>
        <source>Choose a width of 0 or more</source>
        <translation>Wählen Sie eine Breite von 0 oder mehr</translation>
    </message>
    <message>
        <source>smoothing width in mm</source>
        <translation>Glättungsbreite in mm</translation>
    </message>
    <message>
        <source>needs %1 of memory, and %2 are available</source>
        <translation>braucht %1 Speicher, und %2 sind verfügbar</translation>
    </message>
    <message>
        <source>Close other programs, or export the image cropped or at half resolution</source>
        <translation>Schließen Sie andere Programme, oder exportieren Sie das Bild zugeschnitten oder mit halber Auflösung</translation>
    </message>
    <message>
        <source>Export the image again as one three-dimensional volume</source>
        <translation>Exportieren Sie das Bild noch einmal als ein dreidimensionales Volumen</translation>
    </message>
    <message>
        <source>Export the image again as one volume, raw or gzip</source>
        <translation>Exportieren Sie das Bild noch einmal als ein Volumen, raw oder gzip</translation>
    </message>
    <message>
        <source>Choose a NIfTI file that another viewer opens</source>
        <translation>Wählen Sie eine NIfTI-Datei, die ein anderes Programm öffnet</translation>
    </message>
    <message>
        <source>has %1 dimensions, not 3</source>
        <translation>hat %1 Dimensionen, nicht 3</translation>
    </message>
    <message>
        <source>has %1 values a voxel</source>
        <translation>hat %1 Werte je Voxel</translation>
    </message>
    <message>
        <source>has a DimSize that is no size</source>
        <translation>hat eine DimSize, die keine Größe ist</translation>
    </message>
    <message>
        <source>has a data file with a header of its own</source>
        <translation>hat eine Datendatei mit eigenem Kopf</translation>
    </message>
    <message>
        <source>has a voxel spacing of %1</source>
        <translation>hat einen Voxelabstand von %1</translation>
    </message>
    <message>
        <source>has its data in several files</source>
        <translation>hat seine Daten in mehreren Dateien</translation>
    </message>
    <message>
        <source>has no DimSize</source>
        <translation>hat keine DimSize</translation>
    </message>
    <message>
        <source>has no ElementSpacing</source>
        <translation>hat kein ElementSpacing</translation>
    </message>
    <message>
        <source>has voxels of type &quot;%1&quot;</source>
        <translation>hat Voxel der Art „%1“</translation>
    </message>
    <message>
        <source>is not a MetaImage (it names no ElementDataFile)</source>
        <translation>ist kein MetaImage (es nennt kein ElementDataFile)</translation>
    </message>
    <message>
        <source>has a data offset of %1</source>
        <translation>hat einen Datenbeginn von %1</translation>
    </message>
    <message>
        <source>has voxels of NIfTI type %1</source>
        <translation>hat Voxel der NIfTI-Art %1</translation>
    </message>
    <message>
        <source>holds several volumes (a time series or vectors)</source>
        <translation>enthält mehrere Volumen (eine Zeitreihe oder Vektoren)</translation>
    </message>
    <message>
        <source>is an Analyze image, which does not say left from right</source>
        <translation>ist ein Analyze-Bild, das links und rechts nicht unterscheidet</translation>
    </message>
    <message>
        <source>is not a NIfTI image</source>
        <translation>ist kein NIfTI-Bild</translation>
    </message>
    <message>
        <source>is the header of a two-file NIfTI image (.hdr and .img)</source>
        <translation>ist der Kopf eines NIfTI-Bildes aus zwei Dateien (.hdr und .img)</translation>
    </message>
    <message>
        <source>is too short to be a NIfTI image</source>
        <translation>ist zu kurz für ein NIfTI-Bild</translation>
    </message>
    <message>
        <source>does not have three space directions</source>
        <translation>hat keine drei Raumrichtungen</translation>
    </message>
    <message>
        <source>does not say which way its axes run in the patient (no &quot;space&quot; field)</source>
        <translation>sagt nicht, wie seine Achsen im Patienten verlaufen (kein Feld „space“)</translation>
    </message>
    <message>
        <source>has a header without an end</source>
        <translation>hat einen Kopf ohne Ende</translation>
    </message>
    <message>
        <source>has a size that is no size</source>
        <translation>hat eine Größe, die keine ist</translation>
    </message>
    <message>
        <source>has a space direction that is not three numbers</source>
        <translation>hat eine Raumrichtung, die nicht aus drei Zahlen besteht</translation>
    </message>
    <message>
        <source>has encoding &quot;%1&quot;</source>
        <translation>hat die Kodierung „%1“</translation>
    </message>
    <message>
        <source>has its axes in space &quot;%1&quot;</source>
        <translation>hat seine Achsen im Raum „%1“</translation>
    </message>
    <message>
        <source>has no space origin</source>
        <translation>hat keinen Ursprung</translation>
    </message>
    <message>
        <source>holds overlapping segments in layers; export a segmentation whose segments do not overlap, or a label map</source>
        <translation>enthält überlappende Segmente in Ebenen; exportieren Sie eine Segmentierung ohne Überlappung oder eine Labelkarte</translation>
    </message>
    <message>
        <source>skips bytes before its data</source>
        <translation>überspringt Bytes vor seinen Daten</translation>
    </message>
    <message>
        <source>is %1, which makes %2 voxels along an axis</source>
        <translation>ist %1, was %2 Voxel entlang einer Achse ergibt</translation>
    </message>
    <message>
        <source>Choose a coarser spacing</source>
        <translation>Wählen Sie einen gröberen Abstand</translation>
    </message>
    <message>
        <source>Choose a spacing above 0</source>
        <translation>Wählen Sie einen Abstand über 0</translation>
    </message>
    <message>
        <source>voxel spacing in mm</source>
        <translation>Voxelabstand in mm</translation>
    </message>
    <message>
        <source>resampled image</source>
        <translation>umgerechnetes Bild</translation>
    </message>
    <message>
        <source>its segmentation cannot be written: the helper that does it took longer than %1 s</source>
        <translation>seine Segmentierung lässt sich nicht schreiben: Das Hilfsprogramm brauchte länger als %1 s</translation>
    </message>
    <message>
        <source>its segmentation cannot be written: the helper that does it was ended by signal %1</source>
        <translation>seine Segmentierung lässt sich nicht schreiben: Das Hilfsprogramm wurde durch Signal %1 beendet</translation>
    </message>
    <message>
        <source>its segmentation cannot be written: the helper that does it ended with %1</source>
        <translation>seine Segmentierung lässt sich nicht schreiben: Das Hilfsprogramm endete mit %1</translation>
    </message>
    <message>
        <source>its segmentation %1</source>
        <translation>seine Segmentierung %1</translation>
    </message>
    <message>
        <source>cannot be written: the disk takes no more</source>
        <translation>lässt sich nicht schreiben: Der Datenträger nimmt nichts mehr auf</translation>
    </message>
    <message>
        <source>Free some space there, or choose another folder</source>
        <translation>Schaffen Sie dort Platz, oder wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>Export the CT again, or install the program again</source>
        <translation>Exportieren Sie das CT noch einmal, oder installieren Sie das Programm neu</translation>
    </message>
    <message>
        <source>is an enhanced CT, all of its slices in one file</source>
        <translation>ist ein Enhanced CT, alle Schichten in einer Datei</translation>
    </message>
    <message>
        <source>Segmentations are written for classic slices, one file each: export it as these</source>
        <translation>Segmentierungen werden für klassische Schichten geschrieben, eine Datei je Schicht: Exportieren Sie so</translation>
    </message>
    <message>
        <source>nothing of the segmentation lies in this CT</source>
        <translation>Nichts von der Segmentierung liegt in diesem CT</translation>
    </message>
    <message>
        <source>Choose the CT that it was made of</source>
        <translation>Wählen Sie das CT, aus dem sie entstand</translation>
    </message>
    <message>
        <source>holds %1 series and no number %2</source>
        <translation>enthält %1 Serien und keine Nummer %2</translation>
    </message>
    <message>
        <source>Give a number from 1, which is the best, on</source>
        <translation>Geben Sie eine Nummer ab 1 an, der besten</translation>
    </message>
    <message>
        <source>holds no CT series%1</source>
        <translation>enthält keine CT-Serie%1</translation>
    </message>
    <message>
        <source>holds no CT series</source>
        <translation>enthält keine CT-Serie</translation>
    </message>
    <message>
        <source>Choose the folder of a contrast-enhanced CT</source>
        <translation>Wählen Sie den Ordner eines CTs mit Kontrastmittel</translation>
    </message>
    <message>
        <source>Left out %1 scout images</source>
        <translation>%1 Übersichtsbilder wurden ausgelassen</translation>
    </message>
    <message>
        <source>Left out %1</source>
        <translation>Ausgelassen: %1</translation>
    </message>
    <message>
        <source>%1 (%2, %3 images, %4 mm apart, kernel %5, %6)</source>
        <translation>%1 (%2, %3 Bilder, Abstand %4 mm, Kern %5, %6)</translation>
    </message>
    <message>
        <source>%1 (%2, %3 images, %4 mm apart, kernel %5)</source>
        <translation>%1 (%2, %3 Bilder, Abstand %4 mm, Kern %5)</translation>
    </message>
    <message>
        <source>%1 (%2, %3 images, %4 mm apart, %5)</source>
        <translation>%1 (%2, %3 Bilder, Abstand %4 mm, %5)</translation>
    </message>
    <message>
        <source>%1 (%2, %3 images, %4 mm apart)</source>
        <translation>%1 (%2, %3 Bilder, Abstand %4 mm)</translation>
    </message>
    <message>
        <source>%1 (%2, %3 images)</source>
        <translation>%1 (%2, %3 Bilder)</translation>
    </message>
    <message>
        <source>no modality</source>
        <translation>keine Modalität</translation>
    </message>
    <message>
        <source>arterial phase</source>
        <translation>arterielle Phase</translation>
    </message>
    <message>
        <source>portal venous phase</source>
        <translation>portalvenöse Phase</translation>
    </message>
    <message>
        <source>late phase</source>
        <translation>späte Phase</translation>
    </message>
    <message>
        <source>without contrast</source>
        <translation>ohne Kontrastmittel</translation>
    </message>
    <message>
        <source>it is a CT</source>
        <translation>sie ist ein CT</translation>
    </message>
    <message>
        <source>it is no CT</source>
        <translation>sie ist kein CT</translation>
    </message>
    <message>
        <source>it covers more of the body</source>
        <translation>sie deckt mehr vom Körper ab</translation>
    </message>
    <message>
        <source>it has more slices</source>
        <translation>sie hat mehr Schichten</translation>
    </message>
    <message>
        <source>it stands first</source>
        <translation>sie steht vorn</translation>
    </message>
    <message>
        <source>it was taken with contrast</source>
        <translation>sie wurde mit Kontrastmittel aufgenommen</translation>
    </message>
    <message>
        <source>its kernel is for soft tissue</source>
        <translation>ihr Kern ist für Weichteile</translation>
    </message>
    <message>
        <source>its slices are axial and not projected</source>
        <translation>ihre Schichten sind axial und nicht projiziert</translation>
    </message>
    <message>
        <source>its slices lie closer together</source>
        <translation>ihre Schichten liegen enger</translation>
    </message>
    <message>
        <source>of its phase of the contrast</source>
        <translation>wegen ihrer Kontrastmittelphase</translation>
    </message>
    <message>
        <source>its slices lie far apart: thin vessels are lost</source>
        <translation>ihre Schichten liegen weit auseinander: Dünne Gefäße gehen verloren</translation>
    </message>
    <message>
        <source>without contrast no vessel is seen</source>
        <translation>ohne Kontrastmittel ist kein Gefäß zu sehen</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>sie lässt sich nicht lesen: %1</translation>
    </message>
    <message>
        <source>holds no DICOM image</source>
        <translation>enthält kein DICOM-Bild</translation>
    </message>
    <message>
        <source>Choose another series</source>
        <translation>Wählen Sie eine andere Serie</translation>
    </message>
    <message>
        <source>%1 of %2 values are not numbers (NaN or infinite): %3 became the mean of their neighbours, the others air</source>
        <translation>%1 von %2 Werten sind keine Zahlen (NaN oder unendlich): %3 wurden zum Mittel ihrer Nachbarn, die anderen zu Luft</translation>
    </message>
    <message>
        <source>%1 values lie outside 16 bits and were clamped</source>
        <translation>%1 Werte passen nicht in 16 Bit und wurden begrenzt</translation>
    </message>
    <message>
        <source>has the value %1 in every voxel</source>
        <translation>hat in jedem Voxel den Wert %1</translation>
    </message>
    <message>
        <source>has voxels of %1 mm along %2</source>
        <translation>hat Voxel von %1 mm entlang %2</translation>
    </message>
    <message>
        <source>has only %1 voxels along an axis</source>
        <translation>hat nur %1 Voxel entlang einer Achse</translation>
    </message>
    <message>
        <source>has %1 voxels along an axis</source>
        <translation>hat %1 Voxel entlang einer Achse</translation>
    </message>
    <message>
        <source>the mask has %1 voxels, but the CT has %2</source>
        <translation>die Maske hat %1 Voxel, das CT aber %2</translation>
    </message>
    <message>
        <source>holds the value %1, which is no label</source>
        <translation>enthält den Wert %1, der kein Label ist</translation>
    </message>
    <message>
        <source>holds label %1</source>
        <translation>enthält das Label %1</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Prüfen Sie den Pfad</translation>
    </message>
    <message>
        <source>Check the unit of its spacing and export it again in millimetres: the CT of a body has voxels of 0.1 to 10 mm</source>
        <translation>Prüfen Sie die Einheit des Abstands, und exportieren Sie noch einmal in Millimetern: Das CT eines Körpers hat Voxel von 0,1 bis 10 mm</translation>
    </message>
    <message>
        <source>Choose a CT in Hounsfield units that covers the liver</source>
        <translation>Wählen Sie ein CT in Hounsfield-Einheiten, das die Leber abdeckt</translation>
    </message>
    <message>
        <source>Choose a CT that covers the liver</source>
        <translation>Wählen Sie ein CT, das die Leber abdeckt</translation>
    </message>
    <message>
        <source>Choose a CT with an image in it</source>
        <translation>Wählen Sie ein CT, das ein Bild enthält</translation>
    </message>
    <message>
        <source>Choose a mask or label map, not an image</source>
        <translation>Wählen Sie eine Maske oder Labelkarte, kein Bild</translation>
    </message>
    <message>
        <source>Choose a mask that is not empty, or another label of it</source>
        <translation>Wählen Sie eine Maske, die nicht leer ist, oder ein anderes Label</translation>
    </message>
    <message>
        <source>Choose a mask that was drawn on this CT</source>
        <translation>Wählen Sie eine Maske, die auf diesem CT gezeichnet wurde</translation>
    </message>
    <message>
        <source>Labels of a mask go from 1 to 255: give it others, or name those that are vessels (--vessel-label)</source>
        <translation>Labels einer Maske gehen von 1 bis 255: Geben Sie ihr andere in dem Programm, das sie gezeichnet hat</translation>
    </message>
    <message>
        <source>Leave --series out, or give a DICOM folder</source>
        <translation>Lassen Sie die Serie weg, oder geben Sie einen DICOM-Ordner an</translation>
    </message>
    <message>
        <source>is one image and holds no series</source>
        <translation>ist ein einzelnes Bild und enthält keine Serien</translation>
    </message>
    <message>
        <source>the mask lies elsewhere in space than the CT</source>
        <translation>die Maske liegt anderswo im Raum als das CT</translation>
    </message>
    <message>
        <source>marks no voxel</source>
        <translation>markiert kein Voxel</translation>
    </message>
    <message>
        <source>shows no soft tissue (its values run from %1 to %2 HU)</source>
        <translation>zeigt keine Weichteile (die Werte reichen von %1 bis %2 HU)</translation>
    </message>
    <message>
        <source>Choose such a name</source>
        <translation>Wählen Sie einen solchen Namen</translation>
    </message>
    <message>
        <source>does not end in .nii or .nii.gz</source>
        <translation>endet nicht auf .nii oder .nii.gz</translation>
    </message>
    <message>
        <source>does not end in .seg.nrrd</source>
        <translation>endet nicht auf .seg.nrrd</translation>
    </message>
    <message>
        <source>Choose a DICOM folder or a .nii, .nii.gz, .mha, .mhd, .nrrd file</source>
        <translation>Wählen Sie einen DICOM-Ordner oder eine Datei .nii, .nii.gz, .mha, .mhd, .nrrd</translation>
    </message>
    <message>
        <source>Export the image again, with its spacing and orientation</source>
        <translation>Exportieren Sie das Bild noch einmal mit Abstand und Orientierung</translation>
    </message>
    <message>
        <source>Keep both files in one folder</source>
        <translation>Lassen Sie beide Dateien in einem Ordner</translation>
    </message>
    <message>
        <source>has axes that are not at right angles (a sheared grid)</source>
        <translation>hat Achsen, die nicht rechtwinklig sind (ein geschertes Gitter)</translation>
    </message>
    <message>
        <source>is not an image that this program knows</source>
        <translation>ist kein Bild, das dieses Programm kennt</translation>
    </message>
    <message>
        <source>is %1 m long (%2 voxels of %3 mm)</source>
        <translation>ist %1 m lang (%2 Voxel von %3 mm)</translation>
    </message>
    <message>
        <source>its data file %1 is missing</source>
        <translation>die Datendatei %1 fehlt</translation>
    </message>
    <message>
        <source>its first voxel</source>
        <translation>sein erstes Voxel</translation>
    </message>
    <message>
        <source>its header claims %1 voxels (%2), which a file of %3 cannot hold</source>
        <translation>der Kopf nennt %1 Voxel (%2), was eine Datei von %3 nicht fassen kann</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>path of the tip</source>
        <translation>Weg der Spitze</translation>
    </message>
    <message>
        <source>peak force</source>
        <translation>größte Kraft</translation>
    </message>
    <message>
        <source>force over time</source>
        <translation>Kraft über die Zeit</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>Berührungen</translation>
    </message>
    <message>
        <source>time in contact</source>
        <translation>Zeit in Berührung</translation>
    </message>
    <message>
        <source>largest stretch</source>
        <translation>größte Dehnung</translation>
    </message>
    <message>
        <source>joints broken</source>
        <translation>gerissene Verbindungen</translation>
    </message>
    <message>
        <source>blood lost</source>
        <translation>Blutverlust</translation>
    </message>
    <message>
        <source>dose in the target</source>
        <translation>Dosis im Zielgebiet</translation>
    </message>
    <message>
        <source>dose elsewhere</source>
        <translation>Dosis anderswo</translation>
    </message>
    <message>
        <source>share of the dose in the target</source>
        <translation>Anteil der Dosis im Zielgebiet</translation>
    </message>
    <message>
        <source>time of this step</source>
        <translation>Zeit dieses Schritts</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>grip</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>share of the target that the drug has reached</source>
        <translation>vom Wirkstoff erreichter Anteil des Zielgebiets</translation>
    </message>
    <message>
        <source>share of the rest that the drug has reached</source>
        <translation>vom Wirkstoff erreichter Anteil des Rests</translation>
    </message>
    <message>
        <source>injections that are running</source>
        <translation>laufende Injektionen</translation>
    </message>
    <message>
        <source>vessels held by hand or tool</source>
        <translation>von Hand oder Werkzeug gehaltene Gefäße</translation>
    </message>
    <message>
        <source>distance of the tip to</source>
        <translation>Abstand der Spitze zu</translation>
    </message>
    <message>
        <source>way moved by</source>
        <translation>Verschiebung von</translation>
    </message>
    <message>
        <source>distance of the touch to</source>
        <translation>Abstand der Berührung zu</translation>
    </message>
    <message>
        <source>distance of the tip to %1</source>
        <translation>Abstand der Spitze zu: %1</translation>
    </message>
    <message>
        <source>way moved by %1</source>
        <translation>Verschiebung von: %1</translation>
    </message>
    <message>
        <source>distance of the touch to %1</source>
        <translation>Abstand der Berührung zu: %1</translation>
    </message>
    <message>
        <source>no mark</source>
        <translation>keine Marke</translation>
    </message>
    <message>
        <source>%1 at least %2</source>
        <translation>%1 mindestens %2</translation>
    </message>
    <message>
        <source>%1 at most %2</source>
        <translation>%1 höchstens %2</translation>
    </message>
    <message>
        <source>limit broken: %1, but it was %2</source>
        <translation>Grenze verletzt: %1, es war aber %2</translation>
    </message>
    <message>
        <source>pass mark missed: %1, but it is %2</source>
        <translation>Bestehensgrenze verfehlt: %1, es ist aber %2</translation>
    </message>
    <message>
        <source>something was done before the lesson began</source>
        <translation>etwas geschah, bevor die Lektion begann</translation>
    </message>
    <message>
        <source>the play does not begin with what the lesson sets up</source>
        <translation>der Verlauf beginnt nicht mit dem, was die Lektion vorgibt</translation>
    </message>
    <message>
        <source>the simulation stopped by itself: play it again</source>
        <translation>die Simulation blieb von selbst stehen: Üben Sie noch einmal</translation>
    </message>
    <message>
        <source>step %1 of %2 was not reached: %3</source>
        <translation>Schritt %1 von %2 wurde nicht erreicht: %3</translation>
    </message>
    <message>
        <source>the play was taken back</source>
        <translation>der Verlauf wurde zurückgenommen</translation>
    </message>
    <message>
        <source>is %1, not true or false</source>
        <translation>ist %1, nicht wahr oder falsch</translation>
    </message>
    <message>
        <source>Remove it: hepatica-cli lesson scores its recording again</source>
        <translation>Entfernen Sie die Datei: Datei &gt; Aufzeichnung öffnen zeigt die Übung weiterhin</translation>
    </message>
    <message>
        <source>is not JSON</source>
        <translation>ist kein JSON</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>ist zweimal angegeben</translation>
    </message>
    <message>
        <source>Leave one of the two out</source>
        <translation>Lassen Sie eines von beiden weg</translation>
    </message>
    <message>
        <source>Begin with a lesson that is whole</source>
        <translation>Beginnen Sie mit einer vollständigen Lektion</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; %3</source>
        <translation>%1: „%2“ %3</translation>
    </message>
    <message>
        <source>%1 lies %2 beside the vessels of this patient, as if it was clicked on another one: click on it again.</source>
        <translation>%1 liegt %2 neben den Gefäßen dieses Patienten, als wäre auf einen anderen geklickt worden: Klicken Sie noch einmal.</translation>
    </message>
    <message>
        <source>The tool %1 does nothing: the scene has no %2.</source>
        <translation>Das Werkzeug %1 tut nichts: Der Szene fehlen %2.</translation>
    </message>
    <message>
        <source>%1 is a point of one patient, but the lesson is for any: give it as a share of the longest path, or choose the patient.</source>
        <translation>%1 ist ein Punkt eines Patienten, die Lektion ist aber für jeden: Geben Sie ihn als Anteil am längsten Weg an, oder wählen Sie den Patienten.</translation>
    </message>
    <message>
        <source>%1 is a point of the patient who is shown, but the lesson is for another one: choose him, or click on it there.</source>
        <translation>%1 ist ein Punkt des gezeigten Patienten, die Lektion ist aber für einen anderen: Wählen Sie diesen, oder klicken Sie bei ihm.</translation>
    </message>
    <message>
        <source>The case %1 is not there: choose the patient again.</source>
        <translation>Der Fall %1 ist nicht da: Wählen Sie den Patienten noch einmal.</translation>
    </message>
    <message>
        <source>%1, goal</source>
        <translation>%1, Ziel</translation>
    </message>
    <message>
        <source>%1, limits</source>
        <translation>%1, Grenzen</translation>
    </message>
    <message>
        <source>Limits all the time</source>
        <translation>Grenzen zu jeder Zeit</translation>
    </message>
    <message>
        <source>The target</source>
        <translation>Das Zielgebiet</translation>
    </message>
    <message>
        <source>Step %1 &quot;%2&quot;</source>
        <translation>Schritt %1 „%2“</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>The trainee may use no tool: allow one at least.</source>
        <translation>Der Übende darf kein Werkzeug benutzen: Erlauben Sie mindestens eines.</translation>
    </message>
    <message>
        <source>a drug that flows</source>
        <translation>ein fließender Wirkstoff</translation>
    </message>
    <message>
        <source>tools that touch the vessels</source>
        <translation>Werkzeuge, die die Gefäße berühren</translation>
    </message>
    <message>
        <source>vessels that move</source>
        <translation>bewegliche Gefäße</translation>
    </message>
    <message>
        <source>vessels that tear</source>
        <translation>reißende Gefäße</translation>
    </message>
    <message>
        <source>is broken at once, before anything is done.</source>
        <translation>ist sofort verletzt, bevor etwas getan wird.</translation>
    </message>
    <message>
        <source>is never decided: it is 1 at most. Give a bound from 0 to 1.</source>
        <translation>wird nie entschieden: Der Wert ist höchstens 1. Geben Sie eine Grenze von 0 bis 1 an.</translation>
    </message>
    <message>
        <source>is never measured: the scene has no %1.</source>
        <translation>wird nie gemessen: Der Szene fehlen %1.</translation>
    </message>
    <message>
        <source>is out of reach: no tool that is allowed can do that.</source>
        <translation>ist unerreichbar: Kein erlaubtes Werkzeug kann das.</translation>
    </message>
    <message>
        <source>is too short: what is to be held and waited for takes %1 or more.</source>
        <translation>ist zu kurz: Was zu halten und abzuwarten ist, dauert %1 oder mehr.</translation>
    </message>
    <message>
        <source>needs a target: say where it begins.</source>
        <translation>braucht ein Zielgebiet: Sagen Sie, wo es beginnt.</translation>
    </message>
    <message>
        <source>What the trainee is to do.</source>
        <translation>Was der Übende tun soll.</translation>
    </message>
    <message>
        <source>Slowly.</source>
        <translation>Langsam.</translation>
    </message>
    <message>
        <source>is %1, and this program reads 1</source>
        <translation>ist %1, und dieses Programm liest 1</translation>
    </message>
    <message>
        <source>is %1, not a list</source>
        <translation>ist %1, keine Liste</translation>
    </message>
    <message>
        <source>is %1, not a number</source>
        <translation>ist %1, keine Zahl</translation>
    </message>
    <message>
        <source>is %1, not a place</source>
        <translation>ist %1, kein Ort</translation>
    </message>
    <message>
        <source>is %1, not a text</source>
        <translation>ist %1, kein Text</translation>
    </message>
    <message>
        <source>Add it: see docs/lessons.md</source>
        <translation>Bitten Sie den, der die Datei gemacht hat, es zu ergänzen, oder machen Sie eine neue (Lektion &gt; Lektionen bearbeiten)</translation>
    </message>
    <message>
        <source>Choose from %1</source>
        <translation>Wählen Sie aus %1</translation>
    </message>
    <message>
        <source>Give a number</source>
        <translation>Geben Sie eine Zahl an</translation>
    </message>
    <message>
        <source>Give three numbers, in mm</source>
        <translation>Geben Sie drei Zahlen in mm an</translation>
    </message>
    <message>
        <source>Take a newer program, or write the file for version 1</source>
        <translation>Nehmen Sie ein neueres Programm, oder schreiben Sie die Datei für Version 1</translation>
    </message>
    <message>
        <source>Write it as [...]</source>
        <translation>Schreiben Sie es als [...]</translation>
    </message>
    <message>
        <source>Write it as &quot;...&quot;</source>
        <translation>Schreiben Sie es als &quot;...&quot;</translation>
    </message>
    <message>
        <source>Write it as {&quot;...&quot;: ...}</source>
        <translation>Schreiben Sie es als {&quot;...&quot;: ...}</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, not &quot;%2&quot;</source>
        <translation>ist „%1“, nicht „%2“</translation>
    </message>
    <message>
        <source>has no &quot;%1&quot;</source>
        <translation>hat kein „%1“</translation>
    </message>
    <message>
        <source>Of the quantities distance_mm, moved_mm and touch_mm alone name a mark</source>
        <translation>Von den Messgrößen nennen nur distance_mm, moved_mm und touch_mm eine Marke</translation>
    </message>
    <message>
        <source>Give 0 to 3600 seconds</source>
        <translation>Geben Sie 0 bis 3600 Sekunden an</translation>
    </message>
    <message>
        <source>Give &quot;goal&quot; at least one bound</source>
        <translation>Geben Sie „goal“ mindestens eine Grenze</translation>
    </message>
    <message>
        <source>Give a share from 0 (the root) to 1 (the end)</source>
        <translation>Geben Sie einen Anteil von 0 (der Wurzel) bis 1 (dem Ende) an</translation>
    </message>
    <message>
        <source>Leave out at_s and over_s: it is done before the first step</source>
        <translation>Lassen Sie at_s und over_s weg: Es geschieht vor dem ersten Schritt</translation>
    </message>
    <message>
        <source>Name it under &quot;marks&quot;</source>
        <translation>Nennen Sie sie unter „marks“</translation>
    </message>
    <message>
        <source>See docs/lessons.md, and assets/lessons for lessons that work</source>
        <translation>Bitten Sie den, der die Datei gemacht hat, um eine heile, oder machen Sie eine neue (Lektion &gt; Lektionen bearbeiten)</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no mark of this lesson</source>
        <translation>ist „%1“, keine Marke dieser Lektion</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no tool</source>
        <translation>ist „%1“, kein Werkzeug</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is not measured</source>
        <translation>ist „%1“, was nicht gemessen wird</translation>
    </message>
    <message>
        <source>does not say which mark is meant</source>
        <translation>sagt nicht, welche Marke gemeint ist</translation>
    </message>
    <message>
        <source>does something over time</source>
        <translation>tut etwas über eine Zeit</translation>
    </message>
    <message>
        <source>has no goal</source>
        <translation>hat kein Ziel</translation>
    </message>
    <message>
        <source>names a mark that it does not need</source>
        <translation>nennt eine Marke, die es nicht braucht</translation>
    </message>
    <message>
        <source>needs either at_least or at_most</source>
        <translation>braucht entweder at_least oder at_most</translation>
    </message>
    <message>
        <source>needs either share_of_longest_path or point_mm</source>
        <translation>braucht entweder share_of_longest_path oder point_mm</translation>
    </message>
    <message>
        <source>%1 has no goal: add what is to be reached.</source>
        <translation>%1 hat kein Ziel: Fügen Sie hinzu, was zu erreichen ist.</translation>
    </message>
    <message>
        <source>%1 says nothing: write what the trainee is to do.</source>
        <translation>%1 sagt nichts: Schreiben Sie, was der Übende tun soll.</translation>
    </message>
    <message>
        <source>The lesson has no name: give it one.</source>
        <translation>Die Lektion hat keinen Namen: Geben Sie ihr einen.</translation>
    </message>
    <message>
        <source>The scene is of nothing: let the vessels move, a drug be injected, or both.</source>
        <translation>Die Szene besteht aus nichts: Lassen Sie die Gefäße sich bewegen, einen Wirkstoff injizieren oder beides.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has lost its mark. Choose another one, or remove the bound.</source>
        <translation>%1: „%2“ hat seine Marke verloren. Wählen Sie eine andere, oder entfernen Sie die Grenze.</translation>
    </message>
    <message>
        <source>Give each mark a name of its own</source>
        <translation>Geben Sie jeder Marke einen eigenen Namen</translation>
    </message>
    <message>
        <source>has two marks called &quot;%1&quot;</source>
        <translation>hat zwei Marken namens „%1“</translation>
    </message>
    <message>
        <source>A piece came off</source>
        <translation>Ein Stück ging ab</translation>
    </message>
    <message>
        <source>About to tear</source>
        <translation>Kurz vor dem Reißen</translation>
    </message>
    <message>
        <source>Begun again from rest</source>
        <translation>Neu aus der Ruhe begonnen</translation>
    </message>
    <message>
        <source>Blade drawn</source>
        <translation>Schnitt mit dem Skalpell</translation>
    </message>
    <message>
        <source>Bleeding began</source>
        <translation>Blutung begann</translation>
    </message>
    <message>
        <source>Bleeding ended</source>
        <translation>Blutung endete</translation>
    </message>
    <message>
        <source>Cut line drawn</source>
        <translation>Schwächungslinie gezogen</translation>
    </message>
    <message>
        <source>Drug taken out</source>
        <translation>Wirkstoff entfernt</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Losgelassen</translation>
    </message>
    <message>
        <source>Not passed: %1</source>
        <translation>Nicht bestanden: %1</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Injected</source>
        <translation>Injiziert</translation>
    </message>
    <message>
        <source>Touched</source>
        <translation>Berührt</translation>
    </message>
    <message>
        <source>Step %1 reached</source>
        <translation>Schritt %1 erreicht</translation>
    </message>
    <message>
        <source>Rod probe taken</source>
        <translation>Stabsonde genommen</translation>
    </message>
    <message>
        <source>Probe taken</source>
        <translation>Sonde genommen</translation>
    </message>
    <message>
        <source>Hook taken</source>
        <translation>Haken genommen</translation>
    </message>
    <message>
        <source>Forceps taken</source>
        <translation>Pinzette genommen</translation>
    </message>
    <message>
        <source>Rod probe</source>
        <translation>Stabsonde</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Tearing stopped by its budget of %1</source>
        <translation>Das Reißen endete mit seinem Budget für %1</translation>
    </message>
    <message>
        <source>The simulation stopped by itself</source>
        <translation>Die Simulation blieb von selbst stehen</translation>
    </message>
    <message>
        <source>Took hold</source>
        <translation>Zugegriffen</translation>
    </message>
    <message>
        <source>Tool put away</source>
        <translation>Werkzeug weggelegt</translation>
    </message>
    <message>
        <source>Whole again</source>
        <translation>Wieder heil</translation>
    </message>
    <message>
        <source>has no surface</source>
        <translation>hat keine Oberfläche</translation>
    </message>
    <message>
        <source>the patient</source>
        <translation>der Patient</translation>
    </message>
    <message>
        <source>is %1, before the beginning</source>
        <translation>ist %1, vor dem Beginn</translation>
    </message>
    <message>
        <source>Mend the file, or remove it: it holds notes alone</source>
        <translation>Reparieren Sie die Datei, oder entfernen Sie sie: Sie enthält nur Notizen</translation>
    </message>
    <message>
        <source>Remove it by hand</source>
        <translation>Entfernen Sie sie von Hand</translation>
    </message>
    <message>
        <source>cannot be removed: %1</source>
        <translation>lässt sich nicht entfernen: %1</translation>
    </message>
    <message>
        <source>Choose one of a play that was begun</source>
        <translation>Wählen Sie die eines begonnenen Verlaufs</translation>
    </message>
    <message>
        <source>From here on it is not what was played: another build of the program or another processor recorded it</source>
        <translation>Ab hier ist es nicht mehr, was geübt wurde: Ein anderer Bau des Programms oder ein anderer Prozessor hat es aufgezeichnet</translation>
    </message>
    <message>
        <source>holds no step</source>
        <translation>enthält keinen Schritt</translation>
    </message>
    <message>
        <source>was played in another scene than the lesson&apos;s: %1</source>
        <translation>wurde in einer anderen Szene als der der Lektion geübt: %1</translation>
    </message>
    <message>
        <source>%1 is %2, not left out</source>
        <translation>%1 ist %2, nicht weggelassen</translation>
    </message>
    <message>
        <source>%1 is left out, not %2</source>
        <translation>%1 ist weggelassen, nicht %2</translation>
    </message>
    <message>
        <source>%1 is %2, not %3</source>
        <translation>%1 ist %2, nicht %3</translation>
    </message>
    <message>
        <source>diverged from the recording at step %1, so that it cannot be scored</source>
        <translation>wich bei Schritt %1 von der Aufzeichnung ab und lässt sich deshalb nicht bewerten</translation>
    </message>
    <message>
        <source>Another build of the program or another processor made it</source>
        <translation>Ein anderer Bau des Programms oder ein anderer Prozessor hat sie gemacht</translation>
    </message>
    <message>
        <source>Give a recording of this lesson</source>
        <translation>Geben Sie eine Aufzeichnung dieser Lektion an</translation>
    </message>
    <message>
        <source>Choose a place on the vessel tree</source>
        <translation>Wählen Sie einen Ort auf dem Gefäßbaum</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>das Zielgebiet</translation>
    </message>
    <message>
        <source>%1, %2 Newton iterates</source>
        <translation>%1, %2 Newton-Iterationen</translation>
    </message>
    <message>
        <source>%1, %2 substeps</source>
        <translation>%1, %2 Teilschritte</translation>
    </message>
    <message>
        <source>%1, %2 iterations</source>
        <translation>%1, %2 Iterationen</translation>
    </message>
    <message>
        <source>Reading the case</source>
        <translation>Der Fall wird gelesen</translation>
    </message>
    <message>
        <source>Reading the tree</source>
        <translation>Der Gefäßbaum wird gelesen</translation>
    </message>
    <message>
        <source>Reading the built-in patient</source>
        <translation>Der eingebaute Patient wird gelesen</translation>
    </message>
    <message>
        <source>Making the mesh</source>
        <translation>Das Netz wird erzeugt</translation>
    </message>
    <message>
        <source>Meshing the vessels</source>
        <translation>Die Gefäße werden vernetzt</translation>
    </message>
    <message>
        <source>Editing the tree</source>
        <translation>Der Gefäßbaum wird bearbeitet</translation>
    </message>
    <message>
        <source>Parting the liver into segments</source>
        <translation>Die Leber wird in Segmente geteilt</translation>
    </message>
    <message>
        <source>Growing the vessels</source>
        <translation>Die Gefäße wachsen</translation>
    </message>
    <message>
        <source>Drawing the body</source>
        <translation>Der Körper wird gezeichnet</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>Die Aufnahme entsteht</translation>
    </message>
    <message>
        <source>Extracting the tree</source>
        <translation>Der Gefäßbaum wird extrahiert</translation>
    </message>
    <message>
        <source>Making the skeleton one voxel wide</source>
        <translation>Das Skelett wird ein Voxel breit gemacht</translation>
    </message>
    <message>
        <source>Thinning to the skeleton</source>
        <translation>Die Gefäße werden zum Skelett verdünnt</translation>
    </message>
    <message>
        <source>Telling the systems apart</source>
        <translation>Die Gefäßsysteme werden unterschieden</translation>
    </message>
    <message>
        <source>Smoothing the vessels</source>
        <translation>Die Gefäße werden geglättet</translation>
    </message>
    <message>
        <source>Filling the vessels</source>
        <translation>Die Gefäße werden gefüllt</translation>
    </message>
    <message>
        <source>Drawing thin vessels</source>
        <translation>Dünne Gefäße werden gezeichnet</translation>
    </message>
    <message>
        <source>Finding the liver</source>
        <translation>Die Leber wird gesucht</translation>
    </message>
    <message>
        <source>Measuring the contrast</source>
        <translation>Der Kontrast wird gemessen</translation>
    </message>
    <message>
        <source>Refining the surface</source>
        <translation>Die Oberfläche wird verfeinert</translation>
    </message>
    <message>
        <source>Resampling the liver</source>
        <translation>Die Leber wird umgerechnet</translation>
    </message>
    <message>
        <source>Segmenting the vessels</source>
        <translation>Die Gefäße werden segmentiert</translation>
    </message>
    <message>
        <source>Following the vessel</source>
        <translation>Dem Gefäß wird gefolgt</translation>
    </message>
    <message>
        <source>Building the scene</source>
        <translation>Die Szene wird aufgebaut</translation>
    </message>
    <message>
        <source>Replaying</source>
        <translation>Die Aufzeichnung wird durchlaufen</translation>
    </message>
    <message>
        <source>Measuring the reference</source>
        <translation>Die Referenz wird gemessen</translation>
    </message>
    <message>
        <source>Measuring the settings</source>
        <translation>Die Einstellungen werden gemessen</translation>
    </message>
    <message>
        <source>check the name, and that its disk is connected</source>
        <translation>Prüfen Sie den Namen, und ob der Datenträger verbunden ist</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>Diese Datei oder diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>holds no voxels of vessels or organs</source>
        <translation>enthält keine Voxel von Gefäßen oder Organen</translation>
    </message>
    <message>
        <source>Reconstruct the case from its CT</source>
        <translation>Rekonstruieren Sie den Fall aus seinem CT</translation>
    </message>
    <message>
        <source>it is not known where this patient&apos;s CT lies</source>
        <translation>Es ist nicht bekannt, wo das CT dieses Patienten liegt</translation>
    </message>
    <message>
        <source>choose its folder or file</source>
        <translation>Wählen Sie seinen Ordner oder seine Datei</translation>
    </message>
    <message>
        <source>this is not the CT that the patient was reconstructed from</source>
        <translation>Das ist nicht das CT, aus dem der Patient rekonstruiert wurde</translation>
    </message>
    <message>
        <source>choose the one that was opened when the case was made; its files may have other names, but the voxels must be the same</source>
        <translation>Wählen Sie das CT, das geöffnet war, als der Fall entstand; die Dateien dürfen anders heißen, die Voxel müssen dieselben sein</translation>
    </message>
    <message>
        <source>%1 is passed over: %2</source>
        <translation>%1 wird übergangen: %2</translation>
    </message>
    <message>
        <source>Ask for the case again, or for its folder NAME.hep</source>
        <translation>Bitten Sie noch einmal um den Fall oder um seinen Ordner NAME.hep</translation>
    </message>
    <message>
        <source>Choose a folder you may write to, on a disk with room</source>
        <translation>Wählen Sie einen Ordner, in den Sie schreiben dürfen, auf einem Datenträger mit freiem Platz</translation>
    </message>
    <message>
        <source>Free some space among the temporary files: %1</source>
        <translation>Schaffen Sie Platz unter den temporären Dateien: %1</translation>
    </message>
    <message>
        <source>cannot be unpacked</source>
        <translation>lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>holds a file whose name no file of a case has: &quot;%1&quot;</source>
        <translation>enthält eine Datei, deren Namen keine Datei eines Falls hat: „%1“</translation>
    </message>
    <message>
        <source>holds more files than a case can</source>
        <translation>enthält mehr Dateien, als ein Fall haben kann</translation>
    </message>
    <message>
        <source>holds more than a case can: %1 is too large</source>
        <translation>enthält mehr, als ein Fall haben kann: %1 ist zu groß</translation>
    </message>
    <message>
        <source>holds %1 twice</source>
        <translation>enthält %1 zweimal</translation>
    </message>
    <message>
        <source>is damaged at %1</source>
        <translation>ist beschädigt bei %1</translation>
    </message>
    <message>
        <source>is encrypted</source>
        <translation>ist verschlüsselt</translation>
    </message>
    <message>
        <source>is not a case in one file (.hepz), or is damaged</source>
        <translation>ist kein Fall in einer Datei (.hepz) oder ist beschädigt</translation>
    </message>
    <message>
        <source>is not a patient&apos;s case: it holds no case.json</source>
        <translation>ist kein Fall: Er enthält kein case.json</translation>
    </message>
    <message>
        <source>has version %1; this program reads versions %2</source>
        <translation>hat Version %1; dieses Programm liest die Versionen %2</translation>
    </message>
    <message>
        <source>Check the path: a case is a folder NAME.hep or one file NAME.hepz</source>
        <translation>Prüfen Sie den Pfad: Ein Fall ist ein Ordner NAME.hep oder eine Datei NAME.hepz</translation>
    </message>
    <message>
        <source>Reconstruct the patient again: hepatica-cli reconstruct CT --out CASE.hep</source>
        <translation>Rekonstruieren Sie den Patienten noch einmal: Datei &gt; CT-Ordner öffnen oder CT-Datei öffnen</translation>
    </message>
    <message>
        <source>is not the file that case.json was written for (its hash differs)</source>
        <translation>ist nicht die Datei, für die case.json geschrieben wurde (der Hash weicht ab)</translation>
    </message>
    <message>
        <source>was not written by this program</source>
        <translation>wurde nicht von diesem Programm geschrieben</translation>
    </message>
    <message>
        <source>edit %1 at %2</source>
        <translation>Korrektur %1 bei %2</translation>
    </message>
    <message>
        <source>the edits leave nothing of the tree</source>
        <translation>Die Korrekturen lassen nichts vom Gefäßbaum übrig</translation>
    </message>
    <message>
        <source>the last edit</source>
        <translation>die letzte Korrektur</translation>
    </message>
    <message>
        <source>Take it back, or delete a smaller branch</source>
        <translation>Nehmen Sie sie zurück, oder löschen Sie einen kleineren Ast</translation>
    </message>
    <message>
        <source>is there already and is not a patient&apos;s case</source>
        <translation>ist schon da und ist kein Fall</translation>
    </message>
    <message>
        <source>is a folder, and no case in one file can take its place</source>
        <translation>ist ein Ordner, und kein Fall in einer Datei kann an seine Stelle treten</translation>
    </message>
    <message>
        <source>Choose another name, or rename the folder or move it away</source>
        <translation>Wählen Sie einen anderen Namen, oder benennen Sie den Ordner um oder verschieben Sie ihn</translation>
    </message>
    <message>
        <source>%1 is a folder, and no case in one file can take its place. Choose another name, or rename the folder or move it away.</source>
        <translation>%1 ist ein Ordner, und kein Fall in einer Datei kann an seine Stelle treten. Wählen Sie einen anderen Namen, oder benennen Sie den Ordner um oder verschieben Sie ihn.</translation>
    </message>
    <message>
        <source>Give --out another name; only an older case is replaced</source>
        <translation>Wählen Sie einen anderen Namen; ersetzt wird nur ein älterer Fall</translation>
    </message>
    <message>
        <source>Put the case back that was there, or open this one anew</source>
        <translation>Legen Sie den früheren Fall zurück, oder öffnen Sie diesen neu</translation>
    </message>
    <message>
        <source>holds another patient than when it was opened</source>
        <translation>enthält einen anderen Patienten als beim Öffnen</translation>
    </message>
    <message>
        <source>holds edits without the tree that they were made on</source>
        <translation>enthält Korrekturen ohne den Gefäßbaum, an dem sie gemacht wurden</translation>
    </message>
    <message>
        <source>No hepatic vein is known where the liver&apos;s segments part: an adult&apos;s usual planes stand in for them. A seed inside a hepatic vein helps.</source>
        <translation>Wo sich die Lebersegmente trennen, ist keine Lebervene bekannt: Die üblichen Ebenen eines Erwachsenen treten an ihre Stelle. Ein Startpunkt in einer Lebervene hilft.</translation>
    </message>
    <message>
        <source>Not all three hepatic veins are known where the liver&apos;s segments part: an adult&apos;s usual planes stand in for them. A seed inside a hepatic vein helps.</source>
        <translation>Wo sich die Lebersegmente trennen, sind nicht alle drei Lebervenen bekannt: Die üblichen Ebenen eines Erwachsenen treten an ihre Stelle. Ein Startpunkt in einer Lebervene hilft.</translation>
    </message>
    <message>
        <source>No portal branch to the liver&apos;s segment %1 was found: its part of the liver counts to the neighbours.</source>
        <translation>Zum Lebersegment %1 wurde kein Pfortaderast gefunden: Sein Teil der Leber zählt zu den Nachbarn.</translation>
    </message>
    <message>
        <source>No portal branch to the liver&apos;s segments %1 was found: their part of the liver counts to the neighbours.</source>
        <translation>Zu den Lebersegmenten %1 wurde kein Pfortaderast gefunden: Ihr Teil der Leber zählt zu den Nachbarn.</translation>
    </message>
    <message>
        <source>%1, %2 and %3</source>
        <translation>%1, %2 und %3</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>For %1 of the liver it is less than 80 % sure to which of Couinaud&apos;s segments it belongs: the branches there run across the usual borders.</source>
        <translation>Bei %1 der Leber ist weniger als 80 % sicher, zu welchem Couinaud-Segment sie gehören: Die Äste dort laufen über die üblichen Grenzen hinweg.</translation>
    </message>
    <message>
        <source>For %1 of the vessels&apos; length nothing tells which system they belong to. A seed inside the portal vein and one inside a hepatic vein would tell them apart.</source>
        <translation>Bei %1 der Gefäßlänge verrät nichts, zu welchem System sie gehört. Ein Startpunkt in der Pfortader und einer in einer Lebervene würden sie unterscheiden.</translation>
    </message>
    <message>
        <source>For %1 of the vessels&apos; length it is less than 80 % sure whether they belong to the portal vein or to the hepatic veins. Look at branches where both touch; a seed inside a wrong one, or giving the branch to the other system, mends all that hangs on it.</source>
        <translation>Bei %1 der Gefäßlänge ist weniger als 80 % sicher, ob sie zur Pfortader oder zu den Lebervenen gehört. Sehen Sie sich Äste an, wo beide sich berühren; ein Startpunkt in einem falschen, oder ihn dem anderen System zuzuordnen, richtet alles, was daran hängt.</translation>
    </message>
    <message>
        <source>The vessels rise only %1 HU above the liver, where the noise is %2 HU: most thin branches are missing, and some that are found may be noise. A scan in the portal venous phase, or a smoother kernel, shows more.</source>
        <translation>Die Gefäße heben sich nur um %1 HU von der Leber ab, bei einem Rauschen von %2 HU: Die meisten dünnen Äste fehlen, und manche gefundenen können Rauschen sein. Eine Aufnahme in der portalvenösen Phase oder ein glatterer Kern zeigt mehr.</translation>
    </message>
    <message>
        <source>%1 loop within one system, made where branches touch in the image, was opened. Thinner slices would part such branches.</source>
        <translation>%1 Schleife in einem System, entstanden, wo Äste sich im Bild berühren, wurde geöffnet. Dünnere Schichten würden solche Äste trennen.</translation>
    </message>
    <message>
        <source>%1 loops within one system, made where branches touch in the image, were opened. Thinner slices would part such branches.</source>
        <translation>%1 Schleifen in einem System, entstanden, wo Äste sich im Bild berühren, wurden geöffnet. Dünnere Schichten würden solche Äste trennen.</translation>
    </message>
    <message>
        <source>%1 loop is left in the vessels. Cut those that are no real connections.</source>
        <translation>%1 Schleife bleibt in den Gefäßen. Durchtrennen Sie, was keine echte Verbindung ist.</translation>
    </message>
    <message>
        <source>%1 loops are left in the vessels. Cut those that are no real connections.</source>
        <translation>%1 Schleifen bleiben in den Gefäßen. Durchtrennen Sie, was keine echte Verbindung ist.</translation>
    </message>
    <message>
        <source>In one tree (%1) blood comes in at an end of %2 mm radius (%3), and the end at %4, of %5 mm, is a wide way out for it. If that one is the trunk, set the root there.</source>
        <translation>In einem Baum (%1) tritt Blut an einem Ende von %2 mm Radius ein (%3), und das Ende bei %4, von %5 mm, ist ein weiter Ausgang dafür. Wenn jenes der Stamm ist, setzen Sie die Wurzel dorthin.</translation>
    </message>
    <message>
        <source>%1 piece of vessels, %2 mm in all, was left out of the tree: %3. A seed inside such a piece keeps it.</source>
        <translation>%1 Gefäßstück, insgesamt %2 mm, wurde aus dem Baum ausgelassen: %3. Ein Startpunkt darin behält es.</translation>
    </message>
    <message>
        <source>%1 pieces of vessels, %2 mm in all, were left out of the tree: %3. A seed inside such a piece keeps it.</source>
        <translation>%1 Gefäßstücke, insgesamt %2 mm, wurden aus dem Baum ausgelassen: %3. Ein Startpunkt in einem solchen behält es.</translation>
    </message>
    <message>
        <source>%1 piece as wide as an organ, %2 mm in all, was left out of the tree: %3. A seed inside such a piece keeps it.</source>
        <translation>%1 Stück, so weit wie ein Organ, insgesamt %2 mm, wurde aus dem Baum ausgelassen: %3. Ein Startpunkt darin behält es.</translation>
    </message>
    <message>
        <source>%1 pieces as wide as an organ, %2 mm in all, were left out of the tree: %3. A seed inside such a piece keeps it.</source>
        <translation>%1 Stücke, so weit wie ein Organ, insgesamt %2 mm, wurden aus dem Baum ausgelassen: %3. Ein Startpunkt in einem solchen behält es.</translation>
    </message>
    <message>
        <source>pieces shorter than %1 mm that nothing joins are often noise</source>
        <translation>Stücke unter %1 mm, die nichts verbindet, sind oft Rauschen</translation>
    </message>
    <message>
        <source>what hangs on a vessel by a neck and is wide and short is hardly one</source>
        <translation>Was an einem Hals an einem Gefäß hängt und weit und kurz ist, ist kaum eines</translation>
    </message>
    <message>
        <source>what joins the portal trunk before it divides mostly comes from other organs</source>
        <translation>Was vor der Teilung in den Pfortaderstamm mündet, kommt meist aus anderen Organen</translation>
    </message>
    <message>
        <source>The labels of the vessel mask were taken for systems: %1. If they mean something else, name them: --vessel-label LABEL=SYSTEM,LABEL=SYSTEM.</source>
        <translation>Die Labels der Gefäßmaske wurden als Systeme genommen: %1. Wenn sie etwas anderes bedeuten, geben Sie ihnen diese Labels in dem Programm, das sie gezeichnet hat.</translation>
    </message>
    <message>
        <source>%1 as %2, %3 as %4, %5 as %6</source>
        <translation>%1 als %2, %3 als %4, %5 als %6</translation>
    </message>
    <message>
        <source>%1 as %2, %3 as %4</source>
        <translation>%1 als %2, %3 als %4</translation>
    </message>
    <message>
        <source>%1 as %2</source>
        <translation>%1 als %2</translation>
    </message>
    <message>
        <source>Give a mask whose vessels are not 0</source>
        <translation>Geben Sie eine Maske an, in der die Gefäße nicht 0 sind</translation>
    </message>
    <message>
        <source>Name those that are vessels: --vessel-label LABEL=SYSTEM,LABEL=SYSTEM, where SYSTEM is portal, hepatic, artery or unknown; the others are left out</source>
        <translation>Geben Sie den Gefäßen in dem Programm, das sie gezeichnet hat, die Labels 1 (Pfortader), 2 (Lebervenen), 3 (Arterie) oder 255 (unbekannt), und lassen Sie die anderen weg</translation>
    </message>
    <message>
        <source>holds the labels %1, and %2 is no vascular system (%3)</source>
        <translation>enthält die Labels %1, und %2 ist kein Gefäßsystem (%3)</translation>
    </message>
    <message>
        <source>%1 and others</source>
        <translation>%1 und andere</translation>
    </message>
    <message>
        <source>no vessels were found</source>
        <translation>Es wurden keine Gefäße gefunden</translation>
    </message>
    <message>
        <source>Give a window (--window LO,HI) or a vessel mask (--vessel-mask)</source>
        <translation>Geben Sie ein Fenster oder eine Gefäßmaske an (Datei &gt; Mit Optionen rekonstruieren)</translation>
    </message>
    <message>
        <source>Give a window (--window LO,HI), a seed inside a vessel (--seed-mm) or a vessel mask (--vessel-mask)</source>
        <translation>Geben Sie ein Fenster, einen Startpunkt in einem Gefäß oder eine Gefäßmaske an (Datei &gt; Mit Optionen rekonstruieren)</translation>
    </message>
    <message>
        <source>Give the liver, too (--liver-mask): blood reaches tumours through it</source>
        <translation>Geben Sie auch die Leber an (Lebermaske): Tumoren erhalten ihr Blut durch sie</translation>
    </message>
    <message>
        <source>the vessels found are too small for a tree</source>
        <translation>Die gefundenen Gefäße sind zu klein für einen Baum</translation>
    </message>
    <message>
        <source>tumours are given without a liver</source>
        <translation>Tumoren sind ohne eine Leber angegeben</translation>
    </message>
    <message>
        <source>The correction number %1 is left out, because it cannot be made on these vessels: %2 (%3)</source>
        <translation>Die Korrektur Nummer %1 entfällt, weil sie an diesen Gefäßen nicht möglich ist: %2 (%3)</translation>
    </message>
    <message>
        <source>The seed at %1 is left out: %2</source>
        <translation>Der Startpunkt bei %1 entfällt: %2</translation>
    </message>
    <message>
        <source>Take back what was erased, or paint more of the vessels</source>
        <translation>Nehmen Sie zurück, was radiert wurde, oder malen Sie mehr von den Gefäßen</translation>
    </message>
    <message>
        <source>no vessel is left that is long enough for a tree</source>
        <translation>Es bleibt kein Gefäß, das lang genug für einen Baum ist</translation>
    </message>
    <message>
        <source>%1 lies outside the image, which reaches from %2 to %3</source>
        <translation>%1 liegt außerhalb des Bildes, das von %2 bis %3 reicht</translation>
    </message>
    <message>
        <source>%1 lies %2 mm from the liver of %3</source>
        <translation>%1 liegt %2 mm von der Leber von %3 entfernt</translation>
    </message>
    <message>
        <source>Give a place inside a vessel in or at the liver, in mm to the patient&apos;s left, back and head (LPS)</source>
        <translation>Geben Sie einen Ort in einem Gefäß in oder an der Leber an, in mm nach links, hinten und kopfwärts vom Patienten aus (LPS)</translation>
    </message>
    <message>
        <source>Give a place inside a vessel, in mm to the patient&apos;s left, back and head (LPS); other programs may show RAS: there change the sign of X and Y</source>
        <translation>Geben Sie einen Ort in einem Gefäß an, in mm nach links, hinten und kopfwärts vom Patienten aus (LPS); andere Programme zeigen vielleicht RAS: Drehen Sie dort das Vorzeichen von X und Y um</translation>
    </message>
    <message>
        <source>the window from %1 to %2 HU takes in the liver&apos;s own tissue, which has %3 HU</source>
        <translation>Das Fenster von %1 bis %2 HU schließt das Gewebe der Leber selbst ein, das %3 HU hat</translation>
    </message>
    <message>
        <source>only %1 % of the liver lie between %2 and %3 HU and hang together as vessels do; the tissue itself has %4 HU</source>
        <translation>Nur %1 % der Leber liegen zwischen %2 und %3 HU und hängen wie Gefäße zusammen; das Gewebe selbst hat %4 HU</translation>
    </message>
    <message>
        <source>what lies between %1 and %2 HU is darker than the tissue, which has %3 HU</source>
        <translation>Was zwischen %1 und %2 HU liegt, ist dunkler als das Gewebe, das %3 HU hat</translation>
    </message>
    <message>
        <source>what lies between %1 and %2 HU and hangs together as vessels do rises only %3 HU above the tissue, which has %4 HU</source>
        <translation>Was zwischen %1 und %2 HU liegt und wie Gefäße zusammenhängt, hebt sich nur um %3 HU vom Gewebe ab, das %4 HU hat</translation>
    </message>
    <message>
        <source>The slices are %1 mm apart: thin branches may be broken or missing. Up to 1.5 mm is better.</source>
        <translation>Die Schichten liegen %1 mm auseinander: Dünne Äste können unterbrochen sein oder fehlen. Besser sind bis zu 1,5 mm.</translation>
    </message>
    <message>
        <source>Choose a window that reaches from between tissue and vessels to above the brightest vessel, or give none.</source>
        <translation>Wählen Sie ein Fenster, das von zwischen Gewebe und Gefäßen bis über das hellste Gefäß reicht, oder keines.</translation>
    </message>
    <message>
        <source>Give a mask of the whole liver.</source>
        <translation>Geben Sie eine Maske der ganzen Leber an.</translation>
    </message>
    <message>
        <source>Use a scan with contrast medium (portal-venous phase for veins, arterial phase for arteries), or give a vessel mask.</source>
        <translation>Nehmen Sie eine Aufnahme mit Kontrastmittel (portalvenöse Phase für Venen, arterielle für Arterien), oder geben Sie eine Gefäßmaske an.</translation>
    </message>
    <message>
        <source>liver mask</source>
        <translation>Lebermaske</translation>
    </message>
    <message>
        <source>the liver mask is so thin that nothing of it is further than 3 mm inside</source>
        <translation>Die Lebermaske ist so dünn, dass nichts von ihr tiefer als 3 mm innen liegt</translation>
    </message>
    <message>
        <source>the vessels do not stand out from the liver: the brightest structures cover %1 % of it and rise %2 HU above its %3 HU, where the noise is %4 HU</source>
        <translation>Die Gefäße heben sich nicht von der Leber ab: Die hellsten Strukturen bedecken %1 % von ihr und liegen %2 HU über ihren %3 HU, bei einem Rauschen von %4 HU</translation>
    </message>
    <message>
        <source>the number of recursions of the refinement is %1</source>
        <translation>Die Zahl der Durchgänge der Verfeinerung ist %1</translation>
    </message>
    <message>
        <source>the refinement&apos;s level is %1</source>
        <translation>Die Schwelle der Verfeinerung ist %1</translation>
    </message>
    <message>
        <source>the refinement&apos;s sigma is %1 mm</source>
        <translation>Die Breite der Verfeinerung ist %1 mm</translation>
    </message>
    <message>
        <source>Use 0 (no refinement) or more.</source>
        <translation>Nehmen Sie 0 (keine Verfeinerung) oder mehr.</translation>
    </message>
    <message>
        <source>Use a level between 0 and 1.</source>
        <translation>Nehmen Sie eine Schwelle zwischen 0 und 1.</translation>
    </message>
    <message>
        <source>Use a sigma above 0.</source>
        <translation>Nehmen Sie eine Breite über 0.</translation>
    </message>
    <message>
        <source>a working spacing of %1 mm was asked for</source>
        <translation>Verlangt wurde ein Arbeitsabstand von %1 mm</translation>
    </message>
    <message>
        <source>Use 0.3 to 1.5 mm.</source>
        <translation>Nehmen Sie 0,3 bis 1,5 mm.</translation>
    </message>
    <message>
        <source>Give a mask in which the liver is not 0.</source>
        <translation>Geben Sie eine Maske an, in der die Leber nicht 0 ist.</translation>
    </message>
    <message>
        <source>Give the mask of the same patient, in the same space as the CT.</source>
        <translation>Geben Sie die Maske desselben Patienten an, im selben Raum wie das CT.</translation>
    </message>
    <message>
        <source>the liver mask is empty</source>
        <translation>Die Lebermaske ist leer</translation>
    </message>
    <message>
        <source>the liver mask lies outside the CT</source>
        <translation>Die Lebermaske liegt außerhalb des CTs</translation>
    </message>
    <message>
        <source>no liver was found: the largest soft organ between %1 and %2 HU has %3 ml</source>
        <translation>Es wurde keine Leber gefunden: Das größte weiche Organ zwischen %1 und %2 HU hat %3 ml</translation>
    </message>
    <message>
        <source>Check that the scan shows the liver, or give a liver mask.</source>
        <translation>Prüfen Sie, ob die Aufnahme die Leber zeigt, oder geben Sie eine Lebermaske an.</translation>
    </message>
    <message>
        <source>Choose a CT of the upper abdomen; where it does show the liver, give a liver mask.</source>
        <translation>Wählen Sie ein CT des Oberbauchs; wo es die Leber doch zeigt, geben Sie eine Lebermaske an.</translation>
    </message>
    <message>
        <source>no liver was found: the largest soft organ is enclosed by bone (%1 of what lies around it), as a brain is</source>
        <translation>Es wurde keine Leber gefunden: Das größte weiche Organ ist wie ein Gehirn von Knochen umgeben (%1 dessen, was darum liegt)</translation>
    </message>
    <message>
        <source>no liver was found: the largest soft organ lies between the lungs (%1 of what lies around it), as a heart does</source>
        <translation>Es wurde keine Leber gefunden: Das größte weiche Organ liegt wie ein Herz zwischen den Lungen (%1 dessen, was darum liegt)</translation>
    </message>
    <message>
        <source>Give a mask that lies inside the CT.</source>
        <translation>Geben Sie eine Maske an, die im CT liegt.</translation>
    </message>
    <message>
        <source>the liver region is empty</source>
        <translation>Der Leberbereich ist leer</translation>
    </message>
    <message>
        <source>Give the lower value first.</source>
        <translation>Geben Sie den kleineren Wert zuerst an.</translation>
    </message>
    <message>
        <source>the window runs from %1 to %2 HU</source>
        <translation>Das Fenster reicht von %1 bis %2 HU</translation>
    </message>
    <message>
        <source>a seed&apos;s place is no number</source>
        <translation>Der Ort eines Startpunkts ist keine Zahl</translation>
    </message>
    <message>
        <source>Give three finite numbers in mm.</source>
        <translation>Geben Sie drei endliche Zahlen in mm an.</translation>
    </message>
    <message>
        <source>Place the seed inside a vessel that the segmentation found.</source>
        <translation>Setzen Sie den Startpunkt in ein Gefäß, das die Segmentierung gefunden hat.</translation>
    </message>
    <message>
        <source>no vessel lies within 3 mm of the seed at %1</source>
        <translation>Kein Gefäß liegt näher als 3 mm am Startpunkt bei %1</translation>
    </message>
    <message>
        <source>a vesselness scale of %1 mm is below half a voxel</source>
        <translation>Ein Gefäßmaß von %1 mm liegt unter einem halben Voxel</translation>
    </message>
    <message>
        <source>Resample the volume to one spacing first.</source>
        <translation>Rechnen Sie das Volumen erst auf einen einheitlichen Abstand um.</translation>
    </message>
    <message>
        <source>Use scales of at least half the spacing.</source>
        <translation>Nehmen Sie Maße von mindestens dem halben Abstand.</translation>
    </message>
    <message>
        <source>vesselness needs cubic voxels, these are %1 by %2 mm</source>
        <translation>Das Gefäßmaß braucht würfelförmige Voxel, diese sind %1 mal %2 mm</translation>
    </message>
    <message>
        <source>a tolerance or time of the injection is negative</source>
        <translation>eine Toleranz oder Zeit der Injektion ist negativ</translation>
    </message>
    <message>
        <source>Give a time of 0 s or more</source>
        <translation>Geben Sie eine Zeit von 0 s oder mehr an</translation>
    </message>
    <message>
        <source>Give positive values</source>
        <translation>Geben Sie positive Werte an</translation>
    </message>
    <message>
        <source>Say where the drug enters</source>
        <translation>Sagen Sie, wo der Wirkstoff eintritt</translation>
    </message>
    <message>
        <source>the step is %1 s</source>
        <translation>der Schritt ist %1 s</translation>
    </message>
    <message>
        <source>there is no inlet %1</source>
        <translation>es gibt keinen Zufluss %1</translation>
    </message>
    <message>
        <source>injection</source>
        <translation>Injektion</translation>
    </message>
    <message>
        <source>node %1 does not exist</source>
        <translation>Knoten %1 existiert nicht</translation>
    </message>
    <message>
        <source>there is no segment %1</source>
        <translation>es gibt kein Segment %1</translation>
    </message>
    <message>
        <source>Choose a point on the vessel tree</source>
        <translation>Wählen Sie einen Punkt auf dem Gefäßbaum</translation>
    </message>
    <message>
        <source>Correct the list of roots and outlets</source>
        <translation>Korrigieren Sie die Liste der Wurzeln und Ausgänge</translation>
    </message>
    <message>
        <source>Correct the vessel tree there, or delete the segment</source>
        <translation>Korrigieren Sie dort den Gefäßbaum, oder löschen Sie das Segment</translation>
    </message>
    <message>
        <source>it begins and ends in the same node</source>
        <translation>es beginnt und endet im selben Knoten</translation>
    </message>
    <message>
        <source>it has no cones</source>
        <translation>es hat keine Kegel</translation>
    </message>
    <message>
        <source>it names a node that does not exist</source>
        <translation>es nennt einen Knoten, den es nicht gibt</translation>
    </message>
    <message>
        <source>vessel network</source>
        <translation>Gefäßnetz</translation>
    </message>
    <message>
        <source>an inlet&apos;s node</source>
        <translation>der Knoten eines Zuflusses</translation>
    </message>
    <message>
        <source>Give a positive value in Pa s/mm3</source>
        <translation>Geben Sie einen positiven Wert in Pa s/mm³ an</translation>
    </message>
    <message>
        <source>Give a mass flow there, or inject elsewhere</source>
        <translation>Geben Sie dort einen Massenstrom an, oder injizieren Sie anderswo</translation>
    </message>
    <message>
        <source>Give a pressure in Pa, at most 1e12</source>
        <translation>Geben Sie einen Druck in Pa an, höchstens 1e12</translation>
    </message>
    <message>
        <source>Give a value from 0 to 1000; about 1 is the engineering upper end</source>
        <translation>Geben Sie einen Wert von 0 bis 1000 an; etwa 1 ist technisch die Obergrenze</translation>
    </message>
    <message>
        <source>Give a value in Pa s/mm3, 0 or more; infinity closes the outlet</source>
        <translation>Geben Sie einen Wert in Pa s/mm³ an, 0 oder mehr; unendlich schließt den Ausgang</translation>
    </message>
    <message>
        <source>Give more than 0</source>
        <translation>Geben Sie mehr als 0 an</translation>
    </message>
    <message>
        <source>Give one for each or none</source>
        <translation>Geben Sie für jeden einen an oder keinen</translation>
    </message>
    <message>
        <source>Give one per outlet: %1</source>
        <translation>Geben Sie einen je Ausgang an: %1</translation>
    </message>
    <message>
        <source>Name a node of the network</source>
        <translation>Nennen Sie einen Knoten des Netzes</translation>
    </message>
    <message>
        <source>a pressure drives the flow where a vessel is torn and open</source>
        <translation>ein Druck treibt den Fluss, wo ein Gefäß gerissen und offen ist</translation>
    </message>
    <message>
        <source>a terminal resistance</source>
        <translation>ein Endwiderstand</translation>
    </message>
    <message>
        <source>an inlet pressure</source>
        <translation>ein Druck am Zufluss</translation>
    </message>
    <message>
        <source>an outlet pressure</source>
        <translation>ein Druck am Ausgang</translation>
    </message>
    <message>
        <source>flow conditions</source>
        <translation>Flussbedingungen</translation>
    </message>
    <message>
        <source>the ambient pressure</source>
        <translation>der Umgebungsdruck</translation>
    </message>
    <message>
        <source>the bifurcation loss coefficient</source>
        <translation>der Verlustbeiwert der Gabelungen</translation>
    </message>
    <message>
        <source>the number of outlet pressures</source>
        <translation>die Zahl der Drücke an Ausgängen</translation>
    </message>
    <message>
        <source>the number of terminal resistances</source>
        <translation>die Zahl der Endwiderstände</translation>
    </message>
    <message>
        <source>the opening of a torn vessel [mm2]</source>
        <translation>die Öffnung eines gerissenen Gefäßes [mm²]</translation>
    </message>
    <message>
        <source>the openings of torn vessels</source>
        <translation>die Öffnungen gerissener Gefäße</translation>
    </message>
    <message>
        <source>the outlet pressure</source>
        <translation>der Druck am Ausgang</translation>
    </message>
    <message>
        <source>the total terminal resistance</source>
        <translation>der gesamte Endwiderstand</translation>
    </message>
    <message>
        <source>there is no second phase called &apos;%1&apos;</source>
        <translation>es gibt keine zweite Phase namens „%1“</translation>
    </message>
    <message>
        <source>Give a positive value in g/mm3 for density, in Pa s for viscosity</source>
        <translation>Geben Sie einen positiven Wert an, für die Dichte in g/mm³, für die Viskosität in Pa s</translation>
    </message>
    <message>
        <source>Give a value from 0 up to, but not including, 1</source>
        <translation>Geben Sie einen Wert von 0 bis unter 1 an</translation>
    </message>
    <message>
        <source>the void fraction is %1</source>
        <translation>der Anteil der zweiten Phase ist %1</translation>
    </message>
    <message>
        <source>void fraction</source>
        <translation>Anteil der zweiten Phase</translation>
    </message>
    <message>
        <source>a flow of %1 mm3/s enters, but every way out is closed</source>
        <translation>ein Fluss von %1 mm³/s tritt ein, aber jeder Ausgang ist geschlossen</translation>
    </message>
    <message>
        <source>Check the radii and the flow for values out of range</source>
        <translation>Prüfen Sie Radien und Fluss auf unmögliche Werte</translation>
    </message>
    <message>
        <source>Open a segment or an outlet, or give the inlet a pressure instead of a flow</source>
        <translation>Öffnen Sie ein Segment oder einen Ausgang, oder geben Sie dem Zufluss einen Druck statt eines Flusses</translation>
    </message>
    <message>
        <source>Remove segments whose radii differ by many orders of magnitude</source>
        <translation>Entfernen Sie Segmente, deren Radien sich um viele Größenordnungen unterscheiden</translation>
    </message>
    <message>
        <source>the flow did not settle after %1 Newton steps</source>
        <translation>der Fluss kam nach %1 Newton-Schritten nicht zur Ruhe</translation>
    </message>
    <message>
        <source>the pressures cannot be told apart</source>
        <translation>die Drücke lassen sich nicht unterscheiden</translation>
    </message>
    <message>
        <source>the pressure at the tip (--pressure-pa) is %1 Pa and not above the %2 Pa beyond the outlets (--outlet-pressure-pa): nothing would be injected</source>
        <translation>der Druck an der Spitze ist %1 Pa und nicht höher als die %2 Pa jenseits der Ausgänge: Es würde nichts injiziert</translation>
    </message>
    <message>
        <source>Close a segment of the vessel tree</source>
        <translation>Schließen Sie ein Segment des Gefäßbaums</translation>
    </message>
    <message>
        <source>Give a higher pressure, or a mass flow</source>
        <translation>Geben Sie einen höheren Druck oder einen Massenstrom an</translation>
    </message>
    <message>
        <source>duration of the injection in s</source>
        <translation>Dauer der Injektion in s</translation>
    </message>
    <message>
        <source>end in s</source>
        <translation>Ende in s</translation>
    </message>
    <message>
        <source>flow of blood in g/s</source>
        <translation>Blutfluss in g/s</translation>
    </message>
    <message>
        <source>mass flow in g/s</source>
        <translation>Massenstrom in g/s</translation>
    </message>
    <message>
        <source>terminal resistance in Pa s/mm3</source>
        <translation>Endwiderstand in Pa s/mm³</translation>
    </message>
    <message>
        <source>time between samples in s</source>
        <translation>Zeit zwischen Werten in s</translation>
    </message>
    <message>
        <source>time of a tear in s</source>
        <translation>Zeit eines Risses in s</translation>
    </message>
    <message>
        <source>there is no pressure law called &apos;%1&apos;</source>
        <translation>es gibt kein Druckgesetz namens „%1“</translation>
    </message>
    <message>
        <source>Choose one of: published, consistent, regime</source>
        <translation>Wählen Sie eines von: published, consistent, regime</translation>
    </message>
    <message>
        <source>distal radius in mm</source>
        <translation>distaler Radius in mm</translation>
    </message>
    <message>
        <source>length in mm</source>
        <translation>Länge in mm</translation>
    </message>
    <message>
        <source>proximal radius in mm</source>
        <translation>proximaler Radius in mm</translation>
    </message>
    <message>
        <source>vessel segment</source>
        <translation>Gefäßsegment</translation>
    </message>
    <message>
        <source>the step was cut in halves: it would have made energy</source>
        <translation>der Schritt wurde halbiert: Er hätte Energie erzeugt</translation>
    </message>
    <message>
        <source>the body was stopped: no step lowers its energy</source>
        <translation>der Körper wurde angehalten: Kein Schritt senkt seine Energie</translation>
    </message>
    <message>
        <source>the body was slowed down: the step would have made energy</source>
        <translation>der Körper wurde gebremst: Der Schritt hätte Energie erzeugt</translation>
    </message>
    <message>
        <source>%1; a free piece lost spin</source>
        <translation>%1; ein freies Stück verlor Drehung</translation>
    </message>
    <message>
        <source>%1; a free piece lost momentum</source>
        <translation>%1; ein freies Stück verlor Impuls</translation>
    </message>
    <message>
        <source>the system of the step was not positive definite: %1 pivots were dropped</source>
        <translation>das Gleichungssystem des Schritts war nicht positiv definit: %1 Pivots entfielen</translation>
    </message>
    <message>
        <source>the system of the step could not be solved</source>
        <translation>das Gleichungssystem des Schritts ließ sich nicht lösen</translation>
    </message>
    <message>
        <source>the step was shortened: it would have made energy</source>
        <translation>der Schritt wurde verkürzt: Er hätte Energie erzeugt</translation>
    </message>
    <message>
        <source>elements that had turned inside out were put right</source>
        <translation>umgestülpte Elemente wurden zurechtgerückt</translation>
    </message>
    <message>
        <source>cannot follow a tear</source>
        <translation>kann keinem Riss folgen</translation>
    </message>
    <message>
        <source>the solver &quot;skeleton&quot;</source>
        <translation>der Löser „skeleton“</translation>
    </message>
    <message>
        <source>Choose cholesky, automatic or block-jacobi</source>
        <translation>Wählen Sie cholesky, automatic oder block-jacobi</translation>
    </message>
    <message>
        <source>would stand in the body</source>
        <translation>stünde im Körper</translation>
    </message>
    <message>
        <source>puts the body into the tool</source>
        <translation>bringt den Körper in das Werkzeug</translation>
    </message>
    <message>
        <source>the tool</source>
        <translation>das Werkzeug</translation>
    </message>
    <message>
        <source>the state</source>
        <translation>der Zustand</translation>
    </message>
    <message>
        <source>Put it beside the vessels</source>
        <translation>Setzen Sie es neben die Gefäße</translation>
    </message>
    <message>
        <source>Take the tool away first</source>
        <translation>Nehmen Sie erst das Werkzeug weg</translation>
    </message>
    <message>
        <source>the case</source>
        <translation>der Fall</translation>
    </message>
    <message>
        <source>has no mesh, so its vessels cannot be moved</source>
        <translation>hat kein Netz, sodass sich seine Gefäße nicht bewegen lassen</translation>
    </message>
    <message>
        <source>has no jaws</source>
        <translation>hat keine Backen</translation>
    </message>
    <message>
        <source>Take the forceps to open and close them</source>
        <translation>Nehmen Sie die Pinzette, um sie zu öffnen und zu schließen</translation>
    </message>
    <message>
        <source>vertex %1 does not exist</source>
        <translation>Ecke %1 existiert nicht</translation>
    </message>
    <message>
        <source>The body has vertices 0 to %1</source>
        <translation>Der Körper hat die Ecken 0 bis %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known</source>
        <translation>„%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>Give 0 or more</source>
        <translation>Geben Sie 0 oder mehr an</translation>
    </message>
    <message>
        <source>holds vertices that the body does not have</source>
        <translation>enthält Ecken, die der Körper nicht hat</translation>
    </message>
    <message>
        <source>Give a checkpoint of the same patient</source>
        <translation>Geben Sie einen Zwischenstand desselben Patienten an</translation>
    </message>
    <message>
        <source>nothing tears in this scene</source>
        <translation>in dieser Szene reißt nichts</translation>
    </message>
    <message>
        <source>Add &quot;tear&quot;: {} to the scene</source>
        <translation>Fügen Sie der Szene &quot;tear&quot;: {} hinzu</translation>
    </message>
    <message>
        <source>leads along no vessel</source>
        <translation>führt an keinem Gefäß entlang</translation>
    </message>
    <message>
        <source>the cut line</source>
        <translation>die Schwächungslinie</translation>
    </message>
    <message>
        <source>cut line</source>
        <translation>Schwächungslinie</translation>
    </message>
    <message>
        <source>strength along a cut line</source>
        <translation>Festigkeit entlang einer Schwächungslinie</translation>
    </message>
    <message>
        <source>Choose a value from 0 (nothing holds) to 1 (as before)</source>
        <translation>Wählen Sie einen Wert von 0 (nichts hält) bis 1 (wie vorher)</translation>
    </message>
    <message>
        <source>Give two places on one system, on a vessel wide enough to have joints</source>
        <translation>Geben Sie zwei Orte auf einem System an, auf einem Gefäß, das weit genug für Verbindungen ist</translation>
    </message>
    <message>
        <source>Give 0 s or more</source>
        <translation>Geben Sie 0 s oder mehr an</translation>
    </message>
    <message>
        <source>injects into segment %1, which is not there</source>
        <translation>injiziert in Segment %1, das es nicht gibt</translation>
    </message>
    <message>
        <source>bled from segment %1, which is not there</source>
        <translation>blutete aus Segment %1, das es nicht gibt</translation>
    </message>
    <message>
        <source>speed of the drug</source>
        <translation>Tempo des Wirkstoffs</translation>
    </message>
    <message>
        <source>time of the drug</source>
        <translation>Zeit des Wirkstoffs</translation>
    </message>
    <message>
        <source>a small synthetic patient, corotated in 8 substeps a frame, solved exactly, pulled by 30 mm in half a second and back (the mesh&apos;s own error is not in it)</source>
        <translation>einen kleinen synthetischen Patienten, korotiert in 8 Teilschritten je Bild, genau gelöst, in einer halben Sekunde um 30 mm gezogen und zurück (ohne den Fehler des Netzes selbst)</translation>
    </message>
    <message>
        <source>the same body, corotated on %1 tetrahedra, all of it in %2 substeps a frame, solved exactly, pulled by 30 mm in half a second and back (the mesh&apos;s own error is not in it)</source>
        <translation>denselben Körper, korotiert auf %1 Tetraedern, ganz in %2 Teilschritten je Bild, genau gelöst, in einer halben Sekunde um 30 mm gezogen und zurück (ohne den Fehler des Netzes selbst)</translation>
    </message>
    <message>
        <source>the same body, %1 on %2 tetrahedra, %3 substeps a frame, pulled by 30 mm in half a second and back (the mesh&apos;s own error is not in it)</source>
        <translation>denselben Körper, %1 auf %2 Tetraedern, %3 Teilschritte je Bild, in einer halben Sekunde um 30 mm gezogen und zurück (ohne den Fehler des Netzes selbst)</translation>
    </message>
    <message>
        <source>the same body, %1 on %2 tetrahedra, %3 substeps a frame, pulled by 30 mm in half a second and back</source>
        <translation>denselben Körper, %1 auf %2 Tetraedern, %3 Teilschritte je Bild, in einer halben Sekunde um 30 mm gezogen und zurück</translation>
    </message>
    <message>
        <source>dial.json of the case</source>
        <translation>dial.json des Falls</translation>
    </message>
    <message>
        <source>has another format or version</source>
        <translation>hat ein anderes Format oder eine andere Version</translation>
    </message>
    <message>
        <source>Measure again: hepatica-cli dial CASE --anew; or remove the file</source>
        <translation>Entfernen Sie die Datei: Es wird neu gemessen, während niemand übt</translation>
    </message>
    <message>
        <source>Branch %1 (%2), %3 of %4 mm along: %5 of %6 ends lie downstream; they get %7 % of the flow</source>
        <translation>Ast %1 (%2), bei %3 von %4 mm: %5 von %6 Enden liegen stromabwärts; sie erhalten %7 % des Flusses</translation>
    </message>
    <message>
        <source>Branch %1 (%2), %3 of %4 mm along: %5 of %6 ends lie downstream</source>
        <translation>Ast %1 (%2), bei %3 von %4 mm: %5 von %6 Enden liegen stromabwärts</translation>
    </message>
    <message>
        <source>Branch %1 (%2), %3 of %4 mm along: %5 of %6 ends of this tree lie downstream; they get %7 % of its flow; %8 more ends of the system hang on other roots</source>
        <translation>Ast %1 (%2), bei %3 von %4 mm: %5 von %6 Enden dieses Baums liegen stromabwärts; sie erhalten %7 % seines Flusses; %8 weitere Enden des Systems hängen an anderen Wurzeln</translation>
    </message>
    <message>
        <source>Branch %1 (%2), %3 of %4 mm along: %5 of %6 ends of this tree lie downstream; %7 more ends of the system hang on other roots</source>
        <translation>Ast %1 (%2), bei %3 von %4 mm: %5 von %6 Enden dieses Baums liegen stromabwärts; %7 weitere Enden des Systems hängen an anderen Wurzeln</translation>
    </message>
    <message>
        <source>Give 0 to 1000 mm</source>
        <translation>Geben Sie 0 bis 1000 mm an</translation>
    </message>
    <message>
        <source>Give 0.1 to 100 mm</source>
        <translation>Geben Sie 0,1 bis 100 mm an</translation>
    </message>
    <message>
        <source>Give three finite numbers that are not all 0</source>
        <translation>Geben Sie drei endliche Zahlen an, die nicht alle 0 sind</translation>
    </message>
    <message>
        <source>Give three finite numbers that are not along the direction</source>
        <translation>Geben Sie drei endliche Zahlen an, die nicht entlang der Richtung liegen</translation>
    </message>
    <message>
        <source>has a length of %1</source>
        <translation>hat eine Länge von %1</translation>
    </message>
    <message>
        <source>has a radius of %1</source>
        <translation>hat einen Radius von %1</translation>
    </message>
    <message>
        <source>has a side that is not beside its direction</source>
        <translation>hat eine Seite, die nicht neben seiner Richtung liegt</translation>
    </message>
    <message>
        <source>has no direction</source>
        <translation>hat keine Richtung</translation>
    </message>
    <message>
        <source>is a &quot;%1&quot;</source>
        <translation>ist ein „%1“</translation>
    </message>
    <message>
        <source>the place of the tool</source>
        <translation>der Ort des Werkzeugs</translation>
    </message>
    <message>
        <source>Give a checkpoint of this scene</source>
        <translation>Geben Sie einen Zwischenstand dieser Szene an</translation>
    </message>
    <message>
        <source>is of a scene with other parts</source>
        <translation>gehört zu einer Szene mit anderen Teilen</translation>
    </message>
    <message>
        <source>the stepper&apos;s bytes are not base64</source>
        <translation>die Bytes des Rechenschritts sind kein base64</translation>
    </message>
    <message>
        <source>less than nothing bled</source>
        <translation>es blutete weniger als nichts</translation>
    </message>
    <message>
        <source>The recording is damaged</source>
        <translation>Die Aufzeichnung ist beschädigt</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>the share of the tool&apos;s way</source>
        <translation>der Anteil am Weg des Werkzeugs</translation>
    </message>
    <message>
        <source>Add &quot;deform&quot; to the scene</source>
        <translation>Fügen Sie der Szene &quot;deform&quot; hinzu</translation>
    </message>
    <message>
        <source>Add &quot;flow&quot; to the scene</source>
        <translation>Fügen Sie der Szene &quot;flow&quot; hinzu</translation>
    </message>
    <message>
        <source>nothing flows in this scene</source>
        <translation>in dieser Szene fließt nichts</translation>
    </message>
    <message>
        <source>nothing moves in this scene</source>
        <translation>in dieser Szene bewegt sich nichts</translation>
    </message>
    <message>
        <source>command %1, field %2</source>
        <translation>Befehl %1, Feld %2</translation>
    </message>
    <message>
        <source>Correct the script or recording</source>
        <translation>Korrigieren Sie das Skript oder die Aufzeichnung</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no command</source>
        <translation>„%1“ ist kein Befehl</translation>
    </message>
    <message>
        <source>has a value of the wrong kind (%1)</source>
        <translation>hat einen Wert der falschen Art (%1)</translation>
    </message>
    <message>
        <source>has no name</source>
        <translation>hat keinen Namen</translation>
    </message>
    <message>
        <source>a keyframe of step %1 stands behind step %2</source>
        <translation>ein Zwischenstand von Schritt %1 steht hinter Schritt %2</translation>
    </message>
    <message>
        <source>%1, line %2 was not written to its end and is left out</source>
        <translation>%1, Zeile %2 wurde nicht zu Ende geschrieben und entfällt</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>was recorded by version %1, and this is %2, whose steps do not have the same bits</source>
        <translation>wurde mit Version %1 aufgezeichnet, und dies ist %2, deren Schritte nicht dieselben Bits haben</translation>
    </message>
    <message>
        <source>is of format %1, and this program reads format %2</source>
        <translation>hat das Format %1, und dieses Programm liest das Format %2</translation>
    </message>
    <message>
        <source>was made by a newer version of the program, in format %1; this one reads format %2</source>
        <translation>stammt von einer neueren Version des Programms, im Format %1; diese liest das Format %2</translation>
    </message>
    <message>
        <source>Open it with a newer version of the program</source>
        <translation>Öffnen Sie sie mit einer neueren Version des Programms</translation>
    </message>
    <message>
        <source>Choose a folder that exists and can be written to</source>
        <translation>Wählen Sie einen Ordner, der existiert und beschreibbar ist</translation>
    </message>
    <message>
        <source>Give a file written by simulate --record</source>
        <translation>Geben Sie eine Aufzeichnung dieses Programms an</translation>
    </message>
    <message>
        <source>Give a recording</source>
        <translation>Geben Sie eine Aufzeichnung an</translation>
    </message>
    <message>
        <source>Is the disk full? What was written before can be replayed</source>
        <translation>Ist der Datenträger voll? Was vorher geschrieben wurde, lässt sich abspielen</translation>
    </message>
    <message>
        <source>Record the session again</source>
        <translation>Zeichnen Sie den Verlauf noch einmal auf</translation>
    </message>
    <message>
        <source>Replay it with version %1</source>
        <translation>Geben Sie sie mit Version %1 wieder</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a hash</source>
        <translation>„%1“ ist kein Hash</translation>
    </message>
    <message>
        <source>could not be written to its end</source>
        <translation>ließ sich nicht zu Ende schreiben</translation>
    </message>
    <message>
        <source>is not a recording</source>
        <translation>ist keine Aufzeichnung</translation>
    </message>
    <message>
        <source>step %1 is behind the end</source>
        <translation>Schritt %1 liegt hinter dem Ende</translation>
    </message>
    <message>
        <source>the keyframe of step %1 is not the state that was recorded</source>
        <translation>der Zwischenstand von Schritt %1 ist nicht der aufgezeichnete Zustand</translation>
    </message>
    <message>
        <source>Begin at an earlier step</source>
        <translation>Beginnen Sie bei einem früheren Schritt</translation>
    </message>
    <message>
        <source>Give the case whose tree and mesh have the hash %1</source>
        <translation>Geben Sie den Fall an, dessen Baum und Netz den Hash %1 haben</translation>
    </message>
    <message>
        <source>It has %1 steps</source>
        <translation>Sie hat %1 Schritte</translation>
    </message>
    <message>
        <source>Replay it with the back end that recorded it</source>
        <translation>Geben Sie sie mit dem Rechenkern wieder, der sie aufzeichnete</translation>
    </message>
    <message>
        <source>was computed by the back end &quot;%1&quot;, and this is &quot;%2&quot;</source>
        <translation>wurde vom Rechenkern „%1“ berechnet, und dies ist „%2“</translation>
    </message>
    <message>
        <source>is not the patient that was recorded</source>
        <translation>ist nicht der aufgezeichnete Patient</translation>
    </message>
    <message>
        <source>The simulation diverged: it was taken back to its last good state and stopped. Resume to go on</source>
        <translation>Die Simulation ist divergiert: Sie wurde auf ihren letzten guten Zustand zurückgesetzt und angehalten. Lassen Sie sie weiterlaufen, um fortzufahren</translation>
    </message>
    <message>
        <source>The simulation stopped: %1. It goes back to its last good state; resume to go on. %2</source>
        <translation>Die Simulation wurde angehalten: %1. Sie geht auf ihren letzten guten Zustand zurück; lassen Sie sie weiterlaufen, um fortzufahren. %2</translation>
    </message>
    <message>
        <source>it was told to within a step</source>
        <translation>sie wurde in einem Schritt dazu aufgefordert</translation>
    </message>
    <message>
        <source>What was done in the last second is lost</source>
        <translation>Was in der letzten Sekunde geschah, ist verloren</translation>
    </message>
    <message>
        <source>there was not enough memory</source>
        <translation>der Speicher reichte nicht</translation>
    </message>
    <message>
        <source>Close other programs or make the scene smaller</source>
        <translation>Schließen Sie andere Programme, oder machen Sie die Szene kleiner</translation>
    </message>
    <message>
        <source>Save what you need: it may happen again</source>
        <translation>Speichern Sie, was Sie brauchen: Es kann wieder geschehen</translation>
    </message>
    <message>
        <source>an error without a name</source>
        <translation>ein Fehler ohne Namen</translation>
    </message>
    <message>
        <source>Time since the vessels may tear (s)</source>
        <translation>Zeit, seit die Gefäße reißen können (s)</translation>
    </message>
    <message>
        <source>bleeding</source>
        <translation>Blutung</translation>
    </message>
    <message>
        <source>no more bleeding</source>
        <translation>blutet nicht mehr</translation>
    </message>
    <message>
        <source>tear stopped</source>
        <translation>Riss angehalten</translation>
    </message>
    <message>
        <source>entropy budget</source>
        <translation>Entropiebudget</translation>
    </message>
    <message>
        <source>vertex budget</source>
        <translation>Eckenbudget</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Drug arrival (s)</source>
        <translation>Ankunft des Wirkstoffs (s)</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>jetzt %1</translation>
    </message>
    <message>
        <source>axis: square root of time</source>
        <translation>Achse: Wurzel der Zeit</translation>
    </message>
    <message>
        <source>The drug&apos;s front</source>
        <translation>Front des Wirkstoffs</translation>
    </message>
    <message>
        <source>Liver segment</source>
        <translation>Lebersegment</translation>
    </message>
    <message>
        <source>Liver segment %1</source>
        <translation>Lebersegment %1</translation>
    </message>
    <message>
        <source>Load (% of what tears)</source>
        <translation>Last (% bis zum Reißen)</translation>
    </message>
    <message>
        <source>Touch and force</source>
        <translation>Berührung und Kraft</translation>
    </message>
    <message>
        <source>A place of the lesson</source>
        <translation>Ein Ort der Lektion</translation>
    </message>
    <message>
        <source>%1 mm at the depth of the view&apos;s centre</source>
        <translation>%1 mm in der Tiefe der Bildmitte</translation>
    </message>
    <message>
        <source>%1, grip %2</source>
        <translation>%1, Griff %2</translation>
    </message>
    <message>
        <source>grip %1</source>
        <translation>Griff %1</translation>
    </message>
    <message>
        <source>hepatic vein</source>
        <translation>Lebervene</translation>
    </message>
    <message>
        <source>hepatic artery</source>
        <translation>Leberarterie</translation>
    </message>
    <message>
        <source>vein at large strain</source>
        <translation>Vene bei großer Dehnung</translation>
    </message>
    <message>
        <source>parenchyma</source>
        <translation>Parenchym</translation>
    </message>
    <message>
        <source>more than half of it lies in vessels that are there already</source>
        <translation>mehr als die Hälfte davon liegt in Gefäßen, die schon da sind</translation>
    </message>
    <message>
        <source>Begin at the wall of the vessel and draw what is missing, or delete the branch first</source>
        <translation>Beginnen Sie an der Wand des Gefäßes, und zeichnen Sie, was fehlt, oder löschen Sie erst den Ast</translation>
    </message>
    <message>
        <source>both ends of the vessel lie at one point</source>
        <translation>beide Enden des Gefäßes liegen an einem Punkt</translation>
    </message>
    <message>
        <source>Draw it from one place to another</source>
        <translation>Zeichnen Sie es von einem Ort zu einem anderen</translation>
    </message>
    <message>
        <source>vessels meet here, and it is not clear which of them is meant</source>
        <translation>Gefäße treffen sich hier, und es ist nicht klar, welches gemeint ist</translation>
    </message>
    <message>
        <source>Name a place on the vessel away from the fork</source>
        <translation>Nennen Sie einen Ort auf dem Gefäß abseits der Gabelung</translation>
    </message>
    <message>
        <source>the vessel is of that system already: %1</source>
        <translation>das Gefäß gehört schon zu diesem System: %1</translation>
    </message>
    <message>
        <source>Name another vessel, or another system</source>
        <translation>Nennen Sie ein anderes Gefäß oder ein anderes System</translation>
    </message>
    <message>
        <source>no vessel within 10 mm</source>
        <translation>kein Gefäß im Umkreis von 10 mm</translation>
    </message>
    <message>
        <source>Name a place on a vessel</source>
        <translation>Nennen Sie einen Ort auf einem Gefäß</translation>
    </message>
    <message>
        <source>the vessel is too short here to be parted by a gap of 1 mm</source>
        <translation>das Gefäß ist hier zu kurz für eine Lücke von 1 mm</translation>
    </message>
    <message>
        <source>Cut a longer one beside it, or delete it</source>
        <translation>Durchtrennen Sie ein längeres daneben, oder löschen Sie es</translation>
    </message>
    <message>
        <source>both ends of the link lie at one point</source>
        <translation>beide Enden der Verbindung liegen an einem Punkt</translation>
    </message>
    <message>
        <source>Name two places that are not joined yet</source>
        <translation>Nennen Sie zwei Orte, die noch nicht verbunden sind</translation>
    </message>
    <message>
        <source>the vessel would join two systems: %1 and %2</source>
        <translation>das Gefäß würde zwei Systeme verbinden: %1 und %2</translation>
    </message>
    <message>
        <source>End it before the other vessel&apos;s wall, or say first of which system that vessel is</source>
        <translation>Beenden Sie es vor der Wand des anderen Gefäßes, oder sagen Sie erst, zu welchem System jenes gehört</translation>
    </message>
    <message>
        <source>there is no edit named %1</source>
        <translation>es gibt keine Korrektur namens %1</translation>
    </message>
    <message>
        <source>Take the edit out of the file</source>
        <translation>Nehmen Sie die Korrektur aus der Datei</translation>
    </message>
    <message>
        <source>there is no vascular system %1</source>
        <translation>es gibt kein Gefäßsystem %1</translation>
    </message>
    <message>
        <source>Name one of these: %1</source>
        <translation>Nennen Sie eines von diesen: %1</translation>
    </message>
    <message>
        <source>a vessel is drawn by %1 points with %2 radii</source>
        <translation>ein Gefäß ist durch %1 Punkte mit %2 Radien gezeichnet</translation>
    </message>
    <message>
        <source>a vessel is drawn with a radius of %1 mm</source>
        <translation>ein Gefäß ist mit einem Radius von %1 mm gezeichnet</translation>
    </message>
    <message>
        <source>Give two points or more in path_mm, and one of radii_mm for each</source>
        <translation>Geben Sie zwei Punkte oder mehr in path_mm an und einen von radii_mm für jeden</translation>
    </message>
    <message>
        <source>Give radii from 0.001 to 50 mm</source>
        <translation>Geben Sie Radien von 0,001 bis 50 mm an</translation>
    </message>
    <message>
        <source>an edit</source>
        <translation>eine Korrektur</translation>
    </message>
    <message>
        <source>a vessel</source>
        <translation>ein Gefäß</translation>
    </message>
    <message>
        <source>is not a list of edits</source>
        <translation>ist keine Liste von Korrekturen</translation>
    </message>
    <message>
        <source>Give a JSON array of edits</source>
        <translation>Geben Sie ein JSON-Feld von Korrekturen an</translation>
    </message>
    <message>
        <source>the place lies outside of the CT</source>
        <translation>der Ort liegt außerhalb des CTs</translation>
    </message>
    <message>
        <source>Point at the vessel within the image</source>
        <translation>Zeigen Sie im Bild auf das Gefäß</translation>
    </message>
    <message>
        <source>two places that follow each other are more than 50 mm apart</source>
        <translation>zwei aufeinanderfolgende Orte liegen mehr als 50 mm auseinander</translation>
    </message>
    <message>
        <source>Point at places between them</source>
        <translation>Zeigen Sie auf Orte dazwischen</translation>
    </message>
    <message>
        <source>a vessel needs two places at least</source>
        <translation>ein Gefäß braucht mindestens zwei Orte</translation>
    </message>
    <message>
        <source>the vessel that is drawn</source>
        <translation>das gezeichnete Gefäß</translation>
    </message>
    <message>
        <source>Point at its beginning and at its end</source>
        <translation>Zeigen Sie auf seinen Anfang und auf sein Ende</translation>
    </message>
    <message>
        <source>the CT shows no vessel there that is 15 HU brighter than its surroundings</source>
        <translation>das CT zeigt dort kein Gefäß, das 15 HU heller als seine Umgebung ist</translation>
    </message>
    <message>
        <source>Point at the middle of a bright vessel; what the CT does not show is joined as two vessels are linked</source>
        <translation>Zeigen Sie auf die Mitte eines hellen Gefäßes; was das CT nicht zeigt, wird verbunden wie zwei Gefäße</translation>
    </message>
    <message>
        <source>%1 mm long, more than %2 steps of %3 mm</source>
        <translation>%1 mm lang, mehr als %2 Schritte von %3 mm</translation>
    </message>
    <message>
        <source>Check the unit of the positions: millimetres</source>
        <translation>Prüfen Sie die Einheit der Positionen: Millimeter</translation>
    </message>
    <message>
        <source>a bridge</source>
        <translation>eine Überbrückung</translation>
    </message>
    <message>
        <source>a bridge has fewer than two points</source>
        <translation>eine Überbrückung hat weniger als zwei Punkte</translation>
    </message>
    <message>
        <source>Give a JSON array of bridges</source>
        <translation>Geben Sie ein JSON-Feld von Überbrückungen an</translation>
    </message>
    <message>
        <source>Give a tree in a .vtp, .swc or .json file</source>
        <translation>Geben Sie einen Gefäßbaum als .vtp, .swc oder .json an</translation>
    </message>
    <message>
        <source>has a vessel of radius %1</source>
        <translation>hat ein Gefäß vom Radius %1</translation>
    </message>
    <message>
        <source>Give radii in millimetres, from 0.001 to 1000, at every point</source>
        <translation>Geben Sie an jedem Punkt Radien in Millimetern an, von 0,001 bis 1000</translation>
    </message>
    <message>
        <source>counts its vascular systems from 0 and does not name them, as older versions did</source>
        <translation>zählt seine Gefäßsysteme ab 0 und nennt sie nicht, wie ältere Versionen</translation>
    </message>
    <message>
        <source>Make the tree anew: phantom and reconstruct give the same one from the same options; or open the case that it was taken from</source>
        <translation>Erzeugen Sie den Gefäßbaum neu: Aus denselben Optionen entsteht derselbe; oder öffnen Sie den Fall, aus dem er stammt</translation>
    </message>
    <message>
        <source>a node</source>
        <translation>ein Knoten</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>ein Punkt</translation>
    </message>
    <message>
        <source>is no format of vessel trees</source>
        <translation>ist kein Format für Gefäßbäume</translation>
    </message>
    <message>
        <source>Choose a name that ends in .vtp, .swc or .json</source>
        <translation>Wählen Sie einen Namen, der auf .vtp, .swc oder .json endet</translation>
    </message>
    <message>
        <source>hepatica vessel tree</source>
        <translation>hepatica vessel tree</translation>
    </message>
    <message>
        <source>is of version %1</source>
        <translation>ist von der Version %1</translation>
    </message>
    <message>
        <source>Write it anew with this program</source>
        <translation>Schreiben Sie ihn mit diesem Programm neu</translation>
    </message>
    <message>
        <source>Give a JSON file that holds a vessel tree</source>
        <translation>Geben Sie eine JSON-Datei mit einem Gefäßbaum an</translation>
    </message>
    <message>
        <source>line %1 is not a sample</source>
        <translation>Zeile %1 ist kein Messpunkt</translation>
    </message>
    <message>
        <source>Give an SWC file: seven numbers per line</source>
        <translation>Geben Sie eine SWC-Datei an: sieben Zahlen je Zeile</translation>
    </message>
    <message>
        <source>sample %1 is its own ancestor</source>
        <translation>Messpunkt %1 ist sein eigener Vorfahr</translation>
    </message>
    <message>
        <source>Give a tree: each vessel must lead back to a root</source>
        <translation>Geben Sie einen Baum an: Jedes Gefäß muss zu einer Wurzel führen</translation>
    </message>
    <message>
        <source>sample %1 stands there twice</source>
        <translation>Messpunkt %1 kommt doppelt vor</translation>
    </message>
    <message>
        <source>Number the samples differently</source>
        <translation>Nummerieren Sie die Messpunkte verschieden</translation>
    </message>
    <message>
        <source>sample %1 names a parent, %2, that is not there</source>
        <translation>Messpunkt %1 nennt einen Vorgänger, %2, den es nicht gibt</translation>
    </message>
    <message>
        <source>Give the whole file</source>
        <translation>Geben Sie die ganze Datei an</translation>
    </message>
    <message>
        <source>holds no vessel</source>
        <translation>enthält kein Gefäß</translation>
    </message>
    <message>
        <source>Give an SWC file with two samples or more</source>
        <translation>Geben Sie eine SWC-Datei mit mindestens zwei Messpunkten an</translation>
    </message>
    <message>
        <source>Give a VTP file with the centrelines of vessels as lines</source>
        <translation>Geben Sie eine VTP-Datei mit den Mittellinien der Gefäße als Linien an</translation>
    </message>
    <message>
        <source>holds no lines</source>
        <translation>enthält keine Linien</translation>
    </message>
    <message>
        <source>does not say which way its axes run (it has no field data SPACE)</source>
        <translation>sagt nicht, wie seine Achsen verlaufen (es hat keine Felddaten SPACE)</translation>
    </message>
    <message>
        <source>State it, --tree-space lps or --tree-space ras, or save the tree from 3D Slicer, which writes SPACE</source>
        <translation>Sagen Sie es auf der Kommandozeile, oder speichern Sie den Baum mit 3D Slicer, das SPACE schreibt</translation>
    </message>
    <message>
        <source>Save it in LPS or RAS</source>
        <translation>Speichern Sie ihn in LPS oder RAS</translation>
    </message>
    <message>
        <source>says itself that its axes are %1</source>
        <translation>sagt selbst, dass seine Achsen %1 sind</translation>
    </message>
    <message>
        <source>Leave --tree-space out</source>
        <translation>Lassen Sie den Raum des Baums weg</translation>
    </message>
    <message>
        <source>holds radii that are not one number each</source>
        <translation>enthält Radien, die nicht je eine Zahl sind</translation>
    </message>
    <message>
        <source>its segments are not in the order of SegmentId</source>
        <translation>seine Segmente stehen nicht in der Reihenfolge von SegmentId</translation>
    </message>
    <message>
        <source>holds no radii</source>
        <translation>enthält keine Radien</translation>
    </message>
    <message>
        <source>Give the lines a point or cell array MaximumInscribedSphereRadius or Radius [mm], or state one radius for all vessels: --radius-mm</source>
        <translation>Geben Sie den Linien ein Feld MaximumInscribedSphereRadius oder Radius [mm], oder nennen Sie auf der Kommandozeile einen Radius für alle Gefäße</translation>
    </message>
    <message>
        <source>holds radii of its own</source>
        <translation>enthält eigene Radien</translation>
    </message>
    <message>
        <source>Leave --radius-mm out</source>
        <translation>Lassen Sie den Radius weg</translation>
    </message>
    <message>
        <source>Choose a folder that can be written and has space left</source>
        <translation>Wählen Sie einen Ordner, der beschreibbar ist und Platz hat</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>has &quot;%1&quot; in place of a number</source>
        <translation>hat „%1“ anstelle einer Zahl</translation>
    </message>
    <message>
        <source>has %1 bytes, no whole number of values</source>
        <translation>hat %1 Bytes, keine ganze Zahl von Werten</translation>
    </message>
    <message>
        <source>is compressed by &quot;%1&quot;, neither zlib nor LZ4</source>
        <translation>ist mit „%1“ komprimiert, weder zlib noch LZ4</translation>
    </message>
    <message>
        <source>Give a file of VTK&apos;s XML formats</source>
        <translation>Geben Sie eine Datei der XML-Formate von VTK an</translation>
    </message>
    <message>
        <source>is damaged, or no XML file of VTK</source>
        <translation>ist beschädigt oder keine XML-Datei von VTK</translation>
    </message>
    <message>
        <source>has a %1 of &quot;%2&quot;</source>
        <translation>hat ein %1 von „%2“</translation>
    </message>
    <message>
        <source>has a NumberOfComponents of &quot;%1&quot;</source>
        <translation>hat ein NumberOfComponents von „%1“</translation>
    </message>
    <message>
        <source>is of no known type</source>
        <translation>ist von keiner bekannten Art</translation>
    </message>
    <message>
        <source>has %1 numbers instead of %2</source>
        <translation>hat %1 Zahlen statt %2</translation>
    </message>
    <message>
        <source>holds texts with a NumberOfComponents of &quot;%1&quot;</source>
        <translation>enthält Texte mit einem NumberOfComponents von „%1“</translation>
    </message>
    <message>
        <source>has the character %1</source>
        <translation>hat das Zeichen %1</translation>
    </message>
    <message>
        <source>has %1 texts instead of %2</source>
        <translation>hat %1 Texte statt %2</translation>
    </message>
    <message>
        <source>is in no known format</source>
        <translation>ist in keinem bekannten Format</translation>
    </message>
    <message>
        <source>has an offset of &quot;%1&quot; beyond the file&apos;s data</source>
        <translation>hat einen Versatz „%1“ jenseits der Daten</translation>
    </message>
    <message>
        <source>Save the file anew with the program that wrote it</source>
        <translation>Speichern Sie die Datei neu mit dem Programm, das sie schrieb</translation>
    </message>
    <message>
        <source>its array &quot;%1&quot; %2</source>
        <translation>sein Feld „%1“ %2</translation>
    </message>
    <message>
        <source>is of type &quot;%1&quot; instead of %2</source>
        <translation>ist von der Art „%1“ statt %2</translation>
    </message>
    <message>
        <source>holds no %1</source>
        <translation>enthält kein %1</translation>
    </message>
    <message>
        <source>holds several pieces, of which one can be read</source>
        <translation>enthält mehrere Stücke, von denen eines gelesen werden kann</translation>
    </message>
    <message>
        <source>holds no points</source>
        <translation>enthält keine Punkte</translation>
    </message>
    <message>
        <source>has a NumberOfPoints of &quot;%1&quot;</source>
        <translation>hat ein NumberOfPoints von „%1“</translation>
    </message>
    <message>
        <source>holds points that are not of three coordinates</source>
        <translation>enthält Punkte, die nicht drei Koordinaten haben</translation>
    </message>
    <message>
        <source>does not say which points its %1 have</source>
        <translation>sagt nicht, welche Punkte seine %1 haben</translation>
    </message>
    <message>
        <source>does not fit the connectivity of %1 points</source>
        <translation>passt nicht zur Verknüpfung von %1 Punkten</translation>
    </message>
    <message>
        <source>a cell names point %1 of %2</source>
        <translation>eine Zelle nennt Punkt %1 von %2</translation>
    </message>
    <message>
        <source>does not say of what kind its cells are</source>
        <translation>sagt nicht, von welcher Art seine Zellen sind</translation>
    </message>
    <message>
        <source>states %1 bytes where %2 are left</source>
        <translation>nennt %1 Bytes, wo %2 übrig sind</translation>
    </message>
    <message>
        <source>is no base64</source>
        <translation>ist kein base64</translation>
    </message>
    <message>
        <source>has %1 bytes instead of %2</source>
        <translation>hat %1 Bytes statt %2</translation>
    </message>
    <message>
        <source>states %1 bytes</source>
        <translation>nennt %1 Bytes</translation>
    </message>
    <message>
        <source>has a last block of %1 bytes, larger than the others of %2</source>
        <translation>hat einen letzten Block von %1 Bytes, größer als die anderen von %2</translation>
    </message>
    <message>
        <source>states %1 blocks</source>
        <translation>nennt %1 Blöcke</translation>
    </message>
    <message>
        <source>states a block of %1 bytes in %2</source>
        <translation>nennt einen Block von %1 Bytes in %2</translation>
    </message>
    <message>
        <source>has a damaged block</source>
        <translation>hat einen beschädigten Block</translation>
    </message>
    <message>
        <source>the skeleton and the vessel mask lie on different grids</source>
        <translation>Skelett und Gefäßmaske liegen auf verschiedenen Gittern</translation>
    </message>
    <message>
        <source>Make the skeleton from this mask</source>
        <translation>Machen Sie das Skelett aus dieser Maske</translation>
    </message>
    <message>
        <source>The tree file is damaged or not a vessel tree</source>
        <translation>Die Datei des Gefäßbaums ist beschädigt oder kein Gefäßbaum</translation>
    </message>
    <message>
        <source>has fewer than two points</source>
        <translation>hat weniger als zwei Punkte</translation>
    </message>
    <message>
        <source>does not have one radius per point</source>
        <translation>hat nicht einen Radius je Punkt</translation>
    </message>
    <message>
        <source>does not say of each point whether it bridges a gap</source>
        <translation>sagt nicht von jedem Punkt, ob er eine Lücke überbrückt</translation>
    </message>
    <message>
        <source>has a point that is not finite</source>
        <translation>hat einen Punkt, der nicht endlich ist</translation>
    </message>
    <message>
        <source>has a radius that is not positive</source>
        <translation>hat einen Radius, der nicht positiv ist</translation>
    </message>
    <message>
        <source>has two equal consecutive points</source>
        <translation>hat zwei gleiche aufeinanderfolgende Punkte</translation>
    </message>
    <message>
        <source>names a node that does not exist</source>
        <translation>nennt einen Knoten, den es nicht gibt</translation>
    </message>
    <message>
        <source>stands before its parent</source>
        <translation>steht vor seinem Vorgänger</translation>
    </message>
    <message>
        <source>does not begin where its parent ends</source>
        <translation>beginnt nicht, wo sein Vorgänger endet</translation>
    </message>
    <message>
        <source>has a segment %1 whose points end %2 mm away from its node %3</source>
        <translation>hat ein Segment %1, dessen Punkte %2 mm neben seinem Knoten %3 enden</translation>
    </message>
    <message>
        <source>Let its first and last point be the positions of its nodes</source>
        <translation>Lassen Sie den ersten und letzten Punkt auf den Knoten liegen</translation>
    </message>
    <message>
        <source>has a confidence outside 0 to 1</source>
        <translation>hat eine Sicherheit außerhalb von 0 bis 1</translation>
    </message>
    <message>
        <source>a triangle of the surface names a vertex that is not there</source>
        <translation>ein Dreieck der Oberfläche nennt eine Ecke, die es nicht gibt</translation>
    </message>
    <message>
        <source>a vertex was split from one that is not there</source>
        <translation>eine Ecke wurde von einer abgespalten, die es nicht gibt</translation>
    </message>
    <message>
        <source>the surface of %1 meets itself along an edge or in a point, whatever the size of the elements (&quot;closed&quot; is false)</source>
        <translation>die Oberfläche (%1) trifft sich an einer Kante oder in einem Punkt selbst, bei jeder Größe der Elemente</translation>
    </message>
    <message>
        <source>The mesh is not sound: %1. Forces pass through such places as through a hinge. %2</source>
        <translation>Das Netz ist nicht einwandfrei: %1. Kräfte gehen durch solche Stellen wie durch ein Scharnier. %2</translation>
    </message>
    <message>
        <source>Branches that touch may be parted (hepatica-cli edit), or give another number of tetrahedra</source>
        <translation>Äste, die sich berühren, lassen sich trennen (Bearbeiten in der Werkzeugleiste), oder geben Sie eine andere Zahl von Tetraedern an</translation>
    </message>
    <message>
        <source>the mesh</source>
        <translation>das Netz</translation>
    </message>
    <message>
        <source>Check that the folder may be written and has free space</source>
        <translation>Prüfen Sie, ob der Ordner beschreibbar ist und Platz hat</translation>
    </message>
    <message>
        <source>a vertex</source>
        <translation>eine Ecke</translation>
    </message>
    <message>
        <source>holds cells of another kind</source>
        <translation>enthält Zellen anderer Art</translation>
    </message>
    <message>
        <source>names vertex %1, which does not exist</source>
        <translation>nennt Ecke %1, die es nicht gibt</translation>
    </message>
    <message>
        <source>is not closed at the edge between vertices %1 and %2</source>
        <translation>ist an der Kante zwischen den Ecken %1 und %2 nicht geschlossen</translation>
    </message>
    <message>
        <source>has a triangle with vertex %1 twice</source>
        <translation>hat ein Dreieck, das Eckpunkt %1 zweimal nennt</translation>
    </message>
    <message>
        <source>The mesh is damaged; reconstruct the patient again</source>
        <translation>Das Netz ist beschädigt; rekonstruieren Sie den Patienten noch einmal</translation>
    </message>
    <message>
        <source>is flat or inverted (volume %1)</source>
        <translation>ist flach oder umgestülpt (Volumen %1)</translation>
    </message>
    <message>
        <source>the vessels are %1 radii long, too thin for tetrahedra</source>
        <translation>die Gefäße sind %1 Radien lang, zu dünn für Tetraeder</translation>
    </message>
    <message>
        <source>an element size of %1 radii</source>
        <translation>eine Elementgröße von %1 Radien</translation>
    </message>
    <message>
        <source>Check the unit of the radii (millimetres), or set a least radius</source>
        <translation>Prüfen Sie die Einheit der Radien (Millimeter), oder setzen Sie einen kleinsten Radius</translation>
    </message>
    <message>
        <source>Choose a size from 0.3 to 1 radius</source>
        <translation>Wählen Sie eine Größe von 0,3 bis 1 Radius</translation>
    </message>
    <message>
        <source>Lower the window of intensities or give a vessel mask</source>
        <translation>Senken Sie das Fenster, oder geben Sie eine Gefäßmaske an</translation>
    </message>
    <message>
        <source>mesh options</source>
        <translation>Optionen des Netzes</translation>
    </message>
    <message>
        <source>There is no case in this folder. Choose another one, or save a patient here: File &gt; Save case as.</source>
        <translation>In diesem Ordner liegt kein Fall. Wählen Sie einen anderen, oder speichern Sie hier einen Patienten: Datei &gt; Fall speichern unter.</translation>
    </message>
    <message>
        <source>mark %1</source>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>mark 1</source>
        <translation>Marke 1</translation>
    </message>
    <message>
        <source>Pressure at the catheter (mmHg)</source>
        <translation>Druck am Katheter (mmHg)</translation>
    </message>
    <message>
        <source>%1 (s)</source>
        <translation>%1 (s)</translation>
    </message>
    <message>
        <source>%1 (mm)</source>
        <translation>%1 (mm)</translation>
    </message>
    <message>
        <source>%1 (mN)</source>
        <translation>%1 (mN)</translation>
    </message>
    <message>
        <source>%1 (mN s)</source>
        <translation>%1 (mN s)</translation>
    </message>
    <message>
        <source>%1 (mm²)</source>
        <translation>%1 (mm²)</translation>
    </message>
    <message>
        <source>%1 (g)</source>
        <translation>%1 (g)</translation>
    </message>
    <message>
        <source>Choosing the vessels</source>
        <translation>Gefäße werden ausgewählt</translation>
    </message>
    <message>
        <source>Export DICO&amp;M segmentation…</source>
        <translation>DICOM-Se&amp;gmentierung exportieren …</translation>
    </message>
    <message>
        <source>Write vessels, liver and tumours as a segmentation of the CT, for the archive and other viewers</source>
        <translation>Gefäße, Leber und Tumoren als Segmentierung des CTs schreiben, für das Archiv und andere Programme</translation>
    </message>
    <message>
        <source>DICOM segmentations (*.dcm)</source>
        <translation>DICOM-Segmentierungen (*.dcm)</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>is there and is no segmentation</source>
        <translation>ist schon da und keine Segmentierung</translation>
    </message>
    <message>
        <source>Choose another name, or take the file away</source>
        <translation>Wählen Sie einen anderen Namen oder nehmen Sie die Datei weg</translation>
    </message>
    <message>
        <source>More or fewer &amp;vessels…</source>
        <translation>&amp;Mehr oder weniger Gefäße …</translation>
    </message>
    <message>
        <source>Try another threshold in the slices, and make the vessels anew of it</source>
        <translation>Eine andere Schwelle in den Schichten ausprobieren und die Gefäße daraus neu bauen</translation>
    </message>
    <message>
        <source>More or fewer vessels</source>
        <translation>Mehr oder weniger Gefäße</translation>
    </message>
    <message>
        <source>Threshold from which a line is believed to be a vessel</source>
        <translation>Schwelle, ab der eine Linie als Gefäß gilt</translation>
    </message>
    <message>
        <source>To the left more and fainter vessels come in, and more of what is none; to the right the faintest go</source>
        <translation>Nach links kommen mehr und schwächere Gefäße dazu und mehr, was keines ist; nach rechts gehen die schwächsten</translation>
    </message>
    <message>
        <source>%1 % of the usual</source>
        <translation>%1 % der üblichen</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>How often the surface is smoothed on top of what was done</source>
        <translation>Wie oft die Oberfläche noch geglättet wird</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>The &amp;usual</source>
        <translation>Die ü&amp;bliche</translation>
    </message>
    <message>
        <source>&amp;Rebuild</source>
        <translation>&amp;Neu bauen</translation>
    </message>
    <message>
        <source>The vessels are made anew of what the slices show; an undo takes it back</source>
        <translation>Die Gefäße werden aus dem neu gebaut, was die Schichten zeigen; Rückgängig nimmt es zurück</translation>
    </message>
    <message>
        <source>Waiting for the CT</source>
        <translation>Das CT wird erwartet</translation>
    </message>
    <message>
        <source>The lines of the CT are being measured…</source>
        <translation>Gefäßverläufe im CT werden bestimmt …</translation>
    </message>
    <message>
        <source>%1 is no share of the usual threshold</source>
        <translation>%1 ist kein Anteil der üblichen Schwelle</translation>
    </message>
    <message>
        <source>%1 recursions cannot be made</source>
        <translation>%1 Wiederholungen sind nicht möglich</translation>
    </message>
    <message>
        <source>Give a whole number from 0 to %1</source>
        <translation>Geben Sie eine ganze Zahl von 0 bis %1 an</translation>
    </message>
    <message>
        <source>Tumour %1 painted</source>
        <translation>Tumor %1 gemalt</translation>
    </message>
    <message>
        <source>Tumours erased</source>
        <translation>Tumoren radiert</translation>
    </message>
    <message>
        <source>Tumour %1 erased</source>
        <translation>Tumor %1 radiert</translation>
    </message>
    <message>
        <source>there is no such tumour to be erased</source>
        <translation>dort ist kein solcher Tumor, der zu radieren wäre</translation>
    </message>
    <message>
        <source>there is nothing that could become tumour</source>
        <translation>dort ist nichts, was Tumor werden könnte</translation>
    </message>
    <message>
        <source>Lead the brush elsewhere, or take the edit out</source>
        <translation>Führen Sie den Pinsel anderswohin, oder nehmen Sie die Korrektur heraus</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>a brush</source>
        <translation>ein Pinsel</translation>
    </message>
    <message>
        <source>a brush is led nowhere</source>
        <translation>ein Pinsel wird nirgendwohin geführt</translation>
    </message>
    <message>
        <source>Give one point or more in path_mm</source>
        <translation>Geben Sie in path_mm mindestens einen Punkt an</translation>
    </message>
    <message>
        <source>a brush has a radius of %1 mm</source>
        <translation>ein Pinsel hat einen Radius von %1 mm</translation>
    </message>
    <message>
        <source>Give a radius above 0 and up to 50 mm</source>
        <translation>Geben Sie einen Radius über 0 und bis 50 mm an</translation>
    </message>
    <message>
        <source>there can be no tumour %1</source>
        <translation>es kann keinen Tumor %1 geben</translation>
    </message>
    <message>
        <source>Number tumours from 1 to %1</source>
        <translation>Nummerieren Sie Tumoren von 1 bis %1</translation>
    </message>
    <message>
        <source>Paint tumour</source>
        <translation>Tumor malen</translation>
    </message>
    <message>
        <source>Erase tumour</source>
        <translation>Tumor radieren</translation>
    </message>
    <message>
        <source>Drag over what is tumour (+ and - size the brush)</source>
        <translation>Ziehen Sie über den Tumor (+, -: Größe)</translation>
    </message>
    <message>
        <source>Drag over what is no tumour (+ and - size the brush)</source>
        <translation>Ziehen Sie über Falsches (+, -: Größe)</translation>
    </message>
    <message>
        <source>Which tumour is painted or erased</source>
        <translation>Welcher Tumor gemalt oder radiert wird</translation>
    </message>
    <message>
        <source>Tumours keep their numbers; one that is wholly erased is gone</source>
        <translation>Tumoren behalten ihre Nummern; einer, der ganz ausradiert ist, ist fort</translation>
    </message>
    <message>
        <source>Any tumour</source>
        <translation>Jeder Tumor</translation>
    </message>
    <message>
        <source>New tumour</source>
        <translation>Neuer Tumor</translation>
    </message>
    <message>
        <source>Tumour %1</source>
        <translation>Tumor %1</translation>
    </message>
    <message>
        <source>tumour %1</source>
        <translation>Tumor %1</translation>
    </message>
    <message>
        <source>The voxels are being read</source>
        <translation>Die Voxel werden gelesen</translation>
    </message>
    <message>
        <source>Too far from the liver for a tumour of it</source>
        <translation>Zu weit von der Leber für einen Tumor in ihr</translation>
    </message>
    <message>
        <source>There are %1 tumours, and no more can be told apart</source>
        <translation>Es gibt %1 Tumoren; mehr lassen sich nicht unterscheiden</translation>
    </message>
    <message>
        <source>Nothing erased: there is no such tumour</source>
        <translation>Nichts radiert: Dort ist kein solcher Tumor</translation>
    </message>
    <message>
        <source>Nothing painted: that is another tumour or the vena cava</source>
        <translation>Nichts gemalt: Das ist ein anderer Tumor oder die Vena cava</translation>
    </message>
    <message>
        <source>This case knows no voxels that could be tumour</source>
        <translation>Dieser Fall kennt keine Voxel, die Tumor sein könnten</translation>
    </message>
    <message>
        <source>The tumours cannot be read: %1</source>
        <translation>Die Tumoren können nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>CT as volu&amp;me</source>
        <translation>CT als Volu&amp;men</translation>
    </message>
    <message>
        <source>Draw the CT around the vessels: bones, enhanced blood, organs as a haze</source>
        <translation>Das CT um die Gefäße zeichnen: Knochen, kontrastiertes Blut, Organe als Schleier</translation>
    </message>
    <message>
        <source>CT as volume</source>
        <translation>CT als Volumen</translation>
    </message>
    <message>
        <source>Vessels and bones</source>
        <translation>Gefäße und Knochen</translation>
    </message>
    <message>
        <source>Maximum intensity</source>
        <translation>Maximumintensität</translation>
    </message>
    <message>
        <source>What of the CT stands out</source>
        <translation>Was vom CT hervortritt</translation>
    </message>
    <message>
        <source>Vessels and bones: light on what is bright, soft tissue a haze. Maximum intensity: the brightest voxel behind each point. Both follow the grey window of the slices: what they show black is clear</source>
        <translation>Gefäße und Knochen: Licht auf dem, was hell ist, Weichgewebe als Schleier. Maximumintensität: das hellste Voxel hinter jedem Punkt. Beide folgen der Fensterung der Schichten: Was sie schwarz zeigen, ist durchsichtig</translation>
    </message>
    <message>
        <source>How dense the CT is drawn</source>
        <translation>Wie dicht das CT gezeichnet wird</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>this CT holds nothing of the patient&apos;s liver</source>
        <translation>dieses CT enthält nichts von der Leber des Patienten</translation>
    </message>
    <message>
        <source>choose the one that the case was made of</source>
        <translation>wählen Sie das, aus dem der Fall entstanden ist</translation>
    </message>
    <message>
        <source>the vessels found are %1 m long together, more than a liver shows</source>
        <translation>die gefundenen Gefäße sind zusammen %1 m lang, mehr als eine Leber zeigt</translation>
    </message>
    <message>
        <source>Noise is taken for vessels: choose a higher threshold, or give a mask of the vessels</source>
        <translation>Rauschen wird für Gefäße gehalten: Wählen Sie eine höhere Schwelle oder geben Sie eine Maske der Gefäße an</translation>
    </message>
    <message>
        <source>Tumours</source>
        <translation>Tumoren</translation>
    </message>
    <message>
        <source>the time of a move</source>
        <translation>die Zeit eines Zuges</translation>
    </message>
    <message>
        <source>Choose a value above 0, up to 1</source>
        <translation>Wählen Sie einen Wert über 0, bis 1</translation>
    </message>
    <message>
        <source>Give the edit all of its values, each of its kind</source>
        <translation>Geben Sie der Korrektur alle ihre Werte, jeden von seiner Art</translation>
    </message>
    <message>
        <source>%1, edit %2</source>
        <translation>%1, Korrektur %2</translation>
    </message>
    <message>
        <source>The CT of this patient</source>
        <translation>Das CT dieses Patienten</translation>
    </message>
    <message>
        <source>Where is this patient&apos;s CT?</source>
        <translation>Wo liegt das CT dieses Patienten?</translation>
    </message>
    <message>
        <source>Choose the folder of its DICOM series, or the file of a volume.</source>
        <translation>Wählen Sie den Ordner seiner DICOM-Serie oder die Datei eines Volumens.</translation>
    </message>
    <message>
        <source>A lesson was left unsaved when the program ended. It is kept: Lesson &gt; Edit lessons shows it as it was.</source>
        <translation>Eine Lektion war nicht gespeichert, als das Programm endete. Sie ist aufgehoben: Lektion &gt; Lektionen bearbeiten zeigt sie, wie sie war.</translation>
    </message>
    <message>
        <source>Edit it</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>&amp;Usual</source>
        <translation>&amp;Gewohnt</translation>
    </message>
    <message>
        <source>Right drag orbits, middle drag pans, the wheel zooms</source>
        <translation>Rechts ziehen dreht, Mitte ziehen verschiebt, das Rad vergrößert</translation>
    </message>
    <message>
        <source>As in 3D &amp;Slicer</source>
        <translation>Wie in 3D &amp;Slicer</translation>
    </message>
    <message>
        <source>Right drag zooms, middle drag pans; left drag beside the vessels orbits</source>
        <translation>Rechts ziehen vergrößert, Mitte ziehen verschiebt; links neben den Gefäßen ziehen dreht</translation>
    </message>
    <message>
        <source>As in &amp;CAD</source>
        <translation>Wie in &amp;CAD</translation>
    </message>
    <message>
        <source>Middle drag orbits, with Ctrl it pans, with Shift it zooms; right drag pans</source>
        <translation>Mitte ziehen dreht, mit Strg verschiebt es, mit Umschalt vergrößert es; rechts ziehen verschiebt</translation>
    </message>
    <message>
        <source>The lesson %1 holds changes that are not saved.</source>
        <translation>Die Lektion %1 enthält Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Keep for later</source>
        <translation>Für später aufheben</translation>
    </message>
    <message>
        <source>The lesson does not allow this: %1</source>
        <translation>Die Lektion erlaubt das nicht: %1</translation>
    </message>
    <message>
        <source>Whose attempts</source>
        <translation>Wessen Versuche</translation>
    </message>
    <message>
        <source>of everybody</source>
        <translation>von allen</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>none needed</source>
        <translation>nicht nötig</translation>
    </message>
    <message>
        <source>The lesson does not allow this</source>
        <translation>Die Lektion erlaubt das nicht</translation>
    </message>
    <message>
        <source>Pull a vessel aside, hold it there, and let it go. Veins bear little: stay below a stretch of 1.25, and do not jerk: 2000 mN end it.</source>
        <translation>Ziehen Sie ein Gefäß beiseite, halten Sie es dort, und lassen Sie es los. Venen halten wenig aus: Bleiben Sie unter einer Dehnung von 1,25, und reißen Sie nicht daran: 2000 mN beenden die Lektion.</translation>
    </message>
    <message>
        <source>no contacts</source>
        <translation>keine Berührungen</translation>
    </message>
    <message>
        <source>no joints broken</source>
        <translation>keine gerissenen Verbindungen</translation>
    </message>
    <message>
        <source>no injections that are running</source>
        <translation>keine laufenden Injektionen</translation>
    </message>
    <message>
        <source>no vessels held by hand or tool</source>
        <translation>keine Gefäße an Hand oder Werkzeug</translation>
    </message>
    <message>
        <source>the lesson does not allow this: %1</source>
        <translation>die Lektion erlaubt das nicht: %1</translation>
    </message>
    <message>
        <source>pulling by hand</source>
        <translation>Ziehen mit der Hand</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>rod probe</source>
        <translation>Stabsonde</translation>
    </message>
    <message>
        <source>forceps</source>
        <translation>Pinzette</translation>
    </message>
    <message>
        <source>hook</source>
        <translation>Haken</translation>
    </message>
    <message>
        <source>blade</source>
        <translation>Skalpell</translation>
    </message>
    <message>
        <source>injecting</source>
        <translation>Injizieren</translation>
    </message>
    <message>
        <source>changing settings</source>
        <translation>Einstellungen ändern</translation>
    </message>
    <message>
        <source>distance of the tip to %1 at least %2</source>
        <translation>Abstand der Spitze zu „%1“ mindestens %2</translation>
    </message>
    <message>
        <source>distance of the tip to %1 at most %2</source>
        <translation>Abstand der Spitze zu „%1“ höchstens %2</translation>
    </message>
    <message>
        <source>way moved by %1 at least %2</source>
        <translation>Verschiebung von „%1“ mindestens %2</translation>
    </message>
    <message>
        <source>way moved by %1 at most %2</source>
        <translation>Verschiebung von „%1“ höchstens %2</translation>
    </message>
    <message>
        <source>distance of the touch to %1 at least %2</source>
        <translation>Abstand der Berührung zu „%1“ mindestens %2</translation>
    </message>
    <message>
        <source>distance of the touch to %1 at most %2</source>
        <translation>Abstand der Berührung zu „%1“ höchstens %2</translation>
    </message>
    <message>
        <source>Bl&amp;ade</source>
        <translation>S&amp;kalpell</translation>
    </message>
    <message>
        <source>Re&amp;set</source>
        <translation>Zur&amp;ücksetzen</translation>
    </message>
    <message>
        <source>Rims at cr&amp;ossings</source>
        <translation>Ränder an Kreu&amp;zungen</translation>
    </message>
    <message>
        <source>Open the vie&amp;w</source>
        <translation>Ansicht aufschnei&amp;den</translation>
    </message>
    <message>
        <source>H&amp;int</source>
        <translation>H&amp;inweis</translation>
    </message>
    <message>
        <source>Be&amp;gin again</source>
        <translation>Von v&amp;orn beginnen</translation>
    </message>
    <message>
        <source>Leav&amp;e</source>
        <translation>Verla&amp;ssen</translation>
    </message>
    <message>
        <source>Open recen&amp;t</source>
        <translation>Zuletz&amp;t benutzt</translation>
    </message>
    <message>
        <source>&amp;Compare with…</source>
        <translation>Ver&amp;gleichen mit …</translation>
    </message>
    <message>
        <source>&amp;Save a film…</source>
        <translation>&amp;Film speichern …</translation>
    </message>
    <message>
        <source>Leave &amp;the review</source>
        <translation>Rückbli&amp;ck verlassen</translation>
    </message>
    <message>
        <source>Branch %1 is an end and takes %2 % of the flow of its tree (%3, root: branch %4): it may be cut off there, or blood may come in by it. Delete it, or set the root there; else drugs go the wrong way.</source>
        <translation>Ast %1 ist ein Ende und nimmt %2 % des Flusses seines Baums (%3, Wurzel: Ast %4): Er kann dort abgeschnitten sein, oder Blut kommt durch ihn herein. Löschen Sie ihn, oder setzen Sie die Wurzel dorthin; sonst laufen Medikamente falsch.</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>to the view, and on to the panels; a frame shows who has the keys</source>
        <translation>zur Ansicht und weiter zu den Bedienfeldern; ein Rahmen zeigt, wer die Tasten hat</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>turn by 5°; with Shift pan</source>
        <translation>um 5° drehen; mit der Umschalttaste verschieben</translation>
    </message>
    <message>
        <source>+ and -</source>
        <translation>+ und -</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>the whole patient, from where one looks</source>
        <translation>der ganze Patient, von da, woher man schaut</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabetaste</translation>
    </message>
    <message>
        <source>act at the cross in the middle: take hold of the vessel (Pull), inject, edit, measure, bring the tool, set the blade down; Ctrl + Enter injects in Pull mode</source>
        <translation>am Kreuz in der Mitte wirken: das Gefäß fassen (Ziehen), injizieren, korrigieren, messen, das Werkzeug holen, das Skalpell ansetzen; Strg + Eingabetaste injiziert beim Ziehen</translation>
    </message>
    <message>
        <source>Arrow keys, then Enter or Esc</source>
        <translation>Pfeiltasten, dann Eingabetaste oder Esc</translation>
    </message>
    <message>
        <source>lead what is held, a tool also in depth by Page Up and Page Down (with Shift five times as far), then let go</source>
        <translation>führen, was gefasst ist, ein Werkzeug mit Bild auf und Bild ab auch in die Tiefe (mit der Umschalttaste fünfmal so weit), dann loslassen</translation>
    </message>
    <message>
        <source>Arrow keys in a slice</source>
        <translation>Pfeiltasten in einer Schicht</translation>
    </message>
    <message>
        <source>move the crosshair by a voxel</source>
        <translation>das Fadenkreuz um ein Voxel bewegen</translation>
    </message>
    <message>
        <source>Page Up, Page Down in a slice</source>
        <translation>Bild auf, Bild ab in einer Schicht</translation>
    </message>
    <message>
        <source>the next slice, the one before</source>
        <translation>die nächste Schicht, die vorige</translation>
    </message>
    <message>
        <source>Enter in a slice</source>
        <translation>Eingabetaste in einer Schicht</translation>
    </message>
    <message>
        <source>do at the crosshair what a click does</source>
        <translation>am Fadenkreuz tun, was ein Klick tut</translation>
    </message>
    <message>
        <source>Delete in a slice</source>
        <translation>Entf in einer Schicht</translation>
    </message>
    <message>
        <source>take the last point or stroke back</source>
        <translation>den letzten Punkt oder Strich zurücknehmen</translation>
    </message>
    <message>
        <source>Click on a vessel with slices beside</source>
        <translation>Klick auf ein Gefäß mit Schichten daneben</translation>
    </message>
    <message>
        <source>the slices go there (in Pull mode)</source>
        <translation>die Schichten gehen dorthin (beim Ziehen)</translation>
    </message>
    <message>
        <source>Keys in the view of the vessels</source>
        <translation>Tasten in der Ansicht der Gefäße</translation>
    </message>
    <message>
        <source>Keys in a slice</source>
        <translation>Tasten in einer Schicht</translation>
    </message>
    <message>
        <source>Menu %1</source>
        <translation>Menü %1</translation>
    </message>
    <message>
        <source>Vessels erased (waits for Rebuild)</source>
        <translation>Gefäße radiert (wartet auf Neu bauen)</translation>
    </message>
    <message>
        <source>Vessels painted (waits for Rebuild)</source>
        <translation>Gefäße gemalt (wartet auf Neu bauen)</translation>
    </message>
    <message>
        <source>(safe mode: nothing is remembered)</source>
        <translation>(abgesicherter Modus: nichts wird behalten)</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>Weniger</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Open case</source>
        <translation>Fall öffnen</translation>
    </message>
    <message>
        <source>Folder NAME.hep or file NAME.hepz:</source>
        <translation>Ordner NAME.hep oder Datei NAME.hepz:</translation>
    </message>
    <message>
        <source>There is no %1.</source>
        <translation>Es gibt kein %1.</translation>
    </message>
    <message>
        <source>%1 is no case. A case is a folder NAME.hep or a file NAME.hepz; a CT is opened by Open CT folder or Open CT file.</source>
        <translation>%1 ist kein Fall. Ein Fall ist ein Ordner NAME.hep oder eine Datei NAME.hepz; ein CT öffnen Sie mit CT-Ordner öffnen oder CT-Datei öffnen.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) at the vessels of %1 are not made into vessels yet.</source>
        <translation>
            <numerusform>%n Strich an den Gefäßen von %1 ist noch kein Gefäß.</numerusform>
            <numerusform>%n Striche an den Gefäßen von %1 sind noch keine Gefäße.</numerusform>
        </translation>
    </message>
    <message>
        <source>No case can hold strokes: rebuild the vessels with them first, or drop them.</source>
        <translation>Kein Fall kann Striche aufnehmen: Bauen Sie erst die Gefäße mit ihnen neu, oder lassen Sie sie wegfallen.</translation>
    </message>
    <message>
        <source>&amp;Rebuild first</source>
        <translation>Erst &amp;neu bauen</translation>
    </message>
    <message>
        <source>&amp;Drop them</source>
        <translation>&amp;Wegfallen lassen</translation>
    </message>
    <message>
        <source>it is %1 mm high: not all of the liver is in it</source>
        <translation>sie ist %1 mm hoch: Nicht die ganze Leber ist darin</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>ohne Namen</translation>
    </message>
    <message>
        <source>the first is better: %1</source>
        <translation>die erste ist besser: %1</translation>
    </message>
    <message>
        <source>The case holds %L1 mL of vessels, by %2 % of the usual threshold.</source>
        <translation>Der Fall enthält %L1 mL Gefäße, mit %2 % der üblichen Schwelle.</translation>
    </message>
    <message>
        <source>The slices show %L1 mL of vessels (%2%L3 mL).</source>
        <translation>Die Schichten zeigen %L1 mL Gefäße (%2%L3 mL).</translation>
    </message>
    <message>
        <source>The vessels in three dimensions</source>
        <translation>Die Gefäße in drei Dimensionen</translation>
    </message>
    <message>
        <source>Saved %1, without strokes that wait for Rebuild</source>
        <translation>%1 gespeichert, ohne Striche, die auf Neu bauen warten</translation>
    </message>
    <message>
        <source>Record pla&amp;y</source>
        <translation>Übung aufzei&amp;chnen</translation>
    </message>
    <message>
        <source>Record the play from now on, and end that; File &gt; Open recording looks back on it</source>
        <translation>Die Übung von jetzt an aufzeichnen, und das beenden; mit Datei &gt; Aufzeichnung öffnen blickt man darauf zurück</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>Look back on the play</source>
        <translation>Auf die Übung zurückblicken</translation>
    </message>
    <message>
        <source>Forget it</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Record the play</source>
        <translation>Die Übung aufzeichnen</translation>
    </message>
    <message>
        <source>Nothing moved: nothing was recorded.</source>
        <translation>Nichts bewegte sich: Es wurde nichts aufgezeichnet.</translation>
    </message>
    <message>
        <source>The play was recorded: %1</source>
        <translation>Die Übung wurde aufgezeichnet: %1</translation>
    </message>
    <message>
        <source>Writing the report on %1 (%2)</source>
        <translation>Den Bericht über %1 schreiben (%2)</translation>
    </message>
    <message>
        <source>Free play</source>
        <translation>Freie Übung</translation>
    </message>
    <message>
        <source>is being recorded</source>
        <translation>wird gerade aufgezeichnet</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Recordings of lessons and plays, the newest first:</source>
        <translation>Aufzeichnungen von Lektionen und freien Übungen, die neueste zuerst:</translation>
    </message>
    <message>
        <source>Another &amp;file…</source>
        <translation>Andere &amp;Datei …</translation>
    </message>
    <message>
        <source>Played</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>corrections cannot be noted at once</source>
        <translation>Korrekturen können nicht sofort festgehalten werden</translation>
    </message>
    <message>
        <source>make room on the disk; save the case</source>
        <translation>schaffen Sie Platz auf der Platte; speichern Sie den Fall</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung läuft</translation>
    </message>
    <message>
        <source>The play is recorded; F5 ends that</source>
        <translation>Die Übung wird aufgezeichnet; F5 beendet das</translation>
    </message>
    <message>
        <source>Before the first step</source>
        <translation>Vor dem ersten Schritt</translation>
    </message>
    <message>
        <source>Step %1 reached, after %2</source>
        <translation>Schritt %1 erreicht, nach %2</translation>
    </message>
    <message>
        <source>The end, after %1</source>
        <translation>Das Ende, nach %1</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>War</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Eingehalten</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>nach %1</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Reached</source>
        <translation>Erreicht</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Played by %1</source>
        <translation>Geübt von %1</translation>
    </message>
    <message>
        <source>Patient: %1</source>
        <translation>Patient: %1</translation>
    </message>
    <message>
        <source>Played on %1</source>
        <translation>Datum: %1</translation>
    </message>
    <message>
        <source>PASSED.</source>
        <translation>BESTANDEN.</translation>
    </message>
    <message>
        <source>NOT PASSED.</source>
        <translation>NICHT BESTANDEN.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Messgrößen</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Im Verlauf</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>For training and research alone: no diagnosis, no treatment, no certificate.</source>
        <translation>Nur für Übung und Forschung: keine Diagnose, keine Behandlung, kein Befähigungsnachweis.</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Force (mN)</source>
        <translation>Kraft (mN)</translation>
    </message>
    <message>
        <source>Largest stretch beyond rest</source>
        <translation>Größte Dehnung über die Ruhelage hinaus</translation>
    </message>
    <message>
        <source>Stretch (%)</source>
        <translation>Dehnung (%)</translation>
    </message>
    <message>
        <source>Bleeding</source>
        <translation>Blutung</translation>
    </message>
    <message>
        <source>Bleeding (g/s)</source>
        <translation>Blutung (g/s)</translation>
    </message>
    <message>
        <source>holds another patient by now than the unsaved edits were made on</source>
        <translation>enthält inzwischen einen anderen Patienten als den, an dem die ungespeicherten Korrekturen gemacht wurden</translation>
    </message>
    <message>
        <source>Bring the case back as it was, then open them again</source>
        <translation>Stellen Sie den Fall wieder her, wie er war, und öffnen Sie sie dann noch einmal</translation>
    </message>
    <message>
        <source>a piece went on without the step&apos;s forces: they would have made energy or taken its momentum</source>
        <translation>ein Stück bewegte sich ohne die Kräfte des Schritts weiter: Sie hätten Energie erzeugt oder ihm Impuls genommen</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: %2 of %3 lessons passed by %4</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: %2 von %3 Lektionen von %4 bestanden</translation>
    </message>
    <message>
        <source>Edi&amp;t course…</source>
        <translation>Ku&amp;rs bearbeiten …</translation>
    </message>
    <message>
        <source>Add a lesson</source>
        <translation>Lektion hinzufügen</translation>
    </message>
    <message>
        <source>%1 (cannot be read)</source>
        <translation>%1 (nicht lesbar)</translation>
    </message>
    <message>
        <source>Pass marks beside the lesson&apos;s own</source>
        <translation>Bestehensgrenzen neben denen der Lektion</translation>
    </message>
    <message>
        <source>Edit course</source>
        <translation>Kurs bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>A lesson&apos;s file…</source>
        <translation>Datei einer Lektion …</translation>
    </message>
    <message>
        <source>Copy course</source>
        <translation>Kurs kopieren</translation>
    </message>
    <message numerus="yes">
        <source>(%n pass mark(s))</source>
        <translation>
            <numerusform>(%n Bestehensgrenze)</numerusform>
            <numerusform>(%n Bestehensgrenzen)</numerusform>
        </translation>
    </message>
    <message>
        <source>Each change is in the file at once: %1</source>
        <translation>Jede Änderung steht sofort in der Datei: %1</translation>
    </message>
    <message>
        <source>⚠ The last change is not in the file yet: %1</source>
        <translation>⚠ Die letzte Änderung steht noch nicht in der Datei: %1</translation>
    </message>
    <message>
        <source>Copy to another &amp;file…</source>
        <translation>In andere &amp;Datei kopieren …</translation>
    </message>
    <message>
        <source>The program&apos;s &amp;own course</source>
        <translation>Der &amp;mitgelieferte Kurs</translation>
    </message>
    <message>
        <source>They touch the &amp;liver&apos;s surface and tumours</source>
        <translation>Sie berühren die &amp;Leberoberfläche und Tumoren</translation>
    </message>
    <message>
        <source>holds neither a liver nor a tumour that vessels could touch</source>
        <translation>enthält weder eine Leber noch einen Tumor, die Gefäße berühren könnten</translation>
    </message>
    <message>
        <source>Leave &quot;obstacles&quot;: true out of the scene&apos;s contact, or reconstruct the case with a liver or tumours</source>
        <translation>Nehmen Sie &quot;obstacles&quot;: true aus dem Kontakt der Szene heraus, oder rekonstruieren Sie den Fall mit einer Leber oder Tumoren</translation>
    </message>
    <message>
        <source>A copy of the course is edited: where to save it?</source>
        <translation>Bearbeitet wird eine Kopie des Kurses: Wo soll sie gespeichert werden?</translation>
    </message>
    <message>
        <source>Stands in the results of attempts that end from now on, in that of the one that has just ended if it names nobody, and in their reports. Leave it empty, and nobody is named.</source>
        <translation>Steht in den Ergebnissen der Versuche, die von nun an enden, in dem des eben beendeten, wenn es niemanden nennt, und in ihren Berichten. Bleibt es leer, wird niemand genannt.</translation>
    </message>
    <message>
        <source>Give each stroke path_mm, radius_mm, erases and after_edits</source>
        <translation>Geben Sie jedem Strich path_mm, radius_mm, erases und after_edits</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>Red&amp;o: %1</source>
        <translation>Wiederh&amp;olen: %1</translation>
    </message>
    <message>
        <source>Vessels rebuilt</source>
        <translation>Gefäße neu erzeugt</translation>
    </message>
    <message>
        <source>&amp;Results of all…</source>
        <translation>Ergebnisse &amp;aller …</translation>
    </message>
    <message>
        <source>Results of all</source>
        <translation>Ergebnisse aller</translation>
    </message>
    <message>
        <source>The clock stands: it runs from the first thing you do.</source>
        <translation>Die Uhr steht: Sie läuft, sobald Sie etwas tun.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>✓ %1 s, %2</source>
        <translation>✓ %1 s, %2</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: who passed what by the marks of the course, in how many attempts. The time is the shortest of those that passed.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: wer was nach den Bestehensgrenzen des Kurses bestanden hat, und in wie vielen Versuchen. Die Zeit ist die kürzeste der bestandenen.</translation>
    </message>
    <message>
        <source>No attempt at a lesson has ended yet. Each one is counted here once it has, under the name or number at the foot of the panel Lesson.</source>
        <translation>Noch kein Versuch an einer Lektion ist beendet. Jeder wird hier gezählt, sobald er es ist, unter dem Namen oder der Nummer, die unten im Bedienfeld Lektion steht.</translation>
    </message>
    <message>
        <source>Name or number</source>
        <translation>Name oder Nummer</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>ohne Namen</translation>
    </message>
    <message>
        <source>A lesson…</source>
        <translation>Eine Lektion …</translation>
    </message>
    <message>
        <source>The course, from the first lesson on, on the built-in patient</source>
        <translation>Der Kurs von der ersten Lektion an, am eingebauten Patienten</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>d MMM yyyy, hh:mm</source>
        <translation>d. MMM yyyy, hh:mm</translation>
    </message>
    <message>
        <source>A share of gas of 0.386 to 0.433 in the paper. In blood this would be an air embolus.</source>
        <translation>In der Veröffentlichung ein Gasanteil von 0,386 bis 0,433. Im Blut wäre das eine Luftembolie.</translation>
    </message>
    <message>
        <source>laminar to turbulent</source>
        <translation>laminar bis turbulent</translation>
    </message>
    <message>
        <source>The usual one (regime): wall friction once, for laminar and for turbulent flow</source>
        <translation>Das übliche („regime“): Wandreibung einmal, für laminare wie für turbulente Strömung</translation>
    </message>
    <message>
        <source>of the paper, corrected</source>
        <translation>der Veröffentlichung, berichtigt</translation>
    </message>
    <message>
        <source>Consistent: equation (10) of the paper with the flux along the cone</source>
        <translation>Widerspruchsfrei („consistent“): Gleichung (10) der Veröffentlichung mit dem Strom entlang des Kegels</translation>
    </message>
    <message>
        <source>of the paper, as printed</source>
        <translation>der Veröffentlichung, wie gedruckt</translation>
    </message>
    <message>
        <source>Published: equations (5) to (10) of the paper as printed</source>
        <translation>Wie gedruckt („published“): Gleichungen (5) bis (10) der Veröffentlichung</translation>
    </message>
    <message>
        <source>Share of the volume that oil or gas takes (the void fraction of the pressure law)</source>
        <translation>Anteil des Volumens, den Öl oder Gas einnimmt (im Druckgesetz: Gasgehalt, void fraction)</translation>
    </message>
    <message>
        <source>Share of oil or gas</source>
        <translation>Anteil Öl oder Gas</translation>
    </message>
    <message>
        <source>How the pressure along a vessel is computed from the flow through it</source>
        <translation>Wie aus dem Fluss durch ein Gefäß der Druck entlang des Gefäßes berechnet wird</translation>
    </message>
    <message>
        <source>This stroke lies far outside the liver (at %1), and Rebuild would make a vessel of it. Undo takes it back.</source>
        <translation>Dieser Strich liegt weit außerhalb der Leber (bei %1), und „Neu bauen“ würde ein Gefäß daraus machen. „Rückgängig“ nimmt ihn zurück.</translation>
    </message>
    <message>
        <source>A double click shows the branch</source>
        <translation>Ein Doppelklick zeigt den Ast</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es) of the solver a step</source>
        <translation>
            <numerusform>%n Durchgang des Lösers je Schritt</numerusform>
            <numerusform>%n Durchgänge des Lösers je Schritt</numerusform>
        </translation>
    </message>
    <message>
        <source>Setting of the solver: %1</source>
        <translation>Einstellung des Lösers: %1</translation>
    </message>
    <message>
        <source>Expected error %1 of the motion</source>
        <translation>Erwarteter Fehler %1 der Bewegung</translation>
    </message>
    <message>
        <source>Expected error: not measured on these vessels yet</source>
        <translation>Erwarteter Fehler: an diesen Gefäßen noch nicht gemessen</translation>
    </message>
    <message>
        <source>It is measured while nobody plays: one setting of the dial after the other, all against the same motion of these vessels</source>
        <translation>Er wird gemessen, während niemand übt: eine Einstellung des Reglers nach der anderen, alle gegen dieselbe Bewegung dieser Gefäße</translation>
    </message>
    <message>
        <source>How far vessels are beside where the slowest, most exact computation of the same pull has them, as a share of their motion. Each setting of the dial is compared with that one. It is: %1</source>
        <translation>Wie weit die Gefäße neben der Stelle liegen, an der die langsamste, genaueste Berechnung desselben Zugs sie sieht, als Anteil ihrer Bewegung. Jede Einstellung des Reglers wird mit dieser einen verglichen. Gemessen wird gegen %1</translation>
    </message>
    <message>
        <source>There is no such folder, and nothing was saved</source>
        <translation>Diesen Ordner gibt es nicht, und es wurde nichts gespeichert</translation>
    </message>
    <message>
        <source>Make the folder first, or choose one that is there</source>
        <translation>Legen Sie den Ordner zuerst an, oder wählen Sie einen vorhandenen</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner fehlt</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Datenträger nur lesbar</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>es ist kein Ordner</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Datei ist schon da</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Fehler des Datenträgers beim Lesen oder Schreiben</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele offene Dateien</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname zu lang</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Gerät oder Datei belegt</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>zugeteilter Speicherplatz aufgebraucht</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>ungültige Angabe</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>zu viele Verknüpfungen hintereinander</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>Datei auf dem Server nicht mehr vorhanden</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>does not say what kind of file it is (&quot;format&quot;)</source>
        <translation>sagt nicht, was für eine Datei sie ist (&quot;format&quot;)</translation>
    </message>
    <message>
        <source>does not say which version it is of (&quot;version&quot;)</source>
        <translation>sagt nicht, von welcher Version sie ist (&quot;version&quot;)</translation>
    </message>
    <message>
        <source>lacks its name (&quot;name&quot;)</source>
        <translation>hat keinen Namen (&quot;name&quot;)</translation>
    </message>
    <message>
        <source>lacks its steps (&quot;steps&quot;)</source>
        <translation>hat keine Schritte (&quot;steps&quot;)</translation>
    </message>
    <message>
        <source>lacks a goal (&quot;goal&quot;)</source>
        <translation>hat kein Ziel (&quot;goal&quot;)</translation>
    </message>
    <message>
        <source>does not say what the trainee is to do (&quot;text&quot;)</source>
        <translation>sagt nicht, was zu tun ist (&quot;text&quot;)</translation>
    </message>
    <message>
        <source>does not say what moves and flows in it (&quot;scene&quot;)</source>
        <translation>sagt nicht, was sich darin bewegt und fließt (&quot;scene&quot;)</translation>
    </message>
    <message>
        <source>lacks its lessons (&quot;lessons&quot;)</source>
        <translation>hat keine Lektionen (&quot;lessons&quot;)</translation>
    </message>
    <message>
        <source>Ask who made the file: its scene holds what this program does not know</source>
        <translation>Fragen Sie, wer die Datei gemacht hat: Ihre Szene enthält, was dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>Ask who made the file: it holds what this program does not know</source>
        <translation>Fragen Sie, wer die Datei gemacht hat: Sie enthält, was dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>is damaged: it cannot be read from line %1, column %2 on</source>
        <translation>ist beschädigt: Ab Zeile %1, Spalte %2 ist sie nicht lesbar</translation>
    </message>
    <message>
        <source>The liver was found by the program: on real patients about 6 % of such a liver lay outside of an expert&apos;s, and 10 % of the expert&apos;s were missed. A segment beside stomach or pancreas, mostly III, may lie outside of it by nearly half. Where volumes matter, give a mask of the liver.</source>
        <translation>Die Leber hat das Programm gefunden: Bei echten Patienten lagen etwa 6 % einer solchen Leber außerhalb der eines Experten, und 10 % von dessen Leber fehlten. Ein Segment neben Magen oder Bauchspeicheldrüse, meist III, kann fast zur Hälfte außerhalb liegen. Wo es auf Volumen ankommt, geben Sie eine Lebermaske an.</translation>
    </message>
    <message>
        <source>corotated</source>
        <translation>korotiert</translation>
    </message>
    <message>
        <source>Couinaud&apos;s segments I to VIII, in the colours of the branches that supply them (F6)</source>
        <translation>Couinaud-Segmente I bis VIII, in den Farben der Äste, die sie versorgen (F6)</translation>
    </message>
    <message>
        <source>Damage, as entropy produced by tearing: %L1 nats</source>
        <translation>Schaden, als beim Reißen erzeugte Entropie: %L1 nat</translation>
    </message>
    <message>
        <source>d MMMM yyyy, hh:mm</source>
        <translation>d. MMMM yyyy, hh:mm</translation>
    </message>
    <message>
        <source>&amp;Next lesson</source>
        <translation>&amp;Nächste Lektion</translation>
    </message>
    <message>
        <source>Each step is solved directly</source>
        <translation>Jeder Schritt wird direkt gelöst</translation>
    </message>
    <message>
        <source>Pass marks: so far, judged in the end</source>
        <translation>Bestehensgrenzen: bisher, gewertet am Ende</translation>
    </message>
    <message>
        <source>The lesson %1 is being played.</source>
        <translation>Die Lektion %1 läuft gerade.</translation>
    </message>
    <message>
        <source>&amp;Go on playing</source>
        <translation>&amp;Weiter üben</translation>
    </message>
    <message>
        <source>A free play with tears or an injection waits behind what is shown, and ends with this.</source>
        <translation>Hinter dem Gezeigten wartet ein freies Üben mit Rissen oder einer Injektion; es endet hiermit.</translation>
    </message>
    <message>
        <source>It lasts no longer than its patient and the back end that computes it. Cancel leaves all as it is.</source>
        <translation>Es dauert nicht länger als sein Patient und der Rechenkern, der es berechnet. Abbrechen lässt alles, wie es ist.</translation>
    </message>
    <message>
        <source>&amp;End the play</source>
        <translation>Üben &amp;beenden</translation>
    </message>
    <message>
        <source>would stand in an obstacle</source>
        <translation>stünde in einem Hindernis</translation>
    </message>
    <message numerus="yes">
        <source>Vessels rebuilt with %n stroke(s)</source>
        <translation>
            <numerusform>Gefäße neu gebaut mit %n Strich</numerusform>
            <numerusform>Gefäße neu gebaut mit %n Strichen</numerusform>
        </translation>
    </message>
    <message>
        <source>%L1 s of the drug pass in each second of the play.</source>
        <translation>In jeder Sekunde der Übung vergehen %L1 s des Wirkstoffs.</translation>
    </message>
    <message>
        <source>Time: %1</source>
        <translation>Zeit: %1</translation>
    </message>
    <message>
        <source>%1 mm to the mark</source>
        <translation>%1 mm bis zur Marke</translation>
    </message>
    <message>
        <source>What the vessels touch</source>
        <translation>Was die Gefäße berühren</translation>
    </message>
    <message>
        <source>Each other</source>
        <translation>Einander</translation>
    </message>
    <message>
        <source>Vessels no longer pass through each other. Costs time; a change brings them back to rest</source>
        <translation>Gefäße gehen nicht mehr durcheinander hindurch. Kostet Zeit; eine Änderung bringt sie in die Ruhelage zurück</translation>
    </message>
    <message>
        <source>Liver and tumours</source>
        <translation>Leber und Tumoren</translation>
    </message>
    <message>
        <source>Vessels stay out of the tumours and within the liver, as far as the case knows them; a change brings them back to rest. Tumours painted since count after the next correction of a vessel</source>
        <translation>Gefäße bleiben außerhalb der Tumoren und innerhalb der Leber, soweit der Fall sie kennt; eine Änderung bringt sie in die Ruhelage zurück. Seither gemalte Tumoren zählen nach der nächsten Korrektur eines Gefäßes</translation>
    </message>
    <message>
        <source>Friction of vessels on each other</source>
        <translation>Reibung der Gefäße aneinander</translation>
    </message>
    <message>
        <source>Coulomb&apos;s coefficient of vessels that slide on each other; 0: they slip</source>
        <translation>Coulombs Reibungszahl für Gefäße, die aneinander gleiten; 0: sie gleiten frei</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>This case knows neither liver nor tumours: nothing stands in the way</source>
        <translation>Dieser Fall kennt weder Leber noch Tumoren: Nichts steht im Weg</translation>
    </message>
    <message>
        <source>Give a coefficient from 0 to 10</source>
        <translation>Eine Reibungszahl von 0 bis 10 angeben</translation>
    </message>
    <message>
        <source>The one that is shown: save his case first (Ctrl+S)</source>
        <translation>Der gezeigte: zuerst seinen Fall speichern (Strg+S)</translation>
    </message>
    <message>
        <source>It can no longer be passed: begin again, or practise on.</source>
        <translation>Zu bestehen ist sie nicht mehr: neu beginnen oder weiter üben.</translation>
    </message>
    <message>
        <source>A branch was cut and bleeds. Press on its stump with the probe, then take it with the forceps: where a tool presses harder than the blood does, the vessel narrows and bleeds less. Scored is how soon and how gently you stem it.</source>
        <translation>Ein Ast wurde durchtrennt und blutet. Drücken Sie mit der Sonde auf seinen Stumpf, dann fassen Sie ihn mit der Pinzette: Wo ein Werkzeug stärker drückt als das Blut, verengt sich das Gefäß und blutet weniger. Bewertet wird, wie bald und wie sanft Sie die Blutung stillen.</translation>
    </message>
    <message>
        <source>Key 4 takes the probe. Come from the side of the root, and press some millimetres in.</source>
        <translation>Taste 4 nimmt die Sonde. Kommen Sie von der Seite der Wurzel, und drücken Sie einige Millimeter hinein.</translation>
    </message>
    <message>
        <source>the lesson asks for another drug: %1</source>
        <translation>die Lektion verlangt einen anderen Wirkstoff: %1</translation>
    </message>
    <message>
        <source>carrier</source>
        <translation>Trägerlösung</translation>
    </message>
    <message>
        <source>lipiodol</source>
        <translation>Lipiodol</translation>
    </message>
    <message>
        <source>gas</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no drug</source>
        <translation>„%1“ ist kein Wirkstoff</translation>
    </message>
    <message>
        <source>; what feeds the bleeding is pressed to %L1 % of its lumen</source>
        <translation>; was die Blutung speist, ist auf %L1 % seines Lumens gedrückt</translation>
    </message>
    <message>
        <source>; branch %1, which does not feed the bleeding, is pressed to %L2 % of its lumen</source>
        <translation>; Ast %1, der die Blutung nicht speist, ist auf %L2 % seines Lumens gedrückt</translation>
    </message>
    <message>
        <source>the share of a lumen that is left open</source>
        <translation>der Anteil eines Lumens, der offen bleibt</translation>
    </message>
    <message>
        <source>Give more than 0, up to 1</source>
        <translation>Mehr als 0 bis 1 angeben</translation>
    </message>
    <message>
        <source>needs obstacles that this scene does not have</source>
        <translation>braucht Hindernisse, die diese Szene nicht hat</translation>
    </message>
    <message>
        <source>The vessels were corrected since this lesson was made.</source>
        <translation>Seit diese Lektion gemacht wurde, wurden die Gefäße korrigiert.</translation>
    </message>
    <message>
        <source>⚠ %1 (no longer fits)</source>
        <translation>⚠ %1 (passt nicht mehr)</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; holds no lesson yet: Lesson &gt; Edit course adds some</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; enthält noch keine Lektion: Lektion &gt; Kurs bearbeiten fügt welche hinzu</translation>
    </message>
    <message>
        <source>&amp;New course…</source>
        <translation>&amp;Neuer Kurs …</translation>
    </message>
    <message>
        <source>Ne&amp;w course…</source>
        <translation>Ne&amp;uer Kurs …</translation>
    </message>
    <message>
        <source>New course</source>
        <translation>Neuer Kurs</translation>
    </message>
    <message>
        <source>Where should the new course be saved?</source>
        <translation>Wo soll der neue Kurs gespeichert werden?</translation>
    </message>
    <message>
        <source>Where its places lie on the vessels is not noted yet: open its patient, and save it then.</source>
        <translation>Wo ihre Orte auf den Gefäßen liegen, ist noch nicht vermerkt: Öffnen Sie ihren Patienten, und speichern Sie sie dann.</translation>
    </message>
    <message>
        <source>The places are &amp;right as they lie now</source>
        <translation>Die Orte stimmen, wie sie jetzt &amp;liegen</translation>
    </message>
    <message>
        <source>The vessels were corrected since the lesson was made: look at each place, put it elsewhere where that is needed, then say so here and save</source>
        <translation>Seit die Lektion gemacht wurde, wurden die Gefäße korrigiert: Sehen Sie jeden Ort an, setzen Sie ihn anderswohin, wo das nötig ist, sagen Sie es dann hier, und speichern Sie</translation>
    </message>
    <message>
        <source>%1 is not played: the vessels were corrected since it was made, and its places lie elsewhere now.</source>
        <translation>%1 beginnt nicht: Seit die Lektion gemacht wurde, wurden die Gefäße korrigiert, und ihre Orte liegen jetzt anderswo.</translation>
    </message>
    <message>
        <source>Whoever made it looks at them in the lesson editor and saves it again.</source>
        <translation>Wer sie gemacht hat, sieht sie unter Lektion &gt; Lektionen bearbeiten an und speichert sie wieder.</translation>
    </message>
    <message>
        <source>Edit the lesson</source>
        <translation>Lektion bearbeiten</translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) for this patient fit his vessels no more:</source>
        <translation>
            <numerusform>%n Lektion für diesen Patienten passt nicht mehr zu seinen Gefäßen:</numerusform>
            <numerusform>%n Lektionen für diesen Patienten passen nicht mehr zu seinen Gefäßen:</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody can play them until their places were looked at in the lesson editor. Undo of the correction makes them fit again.</source>
        <translation>Niemand kann sie üben, bis ihre Orte unter Lektion &gt; Lektionen bearbeiten angesehen wurden. Wird die Korrektur rückgängig gemacht, passen sie wieder.</translation>
    </message>
    <message>
        <source>No vessel there: drag one (by keys: Enter with the cross on it)</source>
        <translation>Dort ist kein Gefäß: Ziehen Sie an einem (mit Tasten: Eingabe, wenn das Kreuz auf einem liegt)</translation>
    </message>
    <message>
        <source>The vessel slipped out of the jaws: C opens them</source>
        <translation>Das Gefäß ist aus den Backen geglitten: C öffnet sie</translation>
    </message>
    <message>
        <source>The jaws closed beside the vessel: C opens them, the wheel (by keys: Page Up/Down) moves them in depth</source>
        <translation>Die Backen haben sich neben dem Gefäß geschlossen: C öffnet sie, das Mausrad (mit Tasten: Bild auf/ab) bewegt sie in die Tiefe</translation>
    </message>
    <message>
        <source>%1 now lies %2 from where it was when the lesson was made.</source>
        <translation>%1 liegt jetzt %2 von da, wo es lag, als die Lektion gemacht wurde.</translation>
    </message>
    <message>
        <source>%1 has %2 of vessels beyond it, and had %3 when the lesson was made.</source>
        <translation>%1: Dahinter liegen %2 Gefäße; als die Lektion gemacht wurde, waren es %3.</translation>
    </message>
    <message>
        <source>Place %1 of the setup</source>
        <translation>Ort %1 der Vorbereitung</translation>
    </message>
    <message>
        <source>move it in depth, with Shift five times as far; Ctrl + wheel zooms</source>
        <translation>es in die Tiefe bewegen, mit Umschalt fünfmal so weit; Strg + Mausrad vergrößert</translation>
    </message>
    <message>
        <source>Look which lessons still fit</source>
        <translation>Nachsehen, welche Lektionen noch passen</translation>
    </message>
    <message>
        <source>Which lessons still fit the corrected vessels is not known:</source>
        <translation>Welche Lektionen noch zu den korrigierten Gefäßen passen, ist nicht bekannt:</translation>
    </message>
    <message>
        <source>no liver was found: the largest soft organ has no border that it is told by</source>
        <translation>Es wurde keine Leber gefunden: Das größte weiche Organ hat keinen Rand, an dem es zu erkennen ist</translation>
    </message>
    <message>
        <source>Back to the lesson editor</source>
        <translation>Zurück zum Lektionseditor</translation>
    </message>
    <message>
        <source>Choose a tool; a drag or the arrows turn the view</source>
        <translation>Wählen Sie ein Werkzeug; Ziehen mit der Maus oder die Pfeile drehen die Ansicht</translation>
    </message>
    <message>
        <source>Only the flow is played here: there is nothing to pull, touch or cut</source>
        <translation>Hier läuft nur der Fluss: Es gibt nichts zu ziehen, zu berühren oder zu durchtrennen</translation>
    </message>
    <message>
        <source>Only the flow is played here: choose %1; a drag or the arrows turn the view</source>
        <translation>Hier läuft nur der Fluss: Wählen Sie %1; Ziehen mit der Maus oder die Pfeile drehen die Ansicht</translation>
    </message>
    <message>
        <source>Nothing is corrected during a lesson: leave it first</source>
        <translation>Während einer Lektion wird nichts korrigiert: Verlassen Sie sie erst</translation>
    </message>
    <message>
        <source>Not drawn: leave the lesson first</source>
        <translation>Nicht gezeichnet: Verlassen Sie erst die Lektion</translation>
    </message>
    <message>
        <source>holds another play, and would be replaced</source>
        <translation>enthält eine andere Übung und würde ersetzt</translation>
    </message>
    <message>
        <source>No lesson begins while the vessels are corrected: wait for that</source>
        <translation>Solange die Gefäße korrigiert werden, beginnt keine Lektion: warten Sie das ab</translation>
    </message>
    <message>
        <source>What is shown now goes on as it began: the next play is computed by it</source>
        <translation>Was jetzt gezeigt wird, geht weiter, wie es begann: erst die nächste Übung wird davon gerechnet</translation>
    </message>
    <message>
        <source>Computed by</source>
        <translation>Gerechnet von</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Prozessor</translation>
    </message>
    <message>
        <source>CUDA device</source>
        <translation>CUDA-Gerät</translation>
    </message>
    <message>
        <source>CUDA device, emulated</source>
        <translation>CUDA-Gerät, emuliert</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>the processor</source>
        <translation>der Prozessor</translation>
    </message>
    <message>
        <source>The chosen back end is not to be had, so that the processor makes the steps: %1. %2</source>
        <translation>Was gewählt wurde, ist nicht zu haben, sodass der Prozessor die Schritte macht: %1. %2</translation>
    </message>
    <message>
        <source>The processor makes the steps: %1</source>
        <translation>Der Prozessor macht die Schritte: %1</translation>
    </message>
    <message>
        <source>The processor makes single steps: %1</source>
        <translation>Der Prozessor macht einzelne Schritte: %1</translation>
    </message>
    <message>
        <source>Settings of the dial that were measured on %1 (%2) are left out: it does not make the steps here</source>
        <translation>Einstellungen des Schiebers, die auf %1 (%2) gemessen wurden, fehlen: Es macht die Schritte hier nicht</translation>
    </message>
    <message>
        <source>emulated on the processor</source>
        <translation>auf dem Prozessor emuliert</translation>
    </message>
    <message>
        <source>this build has no CUDA</source>
        <translation>dieses Programm wurde ohne CUDA gebaut</translation>
    </message>
    <message>
        <source>this computer has no NVIDIA driver</source>
        <translation>dieser Rechner hat keinen Treiber von NVIDIA</translation>
    </message>
    <message>
        <source>the driver knows CUDA %1, which is older than the %2 of this build</source>
        <translation>der Treiber kennt CUDA %1, was älter ist als %2 dieses Programms</translation>
    </message>
    <message>
        <source>this computer has no CUDA device that can be used</source>
        <translation>dieser Rechner hat kein brauchbares CUDA-Gerät</translation>
    </message>
    <message>
        <source>the CUDA back end</source>
        <translation>das Rechnen mit CUDA</translation>
    </message>
    <message>
        <source>Use the processor, or build with HEPATICA_CUDA=ON where nvcc is</source>
        <translation>Nehmen Sie den Prozessor, oder bauen Sie das Programm mit HEPATICA_CUDA=ON, wo es nvcc gibt</translation>
    </message>
    <message>
        <source>Use the processor, or a computer with an NVIDIA device</source>
        <translation>Nehmen Sie den Prozessor oder einen Rechner mit einem Gerät von NVIDIA</translation>
    </message>
    <message>
        <source>the device failed (%1)</source>
        <translation>das Gerät ist ausgefallen (%1)</translation>
    </message>
    <message>
        <source>no memory on the device: %1</source>
        <translation>kein Speicher auf dem Gerät: %1</translation>
    </message>
    <message>
        <source>the device does not answer: %1</source>
        <translation>das Gerät antwortet nicht: %1</translation>
    </message>
    <message>
        <source>the device failed: %1</source>
        <translation>das Gerät ist ausgefallen: %1</translation>
    </message>
    <message>
        <source>a kernel could not be launched: %1</source>
        <translation>ein Kernel ließ sich nicht starten: %1</translation>
    </message>
    <message>
        <source>a copy to the device failed: %1</source>
        <translation>eine Kopie auf das Gerät misslang: %1</translation>
    </message>
    <message>
        <source>a copy from the device failed: %1</source>
        <translation>eine Kopie vom Gerät misslang: %1</translation>
    </message>
    <message>
        <source>its elements have no kernels yet</source>
        <translation>für seine Elemente gibt es noch keine Kernel</translation>
    </message>
    <message>
        <source>Newton&apos;s method has no kernels yet</source>
        <translation>für das Newton-Verfahren gibt es noch keine Kernel</translation>
    </message>
    <message>
        <source>the solver cholesky has no kernels</source>
        <translation>für den Löser cholesky gibt es keine Kernel</translation>
    </message>
    <message>
        <source>the published step, E of eq. (11) and audits have no kernels</source>
        <translation>für den veröffentlichten Schritt, E aus Gl. (11) und Prüfungen gibt es keine Kernel</translation>
    </message>
    <message>
        <source>a piece would pay for energy or momentum of others</source>
        <translation>ein Stück würde für Energie oder Impuls anderer bezahlen</translation>
    </message>
    <message>
        <source>what its surfaces exchanged would be lost</source>
        <translation>was seine Flächen getauscht haben, ginge verloren</translation>
    </message>
    <message>
        <source>a free body is about to meet itself</source>
        <translation>ein freier Körper trifft gleich auf sich selbst</translation>
    </message>
    <message>
        <source>a step has to be shortened, lest something pass through</source>
        <translation>ein Schritt muss verkürzt werden, damit nichts hindurchgeht</translation>
    </message>
    <message>
        <source>%1, on the processor</source>
        <translation>%1, auf dem Prozessor</translation>
    </message>
    <message>
        <source>has left steps to the processor</source>
        <translation>hat Schritte dem Prozessor überlassen</translation>
    </message>
    <message>
        <source>Measure again, or with --backend cpu</source>
        <translation>Messen Sie noch einmal, oder mit --backend cpu</translation>
    </message>
    <message>
        <source>is not to be had here</source>
        <translation>ist hier nicht zu haben</translation>
    </message>
    <message>
        <source>Let the processor make the steps</source>
        <translation>Lassen Sie den Prozessor die Schritte machen</translation>
    </message>
    <message>
        <source>CUDA, else processor</source>
        <translation>CUDA, sonst Prozessor</translation>
    </message>
    <message>
        <source>What makes the steps; a change begins the play anew. On a device the dial offers the settings that were measured on it, and with &quot;else processor&quot; those of the processor beside them</source>
        <translation>Was die Schritte macht; eine Änderung beginnt die Übung von vorn. Auf einem Gerät bietet der Schieber die Einstellungen, die darauf gemessen wurden, und mit „sonst Prozessor“ daneben die des Prozessors</translation>
    </message>
    <message>
        <source>There is %1 already, and it is no case. Choose another name.</source>
        <translation>Es gibt schon %1, und es ist kein Fall. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>make room on the disk; rebuild the vessels and save the case</source>
        <translation>schaffen Sie Platz auf der Platte; bauen Sie die Gefäße neu und speichern Sie den Fall</translation>
    </message>
    <message>
        <source>Choose the case…</source>
        <translation>Den Fall wählen…</translation>
    </message>
    <message numerus="yes">
        <source>%n measurement(s) removed.</source>
        <translation>
            <numerusform>%n Messung entfernt.</numerusform>
            <numerusform>%n Messungen entfernt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Zurückholen</translation>
    </message>
    <message numerus="yes">
        <source>%n diameter(s) are not shown any more: the vessel that they were measured on is gone. Where it comes back, as by Undo, they do.</source>
        <translation>
            <numerusform>%n Durchmesser wird nicht mehr gezeigt: Das Gefäß, an dem er gemessen wurde, ist fort. Kommt es wieder, etwa durch Rückgängig, so auch er.</numerusform>
            <numerusform>%n Durchmesser werden nicht mehr gezeigt: Die Gefäße, an denen sie gemessen wurden, sind fort. Kommen sie wieder, etwa durch Rückgängig, so auch die Durchmesser.</numerusform>
        </translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>The rebuilding stays: a case does not keep the vessels from before it. Undo once more takes back the correction that was made before.</source>
        <translation>Der Neubau bleibt: Ein Fall enthält die Gefäße von davor nicht. Noch einmal Rückgängig nimmt die Korrektur zurück, die davor gemacht wurde.</translation>
    </message>
    <message>
        <source>Choose the case that was played on</source>
        <translation>Wählen Sie den Fall, an dem geübt wurde</translation>
    </message>
    <message>
        <source>was played on %1, which is not there any more or holds other vessels by now</source>
        <translation>wurde an %1 geübt; dieser Fall ist nicht mehr da oder hat inzwischen andere Gefäße</translation>
    </message>
    <message>
        <source>nothing measures a %1</source>
        <translation>ein Maß namens %1 gibt es nicht</translation>
    </message>
    <message>
        <source>has %1 points_mm in place of %2</source>
        <translation>hat %1 points_mm statt %2</translation>
    </message>
    <message>
        <source>measures at %1, which is farther than 10 m from the origin</source>
        <translation>misst bei %1, weiter als 10 m vom Ursprung</translation>
    </message>
    <message>
        <source>has a stenosis of %1, which is above 1</source>
        <translation>hat eine Stenose von %1, mehr als 1</translation>
    </message>
    <message>
        <source>has the format %1</source>
        <translation>hat das Format %1</translation>
    </message>
    <message>
        <source>has version %1; this program reads version 1</source>
        <translation>hat Version %1; dieses Programm liest Version 1</translation>
    </message>
    <message>
        <source>Correct that value, or remove the file: the case is whole without it</source>
        <translation>Berichtigen Sie diesen Wert, oder entfernen Sie die Datei: Der Fall ist ohne sie vollständig</translation>
    </message>
    <message>
        <source>Take a newer program, or remove the file</source>
        <translation>Nehmen Sie ein neueres Programm, oder entfernen Sie die Datei</translation>
    </message>
    <message>
        <source>Make it readable, or remove it: the case is whole without it</source>
        <translation>Machen Sie sie lesbar, oder entfernen Sie sie: Der Fall ist ohne sie vollständig</translation>
    </message>
    <message>
        <source>%1, measurement %2</source>
        <translation>%1, Messung %2</translation>
    </message>
    <message>
        <source>What was painted at %1 is left out of the tree: it is too short or too round to be a vessel. Paint along the vessel, or undo the rebuilding.</source>
        <translation>Was bei %1 gemalt wurde, fehlt im Baum: Es ist zu kurz oder zu rund für ein Gefäß. Malen Sie entlang des Gefäßes, oder nehmen Sie den Neubau zurück.</translation>
    </message>
    <message>
        <source>What is to be known of this patient&apos;s vessels: show it again</source>
        <translation>Was über die Gefäße dieses Patienten zu wissen ist: noch einmal zeigen</translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n Warnung</numerusform>
            <numerusform>%n Warnungen</numerusform>
        </translation>
    </message>
    <message>
        <source>its parameter mesh is %1, not an object</source>
        <translation>sein Parameter mesh ist %1, kein Objekt</translation>
    </message>
    <message>
        <source>its parameter mesh.%1 is %2, not a number</source>
        <translation>sein Parameter mesh.%1 ist %2, keine Zahl</translation>
    </message>
    <message>
        <source>its parameter mesh.%1 is %2, not a whole number in range</source>
        <translation>sein Parameter mesh.%1 ist %2, keine ganze Zahl im erlaubten Bereich</translation>
    </message>
    <message>
        <source>its parameter %1 is %2, not true or false</source>
        <translation>sein Parameter %1 ist %2, nicht wahr oder falsch</translation>
    </message>
    <message>
        <source>The tumours&apos; masks hold %1 separate pieces, and a case holds %2 tumours at most: the %3 smallest are left out, %4 ml together. Remove specks from the masks.</source>
        <translation>Die Masken der Tumoren enthalten %1 getrennte Stücke, und ein Fall fasst höchstens %2 Tumoren: Die %3 kleinsten sind weggelassen, zusammen %4 ml. Entfernen Sie Sprenkel aus den Masken.</translation>
    </message>
    <message>
        <source>has a node of radius %1</source>
        <translation>hat einen Knoten vom Radius %1</translation>
    </message>
    <message>
        <source>is of the format %1</source>
        <translation>hat das Format %1</translation>
    </message>
    <message>
        <source>Give a file of the format &quot;%1&quot;</source>
        <translation>Geben Sie eine Datei des Formats „%1“ an</translation>
    </message>
    <message>
        <source>Turn its positions into LPS and state &quot;space&quot;: &quot;LPS&quot;</source>
        <translation>Rechnen Sie ihre Positionen in LPS um, und schreiben Sie &quot;space&quot;: &quot;LPS&quot; hinein</translation>
    </message>
    <message>
        <source>must be three numbers, but is a list of %1</source>
        <translation>erwartet werden drei Zahlen, es ist aber eine Liste von %1</translation>
    </message>
    <message>
        <source>%1, tetrahedron %2</source>
        <translation>%1, Tetraeder %2</translation>
    </message>
    <message>
        <source>%1, vertex %2</source>
        <translation>%1, Ecke %2</translation>
    </message>
    <message>
        <source>%1, surface</source>
        <translation>%1, Oberfläche</translation>
    </message>
    <message>
        <source>ended after %1 of %2 bytes: it was cut while it was read</source>
        <translation>endete nach %1 von %2 Bytes: Die Datei wurde gekürzt, während sie gelesen wurde</translation>
    </message>
    <message>
        <source>Read it again when no other program writes it</source>
        <translation>Lesen Sie sie noch einmal, wenn kein anderes Programm sie schreibt</translation>
    </message>
    <message>
        <source>the drug would leave the vessels right where it is injected</source>
        <translation>das Mittel verließe die Gefäße gleich dort, wo es eingespritzt wird</translation>
    </message>
    <message>
        <source>Inject farther up the stream</source>
        <translation>Spritzen Sie weiter stromaufwärts ein</translation>
    </message>
    <message>
        <source>There is a case “%1” here already; it was not replaced. Both can be kept, the new one as “%2”.</source>
        <translation>Hier liegt schon ein Fall „%1“; er wurde nicht ersetzt. Beide können bleiben, der neue als „%2“.</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>Beide behalten</translation>
    </message>
    <message>
        <source>Save the vessels as a DICOM segmentation</source>
        <translation>Die Gefäße als DICOM-Segmentierung speichern</translation>
    </message>
    <message>
        <source>The DICOM segmentation will name the patient.</source>
        <translation>Die DICOM-Segmentierung wird den Patienten nennen.</translation>
    </message>
    <message>
        <source>The patient&apos;s name, number and other data are written into the file as they stand in the CT, so that an archive finds where it belongs. Pass it on only as you would pass on the CT.</source>
        <translation>Name, Nummer und weitere Daten des Patienten werden so in die Datei geschrieben, wie sie im CT stehen, damit ein Archiv sie zuordnen kann. Geben Sie die Datei nur so weiter, wie Sie auch das CT weitergeben würden.</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>counted: %1</source>
        <translation>gezählt: %1</translation>
    </message>
    <message>
        <source>the CT %1 is not there any more</source>
        <translation>das CT %1 liegt nicht mehr dort</translation>
    </message>
    <message>
        <source>choose the folder or file where it lies now, or connect its disk</source>
        <translation>wählen Sie den Ordner oder die Datei, wo es jetzt liegt, oder schließen Sie das Laufwerk an</translation>
    </message>
    <message>
        <source>Let go of the vessel; else take the tool out of the picture, or end measuring, and pull with the mouse again</source>
        <translation>Das Gefäß loslassen; sonst das Werkzeug aus dem Bild nehmen oder das Messen beenden und wieder mit der Maus ziehen</translation>
    </message>
    <message>
        <source>Open the unsaved work first (File &gt; Open unsaved work)</source>
        <translation>Zuerst die ungespeicherte Arbeit öffnen (Datei &gt; Ungespeicherte Arbeit öffnen)</translation>
    </message>
    <message>
        <source>is cut within its NIfTI-2 header</source>
        <translation>ist innerhalb seines NIfTI-2-Kopfes abgeschnitten</translation>
    </message>
    <message>
        <source>The lesson is judged: the tool is put away, and the wheel zooms</source>
        <translation>Die Lektion ist beurteilt: Das Werkzeug ist weggelegt, und das Rad zoomt</translation>
    </message>
    <message>
        <source>pieces off</source>
        <translation>abgetrennte Stücke</translation>
    </message>
    <message>
        <source>area cut or torn</source>
        <translation>Schnitt- und Rissfläche</translation>
    </message>
    <message>
        <source>no pieces off</source>
        <translation>keine abgetrennten Stücke</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Geschnitten</translation>
    </message>
    <message>
        <source>cut or torn</source>
        <translation>geschnitten oder gerissen</translation>
    </message>
    <message>
        <source>piece off</source>
        <translation>Stück abgetrennt</translation>
    </message>
    <message>
        <source>Cut or torn</source>
        <translation>Geschnitten oder gerissen</translation>
    </message>
    <message>
        <source>nothing cut or torn</source>
        <translation>nichts geschnitten oder gerissen</translation>
    </message>
    <message>
        <source>Back to the rest shape: no pull, no tool, no cut, no drug</source>
        <translation>Zurück zur Ruheform: kein Zug, kein Werkzeug, kein Schnitt, kein Wirkstoff</translation>
    </message>
    <message>
        <source>Undo is for corrections and takes no cut back: Begin again makes the vessels whole</source>
        <translation>Rückgängig gilt Korrekturen und nimmt keinen Schnitt zurück: Von vorn beginnen macht die Gefäße wieder ganz</translation>
    </message>
    <message>
        <source>Undo is for corrections of the vessels: what was cut or torn in the play stays so. Reset (Backspace) makes the vessels whole.</source>
        <translation>Rückgängig gilt Korrekturen der Gefäße: Was beim Üben geschnitten wurde oder riss, bleibt so. Zurücksetzen (Rücktaste) macht die Gefäße wieder ganz.</translation>
    </message>
    <message>
        <source>Far beyond the mark: point at a vessel to see what lies downstream of it. A double click injects there; after key 2, one click does.</source>
        <translation>Weit jenseits der Marke: Zeigen Sie auf ein Gefäß, um zu sehen, was stromabwärts liegt. Ein Doppelklick injiziert dort; nach Taste 2 genügt ein Klick.</translation>
    </message>
    <message>
        <source>Press on the stump with the probe until it bleeds less than the goal says, for half a second.</source>
        <translation>Drücken Sie mit der Sonde auf den Stumpf, bis er eine halbe Sekunde lang weniger blutet, als das Ziel sagt.</translation>
    </message>
    <message>
        <source>Take the stump with the forceps until it bleeds less than the goal says, for half a second.</source>
        <translation>Fassen Sie den Stumpf mit der Pinzette, bis er eine halbe Sekunde lang weniger blutet, als das Ziel sagt.</translation>
    </message>
    <message>
        <source>Rod probe: the mouse leads a rod that pushes the vessels</source>
        <translation>Stabsonde: Die Maus führt einen Stab, der die Gefäße wegdrückt</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>not judged: the lesson did not reach its end</source>
        <translation>nicht beurteilt: Die Lektion kam nicht ans Ende</translation>
    </message>
    <message>
        <source>Open the unsaved work</source>
        <translation>Ungespeicherte Arbeit öffnen</translation>
    </message>
    <message>
        <source>; the last step was simplified to stay stable</source>
        <translation>; der letzte Schritt wurde vereinfacht, um stabil zu bleiben</translation>
    </message>
    <message>
        <source>A tumour as the target</source>
        <translation>Ein Tumor als Zielgebiet</translation>
    </message>
    <message>
        <source>This tumour reaches beyond the part of the CT about the liver that a case keeps (at %1): what lies outside of it is left out. Undo takes it back.</source>
        <translation>Dieser Tumor reicht über den Teil des CTs um die Leber hinaus, den ein Fall behält (bei %1): Was außerhalb liegt, fällt weg. „Rückgängig“ nimmt ihn zurück.</translation>
    </message>
    <message>
        <source>trunk</source>
        <translation>Stamm</translation>
    </message>
    <message>
        <source>several</source>
        <translation>mehrere</translation>
    </message>
    <message>
        <source>It supplies several segments of the liver</source>
        <translation>Er versorgt mehrere Segmente der Leber</translation>
    </message>
    <message>
        <source>This tumour lies outside the liver (at %1). Undo takes it back.</source>
        <translation>Dieser Tumor liegt außerhalb der Leber (bei %1). „Rückgängig“ nimmt ihn zurück.</translation>
    </message>
    <message>
        <source>Tumours as they are now become obstacles with the next correction of a vessel</source>
        <translation>Die jetzigen Tumoren werden mit der nächsten Korrektur eines Gefäßes zu Hindernissen</translation>
    </message>
    <message>
        <source>, of it up to %L1 g drug</source>
        <translation>, davon bis zu %L1 g Wirkstoff</translation>
    </message>
    <message>
        <source>the dial</source>
        <translation>der Schieber</translation>
    </message>
    <message>
        <source>none of its settings can tear</source>
        <translation>keine seiner Einstellungen kann reißen</translation>
    </message>
    <message>
        <source>Measure it again, or play without tearing</source>
        <translation>Messen Sie ihn neu, oder üben Sie ohne Reißen</translation>
    </message>
    <message>
        <source>Radius of the vessel that is drawn</source>
        <translation>Radius des Gefäßes, das gezeichnet wird</translation>
    </message>
    <message>
        <source>Radius of the vessel that is drawn; below the least it is measured in the CT</source>
        <translation>Radius des Gefäßes, das gezeichnet wird; unter dem kleinsten wird er im CT gemessen</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>The last change was being written when the program ended, and is lost: all before it is here</source>
        <translation>Die letzte Änderung wurde gerade geschrieben, als das Programm endete, und ist verloren: Alles davor ist da</translation>
    </message>
    <message>
        <source>The unsaved work is that of before line %1 of %2, which is damaged: what was done later is lost</source>
        <translation>Die ungespeicherte Arbeit ist die von vor Zeile %1 von %2, die beschädigt ist: Was danach kam, ist verloren</translation>
    </message>
    <message>
        <source>The unsaved work may lack its end: %1 cannot be read from line %2 on. Check its disk and open it again</source>
        <translation>Der ungespeicherten Arbeit fehlt vielleicht das Ende: %1 lässt sich ab Zeile %2 nicht lesen. Prüfen Sie den Datenträger und öffnen Sie sie noch einmal</translation>
    </message>
    <message>
        <source>a least radius of %1 mm</source>
        <translation>ein kleinster Radius von %1 mm</translation>
    </message>
    <message>
        <source>Choose a least radius from 0 to 50 mm</source>
        <translation>Wählen Sie einen kleinsten Radius von 0 bis 50 mm</translation>
    </message>
    <message>
        <source>Choose a mask that holds whole vessels</source>
        <translation>Wählen Sie eine Maske, die ganze Gefäße enthält</translation>
    </message>
    <message>
        <source>Blood (1/10 of the volume)</source>
        <translation>Blut (1/10 des Volumens)</translation>
    </message>
    <message>
        <source>Red balls: blood, a tenth of the volume lost.</source>
        <translation>Rote Kugeln: Blut, ein Zehntel des verlorenen Volumens.</translation>
    </message>
    <message>
        <source>That is %L1 g/s of the drug; doses are counted in g.</source>
        <translation>Das sind %L1 g/s des Wirkstoffs; Dosen zählen in g.</translation>
    </message>
    <message>
        <source>drug injected</source>
        <translation>injizierter Wirkstoff</translation>
    </message>
    <message>
        <source>drug delivered</source>
        <translation>angekommener Wirkstoff</translation>
    </message>
    <message>
        <source>reflux of the drug</source>
        <translation>Rückfluss des Wirkstoffs</translation>
    </message>
    <message>
        <source>, of it up to %L1 mL (%L2 g) drug</source>
        <translation>, davon bis zu %L1 mL (%L2 g) Wirkstoff</translation>
    </message>
    <message>
        <source>Time since the last injection began (s)</source>
        <translation>Zeit seit Beginn der letzten Injektion (s)</translation>
    </message>
    <message>
        <source>%1 (mL)</source>
        <translation>%1 (mL)</translation>
    </message>
    <message>
        <source>Nothing erased: there is no vessel</source>
        <translation>Nichts radiert: Dort ist kein Gefäß</translation>
    </message>
    <message>
        <source>This injection takes the place of the last one in the picture; what that one reached and gave stays counted in a lesson</source>
        <translation>Diese Injektion tritt im Bild an die Stelle der letzten; was jene erreicht und abgegeben hat, zählt in einer Lektion weiter</translation>
    </message>
    <message>
        <source>The vessel given to the system &quot;%1&quot; touches no other vessel of it and is a tree of its own: neither blood nor a drug comes to it from the others. If it belongs to one of them, choose Link two vessels and click both.</source>
        <translation>Das Gefäß, das dem System „%1“ gegeben wurde, berührt kein anderes Gefäß davon und ist ein eigener Baum: Weder Blut noch ein Wirkstoff kommt aus den anderen zu ihm. Gehört es zu einem von ihnen, „Zwei Gefäße verbinden“ wählen und beide anklicken.</translation>
    </message>
    <message>
        <source>Choose a row in the table of branches (F6) first</source>
        <translation>Erst eine Zeile in der Tabelle der Äste (F6) wählen</translation>
    </message>
    <message>
        <source>Do it to the branch chosen in the table</source>
        <translation>Mit dem Ast tun, der in der Tabelle gewählt ist</translation>
    </message>
    <message>
        <source>As a click on the middle of the branch whose row is chosen in the table of branches (F6) would: for one that is too short to click on</source>
        <translation>Wie ein Klick auf die Mitte des Astes, dessen Zeile in der Tabelle der Äste (F6) gewählt ist: für einen, der zum Anklicken zu kurz ist</translation>
    </message>
    <message>
        <source>Iodised oil, 25 mPa s and 1280 kg/m³ at 37 °C: given into the hepatic artery in chemoembolization, and with glue into the portal vein before a resection.</source>
        <translation>Iodiertes Öl, 25 mPa s und 1280 kg/m³ bei 37 °C: bei der Chemoembolisation in die Leberarterie gegeben, mit Klebstoff vor einer Resektion in die Pfortader.</translation>
    </message>
    <message>
        <source>Fill the target&apos;s vessels with an emulsion of lipiodol and stop before it runs back into the others. A pump drives the emulsion; where the pump stops, the emulsion stays. You see by the filled target when it is enough.</source>
        <translation>Füllen Sie die Gefäße des Zielgebiets mit einer Lipiodol-Emulsion, und hören Sie auf, bevor sie in die anderen zurückläuft. Eine Pumpe treibt die Emulsion; steht die Pumpe, bleibt die Emulsion, wo sie ist. Wann es genug ist, sehen Sie am gefüllten Zielgebiet.</translation>
    </message>
    <message>
        <source>Lower the flow in the panel Injection, then inject the emulsion until nine tenths of the target are full.</source>
        <translation>Verringern Sie den Fluss im Bedienfeld Injektion, und injizieren Sie dann die Emulsion, bis neun Zehntel des Zielgebiets gefüllt sind.</translation>
    </message>
    <message>
        <source>A little beyond the mark, slowly: a flow of 0.5 g/s, which is about 25 mL/min. At 2 g/s the emulsion runs back within seconds.</source>
        <translation>Etwas jenseits der Marke, langsam: ein Fluss von 0,5 g/s, das sind etwa 25 mL/min. Bei 2 g/s läuft die Emulsion binnen Sekunden zurück.</translation>
    </message>
    <message>
        <source>Stop the pump (Space) and leave the emulsion in the target.</source>
        <translation>Halten Sie die Pumpe an (Leertaste), und lassen Sie die Emulsion im Zielgebiet.</translation>
    </message>
    <message>
        <source>Pause in the panel Injection stops the pump too. Del would take the emulsion out again, and the target would be empty.</source>
        <translation>Auch Pause im Bedienfeld Injektion hält die Pumpe an. Entf nähme die Emulsion wieder heraus, und das Zielgebiet wäre leer.</translation>
    </message>
    <message>
        <source>not begun</source>
        <translation>nicht begonnen</translation>
    </message>
    <message>
        <source>Came to</source>
        <translation>Gekommen bis</translation>
    </message>
    <message>
        <source>Saved: %1. The CT is not in it.</source>
        <translation>Gespeichert: %1. Das CT ist nicht darin.</translation>
    </message>
    <message numerus="yes">
        <source>Saved: %1. It holds the case and %n lesson(s) for this patient, not the CT.</source>
        <translation>
            <numerusform>Gespeichert: %1. Darin sind der Fall und %n Lektion für diesen Patienten, nicht aber das CT.</numerusform>
            <numerusform>Gespeichert: %1. Darin sind der Fall und %n Lektionen für diesen Patienten, nicht aber das CT.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) for this patient came with the case and lie beside it: %1</source>
        <translation>
            <numerusform>%n Lektion für diesen Patienten kam mit dem Fall und liegt neben ihm: %1</numerusform>
            <numerusform>%n Lektionen für diesen Patienten kamen mit dem Fall und liegen neben ihm: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>cannot hold all lessons for this patient: they are more than 40</source>
        <translation>kann nicht alle Lektionen für diesen Patienten aufnehmen: Es sind mehr als 40</translation>
    </message>
    <message>
        <source>cannot be set up: %1</source>
        <translation>kann nicht eingerichtet werden: %1</translation>
    </message>
    <message>
        <source>Change what the lesson sets up, or the parts of its scene</source>
        <translation>Ändern Sie, was die Lektion einrichtet, oder die Teile ihrer Szene</translation>
    </message>
    <message>
        <source>Put lessons that are not needed into another folder</source>
        <translation>Legen Sie Lektionen, die nicht gebraucht werden, in einen anderen Ordner</translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) for this patient are in his file: %1. To play them, take the case into the library.</source>
        <translation>
            <numerusform>%n Lektion für diesen Patienten liegt in seiner Datei: %1. Um sie zu üben, übernehmen Sie den Fall in die Bibliothek.</numerusform>
            <numerusform>%n Lektionen für diesen Patienten liegen in seiner Datei: %1. Um sie zu üben, übernehmen Sie den Fall in die Bibliothek.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) for this patient are in his file: %1. To play them, take them out: they then lie beside it in the library.</source>
        <translation>
            <numerusform>%n Lektion für diesen Patienten liegt in seiner Datei: %1. Um sie zu üben, nehmen Sie sie heraus: Sie liegt dann daneben in der Bibliothek.</numerusform>
            <numerusform>%n Lektionen für diesen Patienten liegen in seiner Datei: %1. Um sie zu üben, nehmen Sie sie heraus: Sie liegen dann daneben in der Bibliothek.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take it into the library</source>
        <translation>In die Bibliothek übernehmen</translation>
    </message>
    <message>
        <source>Take the lessons out</source>
        <translation>Die Lektionen herausnehmen</translation>
    </message>
    <message>
        <source>Warning, no longer so</source>
        <translation>Warnung, gilt nicht mehr</translation>
    </message>
    <message>
        <source>Doses are judged by the %1 of %2 that had come out of the ends of the vessels by then: the other %3 of the drug count neither in the target nor elsewhere, wherever they would have gone.</source>
        <translation>Dosen werden nach den %1 von %2 beurteilt, die bis dahin aus den Enden der Gefäße ausgetreten waren: Die anderen %3 des Wirkstoffs zählen weder im Zielgebiet noch anderswo, wohin auch immer sie gelangt wären.</translation>
    </message>
    <message>
        <source>Tried from the lesson editor: it is not kept among the attempts.</source>
        <translation>Aus dem Lektionseditor ausprobiert: Der Versuch wird nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>A place that is reached</source>
        <translation>Ein erreichter Ort</translation>
    </message>
    <message>
        <source>%1 mm to mark %2</source>
        <translation>%1 mm bis zur Marke %2</translation>
    </message>
    <message>
        <source>begun to tear, nothing is apart yet</source>
        <translation>angerissen, noch ist nichts getrennt</translation>
    </message>
    <message>
        <source>The play that was judged is left: &quot;Look back on it&quot; shows its recording.</source>
        <translation>Die beurteilte Übung ist verlassen: „Darauf zurückblicken“ zeigt ihre Aufzeichnung.</translation>
    </message>
    <message>
        <source>Removed; its text stands in the line for notes: Enter keeps it again</source>
        <translation>Entfernt; der Text steht in der Zeile für Notizen: Enter behält ihn wieder</translation>
    </message>
    <message>
        <source>Move slowly: what is stretched pulls back, in one direction more than in another. If the stretch is too large too soon, begin again and pull another way. The number at the held point shows the force.</source>
        <translation>Bewegen Sie sich langsam: Was gedehnt ist, zieht zurück, in einer Richtung mehr als in einer anderen. Wird die Dehnung zu früh zu groß, beginnen Sie noch einmal und ziehen Sie in eine andere Richtung. Die Zahl am gehaltenen Punkt zeigt die Kraft.</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>%1 mm left</source>
        <translation>%1 mm links</translation>
    </message>
    <message>
        <source>%1 mm right</source>
        <translation>%1 mm rechts</translation>
    </message>
    <message>
        <source>%1 mm back</source>
        <translation>%1 mm hinten</translation>
    </message>
    <message>
        <source>%1 mm front</source>
        <translation>%1 mm vorn</translation>
    </message>
    <message>
        <source>%1 mm headwards</source>
        <translation>%1 mm kopfwärts</translation>
    </message>
    <message>
        <source>%1 mm feetwards</source>
        <translation>%1 mm fußwärts</translation>
    </message>
    <message>
        <source>From the origin of the CT: %1</source>
        <translation>Vom Ursprung des CTs aus: %1</translation>
    </message>
    <message>
        <source>liver segment %1</source>
        <translation>Lebersegment %1</translation>
    </message>
    <message>
        <source>What a drug has reached is a share of the vessels&apos; surface: of the target&apos;s, or of all others, whatever their system.</source>
        <translation>Was ein Wirkstoff erreicht hat, ist ein Anteil der Gefäßoberfläche: der des Zielgebiets oder der aller anderen Gefäße, gleich welchen Systems.</translation>
    </message>
    <message>
        <source>%1; a stenosis is judged where the vessel goes on for 10 mm to both sides</source>
        <translation>%1; eine Stenose wird beurteilt, wo das Gefäß zu beiden Seiten 10 mm weit weitergeht</translation>
    </message>
    <message>
        <source>Cut line, not torn yet</source>
        <translation>Schwächungslinie, noch nicht gerissen</translation>
    </message>
    <message>
        <source>Bleeding (mL/min)</source>
        <translation>Blutung (mL/min)</translation>
    </message>
    <message>
        <source>verdict: not passed</source>
        <translation>Urteil: nicht bestanden</translation>
    </message>
    <message>
        <source>Circles: the lesson&apos;s marks.</source>
        <translation>Kreise: die Marken der Lektion.</translation>
    </message>
    <message>
        <source>Purple: the target of the drug.</source>
        <translation>Purpur: das Ziel des Wirkstoffs.</translation>
    </message>
    <message>
        <source>Brown to yellow: what the drug has reached, the earliest darkest.</source>
        <translation>Braun bis Gelb: was der Wirkstoff erreicht hat, das früheste am dunkelsten.</translation>
    </message>
    <message>
        <source>Vessels that the drug has reached</source>
        <translation>Gefäße, die der Wirkstoff erreicht hat</translation>
    </message>
    <message>
        <source>Share (%)</source>
        <translation>Anteil (%)</translation>
    </message>
    <message>
        <source>The rest</source>
        <translation>Der Rest</translation>
    </message>
    <message>
        <source>From the front, without perspective.</source>
        <translation>Von vorn, ohne Perspektive.</translation>
    </message>
    <message>
        <source>show what lies downstream; the panel Injection says its share of the flow</source>
        <translation>zeigen, was stromabwärts liegt; seinen Anteil am Fluss sagt das Bedienfeld Injektion</translation>
    </message>
    <message>
        <source>Settings: gravity, tissue, tearing, the drug&apos;s clock</source>
        <translation>Einstellungen: Schwerkraft, Gewebe, Reißen, Uhr des Wirkstoffs</translation>
    </message>
    <message>
        <source>&amp;Import a case…</source>
        <translation>Fall über&amp;nehmen …</translation>
    </message>
    <message>
        <source>Import a case</source>
        <translation>Fall übernehmen</translation>
    </message>
    <message>
        <source>interrupted before the end</source>
        <translation>vor dem Ende abgebrochen</translation>
    </message>
    <message>
        <source>reached</source>
        <translation>erreicht</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>nicht erreicht</translation>
    </message>
    <message>
        <source>given up before the end</source>
        <translation>vor dem Ende aufgegeben</translation>
    </message>
    <message>
        <source>The largest force: %1, after %2</source>
        <translation>Die größte Kraft: %1, nach %2</translation>
    </message>
    <message>
        <source>Forces shown may be rough: the step was simplified to stay stable</source>
        <translation>Gezeigte Kräfte können grob sein: Der Schritt wurde vereinfacht, um stabil zu bleiben</translation>
    </message>
    <message>
        <source>then: %1</source>
        <translation>danach: %1</translation>
    </message>
    <message>
        <source>Target, downstream of the pointer</source>
        <translation>Zielgebiet, stromabwärts des Zeigers</translation>
    </message>
    <message>
        <source>Target, in the chosen branch</source>
        <translation>Zielgebiet, im gewählten Ast</translation>
    </message>
    <message>
        <source>Downstream of the pointer</source>
        <translation>Stromabwärts des Zeigers</translation>
    </message>
    <message>
        <source>The chosen branch</source>
        <translation>Der gewählte Ast</translation>
    </message>
    <message>
        <source>what was reached before is not told by 0 and 1</source>
        <translation>was vorher erreicht war, ist nicht mit 0 und 1 angegeben</translation>
    </message>
    <message>
        <source>Reached by an earlier injection</source>
        <translation>Von einer früheren Injektion erreicht</translation>
    </message>
    <message>
        <source>The view looks back on this attempt; below is how it was judged. Nothing that you do changes it: &quot;Leave the review&quot; ends looking back, &quot;Begin again&quot; is a new attempt.</source>
        <translation>Die Ansicht blickt auf diesen Versuch zurück; unten steht, wie er beurteilt wurde. Nichts, was Sie tun, ändert ihn: „Rückblick verlassen“ beendet den Rückblick, „Von vorn beginnen“ ist ein neuer Versuch.</translation>
    </message>
    <message>
        <source>Damage by tearing, as entropy (nats)</source>
        <translation>Schaden durch Reißen, als Entropie (nat)</translation>
    </message>
    <message>
        <source>in all</source>
        <translation>insgesamt</translation>
    </message>
    <message>
        <source>since the first tear</source>
        <translation>seit dem ersten Riss</translation>
    </message>
    <message>
        <source>entropy</source>
        <translation>Entropie</translation>
    </message>
    <message>
        <source>Show the branch</source>
        <translation>Ast zeigen</translation>
    </message>
    <message>
        <source>The one that the chosen message names, in the table and the view; so does a double click on the message</source>
        <translation>Den, welchen die gewählte Meldung nennt, in der Tabelle und der Ansicht; ebenso tut es ein Doppelklick auf die Meldung</translation>
    </message>
    <message>
        <source>Click where the distance begins: on a vessel, or anywhere in a slice</source>
        <translation>Klicken Sie, wo der Abstand beginnt: auf ein Gefäß oder irgendwo in einer Schicht</translation>
    </message>
    <message>
        <source>Click on one arm of the angle: on a vessel, or anywhere in a slice</source>
        <translation>Klicken Sie auf einen Schenkel des Winkels: auf ein Gefäß oder irgendwo in einer Schicht</translation>
    </message>
    <message>
        <source>Of the tumours numbered %1 from the masks %2 of %3 ml lie outside the box about the liver and are left out of the case. Check that the masks of tumours and liver are of this CT, or give a liver mask that includes them.</source>
        <translation>Von den Tumoren Nummer %1 der Masken liegen %2 von %3 ml außerhalb des Kastens um die Leber und fehlen im Fall. Prüfen Sie, ob die Masken der Tumoren und der Leber zu diesem CT gehören, oder geben Sie eine Lebermaske an, die sie enthält.</translation>
    </message>
    <message>
        <source>Forces shown were rough for a moment: the step was simplified to stay stable (%1)</source>
        <translation>Gezeigte Kräfte waren einen Augenblick lang ungenau: Der Schritt wurde vereinfacht, um stabil zu bleiben (%1)</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>at the same time: %1</source>
        <translation>gleichzeitig: %1</translation>
    </message>
    <message>
        <source>Who quits now gives it up: it counts as not passed. Its recording is kept.</source>
        <translation>Wer jetzt beendet, gibt sie auf: Sie gilt als nicht bestanden. Die Aufzeichnung bleibt erhalten.</translation>
    </message>
    <message>
        <source>series %1 %2</source>
        <translation>Serie %1 %2</translation>
    </message>
    <message>
        <source>series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>a series %1</source>
        <translation>eine Serie %1</translation>
    </message>
    <message>
        <source>a series</source>
        <translation>eine Serie</translation>
    </message>
    <message>
        <source>no contrast</source>
        <translation>ohne Kontrastmittel</translation>
    </message>
    <message>
        <source>Looking through the folder…</source>
        <translation>Der Ordner wird durchgesehen…</translation>
    </message>
    <message>
        <source>The target begins where the portal or arterial vessels pass nearest to the tumour&apos;s middle; other branches that feed it are not in the target</source>
        <translation>Das Zielgebiet beginnt, wo die Gefäße der Pfortader oder der Arterie der Mitte des Tumors am nächsten liegen; andere Äste, die ihn versorgen, gehören nicht dazu</translation>
    </message>
    <message>
        <source>the CUDA device does not answer</source>
        <translation>das CUDA-Gerät antwortet nicht</translation>
    </message>
    <message>
        <source>holds its voxels as text (BinaryData = False)</source>
        <translation>enthält seine Voxel als Text (BinaryData = False)</translation>
    </message>
    <message>
        <source>none; with less confidence: %1</source>
        <translation>keine; mit weniger Sicherheit: %1</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>Dull pink: what an earlier injection had reached.</source>
        <translation>Mattrosa: was eine frühere Injektion erreicht hatte.</translation>
    </message>
    <message>
        <source>Last point</source>
        <translation>Letzter Punkt</translation>
    </message>
    <message>
        <source>Click on along the vessel. Delete or Ctrl+Z: one back</source>
        <translation>Weiter am Gefäß entlang klicken. Entf oder Strg+Z: einer weg</translation>
    </message>
    <message>
        <source>Click on, or draw it (Enter). Delete or Ctrl+Z: one back. Esc: all</source>
        <translation>Weiter klicken oder zeichnen (Eingabetaste). Entf, Strg+Z: einer weg. Esc: alle</translation>
    </message>
    <message>
        <source>Set a branch&apos;s system</source>
        <translation>System eines Astes setzen</translation>
    </message>
    <message>
        <source>Click a branch; it and what hangs on it take the system below. What it hangs on keeps its own</source>
        <translation>Klicken Sie auf einen Ast; er und alles, was an ihm hängt, nehmen das System unten an. Woran er hängt, behält seines</translation>
    </message>
    <message>
        <source>Set a whole vessel&apos;s system</source>
        <translation>System des ganzen Gefäßes setzen</translation>
    </message>
    <message>
        <source>Click anywhere on a vessel; what hangs on it takes the system below, and towards the root as much as belongs with it</source>
        <translation>Klicken Sie irgendwo auf ein Gefäß; was an ihm hängt, nimmt das System unten an, und zur Wurzel hin so viel, wie dazugehört</translation>
    </message>
    <message>
        <source>Read %1 and left out %2 because %3. On the command line --series %4 reads the one that was left out.</source>
        <translation>Gelesen wurde %1, ausgelassen %2: %3. Die ausgelassene liest Datei &gt; Mit Optionen rekonstruieren, Serie %4.</translation>
    </message>
    <message>
        <source>Read %1 and left out %2 as asked for. On the command line --series %3 reads the one that was left out.</source>
        <translation>Gelesen wurde wie verlangt %1, ausgelassen %2. Die ausgelassene liest Datei &gt; Mit Optionen rekonstruieren, Serie %3.</translation>
    </message>
    <message>
        <source>Read %1 and left out %2 others as asked for, the best of them %3. On the command line --series %4 reads that one, and other numbers read the others.</source>
        <translation>Gelesen wurde wie verlangt %1, ausgelassen wurden %2 andere. Die beste davon, %3, liest Datei &gt; Mit Optionen rekonstruieren, Serie %4; andere Nummern lesen die anderen.</translation>
    </message>
    <message>
        <source>A film in one file needs the program ffmpeg, which is not installed (apt install ffmpeg): it is saved as a folder of pictures.</source>
        <translation>Ein Film in einer Datei braucht das Programm ffmpeg, das nicht installiert ist (apt install ffmpeg): Er wird als Ordner mit Bildern gespeichert.</translation>
    </message>
    <message>
        <source>Save a film as a folder of pictures</source>
        <translation>Film als Ordner mit Bildern speichern</translation>
    </message>
    <message>
        <source>No film was saved</source>
        <translation>Es wurde kein Film gespeichert</translation>
    </message>
    <message>
        <source>Choose a tool: %1</source>
        <translation>Wählen Sie ein Werkzeug: %1</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>E&amp;nd the comparison</source>
        <translation>Vergleich bee&amp;nden</translation>
    </message>
    <message>
        <source>is there already, and not empty</source>
        <translation>ist schon da und nicht leer</translation>
    </message>
    <message>
        <source>Give the folder of pictures another name</source>
        <translation>Geben Sie dem Ordner mit den Bildern einen anderen Namen</translation>
    </message>
    <message>
        <source>%L1 g/s</source>
        <translation>%L1 g/s</translation>
    </message>
    <message>
        <source>%L1 mL/min</source>
        <translation>%L1 mL/min</translation>
    </message>
    <message>
        <source>What torn vessels lose now; the panel Tool says the sum</source>
        <translation>Was gerissene Gefäße jetzt verlieren; die Summe sagt das Bedienfeld Werkzeug</translation>
    </message>
    <message>
        <source>bleeds %1</source>
        <translation>blutet %1</translation>
    </message>
    <message>
        <source>This lesson is played without tools; a drag or the arrows turn the view</source>
        <translation>Diese Lektion kommt ohne Werkzeuge aus; Ziehen oder die Pfeile drehen die Ansicht</translation>
    </message>
    <message>
        <source>Confirmed: its system counts as sure from now on (%1)</source>
        <translation>Bestätigt: Sein System gilt von nun an als sicher (%1)</translation>
    </message>
    <message>
        <source>Tones before something tears, when it tears or bleeds, when a step is reached, and at the verdict</source>
        <translation>Töne, bevor etwas reißt, wenn es reißt oder blutet, wenn ein Schritt erreicht ist, und beim Urteil</translation>
    </message>
    <message>
        <source>This computer has no device for sound now: nothing will be heard</source>
        <translation>Dieser Rechner hat zurzeit kein Gerät für Ton: Es wird nichts zu hören sein</translation>
    </message>
    <message>
        <source>It lacks what is not saved yet: save the case, then copy it once more.</source>
        <translation>Es fehlt, was noch nicht gespeichert ist: Speichern Sie den Fall, dann kopieren Sie ihn noch einmal.</translation>
    </message>
    <message>
        <source>, apart from all others: begin on a centreline to hang it there</source>
        <translation>, getrennt von allen anderen: Beginnen Sie auf einer Mittellinie, dann hängt es dort</translation>
    </message>
    <message>
        <source>Left drag beside the vessels</source>
        <translation>Linksziehen neben den Gefäßen</translation>
    </message>
    <message>
        <source>orbit; with Shift pan</source>
        <translation>drehen; mit der Umschalttaste verschieben</translation>
    </message>
    <message>
        <source>Other drags, as chosen in View &gt; Mouse</source>
        <translation>Sonst, wie unter Ansicht &gt; Maus gewählt</translation>
    </message>
    <message>
        <source>Tumour masks</source>
        <translation>Tumormasken</translation>
    </message>
    <message>
        <source>optional: targets of a drug; next file after a semicolon</source>
        <translation>optional: Ziele eines Wirkstoffs; weitere Dateien nach Semikolon</translation>
    </message>
    <message>
        <source>More about its flow</source>
        <translation>Mehr zu seiner Strömung</translation>
    </message>
    <message>
        <source>Tumour %1 (%L2 ml), its nearest branch %L3 mm from its middle</source>
        <translation>Tumor %1 (%L2 ml), der nächste Ast %L3 mm von seiner Mitte</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Weitere Werkzeuge</translation>
    </message>
    <message>
        <source>The file does not say how the patient lies in it (its qform and sform codes are 0): its axes were taken to lead to his right, front and head. Compare the sides in the slices</source>
        <translation>Die Datei sagt nicht, wie der Patient in ihr liegt (ihre qform- und sform-Codes sind 0): Es wurde angenommen, dass ihre Achsen nach rechts, vorn und kopfwärts führen. Vergleichen Sie die Seiten in den Schichten</translation>
    </message>
    <message>
        <source>The liver lies on the patient&apos;s left: the image may be mirrored, or say wrongly how he lies. Left and right are then exchanged everywhere</source>
        <translation>Die Leber liegt links im Patienten: Das Bild ist vielleicht gespiegelt oder sagt falsch, wie er liegt. Links und rechts sind dann überall vertauscht</translation>
    </message>
    <message>
        <source>Colour the vessels by how far they are stretched instead of by system</source>
        <translation>Die Gefäße nach ihrer Dehnung färben statt nach Systemen</translation>
    </message>
    <message>
        <source>case of %1</source>
        <translation>Fall vom %1</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Inside of what is torn</source>
        <translation>Inneres des Gerissenen</translation>
    </message>
    <message>
        <source>Stretch (length / length at rest)</source>
        <translation>Dehnung (Länge / Länge in Ruhe)</translation>
    </message>
    <message>
        <source>Colour b&amp;y stretch</source>
        <translation>&amp;Farben nach Dehnung</translation>
    </message>
    <message>
        <source>There is a case “%1” already, of this patient or of another one. Replace it?</source>
        <translation>Es gibt schon einen Fall „%1“, von diesem oder einem anderen Patienten. Soll er ersetzt werden?</translation>
    </message>
    <message>
        <source>cut or torn: joints of the mesh broken: %1, pieces off: %2</source>
        <translation>geschnitten oder gerissen: gerissene Verbindungen des Netzes: %1, abgetrennte Stücke: %2</translation>
    </message>
    <message>
        <source>Lost blood</source>
        <translation>Verlorenes Blut</translation>
    </message>
    <message>
        <source>Show the blood that was lost where a vessel is torn or cut</source>
        <translation>Zeigt das Blut, das verloren ging, wo ein Gefäß gerissen oder durchtrennt ist</translation>
    </message>
    <message>
        <source>Of all %1 attempts these are shown: %2.</source>
        <translation>Von allen %1 Versuchen sind diese gezeigt: %2.</translation>
    </message>
    <message>
        <source>Whole vessel given to: %1</source>
        <translation>Ganzes Gefäß zugeordnet: %1</translation>
    </message>
    <message>
        <source>Gap refused</source>
        <translation>Lücke abgelehnt</translation>
    </message>
    <message>
        <source>bridged: %1</source>
        <translation>überbrückt: %1</translation>
    </message>
    <message>
        <source>Refuse it</source>
        <translation>Ablehnen</translation>
    </message>
    <message>
        <source>It is offered no more. What the reconstruction has bridged is cut in its middle. Undo takes that back.</source>
        <translation>Sie wird nicht mehr angeboten. Was die Rekonstruktion überbrückt hat, wird in der Mitte durchtrennt. Rückgängig nimmt das zurück.</translation>
    </message>
    <message>
        <source>Not while you look back on a recording: leave the review first (%1)</source>
        <translation>Nicht während eines Rückblicks: Verlassen Sie ihn zuerst (%1)</translation>
    </message>
    <message>
        <source>What lies before the middle of the view is taken away: D opens it deeper, Shift+D less deep</source>
        <translation>Was vor der Mitte der Ansicht liegt, ist weggenommen: D öffnet sie tiefer, Umschalt+D weniger tief</translation>
    </message>
    <message>
        <source>The view is whole: O opens it</source>
        <translation>Die Ansicht ist nicht aufgeschnitten: O schneidet sie auf</translation>
    </message>
    <message>
        <source>Opened %L1 mm behind where it was put</source>
        <translation>%L1 mm tiefer aufgeschnitten, als die Ebene gesetzt wurde</translation>
    </message>
    <message>
        <source>Opened %L1 mm before where it was put</source>
        <translation>%L1 mm weniger tief aufgeschnitten, als die Ebene gesetzt wurde</translation>
    </message>
    <message>
        <source>“%1” is no place</source>
        <translation>„%1“ ist keine Stelle</translation>
    </message>
    <message>
        <source>write it as the slices do, as L 12 P 40 H 155 mm, and a semicolon before the next one; or leave it empty</source>
        <translation>schreiben Sie sie wie die Schichten, als L 12 P 40 H 155 mm, und ein Semikolon vor die nächste; oder lassen Sie das Feld leer</translation>
    </message>
    <message>
        <source>optional: a place as the slices write it, L 12 P 40 H 155 mm</source>
        <translation>optional: eine Stelle, wie die Schichten sie schreiben, L 12 P 40 H 155 mm</translation>
    </message>
    <message>
        <source>A place in the vessel: to the left (L) or right (R), the back (P) or front (A), the head (H) or feet (F), in mm, as it stands below the slices under the pointer. A semicolon stands before the next one.</source>
        <translation>Eine Stelle im Gefäß: nach links (L) oder rechts (R), hinten (P) oder vorn (A), zum Kopf (H) oder zu den Füßen (F), in mm, wie sie für den Mauszeiger unter den Schichten steht. Vor der nächsten steht ein Semikolon.</translation>
    </message>
    <message>
        <source>There is no recording here yet:</source>
        <translation>Hier gibt es noch keine Aufnahme:</translation>
    </message>
    <message>
        <source>There is no other recording here yet:</source>
        <translation>Hier gibt es noch keine andere Aufnahme:</translation>
    </message>
    <message>
        <source>Pull the vessel at the mark aside and hold it there.</source>
        <translation>Ziehen Sie das Gefäß an der Marke beiseite und halten Sie es dort.</translation>
    </message>
    <message>
        <source>%L1 %, branch of %L2 mm</source>
        <translation>%L1 %, Ast von %L2 mm</translation>
    </message>
    <message>
        <source>Gaps and doubtful branches</source>
        <translation>Lücken und unsichere Äste</translation>
    </message>
    <message>
        <source>Take it</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>A gap is bridged, a branch is drawn</source>
        <translation>Eine Lücke wird überbrückt, ein Ast eingezeichnet</translation>
    </message>
    <message>
        <source>All that are offered with this confidence or more, best first; what another one made needless is left out</source>
        <translation>Alle, die mit dieser Sicherheit oder mehr angeboten sind, das Sicherste zuerst; was durch anderes überflüssig wurde, bleibt weg</translation>
    </message>
    <message>
        <source>Least confidence of what is offered</source>
        <translation>Geringste Sicherheit dessen, was angeboten wird</translation>
    </message>
    <message>
        <source>What may be a vessel, and how sure</source>
        <translation>Was ein Gefäß sein kann, und wie sicher</translation>
    </message>
    <message>
        <source>Looking for doubtful branches</source>
        <translation>Unsichere Äste werden gesucht</translation>
    </message>
    <message>
        <source>the other end of an edit</source>
        <translation>das andere Ende einer Korrektur</translation>
    </message>
    <message>
        <source>an offered branch does not have a radius from 0.001 to 50 mm for each of its points</source>
        <translation>ein angebotener Ast hat nicht für jeden seiner Punkte einen Radius von 0,001 bis 50 mm</translation>
    </message>
    <message>
        <source>Branch taken</source>
        <translation>Ast übernommen</translation>
    </message>
    <message>
        <source>Branch refused</source>
        <translation>Ast abgelehnt</translation>
    </message>
    <message>
        <source>Take all that are listed (%1)</source>
        <translation>Alle der Liste übernehmen (%1)</translation>
    </message>
    <message>
        <source>A drag or the arrows turn the view</source>
        <translation>Ziehen oder die Pfeiltasten drehen die Ansicht</translation>
    </message>
    <message>
        <source>That part is not read yet: what was played is computed again, which takes about as long</source>
        <translation>Dieser Teil ist noch nicht gelesen: Die Übung wird noch einmal berechnet, was etwa ebenso lange dauert</translation>
    </message>
    <message>
        <source>Branches that touch may be parted (Edit in the tool bar), or give another number of tetrahedra</source>
        <translation>Äste, die sich berühren, lassen sich trennen (Bearbeiten in der Werkzeugleiste), oder geben Sie eine andere Zahl von Tetraedern an</translation>
    </message>
    <message>
        <source>%1 of %2 bodies</source>
        <translation>%1 von %2 Körpern</translation>
    </message>
    <message>
        <source>%1 of %2 body</source>
        <translation>%1 von %2 Körper</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>Aufnahme</translation>
    </message>
    <message numerus="yes">
        <source>%n gap(s) and doubtful branch(es) taken</source>
        <translation>
            <numerusform>%n Lücke oder unsicherer Ast übernommen</numerusform>
            <numerusform>%n Lücken und unsichere Äste übernommen</numerusform>
        </translation>
    </message>
    <message>
        <source>By keys: %1</source>
        <translation>Mit Tasten: %1</translation>
    </message>
    <message>
        <source>Taking what is offered</source>
        <translation>Angebotenes wird übernommen</translation>
    </message>
    <message>
        <source>Nothing was taken</source>
        <translation>Nichts wurde übernommen</translation>
    </message>
    <message>
        <source>Looking for what fits</source>
        <translation>Passendes wird gesucht</translation>
    </message>
    <message>
        <source>Nothing was taken, because something was corrected meanwhile</source>
        <translation>Nichts wurde übernommen, weil inzwischen etwas korrigiert wurde</translation>
    </message>
    <message>
        <source>None of them fits: taken one by one, each says why</source>
        <translation>Nichts davon passt. Wird es einzeln übernommen, steht da, warum nicht</translation>
    </message>
    <message>
        <source>the vessels are being corrected, which would end the review</source>
        <translation>die Gefäße werden gerade korrigiert, was den Rückblick beenden würde</translation>
    </message>
    <message>
        <source>Wait until the correction is made</source>
        <translation>Warten Sie, bis die Korrektur gemacht ist</translation>
    </message>
    <message>
        <source>%1 mm to the mark, move away from you</source>
        <translation>%1 mm bis zur Marke, von sich weg führen</translation>
    </message>
    <message>
        <source>%1 mm to the mark, move towards you</source>
        <translation>%1 mm bis zur Marke, zu sich hin führen</translation>
    </message>
    <message>
        <source>%1 mm to mark %2, move away from you</source>
        <translation>%1 mm bis zur Marke %2, von sich weg führen</translation>
    </message>
    <message>
        <source>%1 mm to mark %2, move towards you</source>
        <translation>%1 mm bis zur Marke %2, zu sich hin führen</translation>
    </message>
    <message>
        <source>an edit belongs to step %1</source>
        <translation>eine Korrektur gehört zu Schritt %1</translation>
    </message>
    <message>
        <source>Enter acts at the cross in the middle of the view. Arrow keys lead what is held, Page Up and Page Down a tool in depth; Enter or Esc lets go.</source>
        <translation>Die Eingabetaste handelt am Kreuz in der Mitte der Ansicht. Pfeiltasten führen, was gehalten wird, Bild auf und Bild ab ein Werkzeug in der Tiefe; Eingabetaste oder Esc lässt los.</translation>
    </message>
    <message>
        <source>Number steps from 1 to 1000000, or leave them out</source>
        <translation>Schritte von 1 bis 1000000 nummerieren oder weglassen</translation>
    </message>
    <message>
        <source>bridge that gap; in Edit mode: choose it in the panel</source>
        <translation>diese Lücke überbrücken; im Modus Bearbeiten: sie im Bedienfeld wählen</translation>
    </message>
    <message>
        <source>The play ended before the lesson did: it can be looked back on, and counts as no attempt.</source>
        <translation>Die Übung endete vor der Lektion: Man kann darauf zurückblicken, und sie zählt nicht als Versuch.</translation>
    </message>
    <message>
        <source>Chosen in the panel Corrections: decide there whether to take or refuse it</source>
        <translation>Im Bedienfeld Korrekturen gewählt: Dort entscheiden, ob es übernommen oder abgelehnt wird</translation>
    </message>
    <message>
        <source>Above stands what the reconstruction has bridged, the doubtful first; below it what may be a vessel: gaps between two, and branches that are too faint to be believed, with the confidence that they are vessels. For branches it was learned on synthetic patients: of what was offered on two real ones experts had drawn a quarter to a half. They are dashed in the view, branches in Edit mode. A click on a dashed line takes it; in Edit mode, where a click corrects vessels, it only chooses it in this list. What is chosen stands out in the view and as a line in the slices.</source>
        <translation>Oben steht, was die Rekonstruktion überbrückt hat, das Zweifelhafte zuerst; darunter, was ein Gefäß sein kann: Lücken zwischen zweien und Äste, die zu schwach sind, um ihnen zu glauben, mit der Sicherheit, dass es Gefäße sind. Bei Ästen ist sie an künstlichen Patienten gelernt: Von dem, was bei zwei wirklichen angeboten wurde, hatten Fachleute ein Viertel bis die Hälfte eingezeichnet. Sie sind in der Ansicht gestrichelt, Äste im Modus Bearbeiten. Ein Klick auf eine gestrichelte Linie übernimmt sie; im Modus Bearbeiten, wo ein Klick Gefäße korrigiert, wählt er sie nur in dieser Liste. Was gewählt ist, tritt in der Ansicht hervor und steht als Linie in den Schichten.</translation>
    </message>
    <message>
        <source>The last lesson or recorded play was interrupted (%1). Its recording goes up to that moment. A lesson that was interrupted counts as no attempt.</source>
        <translation>Die letzte Lektion oder aufgezeichnete Übung wurde unterbrochen (%1). Ihre Aufzeichnung reicht bis dahin. Eine unterbrochene Lektion zählt nicht als Versuch.</translation>
    </message>
    <message>
        <source>The film was saved: %1</source>
        <translation>Der Film wurde gespeichert: %1</translation>
    </message>
    <message>
        <source>This step asks you to lead the tool: the wheel (by keys: Page Up/Down) moves it in depth</source>
        <translation>In diesem Schritt ist das Werkzeug zu führen: Das Mausrad (mit Tasten: Bild auf/ab) bewegt es in die Tiefe</translation>
    </message>
    <message>
        <source>That step is not the last one any more: Undo takes the last step back</source>
        <translation>Dieser Schritt ist nicht mehr der letzte: „Rückgängig“ nimmt den letzten Schritt zurück</translation>
    </message>
    <message>
        <source>Cancelled: what was undone is there again</source>
        <translation>Abgebrochen: Was rückgängig gemacht war, ist wieder da</translation>
    </message>
    <message numerus="yes">
        <source>%n correction(s) taken back; Redo makes them again</source>
        <translation>
            <numerusform>%n Korrektur zurückgenommen; Wiederholen macht sie erneut</numerusform>
            <numerusform>%n Korrekturen zurückgenommen; Wiederholen macht sie erneut</numerusform>
        </translation>
    </message>
    <message>
        <source>Hepatic artery seeds</source>
        <translation>Startpunkte Leberarterie</translation>
    </message>
    <message>
        <source>Save the case before it is copied into one file? As last saved, the copy lacks the changes.</source>
        <translation>Den Fall speichern, bevor er in eine Datei kopiert wird? Wie zuletzt gespeichert fehlen der Kopie die Änderungen.</translation>
    </message>
    <message>
        <source>&amp;As last saved</source>
        <translation>&amp;Wie zuletzt gespeichert</translation>
    </message>
    <message>
        <source>Key 4 takes the probe. The mouse leads it, the wheel moves it in depth; a click brings it nowhere here. The picture says how far it is to the mark and which way. Look from the side (L) to judge the depth.</source>
        <translation>Taste 4 nimmt die Sonde. Die Maus führt sie, das Mausrad bewegt sie in die Tiefe; ein Klick bringt sie hier nirgendwohin. Das Bild sagt, wie weit und in welcher Richtung die Marke liegt. Von der Seite (L) lässt sich die Tiefe beurteilen.</translation>
    </message>
    <message>
        <source>Key 6 takes the forceps; they come in front of the vessels. Push them away from you with the wheel until the picture says that the mark is between the jaws, then C closes them. Limited is the force with which a tool pushes or pulls the vessels, not the grip between the jaws.</source>
        <translation>Taste 6 nimmt die Pinzette; sie kommt vor die Gefäße. Mit dem Mausrad in die Tiefe führen, bis im Bild steht, dass die Marke zwischen den Backen liegt, dann schließt C sie. Begrenzt ist die Kraft, mit der ein Werkzeug die Gefäße drückt oder zieht, nicht der Griff zwischen den Backen.</translation>
    </message>
    <message>
        <source>Key 9 draws cut lines; key 1 pulls again. &quot;Along a line&quot; in the panel Tool is what the line leaves of the strength: 0.05, unless you changed it.</source>
        <translation>Taste 9 zeichnet Schwächungslinien; Taste 1 zieht wieder. „Entlang Linie“ im Bedienfeld Werkzeug ist, was die Linie von der Festigkeit übrig lässt: 0,05, wenn nichts geändert wurde.</translation>
    </message>
    <message>
        <source>Interrupted before the end</source>
        <translation>Vor dem Ende unterbrochen</translation>
    </message>
    <message>
        <source>the mark is between the jaws</source>
        <translation>die Marke liegt zwischen den Backen</translation>
    </message>
    <message>
        <source>mark %1 is between the jaws</source>
        <translation>Marke %1 liegt zwischen den Backen</translation>
    </message>
    <message>
        <source>The link joins two systems, which do not meet in a liver: what hangs together with its second end (%1) belongs to the system of its first (%2) from now on.</source>
        <translation>Die Verbindung verknüpft zwei Systeme, die sich in einer Leber nicht treffen: Was mit ihrem zweiten Ende zusammenhängt (%1), gehört von nun an zum System des ersten (%2).</translation>
    </message>
    <message>
        <source>The link leads over %1 from wall to wall, farther than a gap in one vessel is likely to be.</source>
        <translation>Die Verbindung führt von Wand zu Wand über %1, weiter, als eine Lücke in einem Gefäß wahrscheinlich ist.</translation>
    </message>
    <message>
        <source>Seed: %1</source>
        <translation>Startpunkt: %1</translation>
    </message>
    <message>
        <source>Distance: two clicks. Angle: three, its vertex second. Diameter: a click on a vessel, at whose centreline it is taken, with the stenosis against the vessel beside. Draw a vessel: clicks along one that is missing, in any slices, from where its blood comes in; Enter draws it. Delete or Undo takes the last away, Escape all. Correct: a click on a vessel does what the panel of corrections says. Paint, erase: a drag leads a ball through the vessels&apos; voxels; Rebuild makes the vessels anew of them. A tumour changes no vessel: it needs no Rebuild. Seed: a click says which vessel is which, and Reconstruct begins anew with all of them</source>
        <translation>Abstand: zwei Klicks. Winkel: drei, der zweite ist der Scheitel. Durchmesser: ein Klick auf ein Gefäß, an dessen Mittellinie er gemessen wird, mit der Stenose gegen das Gefäß daneben. Gefäß zeichnen: Klicks entlang eines fehlenden Gefäßes, in beliebigen Schichten, von dort an, wo sein Blut eintritt; die Eingabetaste zeichnet es. Entf oder Rückgängig nimmt den letzten weg, Esc alle. Korrigieren: Ein Klick auf ein Gefäß tut, was das Bedienfeld der Korrekturen sagt. Malen, radieren: Ziehen führt eine Kugel durch die Voxel der Gefäße; Neu bauen macht die Gefäße daraus neu. Ein Tumor ändert kein Gefäß: Er braucht kein Neubauen. Startpunkt: Ein Klick sagt, welches Gefäß welches ist, und Rekonstruieren beginnt mit allen neu</translation>
    </message>
    <message>
        <source>Click into the vessel (%1), then Reconstruct. Delete: one back</source>
        <translation>In das Gefäß klicken (%1), dann Rekonstruieren. Entf: einen zurück</translation>
    </message>
    <message>
        <source>Reconstruct…</source>
        <translation>Rekonstruieren …</translation>
    </message>
    <message>
        <source>Makes the vessels anew of the CT and tells them apart by the seeds (crosses). Corrections are not taken over</source>
        <translation>Macht die Gefäße aus dem CT neu und unterscheidet sie nach den Startpunkten (Kreuze). Korrekturen werden nicht übernommen</translation>
    </message>
    <message>
        <source>The CT was not read. Hide the slices and show them again (F7) to read it, or choose another one.</source>
        <translation>Das CT wurde nicht gelesen. Blenden Sie die Schichten aus und wieder ein (F7), um es zu lesen, oder wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Noted</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Notes of the instructor</source>
        <translation>Notizen der Lehrenden</translation>
    </message>
    <message>
        <source>Drawing pictures</source>
        <translation>Bilder werden gezeichnet</translation>
    </message>
    <message>
        <source>Turn the tool back</source>
        <translation>Werkzeug zurückdrehen</translation>
    </message>
    <message>
        <source>Sou&amp;nds</source>
        <translation>T&amp;öne</translation>
    </message>
    <message>
        <source>Legen&amp;d and scale</source>
        <translation>Le&amp;gende und Maßstab</translation>
    </message>
    <message>
        <source>Open it deeper</source>
        <translation>Tiefer aufschneiden</translation>
    </message>
    <message>
        <source>Open it less deep</source>
        <translation>Weniger tief aufschneiden</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Bedienfelder</translation>
    </message>
    <message>
        <source>Li&amp;ght</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>passed earlier, before this course</source>
        <translation>früher bestanden, vor diesem Kurs</translation>
    </message>
    <message>
        <source>everybody here</source>
        <translation>allen hier</translation>
    </message>
    <message>
        <source>✓ The course &quot;%1&quot; is passed by %2: all of its lessons are.</source>
        <translation>✓ Der Kurs „%1“ ist von %2 bestanden: Alle seine Lektionen sind es.</translation>
    </message>
    <message>
        <source>This was the last lesson of the course &quot;%1&quot;: %2 of %3 are passed by %4.</source>
        <translation>Das war die letzte Lektion des Kurses „%1“: %2 von %3 sind von %4 bestanden.</translation>
    </message>
    <message>
        <source>Done with</source>
        <translation>Womit</translation>
    </message>
    <message>
        <source>The goal counts only while this tool is in hand</source>
        <translation>Das Ziel zählt nur, solange dieses Werkzeug in der Hand ist</translation>
    </message>
    <message>
        <source>whatever is in hand</source>
        <translation>womit auch immer</translation>
    </message>
    <message>
        <source>The play is paused as it was when it was judged, and what was in hand is put away. It goes on as soon as you do something.</source>
        <translation>Die Übung ist angehalten, wie sie beim Urteil war, und was in der Hand war, ist weggelegt. Sie geht weiter, sobald Sie etwas tun.</translation>
    </message>
    <message>
        <source>This step is done with: %1</source>
        <translation>Dieser Schritt wird hiermit ausgeführt: %1</translation>
    </message>
    <message>
        <source>“%1” was not copied: it does not lie in the folder that is shown any more.</source>
        <translation>„%1“ wurde nicht kopiert: Der Fall liegt nicht mehr im gezeigten Ordner.</translation>
    </message>
    <message>
        <source>%1 is open in another program, too (on the computer %2). Who saves last is asked before the other&apos;s work is replaced.</source>
        <translation>%1 ist auch in einem anderen Programm offen (auf dem Rechner %2). Wer zuletzt speichert, wird gefragt, bevor die Arbeit des anderen ersetzt wird.</translation>
    </message>
    <message>
        <source>Mous&amp;e</source>
        <translation>M&amp;aus</translation>
    </message>
    <message>
        <source>U&amp;nits</source>
        <translation>&amp;Einheiten</translation>
    </message>
    <message numerus="yes">
        <source>%n correction(s) taken back; Redo makes them again. The Undo before them goes on: Cancel once more ends it, too</source>
        <translation>
            <numerusform>%n Korrektur zurückgenommen; Wiederholen macht sie erneut. Was davor rückgängig gemacht wurde, wird noch vernetzt: Nochmals Abbrechen beendet auch das</numerusform>
            <numerusform>%n Korrekturen zurückgenommen; Wiederholen macht sie erneut. Was davor rückgängig gemacht wurde, wird noch vernetzt: Nochmals Abbrechen beendet auch das</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Cancelled: what was undone is there again. %n correction(s) made after that Undo cannot be made again</source>
        <translation>
            <numerusform>Abgebrochen: Was rückgängig gemacht war, ist wieder da. %n danach gemachte Korrektur lässt sich nicht wiederholen</numerusform>
            <numerusform>Abgebrochen: Was rückgängig gemacht war, ist wieder da. %n danach gemachte Korrekturen lassen sich nicht wiederholen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was not there any more: it was saved anew</source>
        <translation>%1 war nicht mehr da und wurde neu gespeichert</translation>
    </message>
    <message>
        <source>Seeds and masks of the other CT were taken out.</source>
        <translation>Startpunkte und Masken des anderen CT wurden herausgenommen.</translation>
    </message>
    <message>
        <source>The present case was made with seeds, masks or a window. They are offered here once it is known where its CT lies: choose it in the slices (F7).</source>
        <translation>Der gezeigte Fall wurde mit Startpunkten, Masken oder einem Fenster gemacht. Sie werden hier angeboten, sobald bekannt ist, wo sein CT liegt: in den Schichten auswählen (F7).</translation>
    </message>
    <message>
        <source>a liver mask</source>
        <translation>einer Lebermaske</translation>
    </message>
    <message>
        <source>a vessel mask</source>
        <translation>einer Gefäßmaske</translation>
    </message>
    <message numerus="yes">
        <source>%n tumour mask(s)</source>
        <translation>
            <numerusform>%n Tumormaske</numerusform>
            <numerusform>%n Tumormasken</numerusform>
        </translation>
    </message>
    <message>
        <source>The present case was made with %1, and it is not known where that lies. Choose it again, or the new case is without it.</source>
        <translation>Der gezeigte Fall wurde mit %1 gemacht, und es ist nicht bekannt, wo das liegt. Neu auswählen, sonst fehlt es dem neuen Fall.</translation>
    </message>
    <message>
        <source>%1 was changed on the disk since it was opened or saved here.</source>
        <translation>%1 wurde auf dem Datenträger geändert, seit es hier geöffnet oder gespeichert wurde.</translation>
    </message>
    <message>
        <source>Another program or person has saved there. Replacing it loses what they have done; under another name both are kept.</source>
        <translation>Ein anderes Programm oder jemand anderes hat dort gespeichert. Beim Ersetzen geht verloren, was dort getan wurde; unter anderem Namen bleibt beides erhalten.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Leeren</translation>
    </message>
    <message>
        <source>Save its pictures…</source>
        <translation>Seine Bilder speichern …</translation>
    </message>
    <message>
        <source>Each picture of the film as a PNG file, in a folder</source>
        <translation>Jedes Bild des Films als PNG-Datei, in einem Ordner</translation>
    </message>
    <message>
        <source>The device&apos;s steps leave out tension, by which taut vessels resist being turned: they err more where a vessel is pulled</source>
        <translation>Die Schritte der Grafikkarte lassen die Spannung aus, mit der straffe Gefäße sich gegen Drehung wehren: Wo an einem Gefäß gezogen wird, irren sie mehr</translation>
    </message>
    <message>
        <source>Find three places with the tip of a probe, one after the other, without pushing the vessels, and stay at each for half a second. The mouse leads the tip across the picture, the wheel in depth. Turning the view helps to judge the depth, but is not scored: a recording holds what is done to the patient, not where somebody looks.</source>
        <translation>Mit der Spitze einer Sonde nacheinander drei Orte finden, ohne die Gefäße zu verschieben, und an jedem eine halbe Sekunde bleiben. Die Maus führt die Spitze im Bild, das Mausrad in die Tiefe. Die Ansicht zu drehen hilft, die Tiefe zu beurteilen, wird aber nicht bewertet: Eine Aufzeichnung enthält, was am Patienten getan wird, nicht, wohin jemand sieht.</translation>
    </message>
    <message>
        <source>cannot be written: the disk is full</source>
        <translation>lässt sich nicht schreiben: Der Datenträger ist voll</translation>
    </message>
    <message>
        <source>is %1; it must lie from %2 to %3</source>
        <translation>ist %1; erlaubt ist %2 bis %3</translation>
    </message>
    <message>
        <source>is %1, not a time</source>
        <translation>ist %1 und keine Zeit</translation>
    </message>
    <message>
        <source>Write it as &quot;2026-11-23T13:20:05Z&quot;, or leave it out</source>
        <translation>Als „2026-11-23T13:20:05Z“ schreiben oder weglassen</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is not held in the hand</source>
        <translation>ist „%1“ und wird nicht in der Hand gehalten</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which the lesson does not allow</source>
        <translation>ist „%1“ und in der Lektion nicht erlaubt</translation>
    </message>
    <message>
        <source>Name it under &quot;tools&quot;, too</source>
        <translation>Auch unter „tools“ nennen</translation>
    </message>
    <message>
        <source>%1 asks for the tool %2, which the lesson does not allow: allow it, or ask for none.</source>
        <translation>%1 verlangt das Werkzeug %2, das die Lektion nicht erlaubt: erlauben oder keines verlangen.</translation>
    </message>
    <message>
        <source>Forceps closed: they hold something</source>
        <translation>Pinzette geschlossen: Sie hält etwas</translation>
    </message>
    <message>
        <source>Forceps closed: they hold nothing</source>
        <translation>Pinzette geschlossen: Sie hält nichts</translation>
    </message>
    <message>
        <source>Forceps opened</source>
        <translation>Pinzette geöffnet</translation>
    </message>
    <message>
        <source>Slipped out of the forceps</source>
        <translation>Aus der Pinzette gerutscht</translation>
    </message>
    <message>
        <source>the point to hold</source>
        <translation>der zu fassende Punkt</translation>
    </message>
    <message>
        <source>the hand&apos;s position</source>
        <translation>der Ort der Hand</translation>
    </message>
    <message>
        <source>the point</source>
        <translation>der Punkt</translation>
    </message>
    <message>
        <source>is not within 10 m of the origin</source>
        <translation>liegt nicht innerhalb von 10 m um den Ursprung</translation>
    </message>
    <message>
        <source>Give numbers from -10000 to 10000 mm</source>
        <translation>Zahlen von -10000 bis 10000 mm angeben</translation>
    </message>
    <message>
        <source>command %1, field %2 is %3; it must lie from %4 to %5</source>
        <translation>Befehl %1, Feld %2 ist %3; erlaubt ist %4 bis %5</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>%1 mm, move away from you</source>
        <translation>%1 mm, von sich weg führen</translation>
    </message>
    <message>
        <source>%1 mm, move towards you</source>
        <translation>%1 mm, zu sich her führen</translation>
    </message>
    <message>
        <source>closed %1 mm beside the mark: open with C</source>
        <translation>%1 mm neben der Marke geschlossen: mit C öffnen</translation>
    </message>
    <message>
        <source>closed %1 mm beside the mark: open with C and move away from you</source>
        <translation>%1 mm neben der Marke geschlossen: mit C öffnen und von sich weg führen</translation>
    </message>
    <message>
        <source>closed %1 mm beside the mark: open with C and move towards you</source>
        <translation>%1 mm neben der Marke geschlossen: mit C öffnen und zu sich her führen</translation>
    </message>
    <message>
        <source>closed %1 mm beside mark %2: open with C</source>
        <translation>%1 mm neben Marke %2 geschlossen: mit C öffnen</translation>
    </message>
    <message>
        <source>closed %1 mm beside mark %2: open with C and move away from you</source>
        <translation>%1 mm neben Marke %2 geschlossen: mit C öffnen und von sich weg führen</translation>
    </message>
    <message>
        <source>closed %1 mm beside mark %2: open with C and move towards you</source>
        <translation>%1 mm neben Marke %2 geschlossen: mit C öffnen und zu sich her führen</translation>
    </message>
    <message>
        <source>Seed at %1 HU: hardly a vessel with contrast. Delete takes it back</source>
        <translation>Startpunkt bei %1 HU: kaum ein Gefäß mit Kontrastmittel. Entf nimmt ihn zurück</translation>
    </message>
    <message>
        <source>Seed far outside the liver. Delete takes it back</source>
        <translation>Startpunkt weit außerhalb der Leber. Entf nimmt ihn zurück</translation>
    </message>
    <message>
        <source>date unknown</source>
        <translation>Datum unbekannt</translation>
    </message>
    <message>
        <source>Ends the reading of the CT as a volume, and hides it</source>
        <translation>Beendet das Lesen des CT als Volumen und blendet es aus</translation>
    </message>
    <message>
        <source>Date unknown</source>
        <translation>Datum unbekannt</translation>
    </message>
    <message>
        <source>The recording is cut short: this is about what is left of it, which may not be the whole play.</source>
        <translation>Die Aufzeichnung ist abgeschnitten: Dies gilt für das, was von ihr übrig ist, und das ist vielleicht nicht die ganze Übung.</translation>
    </message>
    <message>
        <source>Nothing was played.</source>
        <translation>Es wurde nichts geübt.</translation>
    </message>
    <message>
        <source>Choose from pull, sphere, capsule, forceps, hook</source>
        <translation>Aus pull, sphere, capsule, forceps, hook wählen</translation>
    </message>
    <message>
        <source>The program ended without saving %1 (%2). What is shown is this case without that work.</source>
        <translation>Das Programm endete, ohne %1 zu speichern (%2). Gezeigt wird dieser Fall ohne diese Arbeit.</translation>
    </message>
</context>
</TS>

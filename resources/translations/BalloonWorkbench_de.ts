<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>A line of text where the film is widest, as outlines</source>
        <translation>Eine Textzeile dort, wo die Folie am breitesten ist, als Umrisse</translation>
    </message>
    <message>
        <source>A ready body, made to measure</source>
        <translation>Ein fertiger Körper, nach Maß</translation>
    </message>
    <message>
        <source>A size of the ready body</source>
        <translation>Ein Maß des fertigen Körpers</translation>
    </message>
    <message>
        <source>A tab with a hole to tie the balloon to, outside the weld</source>
        <translation>Eine Lasche mit Loch zum Anbinden, außerhalb der Schweißnaht</translation>
    </message>
    <message>
        <source>Add what the balloon is filled through</source>
        <translation>Fügt hinzu, wodurch der Ballon gefüllt wird</translation>
    </message>
    <message>
        <source>Air that it holds, as a share of what a round balloon of as much film would</source>
        <translation>Luft, die er fasst, als Anteil dessen, was ein runder Ballon aus ebenso viel Folie fassen würde</translation>
    </message>
    <message>
        <source>Another picture for the back; empty takes that of the front</source>
        <translation>Ein anderes Bild für die Rückseite; leer nimmt das der Vorderseite</translation>
    </message>
    <message>
        <source>Area of film inside the welds, all panels</source>
        <translation>Folienfläche innerhalb der Schweißnähte, alle Bahnen</translation>
    </message>
    <message>
        <source>Area of the piece of film</source>
        <translation>Fläche des Folienstücks</translation>
    </message>
    <message>
        <source>Around the balloon, in degrees Celsius</source>
        <translation>Um den Ballon herum, in Grad Celsius</translation>
    </message>
    <message>
        <source>Automatic evens out a nearly symmetric picture, Forced any drawing: its left half is mirrored</source>
        <translation>„Automatisch“ gleicht ein fast symmetrisches Bild aus, „Erzwungen“ jede Zeichnung: Die linke Hälfte wird gespiegelt</translation>
    </message>
    <message>
        <source>Corner relief: corners of the cuts are rounded so; the weld is not</source>
        <translation>Eckenfreistich: So werden Ecken der Schnitte gerundet, die Schweißnaht nicht</translation>
    </message>
    <message>
        <source>Corners of all loops</source>
        <translation>Ecken aller Umrisslinien</translation>
    </message>
    <message>
        <source>Corners of all welds</source>
        <translation>Ecken aller Schweißnähte</translation>
    </message>
    <message>
        <source>Corners of the pattern's seam</source>
        <translation>Ecken der Naht des Schnittmusters</translation>
    </message>
    <message>
        <source>Corners of the triangles on the flat film; z is not 0 where a face does not unroll</source>
        <translation>Ecken der Dreiecke auf der flachen Folie; z ist nicht 0, wo eine Fläche nicht abwickelbar ist</translation>
    </message>
    <message>
        <source>Corners of the welds inside</source>
        <translation>Ecken der inneren Schweißnähte</translation>
    </message>
    <message>
        <source>Correct the pattern until the balloon looks like the drawing, or not</source>
        <translation>Das Schnittmuster korrigieren, bis der Ballon wie die Zeichnung aussieht, oder nicht</translation>
    </message>
    <message>
        <source>Corrections of the pattern</source>
        <translation>Korrekturen des Schnittmusters</translation>
    </message>
    <message>
        <source>Diameter of a body from a file; 0 follows from the height, or the file</source>
        <translation>Durchmesser eines Körpers aus einer Datei; 0 folgt aus der Höhe oder der Datei</translation>
    </message>
    <message>
        <source>Direction of the grain, from the x axis of the drawing</source>
        <translation>Laufrichtung der Folie, von der x-Achse der Zeichnung aus</translation>
    </message>
    <message>
        <source>Direction of the neck, counter-clockwise from the x axis</source>
        <translation>Richtung des Füllhalses, gegen den Uhrzeigersinn von der x-Achse</translation>
    </message>
    <message>
        <source>Direction of the tab from the middle of the pattern</source>
        <translation>Richtung der Lasche von der Mitte des Schnittmusters aus</translation>
    </message>
    <message>
        <source>Display mode when no map is shown</source>
        <translation>Anzeigemodus, wenn keine Farbkarte gezeigt wird</translation>
    </message>
    <message>
        <source>Distance that 95 % of the silhouette keep to</source>
        <translation>Abstand, den 95 % der Silhouette einhalten</translation>
    </message>
    <message>
        <source>Distance that 95 % of the silhouette keep to if the weld creases</source>
        <translation>Abstand, den 95 % der Silhouette einhalten, wenn die Naht knittert</translation>
    </message>
    <message>
        <source>Dots per inch of the files</source>
        <translation>Punkte je Zoll der Dateien</translation>
    </message>
    <message>
        <source>Edge at which the bag is filled, such as Sketch.Edge3; of a file or ready body: the panel and the number of a point, such as side.2, or the number of a seam; empty: as the file or body says</source>
        <translation>Kante, an der der Beutel gefüllt wird, etwa Sketch.Edge3; bei einer Datei oder einem fertigen Körper: die Bahn und die Nummer eines Punktes, etwa side.2, oder die Nummer einer Naht; leer: wie Datei oder Körper es sagen</translation>
    </message>
    <message>
        <source>Edges that are joined, such as Sketch.Edge1=Sketch001.Edge3; edges that faces share need no word</source>
        <translation>Kanten, die verbunden werden, etwa Sketch.Edge1=Sketch001.Edge3; Kanten, die Flächen gemeinsam haben, brauchen keine Angabe</translation>
    </message>
    <message>
        <source>Edges that stand for pieces of curves</source>
        <translation>Kanten, die für Stücke von Kurven stehen</translation>
    </message>
    <message>
        <source>Film left between pieces, and at the edges</source>
        <translation>Folie zwischen den Stücken und am Rand</translation>
    </message>
    <message>
        <source>Film left outside the weld</source>
        <translation>Folie, die außerhalb der Schweißnaht stehen bleibt</translation>
    </message>
    <message>
        <source>Film of both panels with weld and intake, in grams</source>
        <translation>Folie beider Bahnen mit Schweißnaht und Füllhals, in Gramm</translation>
    </message>
    <message>
        <source>Film that wrinkles where it is compressed, or a shell that does not, for comparison</source>
        <translation>Folie, die unter Druck Falten wirft, oder zum Vergleich eine Schale, die das nicht tut</translation>
    </message>
    <message>
        <source>Film, model and solver of the result</source>
        <translation>Folie, Modell und Löser des Ergebnisses</translation>
    </message>
    <message>
        <source>Find the place of the intake</source>
        <translation>Den Ort des Füllhalses suchen</translation>
    </message>
    <message>
        <source>Fit inside width and height instead of stretching to both</source>
        <translation>In Breite und Höhe einpassen, statt auf beide zu dehnen</translation>
    </message>
    <message>
        <source>Flat panels and their seams as JSON, in metres</source>
        <translation>Flache Bahnen und ihre Nähte als JSON, in Metern</translation>
    </message>
    <message>
        <source>Folder that keeps finished balloons; empty: FreeCAD's cache folder</source>
        <translation>Ordner, der fertige Ballons aufbewahrt; leer: der Cache-Ordner von FreeCAD</translation>
    </message>
    <message>
        <source>Follow every change at once; switch it off for heavy models and inflate when you ask for it</source>
        <translation>Jeder Änderung sofort folgen; bei schweren Modellen ausschalten und auf Wunsch aufblasen</translation>
    </message>
    <message>
        <source>FreeCAD's material card that the values were taken from</source>
        <translation>FreeCADs Materialkarte, aus der die Werte stammen</translation>
    </message>
    <message>
        <source>Gores that the accuracy needs, foretold from the profile</source>
        <translation>Segmente, die die Genauigkeit braucht, aus dem Profil vorhergesagt</translation>
    </message>
    <message>
        <source>Height above the sea</source>
        <translation>Höhe über dem Meer</translation>
    </message>
    <message>
        <source>Height of a body from a file, along z; 0 follows</source>
        <translation>Höhe eines Körpers aus einer Datei, entlang z; 0 folgt</translation>
    </message>
    <message>
        <source>Height of a body from a file; 0 follows</source>
        <translation>Höhe eines Körpers aus einer Datei; 0 folgt</translation>
    </message>
    <message>
        <source>Height of all that is cut</source>
        <translation>Höhe von allem, was geschnitten wird</translation>
    </message>
    <message>
        <source>Height of its capital letters</source>
        <translation>Höhe der Großbuchstaben</translation>
    </message>
    <message>
        <source>Height of the drawing; 0 follows from the width</source>
        <translation>Höhe der Zeichnung; 0 folgt aus der Breite</translation>
    </message>
    <message>
        <source>Height of the inflated balloon</source>
        <translation>Höhe des aufgeblasenen Ballons</translation>
    </message>
    <message>
        <source>Height of the outline</source>
        <translation>Höhe des Umrisses</translation>
    </message>
    <message>
        <source>Height of the piece of film</source>
        <translation>Höhe des Folienstücks</translation>
    </message>
    <message>
        <source>Height of the print with its marks</source>
        <translation>Höhe des Drucks mit seinen Marken</translation>
    </message>
    <message>
        <source>Height of the profile</source>
        <translation>Höhe des Profils</translation>
    </message>
    <message>
        <source>How a picture is read: holes of a filled shape stay, lines of a pen drawing are filled inside</source>
        <translation>Wie ein Bild gelesen wird: Löcher einer gefüllten Form bleiben, Linien einer Strichzeichnung werden innen gefüllt</translation>
    </message>
    <message>
        <source>How far along that seam, from 0 to 1 of its length; 0 takes its middle, or that of the edge</source>
        <translation>Wie weit entlang dieser Naht, von 0 bis 1 ihrer Länge; 0 nimmt ihre Mitte oder die der Kante</translation>
    </message>
    <message>
        <source>How far from the background what is drawn must be, of the greatest difference; 0 finds it</source>
        <translation>Wie weit sich Gezeichnetes vom Hintergrund abheben muss, vom größten Unterschied; 0 findet es</translation>
    </message>
    <message>
        <source>How far the balloon may be from its profile or body on average, in parts of the diagonal</source>
        <translation>Wie weit der Ballon im Mittel von seinem Profil oder Körper entfernt sein darf, als Teil der Diagonale</translation>
    </message>
    <message>
        <source>How far the print goes past the cut</source>
        <translation>Wie weit der Druck über den Schnitt hinausgeht</translation>
    </message>
    <message>
        <source>How far the seams of a body of gores are farther out than the gores' centres</source>
        <translation>Wie weit die Nähte eines Körpers aus Segmenten weiter außen liegen als deren Mitten</translation>
    </message>
    <message>
        <source>How its lower and its upper end are closed</source>
        <translation>Wie das untere und das obere Ende geschlossen sind</translation>
    </message>
    <message>
        <source>How large each was then [mm]</source>
        <translation>Wie groß jedes dann war [mm]</translation>
    </message>
    <message>
        <source>How long the ripples are that are smoothed away, in pixels; 0 keeps all</source>
        <translation>Wie lang Wellen sind, die geglättet werden, in Pixeln; 0 behält alle</translation>
    </message>
    <message>
        <source>How many balloons are cut from the sheet</source>
        <translation>Wie viele Ballons aus dem Bogen geschnitten werden</translation>
    </message>
    <message>
        <source>How many balloons are worked out at a time; 0: one for each processor</source>
        <translation>Wie viele Ballons gleichzeitig berechnet werden; 0: einer je Prozessor</translation>
    </message>
    <message>
        <source>How many balloons of each pattern</source>
        <translation>Wie viele Ballons von jedem Schnittmuster</translation>
    </message>
    <message>
        <source>How many gores; 0 takes as many as the accuracy needs</source>
        <translation>Wie viele Segmente; 0 nimmt so viele, wie die Genauigkeit braucht</translation>
    </message>
    <message>
        <source>How much longer one side of a seam may be, as a part of its length</source>
        <translation>Wie viel länger eine Seite einer Naht sein darf, als Teil ihrer Länge</translation>
    </message>
    <message>
        <source>How the balloon is filled and closed</source>
        <translation>Wie der Ballon gefüllt und verschlossen wird</translation>
    </message>
    <message>
        <source>How the grain of pieces lies, where their film has one</source>
        <translation>Wie die Laufrichtung der Stücke liegt, wenn ihre Folie eine hat</translation>
    </message>
    <message>
        <source>How the intake is made and used</source>
        <translation>Wie der Füllhals gemacht und benutzt wird</translation>
    </message>
    <message>
        <source>How the lower end is closed</source>
        <translation>Wie das untere Ende geschlossen ist</translation>
    </message>
    <message>
        <source>How the outline was edited by hand: nodes moved, added and removed, one JSON text each</source>
        <translation>Wie der Umriss von Hand bearbeitet wurde: Knoten verschoben, hinzugefügt und entfernt, je ein JSON-Text</translation>
    </message>
    <message>
        <source>How the seams were changed: panels merged, seams cut and moved, one JSON text each</source>
        <translation>Wie die Nähte geändert wurden: Bahnen vereint, Nähte geschnitten und verschoben, je ein JSON-Text</translation>
    </message>
    <message>
        <source>How the upper end is closed</source>
        <translation>Wie das obere Ende geschlossen ist</translation>
    </message>
    <message>
        <source>How two panels of this film are joined</source>
        <translation>Wie zwei Bahnen dieser Folie verbunden werden</translation>
    </message>
    <message>
        <source>Inner width of the neck, or bore of the nozzle</source>
        <translation>Innere Breite des Halses oder Bohrung des Stutzens</translation>
    </message>
    <message>
        <source>Into how many panels the body is divided; 0 takes the faces of a solid, 16 panels of a mesh; 1 takes only the seams that are drawn</source>
        <translation>In wie viele Bahnen der Körper geteilt wird; 0 nimmt die Flächen eines Volumenkörpers, bei einem Netz 16 Bahnen; 1 nimmt nur die gezeichneten Nähte</translation>
    </message>
    <message>
        <source>It carries itself</source>
        <translation>Er trägt sich selbst</translation>
    </message>
    <message>
        <source>Its place, seen from its sketch</source>
        <translation>Seine Lage, von seiner Skizze aus gesehen</translation>
    </message>
    <message>
        <source>JSON file of panels and seams; a copy travels in the document</source>
        <translation>JSON-Datei mit Bahnen und Nähten; eine Kopie reist im Dokument mit</translation>
    </message>
    <message>
        <source>Label of the values the mesh belongs to</source>
        <translation>Kennzeichen der Werte, zu denen das Netz gehört</translation>
    </message>
    <message>
        <source>Label of what was laid out</source>
        <translation>Kennzeichen dessen, was ausgelegt wurde</translation>
    </message>
    <message>
        <source>Label that the workbench has given it</source>
        <translation>Benennung, die der Arbeitsbereich ihm gegeben hat</translation>
    </message>
    <message>
        <source>Larger dimension before repairs, in mm</source>
        <translation>Größeres Maß vor den Reparaturen, in mm</translation>
    </message>
    <message>
        <source>Largest diameter of the profile</source>
        <translation>Größter Durchmesser des Profils</translation>
    </message>
    <message>
        <source>Largest distance between drawing and silhouette</source>
        <translation>Größter Abstand zwischen Zeichnung und Silhouette</translation>
    </message>
    <message>
        <source>Largest distance between drawing and silhouette if the weld creases</source>
        <translation>Größter Abstand zwischen Zeichnung und Silhouette, wenn die Naht knittert</translation>
    </message>
    <message>
        <source>Largest membrane tension in N/m</source>
        <translation>Größte Membranspannung in N/m</translation>
    </message>
    <message>
        <source>Largest strain of the film</source>
        <translation>Größte Dehnung der Folie</translation>
    </message>
    <message>
        <source>Lay panels first onto what is left of another layout, as its file says; the rest on the film</source>
        <translation>Bahnen zuerst auf das legen, was von einer anderen Anordnung übrig ist, wie es in deren Datei steht; den Rest auf die Folie</translation>
    </message>
    <message>
        <source>Least bending stiffness, in units of the usual least one</source>
        <translation>Kleinste Biegesteifigkeit, als Vielfaches der üblichen kleinsten</translation>
    </message>
    <message>
        <source>Left open in welds that would cut off a part, so wide; 0 gives each part an intake of its own</source>
        <translation>So breit bleiben Nähte offen, die einen Teil abtrennen würden; 0 gibt jedem Teil einen eigenen Füllhals</translation>
    </message>
    <message>
        <source>Length of a notch; at most the allowance</source>
        <translation>Länge einer Passkerbe; höchstens die Zugabe</translation>
    </message>
    <message>
        <source>Length of a sheet; 0 is a roll</source>
        <translation>Länge eines Bogens; 0 ist eine Rolle</translation>
    </message>
    <message>
        <source>Length of all seams on the body</source>
        <translation>Länge aller Nähte auf dem Körper</translation>
    </message>
    <message>
        <source>Length of all welds on it</source>
        <translation>Länge aller Schweißnähte darauf</translation>
    </message>
    <message>
        <source>Length of its welds</source>
        <translation>Länge seiner Schweißnähte</translation>
    </message>
    <message>
        <source>Length of the natural shape's gores, from its lower to its upper end</source>
        <translation>Länge der Segmente der natürlichen Form, vom unteren bis zum oberen Ende</translation>
    </message>
    <message>
        <source>Length of the neck from the seam outward, or diameter of the flange; 0 takes the usual one</source>
        <translation>Länge des Halses von der Naht nach außen oder Durchmesser des Flansches; 0 nimmt den üblichen Wert</translation>
    </message>
    <message>
        <source>Length of the profile from end to end</source>
        <translation>Länge des Profils von Ende zu Ende</translation>
    </message>
    <message>
        <source>Length of the roll that is used</source>
        <translation>Länge der verbrauchten Rolle</translation>
    </message>
    <message>
        <source>Length of the weld</source>
        <translation>Länge der Schweißnaht</translation>
    </message>
    <message>
        <source>Lengths of both sides of each seam in mm</source>
        <translation>Längen beider Seiten jeder Naht in mm</translation>
    </message>
    <message>
        <source>Lines and arcs within 0.02 mm in place of many short lines</source>
        <translation>Geraden und Bögen mit 0,02 mm Toleranz statt vieler kurzer Linien</translation>
    </message>
    <message>
        <source>Longest piece of the side band; 0 is the width of the film</source>
        <translation>Längstes Stück des Seitenbands; 0 ist die Breite der Folie</translation>
    </message>
    <message>
        <source>Mean distance between drawing and silhouette</source>
        <translation>Mittlerer Abstand zwischen Zeichnung und Silhouette</translation>
    </message>
    <message>
        <source>Mean distance between drawing and silhouette if the weld creases</source>
        <translation>Mittlerer Abstand zwischen Zeichnung und Silhouette, wenn die Naht knittert</translation>
    </message>
    <message>
        <source>Names of the panels</source>
        <translation>Namen der Bahnen</translation>
    </message>
    <message>
        <source>Names of the panels and other pieces</source>
        <translation>Namen der Bahnen und anderen Stücke</translation>
    </message>
    <message>
        <source>Names of the pieces that have been arranged</source>
        <translation>Namen der Stücke, die angeordnet wurden</translation>
    </message>
    <message>
        <source>Notches to lay both films on each other by, evenly along the cut; of many panels, groups of them on each seam, 0 as many as its length needs</source>
        <translation>Passkerben, um beide Folien aufeinanderzulegen, gleichmäßig entlang des Schnitts; bei vielen Bahnen Gruppen davon an jeder Naht, 0 so viele, wie ihre Länge braucht</translation>
    </message>
    <message>
        <source>Number of balloons in the table</source>
        <translation>Zahl der Ballons in der Tabelle</translation>
    </message>
    <message>
        <source>Number of balloons that are worked out</source>
        <translation>Zahl der berechneten Ballons</translation>
    </message>
    <message>
        <source>Number of balloons that cannot be made</source>
        <translation>Zahl der Ballons, die sich nicht machen lassen</translation>
    </message>
    <message>
        <source>Number of corners of each loop</source>
        <translation>Zahl der Ecken jeder Umrisslinie</translation>
    </message>
    <message>
        <source>Number of corners of each seam</source>
        <translation>Zahl der Ecken jeder Naht</translation>
    </message>
    <message>
        <source>Number of corners of each weld</source>
        <translation>Zahl der Ecken jeder inneren Schweißnaht</translation>
    </message>
    <message>
        <source>Number of flat panels that it is made of; 0: two equal ones</source>
        <translation>Zahl der flachen Bahnen, aus denen er besteht; 0: zwei gleiche</translation>
    </message>
    <message>
        <source>Number of holes</source>
        <translation>Zahl der Löcher</translation>
    </message>
    <message>
        <source>Number of panels</source>
        <translation>Zahl der Bahnen</translation>
    </message>
    <message>
        <source>Number of pieces on what is shown</source>
        <translation>Zahl der Stücke auf dem gezeigten Bogen</translation>
    </message>
    <message>
        <source>Number of seams between them</source>
        <translation>Zahl der Nähte zwischen ihnen</translation>
    </message>
    <message>
        <source>Number of seams, then the number of vertices of each seam and weld</source>
        <translation>Zahl der Nähte, dann die Zahl der Knoten jeder Naht und Schweißung</translation>
    </message>
    <message>
        <source>Number of sheets</source>
        <translation>Zahl der Bögen</translation>
    </message>
    <message>
        <source>Number of the sheet that is shown and exported</source>
        <translation>Nummer des Bogens, der gezeigt und ausgegeben wird</translation>
    </message>
    <message>
        <source>Of many panels, for each seam: both panels, number of vertices, then those of either side</source>
        <translation>Bei vielen Bahnen, für jede Naht: beide Bahnen, Zahl der Knoten, dann die Knoten beider Seiten</translation>
    </message>
    <message>
        <source>Of many panels, for each: number of vertices, of triangles and of loops</source>
        <translation>Bei vielen Bahnen, für jede: Zahl der Knoten, der Dreiecke und der Ränder</translation>
    </message>
    <message>
        <source>Of many panels, how much longer one side of a seam may be</source>
        <translation>Bei vielen Bahnen: wie viel länger eine Seite einer Naht sein darf</translation>
    </message>
    <message>
        <source>Of warm air, in degrees Celsius</source>
        <translation>Der Warmluft, in Grad Celsius</translation>
    </message>
    <message>
        <source>On which remnant each sheet is, -1 for none</source>
        <translation>Auf welchem Reststück jeder Bogen liegt, -1 für keines</translation>
    </message>
    <message>
        <source>Only one side of this film can be joined so</source>
        <translation>Nur eine Seite dieser Folie lässt sich so verbinden</translation>
    </message>
    <message>
        <source>Panel of each triangle</source>
        <translation>Bahn jedes Dreiecks</translation>
    </message>
    <message>
        <source>Panels and seams as JSON, in metres</source>
        <translation>Bahnen und Nähte als JSON, in Metern</translation>
    </message>
    <message>
        <source>Panels that are cut, each with what is equal to it</source>
        <translation>Bahnen, die geschnitten werden, jede mit denen, die ihr gleichen</translation>
    </message>
    <message>
        <source>Part of the film that the pieces take, in per cent</source>
        <translation>Anteil der Folie, den die Stücke einnehmen, in Prozent</translation>
    </message>
    <message>
        <source>Part of the film's area that hangs loose</source>
        <translation>Anteil der Folienfläche, der schlaff ist</translation>
    </message>
    <message>
        <source>Part of the film's area that is wrinkled</source>
        <translation>Anteil der Folienfläche, der Falten wirft</translation>
    </message>
    <message>
        <source>Picture, SVG, DXF or JSON file; a copy travels in the document</source>
        <translation>Bild, SVG-, DXF- oder JSON-Datei; eine Kopie liegt im Dokument</translation>
    </message>
    <message>
        <source>Place of the intake: counter-clockwise along the outer seam from its rightmost point</source>
        <translation>Ort des Füllhalses: gegen den Uhrzeigersinn entlang der äußeren Naht ab ihrem rechten Ende</translation>
    </message>
    <message>
        <source>Places of the outline that move if the weld creases, the worst first</source>
        <translation>Stellen des Umrisses, die sich verschieben, wenn die Naht knittert, die schlimmste zuerst</translation>
    </message>
    <message>
        <source>Points of the body's triangles</source>
        <translation>Punkte der Dreiecke des Körpers</translation>
    </message>
    <message>
        <source>Points of the profile: radius, 0, height</source>
        <translation>Punkte des Profils: Radius, 0, Höhe</translation>
    </message>
    <message>
        <source>Poisson's ratio of the film</source>
        <translation>Querkontraktionszahl der Folie</translation>
    </message>
    <message>
        <source>Polymer of the side that is welded, such as PE; none where it does not weld, empty: not known</source>
        <translation>Polymer der Siegelseite, etwa PE; none, wenn sie nicht schweißt; leer: unbekannt</translation>
    </message>
    <message>
        <source>Pressure in the inflated balloon</source>
        <translation>Druck im aufgeblasenen Ballon</translation>
    </message>
    <message>
        <source>Pressure inside, above that outside</source>
        <translation>Innendruck, über dem Außendruck</translation>
    </message>
    <message>
        <source>Put the tab opposite the intake</source>
        <translation>Die Lasche gegenüber dem Füllhals anbringen</translation>
    </message>
    <message>
        <source>Remarks made during the design</source>
        <translation>Hinweise aus dem Entwurf</translation>
    </message>
    <message>
        <source>Remarks made while the body was read</source>
        <translation>Bemerkungen beim Lesen des Körpers</translation>
    </message>
    <message>
        <source>Remarks made while the outline was found</source>
        <translation>Hinweise aus der Suche nach dem Umriss</translation>
    </message>
    <message>
        <source>Remarks made while the panels were read</source>
        <translation>Bemerkungen beim Lesen der Bahnen</translation>
    </message>
    <message>
        <source>Remarks made while the pattern was drawn</source>
        <translation>Hinweise aus dem Zeichnen des Schnittmusters</translation>
    </message>
    <message>
        <source>Remarks made while the profile was read</source>
        <translation>Bemerkungen beim Lesen des Profils</translation>
    </message>
    <message>
        <source>Remarks on the layout</source>
        <translation>Hinweise zur Anordnung</translation>
    </message>
    <message>
        <source>Repairs that were made in the drawing, one each; delete an entry to take it back</source>
        <translation>Reparaturen, die an der Zeichnung gemacht wurden, je ein Eintrag; einen Eintrag löschen nimmt sie zurück</translation>
    </message>
    <message>
        <source>Result that is shown as colours, with a legend</source>
        <translation>Ergebnis, das als Farben mit Legende gezeigt wird</translation>
    </message>
    <message>
        <source>STL, OBJ, PLY, 3MF, STEP, IGES or BREP file of a closed body; a copy travels in the document</source>
        <translation>STL-, OBJ-, PLY-, 3MF-, STEP-, IGES- oder BREP-Datei eines geschlossenen Körpers; eine Kopie reist im Dokument mit</translation>
    </message>
    <message>
        <source>SVG, DXF or JSON file of half the outline; a copy travels in the document</source>
        <translation>SVG-, DXF- oder JSON-Datei des halben Umrisses; eine Kopie reist im Dokument mit</translation>
    </message>
    <message>
        <source>Seams by the number on both edges, with their lengths</source>
        <translation>Nähte mit der Nummer an beiden Kanten und ihren Längen</translation>
    </message>
    <message>
        <source>Show the drawing and the silhouette over each other</source>
        <translation>Zeichnung und Silhouette übereinander zeigen</translation>
    </message>
    <message>
        <source>Simulate both panels instead of one and its mirror image</source>
        <translation>Beide Bahnen simulieren statt einer und ihres Spiegelbilds</translation>
    </message>
    <message>
        <source>Size of the body along x, y and z</source>
        <translation>Größe des Körpers entlang x, y und z</translation>
    </message>
    <message>
        <source>Size of the triangles; 0 is automatic</source>
        <translation>Größe der Dreiecke; 0 ist automatisch</translation>
    </message>
    <message>
        <source>Sketch or wire of half the outline, which the body follows</source>
        <translation>Skizze oder Draht des halben Umrisses, dem der Körper folgt</translation>
    </message>
    <message>
        <source>Sketch, wire or face that the outline follows instead of a file</source>
        <translation>Skizze, Draht oder Fläche, denen der Umriss statt einer Datei folgt</translation>
    </message>
    <message>
        <source>Sketches are projected onto the side that is nearer to them only</source>
        <translation>Skizzen werden nur auf die Seite projiziert, die ihnen näher liegt</translation>
    </message>
    <message>
        <source>Sketches whose lines are seams: they are projected onto the body along the normal of their plane</source>
        <translation>Skizzen, deren Linien Nähte sind: Sie werden entlang der Normalen ihrer Ebene auf den Körper projiziert</translation>
    </message>
    <message>
        <source>Sketches, wires and flat faces that are the panels, each seen from outside</source>
        <translation>Skizzen, Drähte und ebene Flächen, die die Bahnen sind, jede von außen gesehen</translation>
    </message>
    <message>
        <source>Smaller holes, of the area of their shape, are filled</source>
        <translation>Kleinere Löcher, gemessen an der Fläche ihrer Form, werden gefüllt</translation>
    </message>
    <message>
        <source>Smooth stretches as single splines in place of arcs</source>
        <translation>Glatte Strecken als einzelne Splines statt als Bögen</translation>
    </message>
    <message>
        <source>So far outside of the body, or inside, the film lies at least</source>
        <translation>So weit außerhalb oder innerhalb des Körpers liegt die Folie mindestens</translation>
    </message>
    <message>
        <source>Solid or mesh that the balloon is to fill, which it follows</source>
        <translation>Volumenkörper oder Netz, das der Ballon füllen soll und dem er folgt</translation>
    </message>
    <message>
        <source>Solver that was used</source>
        <translation>Benutzter Löser</translation>
    </message>
    <message>
        <source>Solver: compiled, NumPy, or the best of them; Newmark follows the inflation in time, slowly</source>
        <translation>Löser: kompiliert, NumPy oder der beste davon; Newmark folgt dem Aufblasen in der Zeit, langsam</translation>
    </message>
    <message>
        <source>Steps of the solver in the last inflation</source>
        <translation>Schritte des Lösers beim letzten Aufblasen</translation>
    </message>
    <message>
        <source>Stiffness of a weld in its plane, in parts of what both films have there when they stay flat</source>
        <translation>Steifigkeit einer Schweißnaht in ihrer Ebene, als Anteil dessen, was beide Folien dort haben, wenn sie flach bleiben</translation>
    </message>
    <message>
        <source>Tension over the section at which the film tears; 0: not known</source>
        <translation>Zugspannung im Querschnitt, bei der die Folie reißt; 0: unbekannt</translation>
    </message>
    <message>
        <source>The balloon of a row that was shown last</source>
        <translation>Der zuletzt gezeigte Ballon einer Zeile</translation>
    </message>
    <message>
        <source>The balloon shown has come to rest</source>
        <translation>Der gezeigte Ballon ist zur Ruhe gekommen</translation>
    </message>
    <message>
        <source>The balloon that is cut from this pattern</source>
        <translation>Der Ballon, der aus diesem Schnittmuster entsteht</translation>
    </message>
    <message>
        <source>The balloon that is varied</source>
        <translation>Der Ballon, der verändert wird</translation>
    </message>
    <message>
        <source>The film resists bending</source>
        <translation>Die Folie widersteht dem Biegen</translation>
    </message>
    <message>
        <source>The machine that finds the print again by its registration marks; empty has crosses for the eye</source>
        <translation>Die Maschine, die den Druck an ihren Passermarken wiederfindet; leer: Kreuze fürs Auge</translation>
    </message>
    <message>
        <source>The outline whose drawing this one shares; empty: its own</source>
        <translation>Der Umriss, dessen Zeichnung dieser mitbenutzt; leer: seine eigene</translation>
    </message>
    <message>
        <source>The pattern that is printed</source>
        <translation>Das Schnittmuster, das bedruckt wird</translation>
    </message>
    <message>
        <source>The pattern that it is a piece of</source>
        <translation>Das Schnittmuster, von dem es ein Stück ist</translation>
    </message>
    <message>
        <source>The patterns that are laid out</source>
        <translation>Die Schnittmuster, die ausgelegt werden</translation>
    </message>
    <message>
        <source>The pressure is that at the lower end and rises with the height, as the gas is lighter than air</source>
        <translation>Der Druck gilt am unteren Ende und nimmt mit der Höhe zu, weil das Gas leichter als Luft ist</translation>
    </message>
    <message>
        <source>The seams in the order of the work</source>
        <translation>Die Nähte in der Reihenfolge der Arbeit</translation>
    </message>
    <message>
        <source>The second panel beside the first, mirrored; else cut twice</source>
        <translation>Die zweite Bahn gespiegelt neben der ersten; sonst zweimal schneiden</translation>
    </message>
    <message>
        <source>The side that is shown and exported for a cutter</source>
        <translation>Die Seite, die gezeigt und für die Schneidemaschine ausgegeben wird</translation>
    </message>
    <message>
        <source>The silhouette is within the tolerance of the drawing</source>
        <translation>Die Silhouette liegt innerhalb der Toleranz um die Zeichnung</translation>
    </message>
    <message>
        <source>The spreadsheet: headings in its first row, a balloon in each below</source>
        <translation>Die Kalkulationstabelle: Überschriften in der ersten Zeile, darunter in jeder ein Ballon</translation>
    </message>
    <message>
        <source>The whole report as JSON</source>
        <translation>Der ganze Bericht als JSON</translation>
    </message>
    <message>
        <source>The workbench has given it a place</source>
        <translation>Es hat einen Platz; ein neues Objekt bekommt einen</translation>
    </message>
    <message>
        <source>Thickness of the balloon, from which the side band follows; 0 takes the band's own width</source>
        <translation>Dicke des Ballons, aus der das Seitenband folgt; 0 nimmt die eigene Breite des Bands</translation>
    </message>
    <message>
        <source>Thickness of the film</source>
        <translation>Dicke der Folie</translation>
    </message>
    <message>
        <source>Thickness of the inflated balloon</source>
        <translation>Dicke des aufgeblasenen Ballons</translation>
    </message>
    <message>
        <source>Three places on each of these, flat</source>
        <translation>Drei Stellen auf jeder davon, flach</translation>
    </message>
    <message>
        <source>Three points of each triangle</source>
        <translation>Drei Punkte jedes Dreiecks</translation>
    </message>
    <message>
        <source>Two points of each edge at which a panel is cut open</source>
        <translation>Zwei Punkte jeder Kante, an der eine Bahn aufgeschnitten ist</translation>
    </message>
    <message>
        <source>Up to date, or what is wrong</source>
        <translation>Aktuell, oder was nicht stimmt</translation>
    </message>
    <message>
        <source>Version of this object's properties</source>
        <translation>Version der Eigenschaften dieses Objekts</translation>
    </message>
    <message>
        <source>Vertices along all seams, then along all welds inside</source>
        <translation>Knoten entlang aller Nähte, dann entlang aller inneren Schweißnähte</translation>
    </message>
    <message>
        <source>Vertices of each triangle</source>
        <translation>Knoten jedes Dreiecks</translation>
    </message>
    <message>
        <source>Vertices of the flat panel</source>
        <translation>Knoten der flachen Bahn</translation>
    </message>
    <message>
        <source>Vertices of the inflated upper film</source>
        <translation>Knoten der aufgeblasenen oberen Folie</translation>
    </message>
    <message>
        <source>Vertices of the lower film where both were simulated</source>
        <translation>Knoten der unteren Folie, wenn beide simuliert wurden</translation>
    </message>
    <message>
        <source>Volume of the balloon, from which the pressure follows</source>
        <translation>Volumen des Ballons, aus dem der Druck folgt</translation>
    </message>
    <message>
        <source>Volume of the body</source>
        <translation>Volumen des Körpers</translation>
    </message>
    <message>
        <source>Volume of the inflated balloon</source>
        <translation>Volumen des aufgeblasenen Ballons</translation>
    </message>
    <message>
        <source>Volume that decides the size</source>
        <translation>Volumen, das die Größe bestimmt</translation>
    </message>
    <message>
        <source>Weight of the film in kg per square metre</source>
        <translation>Gewicht der Folie in kg je Quadratmeter</translation>
    </message>
    <message>
        <source>Weld that resists bending in its plane, or film that crumples there freely, the worst for a ring</source>
        <translation>Naht, die einer Biegung in ihrer Ebene widersteht, oder Folie, die dort frei knittert, das Schlimmste für einen Ring</translation>
    </message>
    <message>
        <source>What decides the size: the outline as it is, a volume to hold or a load to carry</source>
        <translation>Was die Größe bestimmt: der Umriss, wie er ist, ein Volumen oder eine Traglast</translation>
    </message>
    <message>
        <source>What does not fit yet, a sentence each</source>
        <translation>Was noch nicht passt, je ein Satz</translation>
    </message>
    <message>
        <source>What each edge of the shape is called</source>
        <translation>Wie jede Kante der Form heißt</translation>
    </message>
    <message>
        <source>What fills it when it shall float</source>
        <translation>Womit er gefüllt wird, wenn er schweben soll</translation>
    </message>
    <message>
        <source>What is given: the pressure, or the volume that it shall reach</source>
        <translation>Was gegeben ist: der Druck oder das Volumen, das er erreichen soll</translation>
    </message>
    <message>
        <source>What is printed; empty takes the picture or painting of the outline</source>
        <translation>Was gedruckt wird; leer nimmt Bild oder Gemaltes des Umrisses</translation>
    </message>
    <message>
        <source>What is thinner, of the size of the drawing, is a line whose inside is filled; 0 keeps all holes</source>
        <translation>Was dünner ist, gemessen an der Größe der Zeichnung, ist eine Linie, deren Inneres gefüllt wird; 0 behält alle Löcher</translation>
    </message>
    <message>
        <source>What it carries with its gas, in grams; below 0 it sinks</source>
        <translation>Was er mit seinem Gas trägt, in Gramm; unter 0 sinkt er</translation>
    </message>
    <message>
        <source>What it is called on the pattern</source>
        <translation>Wie es auf dem Schnittmuster heißt</translation>
    </message>
    <message>
        <source>What it is to be: an outline, a body of gores or a bag</source>
        <translation>Was es werden soll: ein Umriss, ein Körper aus Segmenten oder ein Beutel</translation>
    </message>
    <message>
        <source>What it shall carry besides itself, in grams; 0 makes it float just so</source>
        <translation>Was er außer sich selbst tragen soll, in Gramm; mit 0 schwebt er gerade</translation>
    </message>
    <message>
        <source>What tells where the intake is</source>
        <translation>Wodurch der Ort des Füllhalses gegeben ist</translation>
    </message>
    <message>
        <source>What the balloon is made of; Custom lets you give your own values</source>
        <translation>Woraus der Ballon ist; „Eigene“ erlaubt eigene Werte</translation>
    </message>
    <message>
        <source>What the body was read from</source>
        <translation>Woraus der Körper gelesen wurde</translation>
    </message>
    <message>
        <source>What the design of many panels has figures, as JSON</source>
        <translation>Was der Entwurf aus vielen Bahnen an Zahlen hat, als JSON</translation>
    </message>
    <message>
        <source>What the outline was read from</source>
        <translation>Woraus der Umriss gelesen wurde</translation>
    </message>
    <message>
        <source>What the panels were read from</source>
        <translation>Woraus die Bahnen gelesen wurden</translation>
    </message>
    <message>
        <source>What the profile was read from</source>
        <translation>Woraus das Profil gelesen wurde</translation>
    </message>
    <message>
        <source>What to do along each wire of the shape</source>
        <translation>Was entlang jedes Drahtes der Form zu tun ist</translation>
    </message>
    <message>
        <source>What would make the balloon better</source>
        <translation>Was den Ballon besser machen würde</translation>
    </message>
    <message>
        <source>Where a balloon of many panels is filled: the number of a seam, or a panel and the point at which an edge begins, such as top.2; a panel alone has a nozzle in its middle</source>
        <translation>Wo ein Ballon aus vielen Bahnen gefüllt wird: die Nummer einer Naht, oder eine Bahn und der Punkt, an dem eine Kante beginnt, etwa top.2; eine Bahn allein hat eine Tülle in ihrer Mitte</translation>
    </message>
    <message>
        <source>Where all pieces lie, as JSON</source>
        <translation>Wo alle Stücke liegen, als JSON</translation>
    </message>
    <message>
        <source>Where it is found: farthest from the centre, or low, where a tied balloon hangs straight</source>
        <translation>Wo er gesucht wird: am weitesten von der Mitte, oder unten, wo ein angebundener Ballon gerade hängt</translation>
    </message>
    <message>
        <source>Where the middle of each lies, turned and mirrored</source>
        <translation>Wo die Mitte von jedem liegt, gedreht und gespiegelt</translation>
    </message>
    <message>
        <source>Where the profile comes from without a sketch: a file, or the shape of a balloon without weight</source>
        <translation>Woher das Profil ohne Skizze kommt: aus einer Datei oder als Form eines Ballons ohne Gewicht</translation>
    </message>
    <message>
        <source>Where the workbench put it</source>
        <translation>Wohin es gesetzt wurde, wenn nicht vom Benutzer</translation>
    </message>
    <message>
        <source>Whether a laser may cut this film</source>
        <translation>Ob ein Laser diese Folie schneiden darf</translation>
    </message>
    <message>
        <source>Whether the balloon follows the body, encloses or lines it</source>
        <translation>Ob der Ballon dem Körper folgt, ihn umschließt oder innen auskleidet</translation>
    </message>
    <message>
        <source>Which edges are joined</source>
        <translation>Welche Kanten verbunden sind</translation>
    </message>
    <message>
        <source>Which film is laid out: pieces of a valve are on one of their own</source>
        <translation>Welche Folie ausgelegt wird: Die Stücke eines Ventils liegen auf einer eigenen</translation>
    </message>
    <message>
        <source>Which of them each wire belongs to; 0: a copy</source>
        <translation>Zu welchem Stück jeder Draht gehört; 0: eine Kopie</translation>
    </message>
    <message>
        <source>Which piece of the pattern it is, from 1</source>
        <translation>Welches Stück des Schnittmusters es ist, ab 1</translation>
    </message>
    <message>
        <source>Which shape of the drawing it is; 1 is the largest</source>
        <translation>Die wievielte Form der Zeichnung es ist; 1 ist die größte</translation>
    </message>
    <message>
        <source>Width from which it carries itself; 0 when never</source>
        <translation>Breite, ab der er sich selbst trägt; 0: nie</translation>
    </message>
    <message>
        <source>Width of a body from a file, along x; 0 follows from the height, or the file</source>
        <translation>Breite eines Körpers aus einer Datei, entlang x; 0 folgt aus der Höhe oder der Datei</translation>
    </message>
    <message>
        <source>Width of a side band between front and back; 0 is two panels</source>
        <translation>Breite eines Seitenbands zwischen Vorder- und Rückseite; 0 sind zwei Bahnen</translation>
    </message>
    <message>
        <source>Width of all that is cut</source>
        <translation>Breite von allem, was geschnitten wird</translation>
    </message>
    <message>
        <source>Width of the drawing; 0 follows from the height</source>
        <translation>Breite der Zeichnung; 0 folgt aus der Höhe</translation>
    </message>
    <message>
        <source>Width of the inflated balloon</source>
        <translation>Breite des aufgeblasenen Ballons</translation>
    </message>
    <message>
        <source>Width of the outline</source>
        <translation>Breite des Umrisses</translation>
    </message>
    <message>
        <source>Width of the piece of film</source>
        <translation>Breite des Folienstücks</translation>
    </message>
    <message>
        <source>Width of the print with its marks</source>
        <translation>Breite des Drucks mit seinen Marken</translation>
    </message>
    <message>
        <source>Width of the roll or sheet</source>
        <translation>Breite der Rolle oder des Bogens</translation>
    </message>
    <message>
        <source>Width of the weld that this film needs</source>
        <translation>Breite der Schweißnaht, die diese Folie braucht</translation>
    </message>
    <message>
        <source>Width of the weld; 0 takes the film's</source>
        <translation>Breite der Schweißnaht; 0 nimmt die der Folie</translation>
    </message>
    <message>
        <source>Young's modulus across the grain; 0 means no grain</source>
        <translation>Elastizitätsmodul quer zur Laufrichtung; 0 heißt ohne Laufrichtung</translation>
    </message>
    <message>
        <source>Young's modulus of the film</source>
        <translation>Elastizitätsmodul der Folie</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench</name>
    <message>
        <source> It may have lacked memory: take a coarser mesh.</source>
        <translation> Vielleicht fehlte Arbeitsspeicher: ein gröberes Netz nehmen.</translation>
    </message>
    <message>
        <source> is not ready: </source>
        <translation> ist nicht bereit: </translation>
    </message>
    <message>
        <source>"hosts" is no list: write {0}.</source>
        <translation>„hosts“ ist keine Liste: {0} schreiben.</translation>
    </message>
    <message>
        <source>"{0}" cannot be read: write {"kind": "latin-hypercube", "rows": 100, "seed": 1}.</source>
        <translation>„{0}“ ist nicht zu lesen: {"kind": "latin-hypercube", "rows": 100, "seed": 1} schreiben.</translation>
    </message>
    <message>
        <source>"{0}" has one result and its value: write {"lift": "20 g"}.</source>
        <translation>„{0}“ hat ein Ergebnis und seinen Wert: {"lift": "20 g"} schreiben.</translation>
    </message>
    <message>
        <source>"{0}" is an edge of {1} panels: name the face too, as in {2}.</source>
        <translation>„{0}“ ist eine Kante von {1} Bahnen: auch die Fläche nennen, wie in {2}.</translation>
    </message>
    <message>
        <source>"{0}" is no choice for a pattern larger than the bed: choose {1}.</source>
        <translation>Mit einem zu großen Schnittmuster geht „{0}“ nicht: {1} wählen.</translation>
    </message>
    <message>
        <source>"{0}" is no colour: give one such as "#cc294d".</source>
        <translation>„{0}“ ist keine Farbe: zum Beispiel „#cc294d“ angeben.</translation>
    </message>
    <message>
        <source>"{0}" is no edge of a panel: write it as in {1}.0, or give the number of a seam, 1 to {2}. There are the panels {3}{4}.</source>
        <translation>„{0}“ ist keine Kante einer Bahn: wie in {1}.0 schreiben, oder die Nummer einer Naht angeben, 1 bis {2}. Es gibt die Bahnen {3}{4}.</translation>
    </message>
    <message>
        <source>"{0}" is no sum of L, W, S, A and millimetres, such as "0.5 W + 2".</source>
        <translation>„{0}“ ist keine Summe aus L, W, S, A und Millimetern, wie „0.5 W + 2“.</translation>
    </message>
    <message>
        <source>"{0}" may not use {1}.</source>
        <translation>„{0}“ darf {1} nicht benutzen.</translation>
    </message>
    <message>
        <source>"{0}" of "{1}" is no whole number: write one.</source>
        <translation>„{0}“ von „{1}“ ist keine ganze Zahl: eine schreiben.</translation>
    </message>
    <message>
        <source>"{0}" of the study is no JSON object: write {"width": ...}.</source>
        <translation>„{0}“ der Studie ist kein JSON-Objekt: {"width": ...} schreiben.</translation>
    </message>
    <message>
        <source>"{0}" of the study is no list of JSON objects: write [{"input": ...}, ...].</source>
        <translation>„{0}“ der Studie ist keine Liste von JSON-Objekten: [{"input": ...}, ...] schreiben.</translation>
    </message>
    <message>
        <source>"{0}" says what may be chosen: write {"width": ["100mm", "400mm"]}.</source>
        <translation>„{0}“ sagt, was gewählt werden darf: {"width": ["100mm", "400mm"]} schreiben.</translation>
    </message>
    <message>
        <source>'{0}' cannot be kept: write {1} or {2}.</source>
        <translation>„{0}“ kann nicht behalten werden: {1} oder {2} schreiben.</translation>
    </message>
    <message>
        <source>'{0}' cannot be read ({1}). Check the name and its access.</source>
        <translation>„{0}“ kann nicht gelesen werden ({1}). Name und Zugriff prüfen.</translation>
    </message>
    <message>
        <source>'{0}' cannot be read ({1}): name a JSON file of settings.</source>
        <translation>„{0}“ ist nicht zu lesen ({1}): eine JSON-Datei mit Einstellungen angeben.</translation>
    </message>
    <message>
        <source>'{0}' cannot be the name of a machine: take up to 40 letters, digits, spaces and - only.</source>
        <translation>'{0}' kann kein Name einer Maschine sein: nehmen Sie höchstens 40 Buchstaben, Ziffern, Leerzeichen und -.</translation>
    </message>
    <message>
        <source>'{0}' has a column twice.</source>
        <translation>„{0}“ hat eine Spalte zweimal.</translation>
    </message>
    <message>
        <source>'{0}' has another unit than {1}: write it like {2}.</source>
        <translation>„{0}“ hat eine andere Einheit als {1}: wie {2} schreiben.</translation>
    </message>
    <message>
        <source>'{0}' has its own panels: leave out what you give of gores or of a side band.</source>
        <translation>„{0}“ hat eigene Bahnen: weglassen, was zu Segmenten oder einem Seitenband angegeben ist.</translation>
    </message>
    <message>
        <source>'{0}' has its panels as they are to be cut: use inflate instead of design.</source>
        <translation>„{0}“ hat seine Bahnen, wie sie geschnitten werden: inflate statt design benutzen.</translation>
    </message>
    <message>
        <source>'{0}' has no closed line: give the pattern as it was cut.</source>
        <translation>„{0}“ hat keine geschlossene Linie: das Schnittmuster angeben, wie es geschnitten wurde.</translation>
    </message>
    <message>
        <source>'{0}' has no panels of its own: give gores, or the width of a side band.</source>
        <translation>„{0}“ hat keine eigenen Bahnen: Segmente oder die Breite eines Seitenbands angeben.</translation>
    </message>
    <message>
        <source>'{0}' has no profile: give half the outline of the body as an SVG, a DXF or JSON.</source>
        <translation>„{0}“ hat kein Profil: den halben Umriss des Körpers als SVG, DXF oder JSON geben.</translation>
    </message>
    <message>
        <source>'{0}' has the size of its panels: leave out the width and the height.</source>
        <translation>„{0}“ hat die Größe seiner Bahnen: Breite und Höhe weglassen.</translation>
    </message>
    <message>
        <source>'{0}' has {1} x {2} pixels, more than {3} million. Make it smaller; 2000 pixels across are plenty.</source>
        <translation>„{0}“ hat {1} x {2} Pixel, mehr als {3} Millionen. Verkleinern; 2000 Pixel Breite sind reichlich.</translation>
    </message>
    <message>
        <source>'{0}' is a body: leave out what you give of gores or of a side band.</source>
        <translation>„{0}“ ist ein Körper: weglassen, was zu Segmenten oder einem Seitenband angegeben ist.</translation>
    </message>
    <message>
        <source>'{0}' is a pipe or a device: save what comes from it, and name that file.</source>
        <translation>„{0}“ ist eine Pipe oder ein Gerät: speichern, was daraus kommt, und diese Datei angeben.</translation>
    </message>
    <message>
        <source>'{0}' is a profile, which has no side band: give a drawing for that.</source>
        <translation>„{0}“ ist ein Profil, das kein Seitenband hat: dafür eine Zeichnung geben.</translation>
    </message>
    <message>
        <source>'{0}' is colder than anything; write a temperature as 20C, 68F or 293K.</source>
        <translation>„{0}“ ist kälter als alles; eine Temperatur als 20C, 68F oder 293K schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is damaged or not a picture ({1}). Save it as PNG, JPEG or BMP once more.</source>
        <translation>„{0}“ ist beschädigt oder kein Bild ({1}). Noch einmal als PNG, JPEG oder BMP speichern.</translation>
    </message>
    <message>
        <source>'{0}' is damaged or not a picture. Save it as PNG, JPEG or BMP once more.</source>
        <translation>„{0}“ ist beschädigt oder kein Bild. Noch einmal als PNG, JPEG oder BMP speichern.</translation>
    </message>
    <message>
        <source>'{0}' is damaged. Save it as PNG, JPEG or BMP once more.</source>
        <translation>„{0}“ ist beschädigt. Noch einmal als PNG, JPEG oder BMP speichern.</translation>
    </message>
    <message>
        <source>'{0}' is empty. Choose another file.</source>
        <translation>„{0}“ ist leer. Eine andere Datei wählen.</translation>
    </message>
    <message>
        <source>'{0}' is larger than {1} MB. Make it simpler.</source>
        <translation>„{0}“ ist größer als {1} MB. Den Inhalt vereinfachen.</translation>
    </message>
    <message>
        <source>'{0}' is larger than {1} MB. Save it as JPEG or PNG.</source>
        <translation>„{0}“ ist größer als {1} MB. Als JPEG oder PNG speichern.</translation>
    </message>
    <message>
        <source>'{0}' is neither SVG, DXF nor JSON. Save the drawing as one of these.</source>
        <translation>„{0}“ ist weder SVG noch DXF noch JSON. Die Zeichnung als eines davon speichern.</translation>
    </message>
    <message>
        <source>'{0}' is neither yes nor no: write one of them for {1}.</source>
        <translation>„{0}“ ist weder yes noch no: für {1} eines davon schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no JSON ({1}{2}).</source>
        <translation>„{0}“ ist kein JSON ({1}{2}).</translation>
    </message>
    <message>
        <source>'{0}' is no JSON object: write {"queue": ...}.</source>
        <translation>„{0}“ ist kein JSON-Objekt: {"queue": ...} schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no closed body: leave out --panels, or give an STL, OBJ, PLY, 3MF or STEP.</source>
        <translation>„{0}“ ist kein geschlossener Körper: --panels weglassen oder eine STL-, OBJ-, PLY-, 3MF- oder STEP-Datei geben.</translation>
    </message>
    <message>
        <source>'{0}' is no cluster: write one of {1}.</source>
        <translation>„{0}“ ist kein Cluster: eines von {1} schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no command of a study: write {1} or {2}.</source>
        <translation>„{0}“ ist kein Befehl einer Studie: {1} oder {2} schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no difference of temperatures: write 5K, 5C or 9F.</source>
        <translation>„{0}“ ist kein Temperaturunterschied: 5K, 5C oder 9F schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no file: name one.</source>
        <translation>„{0}“ ist keine Datei: eine angeben.</translation>
    </message>
    <message>
        <source>'{0}' is no number for {1}.</source>
        <translation>„{0}“ ist keine Zahl für {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no single value for {1}.</source>
        <translation>„{0}“ ist kein einzelner Wert für {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no size: write 500mm for a width, 500mmx700mm for width and height.</source>
        <translation>„{0}“ ist keine Größe: 500mm für eine Breite schreiben, 500mmx700mm für Breite und Höhe.</translation>
    </message>
    <message>
        <source>'{0}' is no table ({1}): save it as CSV.</source>
        <translation>„{0}“ ist keine Tabelle ({1}): als CSV speichern.</translation>
    </message>
    <message>
        <source>'{0}' is no test card: name the test-card.json that was made with it.</source>
        <translation>'{0}' ist keine Testkarte: Nennen Sie die test-card.json, die mit ihr gemacht wurde.</translation>
    </message>
    <message>
        <source>'{0}' is no text in UTF-8: save it as one.</source>
        <translation>„{0}“ ist kein Text in UTF-8: als solchen speichern.</translation>
    </message>
    <message>
        <source>'{0}' is no text in UTF-8: save the table as CSV in UTF-8.</source>
        <translation>„{0}“ ist kein Text in UTF-8: die Tabelle als CSV in UTF-8 speichern.</translation>
    </message>
    <message>
        <source>'{0}' is no value for an option of sbatch: write one line.</source>
        <translation>„{0}“ ist kein Wert für eine Option von sbatch: eine Zeile schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}.</source>
        <translation>„{0}“ ist kein Wert für {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number and its unit.</source>
        <translation>„{0}“ ist kein Wert für {1}: eine Zahl mit ihrer Einheit schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number in its unit.</source>
        <translation>„{0}“ ist kein Wert für {1}: eine Zahl in dessen Einheit schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number without a unit.</source>
        <translation>„{0}“ ist kein Wert für {1}: eine Zahl ohne Einheit schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no way to search: write {1} or {2}.</source>
        <translation>„{0}“ ist keine Art zu suchen: {1} oder {2} schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no way to take samples: write {1} or {2}.</source>
        <translation>„{0}“ ist keine Art, Stichproben zu nehmen: {1} oder {2} schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no whole number: write one for {1}.</source>
        <translation>„{0}“ ist keine ganze Zahl: für {1} eine schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is no {1}: write {2}.</source>
        <translation>„{0}“ gibt es bei {1} nicht: eines von diesen schreiben: {2}.</translation>
    </message>
    <message>
        <source>'{0}' is none of {1} for {2}.</source>
        <translation>„{0}“ ist keines von {1} für {2}.</translation>
    </message>
    <message>
        <source>'{0}' is not a drawing that can be read. Use PNG, JPEG, BMP, SVG, DXF or JSON.</source>
        <translation>„{0}“ ist keine lesbare Zeichnung. PNG, JPEG, BMP, SVG, DXF oder JSON benutzen.</translation>
    </message>
    <message>
        <source>'{0}' is not a file name: leave out the folder.</source>
        <translation>„{0}“ ist kein Dateiname: den Ordner weglassen.</translation>
    </message>
    <message>
        <source>'{0}' is not a picture that can be read. Save it as PNG, JPEG or BMP.</source>
        <translation>„{0}“ ist kein lesbares Bild. Als PNG, JPEG oder BMP speichern.</translation>
    </message>
    <message>
        <source>'{0}' is not a temperature; write it as 20C, 68F or 293K.</source>
        <translation>„{0}“ ist keine Temperatur; als 20C, 68F oder 293K schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is not a {1}; write it like {2}.</source>
        <translation>„{0}“ passt hier nicht ({1}); wie {2} schreiben.</translation>
    </message>
    <message>
        <source>'{0}' is read by FreeCAD, which is not there: install it for the Python that runs this, or give an STL of the solid.</source>
        <translation>„{0}“ wird von FreeCAD gelesen, das nicht da ist: es für das Python installieren, das dies ausführt, oder den Volumenkörper als STL geben.</translation>
    </message>
    <message>
        <source>'{}' has {} x {} pixels, more than {} million. Make it smaller; 2000 across are plenty.</source>
        <translation>„{}“ hat {} x {} Pixel, mehr als {} Millionen. Verkleinern; 2000 Pixel Breite sind reichlich.</translation>
    </message>
    <message>
        <source>'{}' is not a picture. Save it as PNG, JPEG or BMP once more.</source>
        <translation>„{}“ ist kein Bild. Noch einmal als PNG, JPEG oder BMP speichern.</translation>
    </message>
    <message>
        <source>'{}' was painted with a newer release: update Film Balloon.</source>
        <translation>„{}“ wurde mit einer neueren Fassung gemalt: Film Balloon aktualisieren.</translation>
    </message>
    <message>
        <source>, about {0}</source>
        <translation>, etwa {0}</translation>
    </message>
    <message>
        <source>, estimated: the film did not come to rest</source>
        <translation>, geschätzt: Die Folie kam nicht zur Ruhe</translation>
    </message>
    <message>
        <source>, one edge must turn</source>
        <translation>, eine Kante muss sich wenden</translation>
    </message>
    <message>
        <source>, {0} of them mirrored</source>
        <translation>, {0} davon gespiegelt</translation>
    </message>
    <message>
        <source>--jobs and --timeout are numbers above 0.</source>
        <translation>--jobs und --timeout sind Zahlen über 0.</translation>
    </message>
    <message>
        <source>--oversize scale makes the balloon smaller until it fits, --oversize split writes several files between which the film is moved, --oversize write writes the file anyway, --bed tells how large the bed is.</source>
        <translation>--oversize scale macht den Ballon kleiner, bis er passt, --oversize split schreibt mehrere Dateien, zwischen denen die Folie verschoben wird, --oversize write schreibt die Datei trotzdem, --bed sagt, wie groß das Bett ist.</translation>
    </message>
    <message>
        <source>--rim is the width of the weld and of the film beside it: give 0 to 1 m.</source>
        <translation>--rim ist die Breite der Schweißnaht und der Folie daneben: 0 bis 1 m angeben.</translation>
    </message>
    <message>
        <source>--tabs-below is about tabs: give their width too, such as --tabs 0.4mm.</source>
        <translation>--tabs-below betrifft Stege: geben Sie auch deren Breite, etwa --tabs 0.4mm.</translation>
    </message>
    <message>
        <source>--target-volume and --target-lift decide the size: leave out --width and --height.</source>
        <translation>--target-volume und --target-lift bestimmen die Größe: --width und --height weglassen.</translation>
    </message>
    <message>
        <source>1 to {0} pieces can be laid out, not {1}.</source>
        <translation>1 bis {0} Stücke können ausgelegt werden, nicht {1}.</translation>
    </message>
    <message>
        <source>3D model (GLB)</source>
        <translation>3D-Modell (GLB)</translation>
    </message>
    <message>
        <source>95 % below {} ({})</source>
        <translation>95 % unter {} ({})</translation>
    </message>
    <message>
        <source>95 % of it below</source>
        <translation>95 % davon unter</translation>
    </message>
    <message>
        <source>A GIF needs Pillow: install it with pip install pillow.</source>
        <translation>Ein GIF braucht Pillow: installieren Sie es mit pip install pillow.</translation>
    </message>
    <message>
        <source>A balloon has no "{0}": it has {1}.</source>
        <translation>Ein Ballon hat kein „{0}“: Es gibt {1}.</translation>
    </message>
    <message>
        <source>A balloon with a side band has no welds inside: its front and back are apart. Leave them out, or make it of two panels.</source>
        <translation>Ein Ballon mit Seitenband hat keine Schweißnähte im Inneren: Vorder- und Rückseite liegen auseinander. Sie weglassen oder ihn aus zwei Bahnen machen.</translation>
    </message>
    <message>
        <source>A bar is stated to weld {0} at {1}, this tool has {2}: peel a test card before you rely on it.</source>
        <translation>Angegeben ist, dass ein Schweißbalken {0} bei {1} schweißt, dieses Werkzeug hat {2}: ziehen Sie eine Testkarte auseinander, ehe Sie sich darauf verlassen.</translation>
    </message>
    <message>
        <source>A bed is that of a machine: give --machine too.</source>
        <translation>Ein Bett gehört zu einer Maschine: auch --machine angeben.</translation>
    </message>
    <message>
        <source>A bed is {0} mm to {1} mm wide and high: write 600mmx400mm, 600mm for a roll, or {2}.</source>
        <translation>Ein Bett ist {0} mm bis {1} mm breit und hoch: 600mmx400mm schreiben, 600mm für eine Rolle oder {2}.</translation>
    </message>
    <message>
        <source>A bed of {0} is too small to lay so much film on anew: give a larger one, or make the balloon smaller.</source>
        <translation>Ein Bett von {0} ist zu klein, um so viel Folie neu aufzulegen: geben Sie ein größeres oder machen Sie den Ballon kleiner.</translation>
    </message>
    <message>
        <source>A body cannot be made of {0} gores. Take {1} to {2}.</source>
        <translation>Ein Körper kann nicht aus {0} Segmenten gemacht werden. {1} bis {2} nehmen.</translation>
    </message>
    <message>
        <source>A body has 2 panels or more: these are the last ones.</source>
        <translation>Ein Körper hat mindestens 2 Bahnen: dies sind die letzten.</translation>
    </message>
    <message>
        <source>A body is divided into 2 to {0} panels: say how many.</source>
        <translation>Ein Körper wird in 2 bis {0} Bahnen geteilt: angeben, in wie viele.</translation>
    </message>
    <message>
        <source>A body of gores has no side band: leave out what you give of the one or of the other.</source>
        <translation>Ein Körper aus Segmenten hat kein Seitenband: die Angaben zum einen oder zum anderen weglassen.</translation>
    </message>
    <message>
        <source>A closed body; a copy of it travels in the document</source>
        <translation>Ein geschlossener Körper; eine Kopie davon reist im Dokument mit</translation>
    </message>
    <message>
        <source>A colour</source>
        <translation>Eine Farbe</translation>
    </message>
    <message>
        <source>A corner relief of {0} would cut into the weld: choose a smaller radius or a wider allowance.</source>
        <translation>Ein Eckenfreistich von {0} würde in die Schweißnaht schneiden: einen kleineren Radius oder mehr Zugabe wählen.</translation>
    </message>
    <message>
        <source>A cow from a mesh, by Keenan Crane: change the number of panels</source>
        <translation>Eine Kuh aus einem Netz, von Keenan Crane: die Zahl der Bahnen ändern</translation>
    </message>
    <message>
        <source>A drawing with welds inside is not made symmetric: draw it so, and turn this off.</source>
        <translation>Eine Zeichnung mit inneren Schweißnähten wird nicht symmetrisch gemacht: sie so zeichnen und dies ausschalten.</translation>
    </message>
    <message>
        <source>A file of this name is there already</source>
        <translation>Eine Datei mit diesem Namen gibt es schon</translation>
    </message>
    <message>
        <source>A film of this name is there already: else it gets the mean of all</source>
        <translation>Eine Folie dieses Namens gibt es schon: sonst bekommt sie das Mittel aller Fotos</translation>
    </message>
    <message>
        <source>A film of your own beside the balloon's, with what was found; it changes no pattern</source>
        <translation>Eine eigene Folie neben der des Ballons, mit dem, was gefunden wurde; sie ändert kein Schnittmuster</translation>
    </message>
    <message>
        <source>A fitted film is kept beside the numbers of a known one: choose the balloon's film in its panel.</source>
        <translation>Eine angepasste Folie wird neben den Zahlen einer bekannten behalten: wählen Sie die Folie des Ballons in seinem Aufgabenfenster.</translation>
    </message>
    <message>
        <source>A fitted film is written beside the numbers of a known one: give it by --material.</source>
        <translation>Eine angepasste Folie wird neben die Zahlen einer bekannten geschrieben: diese mit --material angeben.</translation>
    </message>
    <message>
        <source>A flat panel has no pressure and no rim: leave out --fit, --rim and --uncorrected.</source>
        <translation>Eine flache Bahn hat keinen Druck und keinen Rand: --fit, --rim und --uncorrected weglassen.</translation>
    </message>
    <message>
        <source>A goal has no '{0}': it has one of {1}, and {2}, {3} and {4}.</source>
        <translation>Ein Ziel hat kein „{0}“: Es hat eines von {1} sowie {2}, {3} und {4}.</translation>
    </message>
    <message>
        <source>A goal has one of {0}: write {1}.</source>
        <translation>Ein Ziel hat eines von {0}: {1} schreiben.</translation>
    </message>
    <message>
        <source>A hole meets the outline or another hole at {0}; keep some film between them.</source>
        <translation>Ein Loch berührt bei {0} den Umriss oder ein anderes Loch; etwas Folie dazwischen lassen.</translation>
    </message>
    <message>
        <source>A hole would open or close: draw that part anew.</source>
        <translation>Ein Loch würde sich öffnen oder schließen: diesen Teil neu zeichnen.</translation>
    </message>
    <message>
        <source>A hot tip is stated to weld {0} at {1}, this tool has {2}: peel a test card before you rely on it.</source>
        <translation>Angegeben ist, dass eine heiße Spitze {0} bei {1} schweißt, dieses Werkzeug hat {2}: ziehen Sie eine Testkarte auseinander, ehe Sie sich darauf verlassen.</translation>
    </message>
    <message>
        <source>A known length, in pixels of the picture</source>
        <translation>Eine bekannte Länge, in Bildpunkten</translation>
    </message>
    <message>
        <source>A label has up to {0} letters, between 0.1 mm and 10 m high: change it.</source>
        <translation>Eine Beschriftung hat bis zu {0} Buchstaben, 0,1 mm bis 10 m hoch: sie ändern.</translation>
    </message>
    <message>
        <source>A layout is as large as its film: give the film the size of the bed there.</source>
        <translation>Eine Anordnung ist so groß wie ihre Folie: der Folie dort die Größe des Betts geben.</translation>
    </message>
    <message>
        <source>A lift of {0} cannot be made: give one such as 5g.</source>
        <translation>Ein Auftrieb von {0} ist nicht möglich: zum Beispiel 5g angeben.</translation>
    </message>
    <message>
        <source>A lift of {0} is out of reach: {1} large, this balloon would carry {2}. Choose a lighter film or gas, a smaller lift, or a rounder shape.</source>
        <translation>Ein Auftrieb von {0} ist unerreichbar: {1} groß trüge dieser Ballon {2}. Leichtere Folie oder leichteres Gas, weniger Auftrieb oder eine rundere Form wählen.</translation>
    </message>
    <message>
        <source>A lift of {0} is out of reach: {1} large, this balloon would lack {2}. Choose a lighter film or gas, a smaller lift, or a rounder shape.</source>
        <translation>Ein Auftrieb von {0} ist unerreichbar: {1} groß fehlten diesem Ballon {2}. Leichtere Folie oder leichteres Gas, weniger Auftrieb oder eine rundere Form wählen.</translation>
    </message>
    <message>
        <source>A line that is projected needs a direction. Give one.</source>
        <translation>Eine Linie, die projiziert wird, braucht eine Richtung. Eine angeben.</translation>
    </message>
    <message>
        <source>A line that is projected needs two points or more. Draw them.</source>
        <translation>Eine Linie, die projiziert wird, braucht zwei oder mehr Punkte. Sie zeichnen.</translation>
    </message>
    <message>
        <source>A mesh of {0} is too coarse for a shape of {1}: use at most {2}.</source>
        <translation>Ein Netz von {0} ist zu grob für eine Form von {1}: höchstens {2} benutzen.</translation>
    </message>
    <message>
        <source>A mesh of {0} would need more than a million vertices for a shape of {1}: use at least {2}.</source>
        <translation>Ein Netz von {0} bräuchte über eine Million Knoten für eine Form von {1}: mindestens {2} benutzen.</translation>
    </message>
    <message>
        <source>A mesh of {0} would need more than a million vertices for these panels: use at least {1}.</source>
        <translation>Ein Netz von {0} bräuchte für diese Bahnen mehr als eine Million Knoten: mindestens {1} nehmen.</translation>
    </message>
    <message>
        <source>A new Sketcher sketch of lines and arcs, to go on with in FreeCAD</source>
        <translation>Eine neue Skizze aus Linien und Bögen, zum Weiterarbeiten in FreeCAD</translation>
    </message>
    <message>
        <source>A node that moves needs a place to move to; nothing else does.</source>
        <translation>Ein Knoten, der verschoben wird, braucht einen Zielort; alles andere hat keinen.</translation>
    </message>
    <message>
        <source>A number of an intake is empty.</source>
        <translation>Eine Zahl eines Füllhalses ist leer.</translation>
    </message>
    <message>
        <source>A package for this cluster is missing: {0}</source>
        <translation>Ein Paket für diesen Cluster fehlt: {0}</translation>
    </message>
    <message>
        <source>A passage of {0} is left open in the weld at {1}, so that air reaches both sides.</source>
        <translation>Ein Durchgang von {0} bleibt bei {1} in der Schweißnaht offen, damit Luft auf beide Seiten kommt.</translation>
    </message>
    <message>
        <source>A photograph</source>
        <translation>Ein Foto</translation>
    </message>
    <message>
        <source>A photograph on a page needs Pillow: install it with pip install pillow.</source>
        <translation>Ein Foto auf einer Seite braucht Pillow: installieren Sie es mit pip install pillow.</translation>
    </message>
    <message>
        <source>A picture cannot be drawn as "{0}": choose {1}.</source>
        <translation>Ein Bild kann nicht als „{0}“ gezeichnet sein: {1} wählen.</translation>
    </message>
    <message>
        <source>A picture has no size of its own. Give the width or the height of the balloon.</source>
        <translation>Ein Bild hat keine eigene Größe. Breite oder Höhe des Ballons angeben.</translation>
    </message>
    <message>
        <source>A picture that covers what is behind the balloon, such as a photograph of a room</source>
        <translation>Ein Bild, das bedeckt, was hinter dem Ballon ist, etwa ein Foto eines Zimmers</translation>
    </message>
    <message>
        <source>A piece does not fit on the sheet: take a larger one.</source>
        <translation>Ein Stück passt nicht auf den Bogen: einen größeren nehmen.</translation>
    </message>
    <message>
        <source>A piece of {0} x {1} does not fit on film of {2}{3}: take film at least {4} wide, or let the grain lie in another direction.</source>
        <translation>Ein Stück von {0} x {1} passt nicht auf Folie von {2}{3}: mindestens {4} breite Folie nehmen oder die Laufrichtung anders legen.</translation>
    </message>
    <message>
        <source>A pillow box cannot be deeper than wide. Choose a smaller depth.</source>
        <translation>Eine Kissenschachtel kann nicht tiefer als breit sein. Eine kleinere Tiefe wählen.</translation>
    </message>
    <message>
        <source>A plane needs its normal. Give one.</source>
        <translation>Eine Ebene braucht ihre Normale. Eine angeben.</translation>
    </message>
    <message>
        <source>A print is not cut in parts: choose a machine with a larger bed than {0}, or make the balloon smaller.</source>
        <translation>Ein Druck wird nicht in Teilen geschnitten: wählen Sie eine Maschine mit größerem Bett als {0} oder machen Sie den Ballon kleiner.</translation>
    </message>
    <message>
        <source>A process beside this one does not start: {0}</source>
        <translation>Ein Prozess neben diesem startet nicht: {0}</translation>
    </message>
    <message>
        <source>A process beside this one is of version {0}, not of {1}: install one of them anew.</source>
        <translation>Ein Prozess neben diesem hat Version {0} statt {1}: einen von beiden neu installieren.</translation>
    </message>
    <message>
        <source>A remnant is left of a layout: give --nest too, such as --nest 500mm.</source>
        <translation>Ein Reststück bleibt von einer Anordnung: geben Sie auch --nest, etwa --nest 500mm.</translation>
    </message>
    <message>
        <source>A script needs to know how many shards it has: give --shards a number.</source>
        <translation>Ein Skript muss wissen, wie viele Teile es hat: --shards eine Zahl geben.</translation>
    </message>
    <message>
        <source>A seam cannot be moved so far: it would meet another one.</source>
        <translation>Eine Naht lässt sich nicht so weit verschieben: Sie würde auf eine andere treffen.</translation>
    </message>
    <message>
        <source>A seam cannot be moved so far: one of its panels would be lost.</source>
        <translation>Eine Naht lässt sich nicht so weit verschieben: Eine ihrer Bahnen ginge verloren.</translation>
    </message>
    <message>
        <source>A seam closes an edge of a triangle to a point. Check which runs it joins.</source>
        <translation>Eine Naht schließt die Kante eines Dreiecks zu einem Punkt. Prüfen, welche Strecken sie verbindet.</translation>
    </message>
    <message>
        <source>A seam near {0} has one place only. Draw it through two.</source>
        <translation>Eine Naht nahe {0} hat nur eine Stelle. Sie durch zwei zeichnen.</translation>
    </message>
    <message>
        <source>A seam near {0} would pass the same place twice. Draw it in two parts.</source>
        <translation>Eine Naht nahe {0} würde zweimal über dieselbe Stelle laufen. Sie in zwei Teilen zeichnen.</translation>
    </message>
    <message>
        <source>A separating layer of PTFE gives off poisonous fumes above {0}, and baking paper chars above {1}: weld slower at a lower temperature, and air the room.</source>
        <translation>Eine Trennschicht aus PTFE gibt über {0} giftige Dämpfe ab, und Backpapier verkohlt über {1}: schweißen Sie langsamer bei niedrigerer Temperatur und lüften Sie.</translation>
    </message>
    <message>
        <source>A setting is tried with up to twelve values, each once.</source>
        <translation>Eine Einstellung wird mit bis zu zwölf Werten versucht, jedem einmal.</translation>
    </message>
    <message>
        <source>A sketch with dimensions: change a cell of the spreadsheet, and all follows</source>
        <translation>Eine Skizze mit Maßen: eine Zelle der Tabelle ändern, und alles folgt</translation>
    </message>
    <message>
        <source>A spread of {0} % leaves nothing of the {1}: give {2} at most {3} %.</source>
        <translation>Eine Streuung von {0} % lässt nichts übrig ({1}): für {2} höchstens {3} % angeben.</translation>
    </message>
    <message>
        <source>A strict reader that wants plain polylines. Layers are told apart by colour: cut red, blue and orange, set the output of all others to no.</source>
        <translation>Ein strenger Leser, der schlichte Polylinien will. Ebenen werden durch Farben unterschieden: Rot, Blau und Orange schneiden, die Ausgabe aller anderen auf Nein stellen.</translation>
    </message>
    <message>
        <source>A study has no '{0}': it has {1} and {2}.</source>
        <translation>Eine Studie hat kein „{0}“: Sie hat {1} und {2}.</translation>
    </message>
    <message>
        <source>A study of tolerances is about one balloon: give {0} a single value.</source>
        <translation>Eine Toleranzstudie gilt einem Ballon: {0} einen einzelnen Wert geben.</translation>
    </message>
    <message>
        <source>A study of tolerances says what strays, such as {"cut": {"normal": "0.2mm"}}.</source>
        <translation>Eine Toleranzstudie sagt, was streut, zum Beispiel {"cut": {"normal": "0.2mm"}}.</translation>
    </message>
    <message>
        <source>A study of tolerances takes 1 to {0} samples, not {1}: {2} tell a lot.</source>
        <translation>Eine Toleranzstudie nimmt 1 bis {0} Stichproben, nicht {1}: {2} sagen schon viel.</translation>
    </message>
    <message>
        <source>A tab must be {0} to {1} wide, not {2}; 0 makes none.</source>
        <translation>Ein Steg muss {0} bis {1} breit sein, nicht {2}; 0 macht keine.</translation>
    </message>
    <message>
        <source>A test card is for a machine, in a folder: give --machine and --out.</source>
        <translation>Eine Testkarte ist für eine Maschine, in einem Ordner: Geben Sie --machine und --out an.</translation>
    </message>
    <message>
        <source>A test card tries one or two settings: give several values of them, such as 200,300,400.</source>
        <translation>Eine Testkarte versucht eine oder zwei Einstellungen: Geben Sie von ihnen mehrere Werte an, etwa 200,300,400.</translation>
    </message>
    <message>
        <source>A tool has no "{0}": choose one of {1}.</source>
        <translation>Ein Werkzeug hat kein "{0}": wählen Sie eines von {1}.</translation>
    </message>
    <message>
        <source>A tool is that of a machine that reads G-code: give --machine gcode-grbl or another.</source>
        <translation>Ein Werkzeug gehört zu einer Maschine, die G-Code liest: --machine gcode-grbl oder eine andere angeben.</translation>
    </message>
    <message>
        <source>A tool that an axis turns does not swivel behind it: set knife_offset_mm to 0, or leave turning_axis out.</source>
        <translation>Ein Werkzeug, das eine Achse dreht, schleppt nicht hinter ihr her: knife_offset_mm auf 0 setzen oder turning_axis weglassen.</translation>
    </message>
    <message>
        <source>A volume of {0} cannot be made: give one such as 10l.</source>
        <translation>Ein Volumen von {0} ist nicht möglich: zum Beispiel 10l angeben.</translation>
    </message>
    <message>
        <source>A volume or a lift decides the size, so the balloon cannot be scaled to fit: leave out --oversize scale, or what you give of --target-volume, --target-lift and --gas-volume.</source>
        <translation>Ein Volumen oder ein Auftrieb bestimmt die Größe, darum kann der Ballon nicht passend verkleinert werden: --oversize scale weglassen, oder was von --target-volume, --target-lift und --gas-volume angegeben ist.</translation>
    </message>
    <message>
        <source>A volume to inflate to and a goal for the size exclude each other: leave one out.</source>
        <translation>Ein Füllvolumen und eine Zielgröße schließen einander aus: eines weglassen.</translation>
    </message>
    <message>
        <source>A web page came instead of the native solver, as some networks send before one has signed in. Open {0} in a browser, then try again. {1}</source>
        <translation>Statt des nativen Lösers kam eine Webseite, wie sie manche Netze vor der Anmeldung schicken. {0} in einem Browser öffnen, dann noch einmal versuchen. {1}</translation>
    </message>
    <message>
        <source>A weld has no length; draw a line, or a circle for a spot.</source>
        <translation>Eine Schweißnaht hat keine Länge; eine Linie zeichnen, oder einen Kreis für einen Punkt.</translation>
    </message>
    <message>
        <source>A weld leaves the film at {0}; keep it inside.</source>
        <translation>Eine Schweißnaht verlässt bei {0} die Folie; innerhalb bleiben.</translation>
    </message>
    <message>
        <source>A weld meets the outline, itself or another weld at {0}; keep some film between them.</source>
        <translation>Eine Schweißnaht trifft bei {0} den Umriss, sich selbst oder eine andere; etwas Folie dazwischen lassen.</translation>
    </message>
    <message>
        <source>A weld runs too near to another one or to the outline at {0} for this mesh: move it away, or use a smaller mesh size.</source>
        <translation>Eine Schweißnaht liegt bei {0} für dieses Netz zu nah an einer anderen oder am Umriss: sie verschieben oder eine kleinere Netzweite benutzen.</translation>
    </message>
    <message>
        <source>A weld that crumples can be simulated of one panel and its mirror image alone: choose the elastic weld, or one panel and its mirror image.</source>
        <translation>Eine Naht, die knittert, lässt sich nur mit einer Bahn und ihrem Spiegelbild simulieren: die elastische Naht wählen, oder eine Bahn und ihr Spiegelbild.</translation>
    </message>
    <message>
        <source>A worker does not have this program ({0}): install it everywhere.</source>
        <translation>Ein Worker hat dieses Programm nicht ({0}): überall installieren.</translation>
    </message>
    <message>
        <source>A worker of Dask failed ({0}: {1}).</source>
        <translation>Ein Worker von Dask ist gescheitert ({0}: {1}).</translation>
    </message>
    <message>
        <source>A {0} of {1} cannot be made; choose one between 1 mm and 100 m.</source>
        <translation>Eine {0} von {1} ist nicht möglich; eine zwischen 1 mm und 100 m wählen.</translation>
    </message>
    <message>
        <source>About {} thick</source>
        <translation>Etwa {} dick</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Ratschläge</translation>
    </message>
    <message>
        <source>Advice ({0}), at {1}: {2}</source>
        <translation>Ratschlag ({0}), bei {1}: {2}</translation>
    </message>
    <message>
        <source>Advice on many panels is measured on the balloon: inflate it first.</source>
        <translation>Ratschläge zu vielen Bahnen werden am Ballon gemessen: ihn erst aufblasen.</translation>
    </message>
    <message>
        <source>Air intake</source>
        <translation>Füllhals</translation>
    </message>
    <message>
        <source>Airship</source>
        <translation>Luftschiff</translation>
    </message>
    <message>
        <source>All packages are installed.</source>
        <translation>Alle Pakete sind installiert.</translation>
    </message>
    <message>
        <source>All panels are on the sheet once: none is drawn a second time, mirrored.</source>
        <translation>Alle Bahnen sind einmal auf dem Bogen: keine wird ein zweites Mal gespiegelt gezeichnet.</translation>
    </message>
    <message>
        <source>All points of the mesh are in one place. Save the body as a mesh of triangles.</source>
        <translation>Alle Punkte des Netzes liegen an einer Stelle. Den Körper als Netz aus Dreiecken speichern.</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Zugabe</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Längs</translation>
    </message>
    <message>
        <source>Along the seam</source>
        <translation>Entlang der Naht</translation>
    </message>
    <message>
        <source>Also on the other side</source>
        <translation>Auch auf der anderen Seite</translation>
    </message>
    <message>
        <source>Aluminised BOPP foil, 30 µm</source>
        <translation>Aluminisierte BOPP-Folie, 30 µm</translation>
    </message>
    <message>
        <source>Aluminised PET ("Mylar"), 25 µm</source>
        <translation>Alu-PET („Mylar“), 25 µm</translation>
    </message>
    <message>
        <source>Aluminised nylon/PE foil (party balloon), 30 µm</source>
        <translation>Aluminisierte Nylon/PE-Folie (Folienballon), 30 µm</translation>
    </message>
    <message>
        <source>An accuracy is for a balloon that follows its body: give the number of panels of one that encloses or lines it.</source>
        <translation>Eine Genauigkeit gilt für einen Ballon, der seinem Körper folgt: für einen, der ihn umschließt oder innen auskleidet, die Zahl der Bahnen angeben.</translation>
    </message>
    <message>
        <source>An animation needs at least two frames, not {0}.</source>
        <translation>Eine Animation braucht mindestens zwei Bilder, nicht {0}.</translation>
    </message>
    <message>
        <source>An intake of {0} does not reach past the cut: give it at least {1}.</source>
        <translation>Ein Füllhals von {0} reicht nicht über den Schnitt hinaus: mindestens {1} geben.</translation>
    </message>
    <message>
        <source>An outline cannot be edited by "{0}": choose one of {1}.</source>
        <translation>Ein Umriss kann nicht mit „{0}“ bearbeitet werden: eines von {1} wählen.</translation>
    </message>
    <message>
        <source>An outline keeps three nodes: move them instead.</source>
        <translation>Ein Umriss behält drei Knoten: sie stattdessen verschieben.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Animate inflation</source>
        <translation>Aufblasen animieren</translation>
    </message>
    <message>
        <source>Another study is running in '{0}': wait for it, or choose another folder.</source>
        <translation>In „{0}“ läuft eine andere Studie: auf sie warten oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Beliebig</translation>
    </message>
    <message>
        <source>Any colour</source>
        <translation>Beliebige Farbe</translation>
    </message>
    <message>
        <source>Any colour (K)</source>
        <translation>Beliebige Farbe (K)</translation>
    </message>
    <message>
        <source>Any program (DXF)</source>
        <translation>Beliebiges Programm (DXF)</translation>
    </message>
    <message>
        <source>Any program (SVG)</source>
        <translation>Beliebiges Programm (SVG)</translation>
    </message>
    <message>
        <source>Any size</source>
        <translation>Beliebige Größe</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Arcs in a sketch, as they hang over a party table</source>
        <translation>Bögen in einer Skizze, wie sie über einem Festtisch hängen</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Arm too thin to fill</source>
        <translation>Arm zu dünn zum Füllen</translation>
    </message>
    <message>
        <source>Artwork</source>
        <translation>Bildvorlage</translation>
    </message>
    <message>
        <source>As Summa with OPOS, and the bar between the lower squares shows the cutter whether the print is bent. Feed the sheet with the bar first. The layer Regmark is not cut.</source>
        <translation>Wie Summa mit OPOS, und der Balken zwischen den unteren Quadraten zeigt der Schneidemaschine, ob der Druck verzogen ist. Legen Sie den Bogen mit dem Balken voran ein. Die Ebene Regmark wird nicht geschnitten.</translation>
    </message>
    <message>
        <source>As at first</source>
        <translation>Wie zu Anfang</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Wie gebaut</translation>
    </message>
    <message>
        <source>As made over what was expected</source>
        <translation>Hergestelltes über Erwartetem</translation>
    </message>
    <message>
        <source>As made: {0}, expected: {1}</source>
        <translation>Hergestellt: {0}, erwartet: {1}</translation>
    </message>
    <message>
        <source>Assembly sheet</source>
        <translation>Montageblatt</translation>
    </message>
    <message>
        <source>Assembly sheet written to {}</source>
        <translation>Montageblatt nach {} geschrieben</translation>
    </message>
    <message>
        <source>At least 95 of 100 balloons bear {0} with their margin, by {1} samples and with a confidence of 95 %.</source>
        <translation>Mindestens 95 von 100 Ballons halten {0} mit ihrer Reserve aus, nach {1} Stichproben und mit 95 % Sicherheit.</translation>
    </message>
    <message>
        <source>At work the {0} is {1} above the film, and lifted {2} only: give it more depth, or a higher lift_mm.</source>
        <translation>Beim Arbeiten ist das Werkzeug ({0}) {1} über der Folie, und angehoben nur {2}: mehr Tiefe oder ein größeres lift_mm angeben.</translation>
    </message>
    <message>
        <source>At worst the film lies {0} on the wrong side of the body, and a margin of {1} was asked for. Take more panels, or a larger margin.</source>
        <translation>Die Folie liegt schlimmstenfalls {0} auf der falschen Seite des Körpers, verlangt war ein Abstand von {1}. Mehr Bahnen nehmen oder einen größeren Abstand.</translation>
    </message>
    <message>
        <source>At {0} dots per inch the sheet would have {1} x {2} pixels: give a lower resolution.</source>
        <translation>Mit {0} Punkten je Zoll hätte der Bogen {1} x {2} Pixel: eine kleinere Auflösung angeben.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rückseite</translation>
    </message>
    <message>
        <source>Bag</source>
        <translation>Beutel</translation>
    </message>
    <message>
        <source>Bag of panels</source>
        <translation>Beutel aus Bahnen</translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation>Ballon</translation>
    </message>
    <message>
        <source>Balloon as a GLB file, for 3D programs</source>
        <translation>Ballon als GLB-Datei, für 3D-Programme</translation>
    </message>
    <message>
        <source>Balloon film</source>
        <translation>Ballonfolie</translation>
    </message>
    <message>
        <source>Balloon of row {0}</source>
        <translation>Ballon der Zeile {0}</translation>
    </message>
    <message>
        <source>Balloon pattern</source>
        <translation>Schnittmuster des Ballons</translation>
    </message>
    <message>
        <source>Balloon: {0}, {1}, solver {2}</source>
        <translation>Ballon: {0}, {1}, Löser {2}</translation>
    </message>
    <message>
        <source>Balloons</source>
        <translation>Ballons</translation>
    </message>
    <message>
        <source>Balloons of each</source>
        <translation>Ballons von jedem</translation>
    </message>
    <message>
        <source>Balloons: {0}, of these are there: {1}</source>
        <translation>Ballons: {0}, davon schon da: {1}</translation>
    </message>
    <message>
        <source>Balloons: {0}, worked out now: {1}, of these failed: {2}</source>
        <translation>Ballons: {0}, jetzt berechnet: {1}, davon gescheitert: {2}</translation>
    </message>
    <message>
        <source>Bar of 100 mm to measure</source>
        <translation>Balken von 100 mm zum Messen</translation>
    </message>
    <message>
        <source>Bed</source>
        <translation>Bett</translation>
    </message>
    <message>
        <source>Before it is written</source>
        <translation>Bevor geschrieben wird</translation>
    </message>
    <message>
        <source>Bending stiffness</source>
        <translation>Biegesteifigkeit</translation>
    </message>
    <message>
        <source>Beside the document</source>
        <translation>Neben dem Dokument</translation>
    </message>
    <message>
        <source>Beside the pattern, to see whether the size was kept</source>
        <translation>Neben dem Schnittmuster, um zu sehen, ob die Größe erhalten blieb</translation>
    </message>
    <message>
        <source>Best field</source>
        <translation>Bestes Feld</translation>
    </message>
    <message>
        <source>Best of {0} balloons: {1}, with {2}.</source>
        <translation>Bester von {0} Ballons: {1}, mit {2}.</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Bleed</source>
        <translation>Anschnitt</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Blue 0, green {}, red {}</source>
        <translation>Blau 0, grün {}, rot {}</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Both halves of the body are made alike: they differ by {0} at most.</source>
        <translation>Beide Hälften des Körpers werden gleich gemacht: sie unterscheiden sich um höchstens {0}.</translation>
    </message>
    <message>
        <source>Both panels</source>
        <translation>Beide Bahnen</translation>
    </message>
    <message>
        <source>Both panels are on the sheet: only the front one gets the hole of the nozzle. Cut it once.</source>
        <translation>Beide Bahnen liegen auf dem Bogen: Nur die vordere bekommt das Loch für den Stutzen. Es einmal schneiden.</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Beide Seiten</translation>
    </message>
    <message>
        <source>Both sides of a seam must be equally long</source>
        <translation>Beide Seiten einer Naht müssen gleich lang sein</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>Flasche</translation>
    </message>
    <message>
        <source>Bring the 3D view of the document to the front first.</source>
        <translation>Zuerst die 3D-Ansicht des Dokuments nach vorn holen.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>By at least</source>
        <translation>Um mindestens</translation>
    </message>
    <message>
        <source>Cannot read '{0}' ({1}): name the file of a test card.</source>
        <translation>'{0}' lässt sich nicht lesen ({1}): Nennen Sie die Datei einer Testkarte.</translation>
    </message>
    <message>
        <source>Cannot write to '{0}' ({1}): choose another folder for the study.</source>
        <translation>In „{0}“ kann nicht geschrieben werden ({1}): einen anderen Ordner für die Studie wählen.</translation>
    </message>
    <message>
        <source>Cannot write to {0}: {1}. Choose another folder, or make room there.</source>
        <translation>In {0} kann nicht geschrieben werden: {1}. Einen anderen Ordner wählen oder dort Platz schaffen.</translation>
    </message>
    <message>
        <source>Cannot write {0}: {1}. Make room there and start the study again; no balloon is lost.</source>
        <translation>{0} kann nicht geschrieben werden: {1}. Dort Platz schaffen und die Studie noch einmal starten; kein Ballon geht verloren.</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Check the size: the 100 mm bar on the cut file or print must measure 100 mm.</source>
        <translation>Die Größe prüfen: Der Kontrollbalken von 100 mm in Schneidedatei oder Ausdruck muss 100 mm messen.</translation>
    </message>
    <message>
        <source>Check, {0}: {1}</source>
        <translation>Prüfung, {0}: {1}</translation>
    </message>
    <message>
        <source>Check: {0}</source>
        <translation>Prüfung: {0}</translation>
    </message>
    <message>
        <source>Checked: ready to make.</source>
        <translation>Geprüft: bereit zum Herstellen.</translation>
    </message>
    <message>
        <source>Checking the pattern</source>
        <translation>Das Schnittmuster wird geprüft</translation>
    </message>
    <message>
        <source>Choose a body</source>
        <translation>Einen Körper wählen</translation>
    </message>
    <message>
        <source>Choose a colour</source>
        <translation>Eine Farbe wählen</translation>
    </message>
    <message>
        <source>Choose a drawing</source>
        <translation>Eine Zeichnung wählen</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Eine Datei wählen</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Einen Ordner wählen</translation>
    </message>
    <message>
        <source>Choose a material card</source>
        <translation>Eine Materialkarte wählen</translation>
    </message>
    <message>
        <source>Choose a photograph first: a PNG, JPEG or BMP file.</source>
        <translation>Wählen Sie zuerst ein Foto: eine PNG-, JPEG- oder BMP-Datei.</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>Ein Bild wählen</translation>
    </message>
    <message>
        <source>Choose a picture or a sketch.</source>
        <translation>Ein Bild oder eine Skizze wählen.</translation>
    </message>
    <message>
        <source>Choose a remnant</source>
        <translation>Reststück wählen</translation>
    </message>
    <message>
        <source>Choose a row first.</source>
        <translation>Zuerst eine Zeile wählen.</translation>
    </message>
    <message>
        <source>Choose a sketch or a file with half the outline.</source>
        <translation>Eine Skizze oder eine Datei mit dem halben Umriss wählen.</translation>
    </message>
    <message>
        <source>Choose a solid, a mesh or a file with one.</source>
        <translation>Einen Volumenkörper, ein Netz oder eine Datei damit wählen.</translation>
    </message>
    <message>
        <source>Choose a test card</source>
        <translation>Testkarte wählen</translation>
    </message>
    <message>
        <source>Choose sketches, a file or a ready body.</source>
        <translation>Skizzen, eine Datei oder einen fertigen Körper wählen.</translation>
    </message>
    <message>
        <source>Choose the balloon that it belongs to.</source>
        <translation>Den zugehörigen Ballon wählen.</translation>
    </message>
    <message>
        <source>Choose the outline to inflate.</source>
        <translation>Den Umriss wählen, der aufgeblasen werden soll.</translation>
    </message>
    <message>
        <source>Choose the pattern to print on.</source>
        <translation>Das Schnittmuster wählen, auf das gedruckt wird.</translation>
    </message>
    <message>
        <source>Choose the patterns to lay out.</source>
        <translation>Die Schnittmuster wählen, die ausgelegt werden.</translation>
    </message>
    <message>
        <source>Choose the photograph that is behind the balloon.</source>
        <translation>Wählen Sie das Foto, das hinter dem Ballon ist.</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Click a seam: its panels become one. Esc: done.</source>
        <translation>Eine Naht anklicken: Ihre Bahnen werden eine. Esc: fertig.</translation>
    </message>
    <message>
        <source>Click a seam: the panels beside it become one</source>
        <translation>Eine Naht anklicken: Die Bahnen neben ihr werden eine</translation>
    </message>
    <message>
        <source>Click an edge to see what it is sealed to, drag a piece to move it.</source>
        <translation>Klicken Sie auf eine Kante: Es wird gezeigt, womit sie verschweißt wird; ziehen Sie ein Stück, um es zu verschieben.</translation>
    </message>
    <message>
        <source>Click an edge to see what it is sealed to.</source>
        <translation>Klicken Sie auf eine Kante: Es wird gezeigt, womit sie verschweißt wird.</translation>
    </message>
    <message>
        <source>Click and type; pull it, its corner, or the ring that turns it. Enter paints it, Esc drops it.</source>
        <translation>Klicken und tippen; es, seine Ecke oder den Ring ziehen, der es dreht. Enter malt es, Esc verwirft es.</translation>
    </message>
    <message>
        <source>Click both ends of a length that you know; a third click moves the nearer mark.</source>
        <translation>Klicken Sie auf beide Enden einer Länge, die Sie kennen; ein dritter Klick verschiebt die nähere Marke.</translation>
    </message>
    <message>
        <source>Click both ends of a ruler in the picture, or of another known length</source>
        <translation>Klicken Sie auf beide Enden eines Lineals im Bild oder einer anderen bekannten Länge</translation>
    </message>
    <message>
        <source>Click on the paper, then type</source>
        <translation>Auf das Papier klicken, dann tippen</translation>
    </message>
    <message>
        <source>Click the line for a new node; drag nodes; Delete removes them; S: sharp or round.</source>
        <translation>Ein Klick auf die Linie macht einen Knoten; Knoten ziehen; Entf entfernt sie; S: spitz oder rund.</translation>
    </message>
    <message>
        <source>Click to see it larger</source>
        <translation>Klicken, um es größer zu sehen</translation>
    </message>
    <message>
        <source>Click two places: a seam runs between them</source>
        <translation>Zwei Stellen anklicken: Eine Naht läuft zwischen ihnen</translation>
    </message>
    <message>
        <source>Click two points to measure between them.</source>
        <translation>Klicken Sie auf zwei Punkte, um dazwischen zu messen.</translation>
    </message>
    <message>
        <source>Click where the new seam begins. Esc: done.</source>
        <translation>Klicken, wo die neue Naht beginnt. Esc: fertig.</translation>
    </message>
    <message>
        <source>Click where the seam ends. Esc: another start.</source>
        <translation>Klicken, wo die Naht endet. Esc: anderer Anfang.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close the open task panel first.</source>
        <translation>Zuerst das offene Aufgabenfenster schließen.</translation>
    </message>
    <message>
        <source>Cloud</source>
        <translation>Wolke</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>Farbkarte</translation>
    </message>
    <message>
        <source>Colour {}</source>
        <translation>Farbe {}</translation>
    </message>
    <message>
        <source>Columns from the left: {0}</source>
        <translation>Spalten von links: {0}</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Compare with a photograph</source>
        <translation>Mit einem Foto vergleichen</translation>
    </message>
    <message>
        <source>Comparing with the photograph</source>
        <translation>Vergleich mit dem Foto</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>Vergleiche…</translation>
    </message>
    <message>
        <source>Coordinates really are inches, and the header says so.</source>
        <translation>Die Koordinaten sind wirklich Zoll, und der Dateikopf sagt es.</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Stückzahl</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation>Kopieren (Strg+C)</translation>
    </message>
    <message>
        <source>Corner relief</source>
        <translation>Eckenfreistich</translation>
    </message>
    <message>
        <source>Cricut Design Space</source>
        <translation>Cricut Design Space</translation>
    </message>
    <message>
        <source>Crosses, by eye</source>
        <translation>Kreuze, fürs Auge</translation>
    </message>
    <message>
        <source>Crumpled</source>
        <translation>Geknittert</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Cut (Ctrl+X)</source>
        <translation>Ausschneiden (Strg+X)</translation>
    </message>
    <message>
        <source>Cut all panels from {film}, as they are drawn: so they are seen from outside, with the sealing side below.</source>
        <translation>Alle Bahnen aus {film} schneiden, wie sie gezeichnet sind: so sieht man sie von außen, mit der Siegelseite unten.</translation>
    </message>
    <message>
        <source>Cut all panels from {film}. As they are drawn they are seen from outside.</source>
        <translation>Alle Bahnen aus {film} schneiden. Wie sie gezeichnet sind, sieht man sie von außen.</translation>
    </message>
    <message>
        <source>Cut each page along its left and lower crosses, lay it on the crosses of its neighbours, tape.</source>
        <translation>Jede Seite links und unten an den Kreuzen abschneiden, auf die Kreuze der Nachbarn legen und festkleben.</translation>
    </message>
    <message>
        <source>Cut out the hole of the nozzle, in the front panel only.</source>
        <translation>Das Loch für den Stutzen ausschneiden, nur in der vorderen Bahn.</translation>
    </message>
    <message>
        <source>Cut out the holes inside.</source>
        <translation>Die Löcher innen ausschneiden.</translation>
    </message>
    <message>
        <source>Cut two panels from {film}, the second one mirrored, so that the sealing sides face each other.</source>
        <translation>Zwei Bahnen schneiden ({film}), die zweite gespiegelt, damit die Siegelseiten zueinander liegen.</translation>
    </message>
    <message>
        <source>Cut two panels from {film}, the second one mirrored.</source>
        <translation>Zwei Bahnen schneiden ({film}), die zweite gespiegelt.</translation>
    </message>
    <message>
        <source>Cuts without room for two tabs of {0} on a straight: {1}, the first near {2}. What they go round comes free.</source>
        <translation>Schnitte ohne Platz für zwei Stege von {0} auf einem geraden Stück: {1}, der erste bei {2}. Was sie umschließen, fällt heraus.</translation>
    </message>
    <message>
        <source>Cutting shop (DXF R12)</source>
        <translation>Zuschnittbetrieb (DXF R12)</translation>
    </message>
    <message>
        <source>Cutting shop in inches (DXF R2000)</source>
        <translation>Zuschnittbetrieb in Zoll (DXF R2000)</translation>
    </message>
    <message>
        <source>DXF files can be neither read nor written without it; SVG files can.</source>
        <translation>DXF-Dateien können ohne es weder gelesen noch geschrieben werden; SVG-Dateien schon.</translation>
    </message>
    <message>
        <source>DXF files need the Python package ezdxf. Install it with 'pip install ezdxf', or save the drawing as SVG.</source>
        <translation>DXF-Dateien brauchen das Python-Paket ezdxf. Mit „pip install ezdxf“ installieren oder die Zeichnung als SVG speichern.</translation>
    </message>
    <message>
        <source>Decoration</source>
        <translation>Verzierung</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete {}? Its file goes for good.</source>
        <translation>{} löschen? Die Datei ist dann endgültig weg.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Diameter {}, height {}, gores {} long</source>
        <translation>Durchmesser {}, Höhe {}, Segmente {} lang</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Distance from profile, drawing or body</source>
        <translation>Abstand von Profil, Zeichnung oder Körper</translation>
    </message>
    <message>
        <source>Distance {}, across {}, up {}</source>
        <translation>Abstand {}, waagrecht {}, senkrecht {}</translation>
    </message>
    <message>
        <source>Dividing a body needs scipy: install it with pip install scipy.</source>
        <translation>Einen Körper zu teilen braucht scipy: mit pip install scipy installieren.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Done (Esc)</source>
        <translation>Fertig (Esc)</translation>
    </message>
    <message>
        <source>Dots per inch</source>
        <translation>Punkte je Zoll</translation>
    </message>
    <message>
        <source>Double-click a row to see its balloon</source>
        <translation>Doppelklick auf eine Zeile zeigt ihren Ballon</translation>
    </message>
    <message>
        <source>Drag a seam to where it shall run. Esc: done.</source>
        <translation>Eine Naht dorthin ziehen, wo sie laufen soll. Esc: fertig.</translation>
    </message>
    <message>
        <source>Drag a seam: it runs through the place</source>
        <translation>Eine Naht ziehen: Sie läuft durch die Stelle</translation>
    </message>
    <message>
        <source>Drag in the view</source>
        <translation>In der Ansicht ziehen</translation>
    </message>
    <message>
        <source>Drag to turn, turn the wheel to zoom; keys: arrows, plus, minus, Home.</source>
        <translation>Ziehen dreht, das Mausrad zoomt; Tasten: Pfeile, Plus, Minus, Pos1.</translation>
    </message>
    <message>
        <source>Draw a closed line, or paint an area: it becomes a balloon.</source>
        <translation>Eine geschlossene Linie zeichnen oder eine Fläche malen: Sie wird ein Ballon.</translation>
    </message>
    <message>
        <source>Draw half of the outline, and its axis as a straight upright line on its left.</source>
        <translation>Die Hälfte des Umrisses zeichnen, und links davon seine Achse als gerade, aufrechte Linie.</translation>
    </message>
    <message>
        <source>Draw lines. A closed line becomes a balloon.</source>
        <translation>Linien zeichnen. Eine geschlossene Linie wird ein Ballon.</translation>
    </message>
    <message>
        <source>Drawing and silhouette</source>
        <translation>Zeichnung und Silhouette</translation>
    </message>
    <message>
        <source>Drawing over silhouette</source>
        <translation>Zeichnung über der Silhouette</translation>
    </message>
    <message>
        <source>Drawing seams needs scipy: install it with pip install scipy.</source>
        <translation>Nähte zu zeichnen braucht scipy: mit pip install scipy installieren.</translation>
    </message>
    <message>
        <source>Drawing {0}</source>
        <translation>{0} wird gezeichnet</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Zeichnungen</translation>
    </message>
    <message>
        <source>Drawn as</source>
        <translation>Gezeichnet als</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Tropfen</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Wartezeit</translation>
    </message>
    <message>
        <source>E across the grain</source>
        <translation>E-Modul quer zur Laufrichtung</translation>
    </message>
    <message>
        <source>Each row of the table once with each of these values</source>
        <translation>Jede Zeile der Tabelle einmal mit jedem dieser Werte</translation>
    </message>
    <message>
        <source>Each stroke colour becomes an operation of its own: cut red, blue and orange, set all others to ignore. DXF is not read.</source>
        <translation>Jede Strichfarbe wird ein eigener Arbeitsgang: Rot, Blau und Orange schneiden, alle anderen ignorieren lassen. DXF wird nicht gelesen.</translation>
    </message>
    <message>
        <source>Edges of the mesh at which more than two triangles meet: {0}, one of them at ({1}) of the mesh. Repair it in the program that it comes from, so that it is the surface of a solid.</source>
        <translation>Kanten des Netzes, an denen mehr als zwei Dreiecke zusammenkommen: {0}, eine davon bei ({1}) des Netzes. Es in dem Programm reparieren, aus dem es kommt, sodass es die Oberfläche eines Volumenkörpers ist.</translation>
    </message>
    <message>
        <source>Edges of the panels</source>
        <translation>Kanten der Bahnen</translation>
    </message>
    <message>
        <source>Edit artwork</source>
        <translation>Bildvorlage bearbeiten</translation>
    </message>
    <message>
        <source>Edit balloon</source>
        <translation>Ballon bearbeiten</translation>
    </message>
    <message>
        <source>Edit film</source>
        <translation>Folienbogen bearbeiten</translation>
    </message>
    <message>
        <source>Edit outline</source>
        <translation>Umriss bearbeiten</translation>
    </message>
    <message>
        <source>Edit outline ...</source>
        <translation>Umriss bearbeiten ...</translation>
    </message>
    <message>
        <source>Edit study</source>
        <translation>Studie bearbeiten</translation>
    </message>
    <message>
        <source>Eight panels for a solid with fillets: change its section or their number</source>
        <translation>Acht Bahnen für einen Volumenkörper mit Verrundungen: seinen Querschnitt oder ihre Zahl ändern</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>Elastisch</translation>
    </message>
    <message>
        <source>Elastic materials</source>
        <translation>Elastische Werkstoffe</translation>
    </message>
    <message>
        <source>Encloses it</source>
        <translation>Umschließt ihn</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Radierer</translation>
    </message>
    <message>
        <source>Errors as large as these leave no panel: give smaller ones.</source>
        <translation>Bei so großen Abweichungen bleibt keine Bahn übrig: kleinere angeben.</translation>
    </message>
    <message>
        <source>Errors of {0} stay alike over a length above 0, such as 50mm.</source>
        <translation>Abweichungen von {0} bleiben sich über eine Länge über 0 ähnlich, zum Beispiel 50mm.</translation>
    </message>
    <message>
        <source>Errors that stay alike over {0} alone are too fine for a seam of {1}: give at least {2} as 'along'.</source>
        <translation>Abweichungen, die sich nur über {0} ähnlich bleiben, sind zu fein für eine Naht von {1}: als „along“ mindestens {2} angeben.</translation>
    </message>
    <message>
        <source>Every layer becomes a colour of the cut list; layers that share a colour would be merged. Set the import unit to millimetres. Cut red, blue and orange only and switch the output of all others off; the LightBurn project has them on tool layers already.</source>
        <translation>Jede Ebene wird eine Farbe der Schnittliste; Ebenen gleicher Farbe würden vereint. Die Einheit beim Import auf Millimeter stellen. Nur Rot, Blau und Orange schneiden und die Ausgabe aller anderen abschalten; im LightBurn-Projekt liegen diese schon auf Werkzeugebenen.</translation>
    </message>
    <message>
        <source>Expected thickness</source>
        <translation>Erwartete Dicke</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>Export begins with it</source>
        <translation>Export beginnt damit</translation>
    </message>
    <message>
        <source>Export for the web</source>
        <translation>Fürs Web ausgeben</translation>
    </message>
    <message>
        <source>Export pattern</source>
        <translation>Schnittmuster ausgeben</translation>
    </message>
    <message>
        <source>Export pattern begins with this machine; it is a preference</source>
        <translation>Schnittmuster ausgeben beginnt mit dieser Maschine; das ist eine Einstellung</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Ausdruck</translation>
    </message>
    <message>
        <source>Face{0} of {1} is curved so much that it would take {2} strips of film. Give a number of panels, or leave such details out of the solid.</source>
        <translation>Face{0} von {1} ist so stark gekrümmt, dass sie {2} Streifen Folie bräuchte. Eine Zahl von Bahnen angeben oder solche Einzelheiten im Volumenkörper weglassen.</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Gescheitert</translation>
    </message>
    <message>
        <source>Farthest off near {0}</source>
        <translation>Größte Abweichung nahe {0}</translation>
    </message>
    <message>
        <source>Farthest point</source>
        <translation>Fernster Punkt</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Feed in corners</source>
        <translation>Vorschub in Ecken</translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation>Herunterladen</translation>
    </message>
    <message>
        <source>Fetch the native solver ...</source>
        <translation>Den nativen Löser herunterladen ...</translation>
    </message>
    <message>
        <source>Fetches the native solver of this version, checks its SHA-256 and puts it in its place.</source>
        <translation>Lädt den nativen Löser dieser Version herunter, prüft seine SHA-256 und legt ihn an seinen Platz.</translation>
    </message>
    <message>
        <source>Fetching the native solver</source>
        <translation>Der native Löser wird heruntergeladen</translation>
    </message>
    <message>
        <source>Fetching {0} ({1} MB) into {2}; only the file with SHA-256 {3} is kept.</source>
        <translation>{0} ({1} MB) wird nach {2} heruntergeladen; nur die Datei mit der SHA-256 {3} wird behalten.</translation>
    </message>
    <message>
        <source>Few panels or true to shape</source>
        <translation>Wenige Bahnen oder formtreu</translation>
    </message>
    <message>
        <source>Few panels or true to shape?</source>
        <translation>Wenige Bahnen oder formtreu?</translation>
    </message>
    <message>
        <source>Fields: {}, on {} of film</source>
        <translation>Felder: {}, auf {} Folie</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Files written to {}</source>
        <translation>Dateien nach {} geschrieben</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Fill a closed line, or give an area another colour</source>
        <translation>Eine geschlossene Linie füllen oder einer Fläche eine andere Farbe geben</translation>
    </message>
    <message>
        <source>Fill at the nozzle, to at most {column} of water.</source>
        <translation>An der Tülle füllen, bis höchstens {column} Wassersäule.</translation>
    </message>
    <message>
        <source>Fill through a straw in the neck, to at most {column} of water.</source>
        <translation>Durch einen Strohhalm im Hals füllen, bis höchstens {column} Wassersäule.</translation>
    </message>
    <message>
        <source>Fill through a tube of 6 mm, its end cut aslant, pushed 25 mm past the seal across the neck, to at most {column} of water. Pull it out: the strips close by themselves.</source>
        <translation>Durch einen Schlauch von 6 mm füllen, am Ende schräg geschnitten, 25 mm über die Naht quer über den Hals hineingeschoben, bis höchstens {column} Wassersäule. Herausziehen: die Streifen schließen von selbst.</translation>
    </message>
    <message>
        <source>Fill through a tube of 6 mm, its end cut aslant, pushed 25 mm past the weld across the neck. Pull it out: the pressure presses the strips together.</source>
        <translation>Durch ein Röhrchen von 6 mm füllen, das Ende schräg geschnitten, 25 mm über die Naht quer zum Hals hinausgeschoben. Es herausziehen: Der Druck presst die Streifen aufeinander.</translation>
    </message>
    <message>
        <source>Fill to {pressure}, never above {safe}: film and seam then keep a margin of {margin}.</source>
        <translation>Bis {pressure} füllen, nie über {safe}: Folie und Naht behalten dann {margin}-fache Reserve.</translation>
    </message>
    <message>
        <source>Fill to {pressure}, never above {safe}: film and weld then keep a margin of {margin}.</source>
        <translation>Bis {pressure} füllen, nie über {safe}: Folie und Schweißnaht behalten dann {margin}-fache Reserve.</translation>
    </message>
    <message>
        <source>Fill to {safe} at most: {pressure} is more than film and seam bear with a margin of {margin}. Mind your eyes.</source>
        <translation>Höchstens bis {safe} füllen: {pressure} sind mehr, als Folie und Naht mit {margin}-facher Reserve tragen. Augen schützen.</translation>
    </message>
    <message>
        <source>Fill to {safe} at most: {pressure} is more than film and weld bear with a margin of {margin}. Mind your eyes.</source>
        <translation>Höchstens bis {safe} füllen: {pressure} sind mehr, als Folie und Schweißnaht mit {margin}-facher Reserve tragen. Augen schützen.</translation>
    </message>
    <message>
        <source>Fill with air a little and brush soapy water along the weld: bubbles show leaks. Weld once more there.</source>
        <translation>Etwas Luft einfüllen und die Naht mit Seifenwasser bestreichen: Blasen zeigen undichte Stellen. Dort noch einmal schweißen.</translation>
    </message>
    <message>
        <source>Filled shape</source>
        <translation>Gefüllte Form</translation>
    </message>
    <message>
        <source>Filleted housing</source>
        <translation>Verrundetes Gehäuse</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Folie</translation>
    </message>
    <message>
        <source>Film Balloon {0} in FreeCAD {1}</source>
        <translation>Film Balloon {0} in FreeCAD {1}</translation>
    </message>
    <message>
        <source>Film needed</source>
        <translation>Benötigte Folie</translation>
    </message>
    <message>
        <source>Film needed: {0}</source>
        <translation>Benötigte Folie: {0}</translation>
    </message>
    <message>
        <source>Film of your own</source>
        <translation>Eigene Folie</translation>
    </message>
    <message>
        <source>Film that it takes</source>
        <translation>Benötigte Folie</translation>
    </message>
    <message>
        <source>Film width</source>
        <translation>Folienbreite</translation>
    </message>
    <message>
        <source>Film {0} large is too much: write 500mm.</source>
        <translation>{0} Folie sind zu viel: 500mm schreiben.</translation>
    </message>
    <message>
        <source>Film: {0}</source>
        <translation>Folie: {0}</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>Folien</translation>
    </message>
    <message>
        <source>Find how much the film stretched, and how far the weld draws the seam inward</source>
        <translation>Finden, wie weit sich die Folie gedehnt hat und wie weit die Schweißnaht die Nahtlinie nach innen zieht</translation>
    </message>
    <message>
        <source>Find its place</source>
        <translation>Seinen Ort finden</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Fit the film, too</source>
        <translation>Auch die Folie anpassen</translation>
    </message>
    <message>
        <source>Fit to drawing</source>
        <translation>An Zeichnung anpassen</translation>
    </message>
    <message>
        <source>Fitting the pattern</source>
        <translation>Das Schnittmuster wird angepasst</translation>
    </message>
    <message>
        <source>Flat pieces</source>
        <translation>Flache Stücke</translation>
    </message>
    <message>
        <source>Flattening needs scipy: install it with pip install scipy.</source>
        <translation>Das Abwickeln braucht scipy: mit pip install scipy installieren.</translation>
    </message>
    <message>
        <source>Flower</source>
        <translation>Blume</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Folder for the artwork</source>
        <translation>Ordner für die Bildvorlage</translation>
    </message>
    <message>
        <source>Follow every change at once</source>
        <translation>Jeder Änderung sofort folgen</translation>
    </message>
    <message>
        <source>Follows the body</source>
        <translation>Folgt dem Körper</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>For Send to Silhouette of inkscape-silhouette. It looks for four marks, which lie on the layer Regmarks, are not cut, 10 mm from the edges of A4 and 190 and 277 mm apart: give that there, and four marks. Nothing is cut outside them. For other paper change page_mm in a copy.</source>
        <translation>Für Send to Silhouette von inkscape-silhouette. Es sucht vier Marken, die auf der Ebene Regmarks liegen, nicht geschnitten werden, 10 mm von den Rändern von A4 und 190 und 277 mm auseinander: geben Sie das dort ein, und vier Marken. Außerhalb davon wird nichts geschnitten. Für anderes Papier ändern Sie page_mm in einer Kopie.</translation>
    </message>
    <message>
        <source>For Send to Silhouette of inkscape-silhouette. The marks of a print lie on the layer Regmarks, which is not cut, 10 mm from the edges of A4 and 190 and 277 mm apart: give that there. Nothing is cut outside them. For other paper change page_mm in a copy.</source>
        <translation>Für Send to Silhouette von inkscape-silhouette. Die Marken eines Drucks liegen auf der Ebene Regmarks, die nicht geschnitten wird, 10 mm von den Rändern von A4 und 190 und 277 mm auseinander: geben Sie das dort ein. Außerhalb davon wird nichts geschnitten. Für anderes Papier ändern Sie page_mm in einer Kopie.</translation>
    </message>
    <message>
        <source>For {0} of {1} pieces there is no room on the remnant: give film for the rest too.</source>
        <translation>Für {0} von {1} Stücken ist auf dem Reststück kein Platz: geben Sie auch Folie für den Rest.</translation>
    </message>
    <message>
        <source>For {0} the drawing would be {1} large: choose a volume that makes it {2} to {3}.</source>
        <translation>Für {0} würde die Zeichnung {1} groß: ein Volumen wählen, das sie {2} bis {3} groß macht.</translation>
    </message>
    <message>
        <source>Forced</source>
        <translation>Erzwungen</translation>
    </message>
    <message>
        <source>Forget earlier photographs</source>
        <translation>Frühere Fotos vergessen</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Frames are even in movement, not in time. Only the film has mass, the gas has none.</source>
        <translation>Die Bilder sind gleichmäßig in der Bewegung, nicht in der Zeit. Nur die Folie hat Masse, das Gas keine.</translation>
    </message>
    <message>
        <source>FreeCAD does not start beside this one ({0}): install it for the Python that runs there.</source>
        <translation>Neben diesem startet kein weiteres FreeCAD ({0}): es für das Python installieren, das dort läuft.</translation>
    </message>
    <message>
        <source>FreeCAD failed while {0} ({1}). {2}</source>
        <translation>FreeCAD scheiterte {0} ({1}). {2}</translation>
    </message>
    <message>
        <source>FreeCAD has no material card "{0}": choose one of its material editor.</source>
        <translation>FreeCAD hat keine Materialkarte „{0}“: eine aus dem Materialeditor wählen.</translation>
    </message>
    <message>
        <source>FreeCAD needs a home folder and a temporary folder that it can write to, and enough memory.</source>
        <translation>Es braucht ein Benutzerverzeichnis und einen temporären Ordner, in die es schreiben kann, und Arbeitsspeicher.</translation>
    </message>
    <message>
        <source>FreeCAD stopped while {0} ({1}). {2}</source>
        <translation>FreeCAD brach {0} ab ({1}). {2}</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>From the flat film to the balloon at rest</source>
        <translation>Von der flachen Folie bis zum Ballon in Ruhe</translation>
    </message>
    <message>
        <source>From this value, with its unit</source>
        <translation>Von diesem Wert, mit Einheit</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorderseite</translation>
    </message>
    <message>
        <source>Front and back as PNG and PDF, and as DXF and SVG with the same marks for the cutter</source>
        <translation>Vorder- und Rückseite als PNG und PDF sowie als DXF und SVG mit denselben Marken für die Schneidemaschine</translation>
    </message>
    <message>
        <source>Front, back and a band between them: change its width</source>
        <translation>Vorderseite, Rückseite und ein Band dazwischen: seine Breite ändern</translation>
    </message>
    <message>
        <source>G-code, and no other format, has a tool: give both or none.</source>
        <translation>G-Code, und kein anderes Format, hat ein Werkzeug: beides oder keines angeben.</translation>
    </message>
    <message>
        <source>GRBL knows X, Y and Z only: leave turning_axis out, or take LinuxCNC or Marlin where an axis turns the tool.</source>
        <translation>GRBL kennt nur X, Y und Z: turning_axis weglassen, oder LinuxCNC oder Marlin nehmen, wo eine Achse das Werkzeug dreht.</translation>
    </message>
    <message>
        <source>GRBL machine (G-code)</source>
        <translation>GRBL-Maschine (G-Code)</translation>
    </message>
    <message>
        <source>Gaps of up to {0} between lines were closed.</source>
        <translation>Lücken bis {0} zwischen Linien wurden geschlossen.</translation>
    </message>
    <message>
        <source>Gas</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>Gas that it takes, at the pressure outside</source>
        <translation>Benötigtes Gas, beim Druck außen</translation>
    </message>
    <message>
        <source>Give --artwork for the front too.</source>
        <translation>--artwork auch für die Vorderseite angeben.</translation>
    </message>
    <message>
        <source>Give --png or --report html with --ground: it is the ground of these.</source>
        <translation>Geben Sie --png oder --report html zu --ground: davon ist es der Hintergrund.</translation>
    </message>
    <message>
        <source>Give a number of panels, into which the body is divided.</source>
        <translation>Eine Zahl von Bahnen angeben, in die der Körper geteilt wird.</translation>
    </message>
    <message>
        <source>Give a study either "{0}" or "{1}".</source>
        <translation>Einer Studie entweder „{0}“ oder „{1}“ geben.</translation>
    </message>
    <message>
        <source>Give either --material, or all of --young, --poisson and --thickness.</source>
        <translation>Entweder --material angeben oder alle drei: --young, --poisson und --thickness.</translation>
    </message>
    <message>
        <source>Give either --scheduler or --dask.</source>
        <translation>Entweder --scheduler oder --dask angeben.</translation>
    </message>
    <message>
        <source>Give either a volume or a lift as the goal.</source>
        <translation>Entweder ein Volumen oder einen Auftrieb als Ziel angeben.</translation>
    </message>
    <message>
        <source>Give one or two settings several values, such as 200, 300, 400, and each of the others one.</source>
        <translation>Geben Sie einer oder zwei Einstellungen mehrere Werte, etwa 200, 300, 400, und jeder anderen einen.</translation>
    </message>
    <message>
        <source>Give the document the values of the chosen row</source>
        <translation>Dem Dokument die Werte der gewählten Zeile geben</translation>
    </message>
    <message>
        <source>Give {0} either "{1}" or "{2}", {3}.</source>
        <translation>{0} entweder „{1}“ oder „{2}“ geben, {3}.</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Gegeben</translation>
    </message>
    <message>
        <source>Glowforge</source>
        <translation>Glowforge</translation>
    </message>
    <message>
        <source>Glue</source>
        <translation>Kleber</translation>
    </message>
    <message>
        <source>Glue a strip of {seal} along the dashed line. Let it dry under a weight.</source>
        <translation>Entlang der gestrichelten Linie einen Streifen von {seal} kleben. Unter einem Gewicht trocknen lassen.</translation>
    </message>
    <message>
        <source>Glue a strip of {seal} along the dashed line; leave the mouth of the neck open. Let it dry under a weight.</source>
        <translation>Entlang der gestrichelten Linie einen Streifen von {seal} kleben; die Mündung des Halses offen lassen. Unter einem Gewicht trocknen lassen.</translation>
    </message>
    <message>
        <source>Glue the lines inside the balloon.</source>
        <translation>Die Linien im Inneren des Ballons kleben.</translation>
    </message>
    <message>
        <source>Glue the seams. Stiffer along the web than across it; E is the geometric mean. Does not hold gas for long and creases sharply.</source>
        <translation>Die Nähte kleben. Entlang der Bahn steifer als quer; E ist das geometrische Mittel. Hält Gas nicht lange und knickt scharf.</translation>
    </message>
    <message>
        <source>Glue the seams. Stiffer along the web than across it; E is the geometric mean. Porous: for a moment's inflation or with a lining.</source>
        <translation>Die Nähte kleben. Entlang der Bahn steifer als quer; E ist das geometrische Mittel. Porös: für kurzes Aufblasen oder mit Futter.</translation>
    </message>
    <message>
        <source>Glued seam</source>
        <translation>Geklebte Naht</translation>
    </message>
    <message>
        <source>Gores</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Laufrichtung</translation>
    </message>
    <message>
        <source>Grain lies</source>
        <translation>Laufrichtung liegt</translation>
    </message>
    <message>
        <source>Graphtec with ARMS (vinyl cutter)</source>
        <translation>Graphtec mit ARMS (Folienschneider)</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>HPGL is written as polylines: give "arcs": false.</source>
        <translation>HPGL wird als Polylinien geschrieben: "arcs": false angeben.</translation>
    </message>
    <message>
        <source>HPGL plotter or vinyl cutter</source>
        <translation>HPGL-Plotter oder Folienschneider</translation>
    </message>
    <message>
        <source>Half the outline and its axis; a copy of it travels in the document</source>
        <translation>Der halbe Umriss und seine Achse; eine Kopie davon reist im Dokument mit</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Herz</translation>
    </message>
    <message>
        <source>Heart from a spreadsheet</source>
        <translation>Herz aus einer Tabelle</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Wärme</translation>
    </message>
    <message>
        <source>Heat sealer on a plotter</source>
        <translation>Heißsiegler auf einem Plotter</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height between two lines; empty: 5 mm</source>
        <translation>Höhe zwischen zwei Linien; leer: 5 mm</translation>
    </message>
    <message>
        <source>Helium</source>
        <translation>Helium</translation>
    </message>
    <message>
        <source>High frequency</source>
        <translation>Hochfrequenz</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}'</source>
        <translation>Loch {0} der Bahn „{1}“</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}' lies outside its film. Move it, or take it out.</source>
        <translation>Loch {0} der Bahn „{1}“ liegt außerhalb ihrer Folie. Es verschieben oder herausnehmen.</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}' runs counter-clockwise. Turn the order of its points round.</source>
        <translation>Loch {0} der Bahn „{1}“ läuft gegen den Uhrzeigersinn. Die Reihenfolge seiner Punkte umkehren.</translation>
    </message>
    <message>
        <source>Holes from</source>
        <translation>Löcher ab</translation>
    </message>
    <message>
        <source>Holes of the mesh that were closed: {0}.</source>
        <translation>Löcher des Netzes, die geschlossen wurden: {0}.</translation>
    </message>
    <message>
        <source>Home, then set X0 Y0 at the lower left corner of the film and Z0 where the tip touches the layer over it (G92); nothing homes. Lay baking paper or PTFE between tip and film, tape the film flat.</source>
        <translation>Referenzfahrt machen, dann X0 Y0 auf die linke untere Ecke der Folie setzen und Z0 dorthin, wo die Spitze die Lage über ihr berührt (G92); die Datei macht keine Referenzfahrt. Backpapier oder PTFE zwischen Spitze und Folie legen, die Folie flach festkleben.</translation>
    </message>
    <message>
        <source>Hot tip</source>
        <translation>Heiße Spitze</translation>
    </message>
    <message>
        <source>Hot wheel</source>
        <translation>Heißes Rad</translation>
    </message>
    <message>
        <source>Hours of welding, where they are known</source>
        <translation>Stunden des Schweißens, wo sie bekannt sind</translation>
    </message>
    <message>
        <source>How a balloon follows its pattern can be worked out for an elastic weld alone: choose that one.</source>
        <translation>Wie ein Ballon seinem Schnittmuster folgt, lässt sich nur für eine elastische Naht berechnen: diese wählen.</translation>
    </message>
    <message>
        <source>How far a closed cut runs past its start; empty: six times the knife's offset</source>
        <translation>Wie weit ein geschlossener Schnitt über seinen Anfang hinausläuft; leer: das Sechsfache des Messerversatzes</translation>
    </message>
    <message>
        <source>How far a closed weld runs past its start, so that the joint is tight</source>
        <translation>Wie weit eine geschlossene Schweißnaht über ihren Anfang hinausläuft, damit der Stoß dicht ist</translation>
    </message>
    <message>
        <source>How far a swivel knife or wheel lies behind its axis; 0 where the machine makes up for it</source>
        <translation>Wie weit ein Schleppmesser oder Rad hinter seiner Achse liegt; 0, wo die Maschine das ausgleicht</translation>
    </message>
    <message>
        <source>How far along it</source>
        <translation>Wie weit daran entlang</translation>
    </message>
    <message>
        <source>How far along its seam the opening is must be from 0 to 1.</source>
        <translation>Wie weit die Öffnung entlang ihrer Naht liegt, muss von 0 bis 1 sein.</translation>
    </message>
    <message>
        <source>How far below the place where it touches the film it works: it presses so hard, or cuts so deep; of a laser its focus. Empty: not known yet</source>
        <translation>Wie weit es unter der Stelle arbeitet, an der es die Folie berührt: so fest drückt oder so tief schneidet es; beim Laser sein Fokus. Leer: noch nicht bekannt</translation>
    </message>
    <message>
        <source>How far the balloon may be from the body on average, of the body's diagonal</source>
        <translation>Wie weit der Ballon im Mittel vom Körper entfernt sein darf, gemessen an dessen Diagonale</translation>
    </message>
    <message>
        <source>How far the outline moves if the weld creases could not be simulated. {0}</source>
        <translation>Wie weit sich der Umriss verschiebt, wenn die Naht knittert, konnte nicht simuliert werden. {0}</translation>
    </message>
    <message>
        <source>How far weld and film reach beyond the seam in the photograph; empty: as in the pattern, 0: folded back</source>
        <translation>Wie weit Schweißnaht und Folie im Foto über die Nahtlinie hinausreichen; leer: wie im Schnittmuster, 0: zurückgeklappt</translation>
    </message>
    <message>
        <source>How fast it goes along a line; empty: not known yet</source>
        <translation>Wie schnell es eine Linie entlangfährt; leer: noch nicht bekannt</translation>
    </message>
    <message>
        <source>How long a way from waste film to a weld may be; 0 for none</source>
        <translation>Wie lang ein Weg von der Abfallfolie zur Schweißnaht sein darf; 0 für keinen</translation>
    </message>
    <message>
        <source>How long it waits before it moves along a line: film warms, a beam burns in, a spindle starts</source>
        <translation>Wie lange es wartet, ehe es eine Linie entlangfährt: Folie wird warm, ein Strahl brennt ein, eine Spindel läuft an</translation>
    </message>
    <message>
        <source>How wide shall it be?</source>
        <translation>Wie breit soll er werden?</translation>
    </message>
    <message>
        <source>Hydrogen</source>
        <translation>Wasserstoff</translation>
    </message>
    <message>
        <source>If the weld creases</source>
        <translation>Wenn die Naht knittert</translation>
    </message>
    <message>
        <source>If the weld creases, the outline may lie up to {0} away near {1}.</source>
        <translation>Wenn die Naht knittert, kann der Umriss nahe {1} bis zu {0} daneben liegen.</translation>
    </message>
    <message>
        <source>If the weld creases: {0} on average, at most {1}</source>
        <translation>Wenn die Naht knittert: im Mittel {0}, höchstens {1}</translation>
    </message>
    <message>
        <source>In no seam yet: {}</source>
        <translation>Noch in keiner Naht: {}</translation>
    </message>
    <message>
        <source>In {0} of {1} samples the pressure is above the safe one: fill it less.</source>
        <translation>In {0} von {1} Stichproben ist der Druck höher als der sichere: weniger füllen.</translation>
    </message>
    <message>
        <source>Inflate as drawn</source>
        <translation>Wie gezeichnet aufblasen</translation>
    </message>
    <message>
        <source>Inflate now</source>
        <translation>Jetzt aufblasen</translation>
    </message>
    <message>
        <source>Inflate with these values and show the balloon</source>
        <translation>Mit diesen Werten aufblasen und den Ballon zeigen</translation>
    </message>
    <message>
        <source>Inflated</source>
        <translation>Aufgeblasen</translation>
    </message>
    <message>
        <source>Inflating</source>
        <translation>Aufblasen</translation>
    </message>
    <message>
        <source>Inflating in time</source>
        <translation>Zeitliches Aufblasen</translation>
    </message>
    <message>
        <source>Inflating {0}</source>
        <translation>{0} wird aufgeblasen</translation>
    </message>
    <message>
        <source>Inflation</source>
        <translation>Aufblasen</translation>
    </message>
    <message>
        <source>Ink, or a slip of baking paper</source>
        <translation>Tinte oder ein Stück Backpapier</translation>
    </message>
    <message>
        <source>Inkscape</source>
        <translation>Inkscape</translation>
    </message>
    <message>
        <source>Intake</source>
        <translation>Füllhals</translation>
    </message>
    <message>
        <source>Intake in a side part</source>
        <translation>Füllhals in einem Nebenteil</translation>
    </message>
    <message>
        <source>Intake on a thin part</source>
        <translation>Füllhals an einem dünnen Teil</translation>
    </message>
    <message>
        <source>It came with the workbench: copy it to set it up as your own.</source>
        <translation>Sie kam mit dem Arbeitsbereich: kopieren Sie sie, um sie als Ihre eigene einzurichten.</translation>
    </message>
    <message>
        <source>It holds {} of the air that a round balloon of as much film would.</source>
        <translation>Er fasst {} der Luft, die ein runder Ballon aus ebenso viel Folie fassen würde.</translation>
    </message>
    <message>
        <source>It is filled to {0}, its safe pressure is {1}: fill it less.</source>
        <translation>Er wird auf {0} gefüllt, sein sicherer Druck ist {1}: füllen Sie ihn weniger.</translation>
    </message>
    <message>
        <source>It is not inflated yet: choose Inflate now in its context menu, or switch Live on.</source>
        <translation>Er ist noch nicht aufgeblasen: im Kontextmenü „Jetzt aufblasen“ wählen oder Live einschalten.</translation>
    </message>
    <message>
        <source>It is not repeated on the other side. {0}</source>
        <translation>Auf der anderen Seite wird das nicht wiederholt. {0}</translation>
    </message>
    <message>
        <source>It is wider now. Ctrl+Z takes that back.</source>
        <translation>Jetzt ist er breiter. Strg+Z nimmt das zurück.</translation>
    </message>
    <message>
        <source>It lies</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>It meets what it was designed for</source>
        <translation>Er erfüllt, wofür er entworfen wurde</translation>
    </message>
    <message>
        <source>It needs more places: give them all.</source>
        <translation>Es fehlen Stellen: alle angeben.</translation>
    </message>
    <message>
        <source>It takes {0} h at {1} m/min and {2} min for each seam.</source>
        <translation>Es dauert {0} h bei {1} m/min und {2} min für jede Naht.</translation>
    </message>
    <message>
        <source>It took longer than {0} s: take a coarser mesh, or raise --timeout.</source>
        <translation>Er brauchte länger als {0} s: ein gröberes Netz nehmen oder --timeout erhöhen.</translation>
    </message>
    <message>
        <source>Its pattern is gone: delete it.</source>
        <translation>Sein Schnittmuster fehlt: dieses Stück löschen.</translation>
    </message>
    <message>
        <source>Its process ended with {0} ({1}).</source>
        <translation>Sein Prozess endete mit {0} ({1}).</translation>
    </message>
    <message>
        <source>Its process was ended by {0}.</source>
        <translation>Sein Prozess wurde durch {0} beendet.</translation>
    </message>
    <message>
        <source>Its process was ended by {0}. It may have lacked memory: take a coarser mesh.</source>
        <translation>Sein Prozess wurde durch {0} beendet. Vielleicht fehlte Arbeitsspeicher: ein gröberes Netz nehmen.</translation>
    </message>
    <message>
        <source>Its process was ended by {0}.{1}</source>
        <translation>Sein Prozess wurde durch {0} beendet.{1}</translation>
    </message>
    <message>
        <source>Its workers were killed again and again: take a coarser mesh, or start it again.</source>
        <translation>Seine Worker wurden immer wieder abgebrochen: ein gröberes Netz nehmen oder ihn noch einmal starten.</translation>
    </message>
    <message>
        <source>JSON</source>
        <translation>JSON</translation>
    </message>
    <message>
        <source>Jobs of a study is 0 or more: 0 takes one for each processor.</source>
        <translation>Jobs einer Studie ist 0 oder mehr: 0 nimmt einen je Prozessor.</translation>
    </message>
    <message>
        <source>Join the panels along the dashed line, {seal} wide, all the way round.</source>
        <translation>Die Bahnen entlang der gestrichelten Linie verbinden, {seal} breit, rundherum.</translation>
    </message>
    <message>
        <source>Join the panels along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>Die Bahnen entlang der gestrichelten Linie verbinden, {seal} breit; die Mündung des Halses offen lassen.</translation>
    </message>
    <message>
        <source>Join the panels along the lines inside the balloon.</source>
        <translation>Die Bahnen entlang der Linien im Inneren des Ballons verbinden.</translation>
    </message>
    <message>
        <source>Joined</source>
        <translation>Verbunden</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keep the best</source>
        <translation>Bestes behalten</translation>
    </message>
    <message>
        <source>Keep the film</source>
        <translation>Folie behalten</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Seitenverhältnis beibehalten</translation>
    </message>
    <message>
        <source>Keep what is left</source>
        <translation>Rest aufheben</translation>
    </message>
    <message>
        <source>Keep what is left...</source>
        <translation>Rest aufheben ...</translation>
    </message>
    <message>
        <source>Kept, and offered by Export pattern: {}</source>
        <translation>Behalten, und von Schnittmuster ausgeben angeboten: {}</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Schnittfuge</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Messer</translation>
    </message>
    <message>
        <source>Knife offset</source>
        <translation>Messerversatz</translation>
    </message>
    <message>
        <source>Kraft paper, 80 g/m²</source>
        <translation>Kraftpapier, 80 g/m²</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Labels need matplotlib: install it with pip install matplotlib, or leave the label empty.</source>
        <translation>Beschriftungen brauchen matplotlib: mit pip install matplotlib installieren oder die Beschriftung leer lassen.</translation>
    </message>
    <message>
        <source>Laid flat</source>
        <translation>Flach ausgelegt</translation>
    </message>
    <message>
        <source>Laid one piece after another: the package spyrrow (pip install spyrrow) often finds a closer layout.</source>
        <translation>Stück für Stück ausgelegt: Das Paket spyrrow (pip install spyrrow) findet oft eine dichtere Anordnung.</translation>
    </message>
    <message>
        <source>Largest strain</source>
        <translation>Größte Dehnung</translation>
    </message>
    <message>
        <source>Largest tension of the film</source>
        <translation>Größte Spannung der Folie</translation>
    </message>
    <message>
        <source>Laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>Lay a picture under the paper for tracing; press again to take it away</source>
        <translation>Ein Bild zum Nachzeichnen unter das Papier legen; noch einmal drücken nimmt es weg</translation>
    </message>
    <message>
        <source>Lay both valve strips on each other, their lines together. On the field marked on VALVE, INK put heat-resistant ink, or a slip of baking paper between the strips. Weld them along both long lines.</source>
        <translation>Beide Ventilstreifen Linie auf Linie aufeinanderlegen. Auf das markierte Feld von VALVE, INK hitzefeste Tinte geben oder dort ein Stück Backpapier zwischen die Streifen legen. Entlang beider langen Linien verschweißen.</translation>
    </message>
    <message>
        <source>Lay edges of the same number on each other, inner sides together: arrows the same way, the lines across the weld and the notches on each other. Tape outside the cut.</source>
        <translation>Kanten mit derselben Nummer aufeinanderlegen, Innenseiten zueinander: die Pfeile gleich gerichtet, die Striche quer zur Schweißnaht und die Kerben aufeinander. Außerhalb des Schnitts festkleben.</translation>
    </message>
    <message>
        <source>Lay out</source>
        <translation>Auslegen</translation>
    </message>
    <message>
        <source>Lay out anew</source>
        <translation>Neu auslegen</translation>
    </message>
    <message>
        <source>Lay out on film</source>
        <translation>Auf Folie auslegen</translation>
    </message>
    <message>
        <source>Lay the grain of all panels along the line with two arrowheads.</source>
        <translation>Die Laufrichtung aller Bahnen entlang der Linie mit zwei Pfeilspitzen legen.</translation>
    </message>
    <message>
        <source>Lay the grain of both panels the same way.</source>
        <translation>Die Laufrichtung beider Bahnen gleich legen.</translation>
    </message>
    <message>
        <source>Lay the panels on each other, sealing sides inward. Line them up by the notches or edges; tape outside the cut.</source>
        <translation>Die Bahnen mit den Siegelseiten nach innen aufeinanderlegen. An Passkerben oder Kanten ausrichten; außerhalb des Schnitts mit Klebeband fixieren.</translation>
    </message>
    <message>
        <source>Lay the panels on each other. Line them up by the notches or edges; tape outside the cut.</source>
        <translation>Die Bahnen aufeinanderlegen. An Passkerben oder Kanten ausrichten; außerhalb des Schnitts mit Klebeband fixieren.</translation>
    </message>
    <message>
        <source>Lay the strips into the neck of one panel, end at the mouth, line on line. Tack them to this panel only, with two spots of weld on the line, beside the channel.</source>
        <translation>Die Streifen in den Hals einer Bahn legen, Ende an der Mündung, Linie auf Linie. Nur an diese Bahn heften, mit zwei Schweißpunkten auf der Linie, neben dem Kanal.</translation>
    </message>
    <message>
        <source>Layers, millimetres and arcs, to go on drawing.</source>
        <translation>Ebenen, Millimeter und Bögen, zum Weiterzeichnen.</translation>
    </message>
    <message>
        <source>Laying out {0}</source>
        <translation>{0} wird ausgelegt</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Anfahrweg</translation>
    </message>
    <message>
        <source>Leak test: fill with air through a tube in the neck, closed round it by hand or with tape, to at most {column} of water in a hose. Wait 15 min, brush soapy water along the seams. Mark with a pen where bubbles grow, let the air out, dry it, seal there once more, test again.</source>
        <translation>Dichtprobe: durch einen Schlauch im Hals, mit der Hand oder mit Band darum geschlossen, mit Luft füllen, bis höchstens {column} Wassersäule in einem Schlauch. 15 min warten, Seifenwasser auf die Nähte streichen. Mit einem Stift anzeichnen, wo Blasen wachsen, die Luft ablassen, trocknen, dort noch einmal schweißen, wieder prüfen.</translation>
    </message>
    <message>
        <source>Leak test: fill with air to at most {column} of water in a hose. Wait 15 min, brush soapy water along the seams. Mark with a pen where bubbles grow, let the air out, dry it, seal there once more, test again.</source>
        <translation>Dichtprobe: mit Luft füllen, bis höchstens {column} Wassersäule in einem Schlauch. 15 min warten, Seifenwasser auf die Nähte streichen. Mit einem Stift anzeichnen, wo Blasen wachsen, die Luft ablassen, trocknen, dort noch einmal schweißen, wieder prüfen.</translation>
    </message>
    <message>
        <source>Leave tabs so wide in the cuts, such as 0.4 mm, on straights, two or more on each and one in 100 mm, so that pieces stay in the film. It is kept for this machine</source>
        <translation>So breite Stege in den Schnitten lassen, etwa 0,4 mm, auf geraden Stücken, zwei oder mehr in jedem und einer auf 100 mm, damit die Stücke in der Folie bleiben. Das wird für diese Maschine behalten</translation>
    </message>
    <message>
        <source>Left out: {0}</source>
        <translation>Weggelassen: {0}</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of a gore</source>
        <translation>Länge eines Segments</translation>
    </message>
    <message>
        <source>Length of the seams</source>
        <translation>Länge der Nähte</translation>
    </message>
    <message>
        <source>Length of the usual roll that it takes</source>
        <translation>Benötigte Länge der üblichen Rolle</translation>
    </message>
    <message>
        <source>Let all pieces lie as the pattern lays them</source>
        <translation>Alle Stücke so legen, wie das Schnittmuster sie legt</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Buchstabe</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>Buchstabenhöhe</translation>
    </message>
    <message>
        <source>Letter with a side band</source>
        <translation>Buchstabe mit Seitenband</translation>
    </message>
    <message>
        <source>Letters on a ground that makes one balloon of them</source>
        <translation>Buchstaben auf einem Grund, der aus ihnen einen Ballon macht</translation>
    </message>
    <message>
        <source>Letters, digits, spaces and - only</source>
        <translation>Nur Buchstaben, Ziffern, Leerzeichen und -</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Auftrieb</translation>
    </message>
    <message>
        <source>Lift in g</source>
        <translation>Auftrieb in g</translation>
    </message>
    <message>
        <source>Lift needs vertices of the balloon that hold it. Give those of its lower end.</source>
        <translation>Auftrieb braucht Knoten des Ballons, die ihn halten. Die des unteren Endes angeben.</translation>
    </message>
    <message>
        <source>LightBurn (laser)</source>
        <translation>LightBurn (Laser)</translation>
    </message>
    <message>
        <source>LightBurn has too few layers for panels in holes of panels: lay out fewer.</source>
        <translation>LightBurn hat zu wenige Ebenen für Teile in Löchern von Teilen: weniger auslegen.</translation>
    </message>
    <message>
        <source>LightBurn project (laser)</source>
        <translation>LightBurn-Projekt (Laser)</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Lines it inside</source>
        <translation>Kleidet ihn innen aus</translation>
    </message>
    <message>
        <source>Lines that close around nothing beside the shapes were left out.</source>
        <translation>Linien neben den Formen, die nichts umschließen, wurden weggelassen.</translation>
    </message>
    <message>
        <source>Lines up to</source>
        <translation>Linien bis</translation>
    </message>
    <message>
        <source>LinuxCNC machine (G-code)</source>
        <translation>LinuxCNC-Maschine (G-Code)</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Longest piece of the band</source>
        <translation>Längstes Stück des Bands</translation>
    </message>
    <message>
        <source>Look for the closest layout; Esc takes the best one so far</source>
        <translation>Die dichteste Anordnung suchen; Esc nimmt die bisher beste</translation>
    </message>
    <message>
        <source>Loose ends of lines were joined to the drawing.</source>
        <translation>Lose Linienenden wurden mit der Zeichnung verbunden.</translation>
    </message>
    <message>
        <source>Loose film: {0}, wrinkled: {1}; wrinkles hide {2} of it</source>
        <translation>Schlaffe Folie: {0}, faltig: {1}; Falten verbergen {2} davon</translation>
    </message>
    <message>
        <source>Low</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Lower end</source>
        <translation>Unteres Ende</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Made with brush and pen: double-click the Outline to paint on</source>
        <translation>Mit Pinsel und Stift gemacht: zum Weitermalen auf den Umriss doppelklicken</translation>
    </message>
    <message>
        <source>Make a card</source>
        <translation>Karte machen</translation>
    </message>
    <message>
        <source>Make a machine of your own with the values of this one</source>
        <translation>Eine eigene Maschine mit den Werten dieser machen</translation>
    </message>
    <message>
        <source>Make a sketch of the cuts</source>
        <translation>Eine Skizze der Schnitte machen</translation>
    </message>
    <message>
        <source>Make a test card: nobody states a temperature for this film.</source>
        <translation>Machen Sie eine Testkarte: für diese Folie gibt niemand eine Temperatur an.</translation>
    </message>
    <message>
        <source>Make it!</source>
        <translation>Mach ihn!</translation>
    </message>
    <message>
        <source>Make rows</source>
        <translation>Zeilen anlegen</translation>
    </message>
    <message>
        <source>Make the balloon smaller and inflate it again, until its pattern fits the bed. Weld and allowance keep their widths; one undo takes it back</source>
        <translation>Den Ballon verkleinern und neu aufblasen, bis sein Schnittmuster auf das Bett passt. Schweißnaht und Zugabe behalten ihre Breite; einmal Rückgängig nimmt es zurück</translation>
    </message>
    <message>
        <source>Making tool paths</source>
        <translation>Werkzeugwege werden erzeugt</translation>
    </message>
    <message>
        <source>Mark a length</source>
        <translation>Länge anzeichnen</translation>
    </message>
    <message>
        <source>Mark a length in the picture, and give its true length, such as 300 mm.</source>
        <translation>Zeichnen Sie eine Länge im Bild an und geben Sie ihre wahre Länge, etwa 300 mm.</translation>
    </message>
    <message>
        <source>Mark a length…</source>
        <translation>Länge anzeichnen…</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>Marks for</source>
        <translation>Marken für</translation>
    </message>
    <message>
        <source>Marlin printer (G-code)</source>
        <translation>Marlin-Drucker (G-Code)</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>May be cut</source>
        <translation>Darf geschnitten werden</translation>
    </message>
    <message>
        <source>Mean distance from the body</source>
        <translation>Mittlerer Abstand vom Körper</translation>
    </message>
    <message>
        <source>Measure (M)</source>
        <translation>Messen (M)</translation>
    </message>
    <message>
        <source>Measured on the inflated balloon.</source>
        <translation>Am aufgeblasenen Ballon gemessen.</translation>
    </message>
    <message>
        <source>Membrane tension</source>
        <translation>Membranspannung</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Vereinen</translation>
    </message>
    <message>
        <source>Mesh reuse needs scipy: install it with pip install scipy.</source>
        <translation>Die Wiederverwendung von Netzen braucht scipy: mit pip install scipy installieren.</translation>
    </message>
    <message>
        <source>Mesh size</source>
        <translation>Netzweite</translation>
    </message>
    <message>
        <source>Mesh size (0: automatic)</source>
        <translation>Netzweite (0: automatisch)</translation>
    </message>
    <message>
        <source>Meshing needs scipy: install it with pip install scipy.</source>
        <translation>Das Vernetzen braucht scipy: mit pip install scipy installieren.</translation>
    </message>
    <message>
        <source>Mimaki with register marks (vinyl cutter)</source>
        <translation>Mimaki mit Passermarken (Folienschneider)</translation>
    </message>
    <message>
        <source>Mind</source>
        <translation>Achtung</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Mirror piece</source>
        <translation>Stück spiegeln</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>More gores hardly help: change the profile.</source>
        <translation>Mehr Segmente helfen kaum: das Profil ändern.</translation>
    </message>
    <message>
        <source>More: text, stamps, layers, symmetry, any colour (Q)</source>
        <translation>Mehr: Text, Stempel, Ebenen, Symmetrie, beliebige Farbe (Q)</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Move piece</source>
        <translation>Stück verschieben</translation>
    </message>
    <message>
        <source>Move the pointer to bend the line, then click. Esc drops it.</source>
        <translation>Zum Biegen den Zeiger bewegen, dann klicken. Esc verwirft die Linie.</translation>
    </message>
    <message>
        <source>Move, add and remove nodes of the outline in a tab, over the picture</source>
        <translation>Knoten des Umrisses verschieben, hinzufügen und entfernen, in einem Reiter über dem Bild</translation>
    </message>
    <message>
        <source>My machines</source>
        <translation>Meine Maschinen</translation>
    </message>
    <message>
        <source>My {}</source>
        <translation>Meine {}</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Name der Maschine</translation>
    </message>
    <message>
        <source>Native</source>
        <translation>Nativ</translation>
    </message>
    <message>
        <source>Natural shape</source>
        <translation>Natürliche Form</translation>
    </message>
    <message>
        <source>Near {0} the film stays {1} from the body, which is too thin or too sharp there for panels. Cut such a part off, or divide the body along it.</source>
        <translation>Nahe {0} bleibt die Folie {1} vom Körper entfernt, der dort zu dünn oder zu spitz für Bahnen ist. Einen solchen Teil abschneiden oder den Körper an ihm entlang teilen.</translation>
    </message>
    <message>
        <source>Near {0} the inflated outline stays up to {1} from the drawing, over a length of {2}: film cannot follow it there. Round it off or widen it.</source>
        <translation>Nahe {0} bleibt der aufgeblasene Umriss bis zu {1} von der Zeichnung entfernt, auf {2} Länge: Die Folie kann ihr dort nicht folgen. Die Stelle runden oder verbreitern.</translation>
    </message>
    <message>
        <source>Near {0} the inflated outline stays up to {1} from the drawing, over a length of {2}: the balloon folds across a hole or a spot. Make that larger, or leave it out.</source>
        <translation>Nahe {0} bleibt der aufgeblasene Umriss bis zu {1} von der Zeichnung entfernt, auf {2} Länge: Der Ballon faltet sich quer über ein Loch oder einen Schweißpunkt. Dieses Loch oder diesen Punkt vergrößern oder weglassen.</translation>
    </message>
    <message>
        <source>Neck that chokes the air path</source>
        <translation>Engstelle, die die Luft drosselt</translation>
    </message>
    <message>
        <source>Needed</source>
        <translation>Benötigt</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source>Never cut PVC with a laser: it gives off hydrogen chloride, which is toxic and ruins the machine. Weld with high frequency or hot air. Stretches visibly: at 2 kPa the shape depends on the grade and on the pressure.</source>
        <translation>PVC nie mit dem Laser schneiden: Es gibt Chlorwasserstoff ab, der giftig ist und die Maschine zerstört. Mit Hochfrequenz oder Heißluft schweißen. Dehnt sich sichtbar: Bei 2 kPa hängt die Form von der Sorte und vom Druck ab.</translation>
    </message>
    <message>
        <source>Never cut this film with a laser.</source>
        <translation>Diese Folie nie mit dem Laser schneiden.</translation>
    </message>
    <message>
        <source>New bag of panels</source>
        <translation>Neuer Beutel aus Bahnen</translation>
    </message>
    <message>
        <source>New balloon from body</source>
        <translation>Neuer Ballon aus Volumenkörper</translation>
    </message>
    <message>
        <source>New balloon from picture</source>
        <translation>Neuer Ballon aus Bild</translation>
    </message>
    <message>
        <source>New balloon from sketch</source>
        <translation>Neuer Ballon aus Skizze</translation>
    </message>
    <message>
        <source>New balloons</source>
        <translation>Neue Ballons</translation>
    </message>
    <message>
        <source>New body of gores</source>
        <translation>Neuer Körper aus Segmenten</translation>
    </message>
    <message>
        <source>New, laid beside the others: {}.</source>
        <translation>Neu, neben die anderen gelegt: {}.</translation>
    </message>
    <message>
        <source>Newmark</source>
        <translation>Newmark</translation>
    </message>
    <message>
        <source>No axis turns a {0}: leave {1} out.</source>
        <translation>Keine Achse dreht dieses Werkzeug ({0}): {1} weglassen.</translation>
    </message>
    <message>
        <source>No balloon came within {0} of the body's diagonal: tried were {1} panels. This is the nearest one, {2}. Ask for less, or divide the body yourself where the film stays far from it.</source>
        <translation>Kein Ballon kam dem Körper auf {0} seiner Diagonale nahe: versucht wurden {1} Bahnen. Dies ist der nächste, {2}. Weniger verlangen oder den Körper dort selbst teilen, wo die Folie weit von ihm entfernt bleibt.</translation>
    </message>
    <message>
        <source>No balloon can be inflated anew without it; patterns can be changed and written.</source>
        <translation>Ohne es kann kein Ballon neu aufgeblasen werden; Schnittmuster können geändert und geschrieben werden.</translation>
    </message>
    <message>
        <source>No balloon has {0} and {1}: these limits exclude each other.</source>
        <translation>Kein Ballon hat {0} und {1}: Diese Grenzen schließen einander aus.</translation>
    </message>
    <message>
        <source>No file could be made.</source>
        <translation>Es konnte keine Datei erstellt werden.</translation>
    </message>
    <message>
        <source>No file for {0}: {1}</source>
        <translation>Keine Datei für {0}: {1}</translation>
    </message>
    <message>
        <source>No file is like '{0}' in '{1}'. Check the pattern and the folder.</source>
        <translation>Keine Datei wie „{0}“ in „{1}“. Suchmuster und Ordner prüfen.</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Keine Grenze</translation>
    </message>
    <message>
        <source>No longer in the pattern, with their places: {}.</source>
        <translation>Nicht mehr im Schnittmuster, mit ihren Plätzen: {}.</translation>
    </message>
    <message>
        <source>No number of panels up to {} comes so near. {} panels: about {} off</source>
        <translation>Keine Zahl von Bahnen bis {} kommt so nahe. {} Bahnen: etwa {} daneben</translation>
    </message>
    <message>
        <source>No panel has an edge "{0}": choose one of an outline or face of this bag.</source>
        <translation>Keine Bahn hat eine Kante „{0}“: eine Kante eines Umrisses oder einer Fläche dieses Beutels wählen.</translation>
    </message>
    <message>
        <source>No panel of the balloon is cut: make at least one of film.</source>
        <translation>Keine Bahn des Ballons wird geschnitten: mindestens eine aus Folie machen.</translation>
    </message>
    <message>
        <source>No pattern can be drawn anew without it; documents keep theirs.</source>
        <translation>Ohne es kann kein Schnittmuster neu gezeichnet werden; Dokumente behalten ihre.</translation>
    </message>
    <message>
        <source>No pattern here has pieces of "{0}": choose another film.</source>
        <translation>Kein Schnittmuster hat hier Stücke aus „{0}“: eine andere Folie wählen.</translation>
    </message>
    <message>
        <source>No process can be started beside this one ({0}).</source>
        <translation>Neben diesem kann kein Prozess gestartet werden ({0}).</translation>
    </message>
    <message>
        <source>No row of {0} makes sense: {1}</source>
        <translation>Keine Zeile von {0} ergibt einen Sinn: {1}</translation>
    </message>
    <message>
        <source>No seam can be drawn near {0}.</source>
        <translation>Nahe {0} lässt sich keine Naht zeichnen.</translation>
    </message>
    <message>
        <source>No shape in the photograph is like the one that was expected: take it straight from the front, on a plain background without anything else in it.</source>
        <translation>Keine Form auf dem Foto gleicht der erwarteten: es gerade von vorn aufnehmen, vor einem einfarbigen Hintergrund und ohne etwas anderes darauf.</translation>
    </message>
    <message>
        <source>No shape stands out in the picture. Use stronger colours or a plainer background.</source>
        <translation>Im Bild hebt sich keine Form ab. Kräftigere Farben oder einen ruhigeren Hintergrund benutzen.</translation>
    </message>
    <message>
        <source>No size of the balloon fits a bed of {0}: weld, allowance, intake and control bar keep their sizes. Choose another machine.</source>
        <translation>Keine Größe des Ballons passt auf ein Bett von {0}: Schweißnaht, Zugabe, Füllhals und Kontrollbalken behalten ihre Maße. Eine andere Maschine wählen.</translation>
    </message>
    <message>
        <source>No solver works here.</source>
        <translation>Hier arbeitet kein Löser.</translation>
    </message>
    <message>
        <source>No solver works here: {0}</source>
        <translation>Hier arbeitet kein Löser: {0}</translation>
    </message>
    <message>
        <source>No solver works here: {0} Build it or install the package scipy.</source>
        <translation>Hier arbeitet kein Löser: {0} Ihn bauen oder das Paket scipy installieren.</translation>
    </message>
    <message>
        <source>No speed and power are known for {0}, so none are written: set them in LightBurn, or give speed_mm_s and max_power_percent in a file of your machine.</source>
        <translation>Für {0} sind Geschwindigkeit und Leistung unbekannt, darum werden keine geschrieben: sie in LightBurn einstellen, oder speed_mm_s und max_power_percent in einer eigenen Maschinendatei angeben.</translation>
    </message>
    <message>
        <source>No triangle of the mesh has an area. Save the body as a mesh of triangles.</source>
        <translation>Kein Dreieck des Netzes hat eine Fläche. Den Körper als Netz aus Dreiecken speichern.</translation>
    </message>
    <message>
        <source>No worker of Dask can be reached at '{0}' ({1}): start a scheduler and workers, and give its address.</source>
        <translation>Unter „{0}“ ist kein Worker von Dask zu erreichen ({1}): einen Scheduler und Worker starten und dessen Adresse angeben.</translation>
    </message>
    <message>
        <source>No, use NumPy</source>
        <translation>Nein, NumPy benutzen</translation>
    </message>
    <message>
        <source>Nobody but you knows the {0} of your {1} for this film: fill in My machines in FreeCAD, or give {2}.</source>
        <translation>Niemand als Sie kennt {0} für {1} und diese Folie: füllen Sie in FreeCAD Meine Maschinen aus oder geben Sie {2}.</translation>
    </message>
    <message>
        <source>Nobody but you knows this: {}. Give one value, or several to try.</source>
        <translation>Niemand als Sie kennt das: {}. Geben Sie einen Wert oder mehrere zum Probieren.</translation>
    </message>
    <message>
        <source>Nobody states a temperature for this film. Make a test card: weld strips with several temperatures and times, peel them, keep the best.</source>
        <translation>Für diese Folie gibt niemand eine Temperatur an. Machen Sie eine Testkarte: Streifen mit mehreren Temperaturen und Zeiten schweißen, auseinanderziehen, die besten behalten.</translation>
    </message>
    <message>
        <source>Nodes of the outline</source>
        <translation>Knoten des Umrisses</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>None of {0} balloons could be made: the table says why.</source>
        <translation>Keiner von {0} Ballons ließ sich machen: Die Tabelle sagt, warum.</translation>
    </message>
    <message>
        <source>None of {0} balloons is within the limits; the nearest: {1}, asked for {2}.</source>
        <translation>Keiner von {0} Ballons liegt innerhalb der Grenzen; der nächste: {1}, verlangt war {2}.</translation>
    </message>
    <message>
        <source>Not all holes are seen in the photograph: those that are not count as wrong.</source>
        <translation>Auf dem Foto sind nicht alle Löcher zu sehen: die nicht zu sehenden zählen als falsch.</translation>
    </message>
    <message>
        <source>Not possible</source>
        <translation>Nicht möglich</translation>
    </message>
    <message>
        <source>Notch with a stress peak</source>
        <translation>Kerbe mit Spannungsspitze</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Passkerben</translation>
    </message>
    <message>
        <source>Notches of {0} do not end before the weld: the allowance is {1}.</source>
        <translation>Passkerben von {0} enden nicht vor der Schweißnaht: Die Zugabe ist {1}.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Note: {0}</source>
        <translation>Hinweis: {0}</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Nothing can be computed without it; documents open and keep their shapes.</source>
        <translation>Ohne es kann nichts berechnet werden; Dokumente lassen sich öffnen und behalten ihre Formen.</translation>
    </message>
    <message>
        <source>Nothing here writes an MP4: choose a GIF, or install opencv-python-headless with pip.</source>
        <translation>Hier schreibt nichts ein MP4: Wählen Sie ein GIF, oder installieren Sie opencv-python-headless mit pip.</translation>
    </message>
    <message>
        <source>Nothing strays that is called "{0}": choose of {1}.</source>
        <translation>Nichts, was streut, heißt „{0}“: aus {1} wählen.</translation>
    </message>
    <message>
        <source>Nothing to improve.</source>
        <translation>Nichts zu verbessern.</translation>
    </message>
    <message>
        <source>Nothing varies in {0}: write into its first row what does, such as Width.</source>
        <translation>In {0} wird nichts verändert: in die erste Zeile schreiben, was verändert wird, etwa Width.</translation>
    </message>
    <message>
        <source>Nothing varies: give "{0}" a column.</source>
        <translation>Nichts wird verändert: „{0}“ eine Spalte geben.</translation>
    </message>
    <message>
        <source>Now pick the partner of {}.</source>
        <translation>Nun die Partnerkante von {} wählen.</translation>
    </message>
    <message>
        <source>Nowhere on the seam is room for an intake of {0}: choose a narrower one, or a place for it.</source>
        <translation>Nirgends auf der Naht ist Platz für einen Füllhals von {0}: einen schmaleren wählen oder einen Ort für ihn.</translation>
    </message>
    <message>
        <source>Nozzle with flange</source>
        <translation>Stutzen mit Flansch</translation>
    </message>
    <message>
        <source>NumPy computes the same, 20 to 30 times slower.</source>
        <translation>NumPy rechnet dasselbe, 20- bis 30-mal langsamer.</translation>
    </message>
    <message>
        <source>NumPy took 20 to 30 times longer than the native solver, which fetch-solver fetches.</source>
        <translation>NumPy brauchte 20- bis 30-mal so lange wie der native Löser, den fetch-solver herunterlädt.</translation>
    </message>
    <message>
        <source>Number of panels</source>
        <translation>Zahl der Bahnen</translation>
    </message>
    <message>
        <source>Number of values, both ends among them</source>
        <translation>Zahl der Werte, beide Enden mitgezählt</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>OK, then {}</source>
        <translation>OK, dann {}</translation>
    </message>
    <message>
        <source>Of a card one field is kept: give --keep B3, or another one, and --name.</source>
        <translation>Von einer Karte wird ein Feld behalten: Geben Sie --keep B3 oder ein anderes an, und --name.</translation>
    </message>
    <message>
        <source>Of a symmetric outline the other side is edited, too</source>
        <translation>Bei einem symmetrischen Umriss wird auch die andere Seite bearbeitet</translation>
    </message>
    <message>
        <source>Of the bodies of the mesh only the largest is made; all in all there are: {0}.</source>
        <translation>Von den Körpern des Netzes wird nur der größte gemacht; insgesamt sind es: {0}.</translation>
    </message>
    <message>
        <source>Of the film of {0} nothing is left that is large enough to be used again.</source>
        <translation>Von der Folie von {0} ist nichts übrig, was groß genug ist, um wieder gebraucht zu werden.</translation>
    </message>
    <message>
        <source>Of the tip or wheel, 40 to 400 °C. Above 260 °C a layer of PTFE gives off poisonous fumes</source>
        <translation>Der Spitze oder des Rads, 40 bis 400 °C. Über 260 °C gibt eine Schicht PTFE giftige Dämpfe ab</translation>
    </message>
    <message>
        <source>Of {0}: sheet {1}.</source>
        <translation>Aus {0}: Bogen {1}.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Off at most</source>
        <translation>Größte Abweichung</translation>
    </message>
    <message>
        <source>Off it at most</source>
        <translation>Größte Abweichung davon</translation>
    </message>
    <message>
        <source>Off on average</source>
        <translation>Mittlere Abweichung</translation>
    </message>
    <message>
        <source>Off the body</source>
        <translation>Neben dem Körper</translation>
    </message>
    <message>
        <source>Off the drawing</source>
        <translation>Neben der Zeichnung</translation>
    </message>
    <message>
        <source>Off the drawing, profile or body on average</source>
        <translation>Abweichung von Zeichnung, Profil oder Körper im Mittel</translation>
    </message>
    <message>
        <source>Off the drawing: {0} on average, at most {1}</source>
        <translation>Neben der Zeichnung: im Mittel {0}, höchstens {1}</translation>
    </message>
    <message>
        <source>Off the profile</source>
        <translation>Neben dem Profil</translation>
    </message>
    <message>
        <source>Off the {0}: {1} on average, 95 % below {2}, at most {3}</source>
        <translation>Abstand ({0}): im Mittel {1}, 95 % unter {2}, höchstens {3}</translation>
    </message>
    <message>
        <source>Offer the native solver where it is missing</source>
        <translation>Den nativen Löser anbieten, wo er fehlt</translation>
    </message>
    <message>
        <source>On a symmetric body a change is repeated where its mirror image lies</source>
        <translation>An einem symmetrischen Körper wird eine Änderung wiederholt, wo ihr Spiegelbild liegt</translation>
    </message>
    <message>
        <source>On the way of the valve the balloon narrows to {0} at {1}; its channel takes {2} with its welds there. Make the neck wider or put it elsewhere, else the weld closes the valve.</source>
        <translation>Auf dem Weg des Ventils verengt sich der Ballon bei {1} auf {0}; der Kanal mit seinen Nähten braucht dort {2}. Den Hals verbreitern oder anderswo anbringen, sonst verschließt die Schweißnaht das Ventil.</translation>
    </message>
    <message>
        <source>Once the seam is closed, turn the tail in through itself with a straw, at the mark beside the balloon, and fill through it up to the second mark. Pull the straw out: the air in the balloon presses the tail flat.</source>
        <translation>Wenn die Naht geschlossen ist, den Schwanz an der Marke neben dem Ballon mit einem Strohhalm durch sich selbst nach innen stülpen und bis zur zweiten Marke füllen. Den Halm herausziehen: Die Luft im Ballon drückt den Schwanz flach.</translation>
    </message>
    <message>
        <source>One large page</source>
        <translation>Eine große Seite</translation>
    </message>
    <message>
        <source>One-way tail</source>
        <translation>Rückschlagschwanz</translation>
    </message>
    <message>
        <source>Only a film with another stiffness across has a grain: give --young-across too.</source>
        <translation>Nur eine Folie mit anderer Steifigkeit quer hat eine Laufrichtung: auch --young-across angeben.</translation>
    </message>
    <message>
        <source>Only balloons of two equal panels are compared with a photograph: compare the panels of others one by one with --flat.</source>
        <translation>Nur Ballons aus zwei gleichen Bahnen werden mit einem Foto verglichen: die Bahnen anderer einzeln mit --flat vergleichen.</translation>
    </message>
    <message>
        <source>Only balloons of two equal panels are compared with a photograph: compare the panels of others one by one, with the command compare and its --flat.</source>
        <translation>Nur Ballons aus zwei gleichen Bahnen werden mit einem Foto verglichen: vergleichen Sie die Bahnen anderer einzeln, mit dem Befehl compare und seinem --flat.</translation>
    </message>
    <message>
        <source>Only grades of this film with a sealing layer weld: try scraps before you cut.</source>
        <translation>Nur Sorten dieser Folie mit Siegelschicht lassen sich schweißen: vor dem Schneiden an Reststücken ausprobieren.</translation>
    </message>
    <message>
        <source>Only pieces that are no larger than this either way get tabs, such as 50 mm</source>
        <translation>Nur Stücke, die in keiner Richtung größer sind, bekommen Stege, etwa 50 mm</translation>
    </message>
    <message>
        <source>Only the middle of the weld. A closed weld runs past its start, so that the joint is tight.</source>
        <translation>Nur die Mitte der Schweißnaht. Eine geschlossene Naht läuft über ihren Anfang hinaus, damit die Stelle dicht ist.</translation>
    </message>
    <message>
        <source>Only the shape is compared, at the size that fits best</source>
        <translation>Nur die Form wird verglichen, in der Größe, die am besten passt</translation>
    </message>
    <message>
        <source>Only {0} of film stay between two cuts near {1}; {2} wants {3}. It may tear or melt there.</source>
        <translation>Nahe {1} bleiben nur {0} Folie zwischen zwei Schnitten; {2} will {3}. Sie kann dort reißen oder schmelzen.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Open edge: {}</source>
        <translation>Offene Kante: {}</translation>
    </message>
    <message>
        <source>Open it, do not import it. Outline, holes and notches are on cut layers, without speed and power: take them from your material library. Welds (T1) and all that is drawn (T2) are on tool layers, which LightBurn never burns.</source>
        <translation>Öffnen, nicht importieren. Umriss, Löcher und Passkerben liegen auf Schneidebenen, ohne Geschwindigkeit und Leistung: diese aus der Materialbibliothek nehmen. Schweißnähte (T1) und alles Gezeichnete (T2) liegen auf Werkzeugebenen, die LightBurn nie brennt.</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>Opposite the intake</source>
        <translation>Gegenüber dem Füllhals</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Order of the seams</source>
        <translation>Reihenfolge der Nähte</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Outline edit {0} at {1} is left out. {2}</source>
        <translation>Bearbeitung {0} des Umrisses bei {1} entfällt. {2}</translation>
    </message>
    <message>
        <source>Outline edit {0} does none of {1}. {2}</source>
        <translation>Bearbeitung {0} des Umrisses tut keines von {1}. {2}</translation>
    </message>
    <message>
        <source>Outline edit {0} has an 'at' that does not fit. {1}</source>
        <translation>Bearbeitung {0} des Umrisses hat ein 'at', das nicht passt. {1}</translation>
    </message>
    <message>
        <source>Outline edit {0} has an unknown '{1}'. Use {2}.</source>
        <translation>Bearbeitung {0} des Umrisses hat ein unbekanntes „{1}“. {2} benutzen.</translation>
    </message>
    <message>
        <source>Outline edit {0} has no place [x, y] as its 'to', or one too many. {1}</source>
        <translation>Bearbeitung {0} des Umrisses hat keinen Ort [x, y] als 'to', oder einen zu viel. {1}</translation>
    </message>
    <message>
        <source>Outline edit {0}: 'mirrored' is true or false.</source>
        <translation>Bearbeitung {0} des Umrisses: 'mirrored' ist true oder false.</translation>
    </message>
    <message>
        <source>Outline {}</source>
        <translation>Umriss {}</translation>
    </message>
    <message>
        <source>Outline {}, holes: {}</source>
        <translation>Umriss {}, Löcher: {}</translation>
    </message>
    <message>
        <source>Overcut</source>
        <translation>Überschnitt</translation>
    </message>
    <message>
        <source>PDF files, previews and labels need it; DXF, SVG and HPGL can be written.</source>
        <translation>PDF-Dateien, Vorschauen und Beschriftungen brauchen es; DXF, SVG und HPGL können geschrieben werden.</translation>
    </message>
    <message>
        <source>PNG, JPEG or BMP</source>
        <translation>PNG, JPEG oder BMP</translation>
    </message>
    <message>
        <source>Pa, its own range</source>
        <translation>Pa, ihr eigener Bereich</translation>
    </message>
    <message>
        <source>Page {0} of {1}: column {2}, row {3}</source>
        <translation>Seite {0} von {1}: Spalte {2}, Zeile {3}</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Paint a balloon</source>
        <translation>Einen Ballon malen</translation>
    </message>
    <message>
        <source>Paint a shape first: the decoration is seen on it alone.</source>
        <translation>Zuerst eine Form malen: Nur auf ihr ist die Verzierung zu sehen.</translation>
    </message>
    <message>
        <source>Paint both sides at once, mirrored (M)</source>
        <translation>Beide Seiten zugleich malen, gespiegelt (M)</translation>
    </message>
    <message>
        <source>Paint broad, soft strokes: what is painted becomes a balloon.</source>
        <translation>Breite, weiche Striche malen: Was gemalt ist, wird ein Ballon.</translation>
    </message>
    <message>
        <source>Paint so many times around a centre ( , fewer, . more)</source>
        <translation>So oft um eine Mitte malen ( , weniger, . mehr)</translation>
    </message>
    <message>
        <source>Paint something first: a closed line is enough.</source>
        <translation>Zuerst etwas malen: Eine geschlossene Linie genügt.</translation>
    </message>
    <message>
        <source>Paint what becomes the outline (D)</source>
        <translation>Malen, was zum Umriss wird (D)</translation>
    </message>
    <message>
        <source>Paint what is printed on the film and leaves the outline as it is (D)</source>
        <translation>Malen, was auf die Folie gedruckt wird und den Umriss lässt, wie er ist (D)</translation>
    </message>
    <message>
        <source>Painted balloon</source>
        <translation>Gemalter Ballon</translation>
    </message>
    <message>
        <source>Painted fish</source>
        <translation>Gemalter Fisch</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Panel '{0}' crosses itself: divide the body otherwise there.</source>
        <translation>Die Bahn „{0}“ kreuzt sich selbst: den Körper dort anders teilen.</translation>
    </message>
    <message>
        <source>Panel '{0}' crosses or nearly touches itself: separate the parts that meet there.</source>
        <translation>Die Bahn „{0}“ kreuzt oder berührt sich fast selbst: die Teile, die dort zusammenkommen, voneinander trennen.</translation>
    </message>
    <message>
        <source>Panel '{0}' is folded over: {1} crosses or touches another edge at {2}. Separate them.</source>
        <translation>Die Bahn „{0}“ ist gefaltet: {1} kreuzt oder berührt bei {2} eine andere Kante. Beide voneinander trennen.</translation>
    </message>
    <message>
        <source>Panel '{0}' is only {1} wide at {2}, too narrow for welds of {3} along both of its sides. Make it wider, or the welds narrower.</source>
        <translation>Die Bahn „{0}“ ist bei {2} nur {1} breit, zu schmal für Schweißnähte von {3} an beiden Seiten. Sie breiter machen oder die Nähte schmaler.</translation>
    </message>
    <message>
        <source>Panel '{0}' is seen from inside: its points run clockwise. Mirror it, or turn their order round.</source>
        <translation>Die Bahn „{0}“ ist von innen gesehen: ihre Punkte laufen im Uhrzeigersinn. Sie spiegeln oder die Reihenfolge umkehren.</translation>
    </message>
    <message>
        <source>Panel '{0}' is the whole surface and has no edge: divide the body into more panels.</source>
        <translation>Die Bahn „{0}“ ist die ganze Oberfläche und hat keine Kante: den Körper in mehr Bahnen teilen.</translation>
    </message>
    <message>
        <source>Panel '{0}' would cross itself when laid flat. {1}</source>
        <translation>Die Bahn „{0}“ würde sich flach ausgelegt selbst kreuzen. {1}</translation>
    </message>
    <message>
        <source>Panel {0} goes round a part of the body: it is cut open there.</source>
        <translation>Bahn {0} läuft um einen Teil des Körpers herum: dort ist sie aufgeschnitten.</translation>
    </message>
    <message>
        <source>Panel {0} has a triangle with a vertex that is not there. Mesh it anew.</source>
        <translation>Bahn {0} hat ein Dreieck mit einer Ecke, die es nicht gibt. Neu vernetzen.</translation>
    </message>
    <message>
        <source>Panel {0} has a vertex without triangles. Mesh it anew.</source>
        <translation>Bahn {0} hat eine Ecke ohne Dreiecke. Neu vernetzen.</translation>
    </message>
    <message>
        <source>Panel {0} has an edge with more than two triangles. Mesh it anew.</source>
        <translation>Bahn {0} hat eine Kante mit mehr als zwei Dreiecken. Neu vernetzen.</translation>
    </message>
    <message>
        <source>Panel {0} has no edge {1} for the opening: say another one of its outer loop.</source>
        <translation>Die Bahn {0} hat keine Kante {1} für die Öffnung: eine andere ihres äußeren Rands angeben.</translation>
    </message>
    <message>
        <source>Panel {0} has no room for its name: write it beside the cut when you lay it out.</source>
        <translation>Die Bahn {0} hat keinen Platz für ihren Namen: ihn beim Auslegen neben den Schnitt schreiben.</translation>
    </message>
    <message>
        <source>Panel {0} has no room for numbers and arrows of seams: {1}. Its notches tell them apart.</source>
        <translation>Die Bahn {0} hat keinen Platz für Nummern und Pfeile der Nähte: {1}. Ihre Passkerben unterscheiden sie.</translation>
    </message>
    <message>
        <source>Panel {0} is not cut: say another one for the opening.</source>
        <translation>Die Bahn {0} wird nicht geschnitten: eine andere für die Öffnung angeben.</translation>
    </message>
    <message>
        <source>Panel {0} is nowhere wider than {1}, and its welds are {2} wide: it hardly bulges. Make the balloon larger, the panel wider or the seal narrower.</source>
        <translation>Die Bahn {0} ist nirgends breiter als {1}, und ihre Schweißnähte sind {2} breit: sie wölbt sich kaum. Den Ballon größer, die Bahn breiter oder die Naht schmaler machen.</translation>
    </message>
    <message>
        <source>Panel {0} is open between its vertices {1} and {2}: the boundary is in no seam there. Seal it to another.</source>
        <translation>Bahn {0} ist zwischen ihren Ecken {1} und {2} offen: Der Rand ist dort in keiner Naht. Mit einem anderen verschweißen.</translation>
    </message>
    <message>
        <source>Panel {0} leans by {1} between front and back. Make the side band narrower there, or the parts of the drawing wider.</source>
        <translation>Die Bahn {0} neigt sich zwischen Vorder- und Rückseite um {1}. Das Seitenband dort schmaler oder die Teile der Zeichnung breiter machen.</translation>
    </message>
    <message>
        <source>Panel {0} near {1} goes round the body and cannot be laid flat. Draw a seam across it.</source>
        <translation>Bahn {0} nahe {1} läuft um den Körper herum und lässt sich nicht flach auslegen. Eine Naht quer über sie zeichnen.</translation>
    </message>
    <message>
        <source>Panel {0} of the JSON file has no name or no 'outer' loop. {1}</source>
        <translation>Die Bahn {0} der JSON-Datei hat keinen Namen oder keinen Rand 'outer'. {1}</translation>
    </message>
    <message>
        <source>Panel {0}: an intake of this kind leads through a seam. Say which one, or an edge of the panel such as {1}.0, or choose a nozzle.</source>
        <translation>Bahn {0}: ein Füllhals dieser Art führt durch eine Naht. Sagen, durch welche, oder eine Kante der Bahn wie {1}.0 angeben, oder eine Tülle wählen.</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Panels and seams; a copy of them travels in the document</source>
        <translation>Bahnen und Nähte; eine Kopie davon reist im Dokument mit</translation>
    </message>
    <message>
        <source>Panels are laid on the film in rows instead of closely; nothing else changes.</source>
        <translation>Die Bahnen werden in Reihen statt dicht ausgelegt; sonst ändert sich nichts.</translation>
    </message>
    <message>
        <source>Panels laid flat: strained by {0} on average, at most {1}</source>
        <translation>Flach ausgelegte Bahnen: im Mittel um {0} gedehnt, höchstens {1}</translation>
    </message>
    <message>
        <source>Panels with gussets, whose sizes come from a spreadsheet</source>
        <translation>Bahnen mit Seitenfalten, deren Maße aus einer Tabelle kommen</translation>
    </message>
    <message>
        <source>Panels: {0}, of different shapes: {1}</source>
        <translation>Bahnen: {0}, davon verschiedene Formen: {1}</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Parts of the balloon may lean to one side or the other: the inflated outline is {0} to {1} from the drawing. Another width of the side band may hold them.</source>
        <translation>Teile des Ballons können sich zur einen oder anderen Seite neigen: der aufgeblasene Umriss liegt {0} bis {1} neben der Zeichnung. Eine andere Breite des Seitenbands kann sie halten.</translation>
    </message>
    <message>
        <source>Paste (Ctrl+V)</source>
        <translation>Einfügen (Strg+V)</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Schnittmuster</translation>
    </message>
    <message>
        <source>Pattern correction needs scipy: install it with pip install scipy.</source>
        <translation>Die Korrektur des Schnittmusters braucht scipy: mit pip install scipy installieren.</translation>
    </message>
    <message>
        <source>Pattern drawn 1 : {0}</source>
        <translation>Schnittmuster im Maßstab 1 : {0}</translation>
    </message>
    <message>
        <source>Pattern of the balloon, all pieces</source>
        <translation>Schnittmuster des Ballons, alle Teile</translation>
    </message>
    <message>
        <source>Pattern on several pages</source>
        <translation>Schnittmuster auf mehreren Seiten</translation>
    </message>
    <message>
        <source>Pattern written to {}</source>
        <translation>Schnittmuster nach {} geschrieben</translation>
    </message>
    <message>
        <source>Pattern {0} ({1} x {2} in), pages: {3}.</source>
        <translation>Schnittmuster {0} ({1} x {2} Zoll), Seiten: {3}.</translation>
    </message>
    <message>
        <source>Pattern, cut two (one mirrored)</source>
        <translation>Schnittmuster, zweimal schneiden (einmal gespiegelt)</translation>
    </message>
    <message>
        <source>Pattern, {0} panels</source>
        <translation>Schnittmuster, {0} Bahnen</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Schnittmuster</translation>
    </message>
    <message>
        <source>Patterns need shapely: install it with pip install shapely.</source>
        <translation>Schnittmuster brauchen shapely: mit pip install shapely installieren.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>Pen drawing</source>
        <translation>Strichzeichnung</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Pick an edge to see its partner.</source>
        <translation>Eine Kante wählen, um ihre Partnerkante zu sehen.</translation>
    </message>
    <message>
        <source>Pick an edge, then its partner, here or in the 3D view. Free edges: {}</source>
        <translation>Eine Kante wählen, dann ihre Partnerkante, hier oder in der 3D-Ansicht. Freie Kanten: {}</translation>
    </message>
    <message>
        <source>Pick the edge at which it is filled.</source>
        <translation>Die Kante wählen, an der er gefüllt wird.</translation>
    </message>
    <message>
        <source>Picture (PNG)</source>
        <translation>Bild (PNG)</translation>
    </message>
    <message>
        <source>Picture, SVG, DXF or JSON</source>
        <translation>Bild, SVG, DXF oder JSON</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Pictures are read by Qt and traced with SciPy instead, a little slower.</source>
        <translation>Bilder werden stattdessen etwas langsamer von Qt gelesen und mit SciPy nachgezeichnet.</translation>
    </message>
    <message>
        <source>Pictures need OpenCV or SciPy: install the package python3-opencv or python3-scipy.</source>
        <translation>Bilder brauchen OpenCV oder SciPy: das Paket python3-opencv oder python3-scipy installieren.</translation>
    </message>
    <message>
        <source>Pictures need OpenCV, which is missing or does not work here. Install the package python3-opencv (or opencv-python-headless), or open the picture inside FreeCAD.</source>
        <translation>Bilder brauchen OpenCV, das fehlt oder hier nicht arbeitet. Das Paket python3-opencv (oder opencv-python-headless) installieren oder das Bild in FreeCAD öffnen.</translation>
    </message>
    <message>
        <source>Pictures of the work</source>
        <translation>Bilder der Arbeit</translation>
    </message>
    <message>
        <source>Pieces of the side band cannot be {0} long. Give 0 or more.</source>
        <translation>Stücke des Seitenbands können nicht {0} lang sein. 0 oder mehr angeben.</translation>
    </message>
    <message>
        <source>Pieces of {0} are too short for a side band of {1}. Allow longer ones.</source>
        <translation>Stücke von {0} sind zu kurz für ein Seitenband von {1}. Längere zulassen.</translation>
    </message>
    <message>
        <source>Pieces: {}, on {}, {} used</source>
        <translation>Stücke: {}, auf {}, {} genutzt</translation>
    </message>
    <message>
        <source>Pipette</source>
        <translation>Pipette</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Bildpunkte</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Place by</source>
        <translation>Ort nach</translation>
    </message>
    <message>
        <source>Place on the seam</source>
        <translation>Ort auf der Naht</translation>
    </message>
    <message>
        <source>Places of a seam</source>
        <translation>Stellen einer Naht</translation>
    </message>
    <message>
        <source>Places on the body in mm: two for a cut, one for the chosen seam to be moved to</source>
        <translation>Stellen auf dem Körper in mm: zwei für einen Schnitt, eine, an die die gewählte Naht verschoben wird</translation>
    </message>
    <message>
        <source>Plain PET does not weld to itself: take a grade with a sealing layer, or tape. The aluminium (some 50 nm) adds neither stiffness nor weight. What shops sell as Mylar balloons is mostly nylon-foil.</source>
        <translation>Reines PET verschweißt nicht mit sich selbst: eine Sorte mit Siegelschicht nehmen oder Klebeband. Das Aluminium (etwa 50 nm) fügt weder Steifigkeit noch Gewicht hinzu. Was Läden als Mylarballons verkaufen, ist meist nylon-foil.</translation>
    </message>
    <message>
        <source>Plain paper (PDF)</source>
        <translation>Gewöhnliches Papier (PDF)</translation>
    </message>
    <message>
        <source>Plain shell</source>
        <translation>Einfache Schale</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play the inflation, or stop at a frame</source>
        <translation>Das Aufblasen abspielen oder bei einem Bild anhalten</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Auftragen</translation>
    </message>
    <message>
        <source>Plotter units of 0.025 mm. Pen 1 draws the control bar, pen 2 cuts the notches, pen 3 the rest. Nothing is in the file that may not be cut. For a swivel knife set its offset, 0.25 mm is common. Cuts run 1 mm past their start: set overcut_mm to 0 where the cutter does that itself.</source>
        <translation>Plottereinheiten von 0,025 mm. Stift 1 zeichnet den Kontrollbalken, Stift 2 schneidet die Passkerben, Stift 3 den Rest. In der Datei ist nichts, was nicht geschnitten werden darf. Bei einem Schleppmesser dessen Versatz einstellen, üblich sind 0,25 mm. Schnitte laufen 1 mm über ihren Anfang hinaus: overcut_mm auf 0 setzen, wenn die Schneidemaschine das selbst tut.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Point {0} of the JSON file's 'profile' is not a pair of numbers. {1}</source>
        <translation>Punkt {0} im 'profile' der JSON-Datei ist kein Zahlenpaar. {1}</translation>
    </message>
    <message>
        <source>Point {0} of the JSON file's {1} is not a pair of numbers. {2}</source>
        <translation>Punkt {0} von {1} der JSON-Datei ist kein Zahlenpaar. {2}</translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation>Querkontraktionszahl</translation>
    </message>
    <message>
        <source>Polyethylene film (LDPE), 50 µm</source>
        <translation>Polyethylenfolie (LDPE), 50 µm</translation>
    </message>
    <message>
        <source>Polylines at the real size with a layer and a colour for each role. CUT, CUT_INNER and NOTCH are cut, SEAL and WELD welded, all others drawn.</source>
        <translation>Polylinien in wahrer Größe mit einer Ebene und einer Farbe je Aufgabe. CUT, CUT_INNER und NOTCH werden geschnitten, SEAL und WELD geschweißt, alle anderen gezeichnet.</translation>
    </message>
    <message>
        <source>Polylines in millimetres with a layer for each role: what every program reads. CUT, CUT_INNER and NOTCH are cut, SEAL and WELD welded, all others drawn.</source>
        <translation>Polylinien in Millimetern mit einer Ebene je Aufgabe: Das liest jedes Programm. CUT, CUT_INNER und NOTCH werden geschnitten, SEAL und WELD geschweißt, alle anderen gezeichnet.</translation>
    </message>
    <message>
        <source>Pouch</source>
        <translation>Standbeutel</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Predicted from the outline; not inflated yet.</source>
        <translation>Aus dem Umriss vorhergesagt; noch nicht aufgeblasen.</translation>
    </message>
    <message>
        <source>Press a head to sort by it.</source>
        <translation>Zum Sortieren eine Spaltenüberschrift anklicken.</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Pressure inside, above that outside</source>
        <translation>Innendruck, über dem Außendruck</translation>
    </message>
    <message>
        <source>Pressure rises with height</source>
        <translation>Druck steigt mit der Höhe</translation>
    </message>
    <message>
        <source>Pressure with the margin left</source>
        <translation>Druck, bei dem die Reserve bleibt</translation>
    </message>
    <message>
        <source>Pressure: {0}</source>
        <translation>Druck: {0}</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Print at 100 % ("actual size"). The bar below must be 100 mm long.</source>
        <translation>Mit 100 % drucken („tatsächliche Größe“). Der Balken unten muss 100 mm lang sein.</translation>
    </message>
    <message>
        <source>Print shop (PDF with CutContour)</source>
        <translation>Druckerei (PDF mit CutContour)</translation>
    </message>
    <message>
        <source>Print the pieces</source>
        <translation>Die Stücke drucken</translation>
    </message>
    <message>
        <source>Print {0} at {1} dpi, all panels</source>
        <translation>Druck von {0} mit {1} dpi, alle Bahnen</translation>
    </message>
    <message>
        <source>Print {0} at {1} dpi, front and back</source>
        <translation>Bedruckt: {0} mit {1} dpi, Vorder- und Rückseite</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Pull a line; then move the pointer to bend it, and click. A right click keeps it straight.</source>
        <translation>Eine Linie ziehen; dann den Zeiger bewegen, um sie zu biegen, und klicken. Ein Rechtsklick lässt sie gerade.</translation>
    </message>
    <message>
        <source>Pull a rectangle to copy (Ctrl+C) or cut (Ctrl+X); without one that is all. Ctrl+V pastes.</source>
        <translation>Ein Rechteck ziehen, um es zu kopieren (Strg+C) oder auszuschneiden (Strg+X); ohne Rechteck gilt das für alles. Strg+V fügt ein.</translation>
    </message>
    <message>
        <source>Pull a shape to its size, up or down to turn it; Shift keeps it upright.</source>
        <translation>Eine Form auf ihre Größe ziehen, nach oben oder unten, um sie zu drehen; mit Umschalt bleibt sie aufrecht.</translation>
    </message>
    <message>
        <source>Pull it, its corner, or the ring that turns it. Enter paints it, Esc drops it.</source>
        <translation>Es, seine Ecke oder den Ring ziehen, der es dreht. Enter malt es, Esc verwirft es.</translation>
    </message>
    <message>
        <source>Pull the centre of the symmetry to its place, and turn its axis by the ring</source>
        <translation>Die Mitte der Symmetrie an ihren Platz ziehen und ihre Achse am Ring drehen</translation>
    </message>
    <message>
        <source>Pull the paper. The middle button, or the space bar, does it with every tool; the wheel zooms.</source>
        <translation>Das Papier verschieben. Mit der mittleren Taste oder der Leertaste geht das bei jedem Werkzeug; das Rad zoomt.</translation>
    </message>
    <message>
        <source>Pull the straw out and seal straight across the neck, beside the balloon.</source>
        <translation>Den Strohhalm herausziehen und gerade quer über den Hals schweißen, neben dem Ballon.</translation>
    </message>
    <message>
        <source>Push a straw in, fill, pull it out and close the neck like the seam, straight across beside the balloon.</source>
        <translation>Einen Strohhalm einschieben, füllen, herausziehen und den Hals neben dem Ballon gerade quer verschließen wie die Naht.</translation>
    </message>
    <message>
        <source>Push the nozzle through the hole of the front panel from inside, put the ring over it from outside, and join flange, film and ring like the seam, along the ring's line, before the panels are joined.</source>
        <translation>Den Stutzen von innen durch das Loch der vorderen Bahn stecken, den Ring von außen darüberlegen und Flansch, Folie und Ring entlang der Ringlinie wie die Naht verbinden, bevor die Bahnen verbunden werden.</translation>
    </message>
    <message>
        <source>Put a picture on the paper, without its background</source>
        <translation>Ein Bild ohne seinen Hintergrund aufs Papier setzen</translation>
    </message>
    <message>
        <source>Put outline, balloon and pattern into the document, and print the pattern</source>
        <translation>Umriss, Ballon und Schnittmuster ins Dokument legen und das Schnittmuster drucken</translation>
    </message>
    <message>
        <source>Put the intake low</source>
        <translation>Den Füllhals unten anbringen</translation>
    </message>
    <message>
        <source>Put the same moves into the document, as objects of FreeCAD's workbench Path (CAM since 1.0), which can simulate them and write them with its post processors</source>
        <translation>Dieselben Bewegungen ins Dokument legen, als Objekte von FreeCADs Arbeitsbereich Path (seit 1.0 CAM), der sie simulieren und mit seinen Postprozessoren schreiben kann</translation>
    </message>
    <message>
        <source>RDWorks (Ruida laser)</source>
        <translation>RDWorks (Ruida-Laser)</translation>
    </message>
    <message>
        <source>Reading a mesh needs scipy: install it with pip install scipy.</source>
        <translation>Ein Netz zu lesen braucht scipy: mit pip install scipy installieren.</translation>
    </message>
    <message>
        <source>Reads</source>
        <translation>Liest</translation>
    </message>
    <message>
        <source>Ready body</source>
        <translation>Fertiger Körper</translation>
    </message>
    <message>
        <source>Ready to make. Paint on, or press Make it!</source>
        <translation>Bereit zum Herstellen. Weitermalen oder „Mach ihn!“ drücken.</translation>
    </message>
    <message>
        <source>Real size, to cut out by hand. Print at 100 % and measure the control bar.</source>
        <translation>Wahre Größe, zum Ausschneiden von Hand. Mit 100 % drucken und den Kontrollbalken nachmessen.</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Y)</source>
        <translation>Wiederherstellen (Strg+Y)</translation>
    </message>
    <message>
        <source>Remnant</source>
        <translation>Reststück</translation>
    </message>
    <message>
        <source>Remnants</source>
        <translation>Reststücke</translation>
    </message>
    <message>
        <source>Remove (Del)</source>
        <translation>Entfernen (Entf)</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparieren</translation>
    </message>
    <message>
        <source>Repair {0} cannot be read: delete it from Repairs.</source>
        <translation>Reparatur {0} ist nicht lesbar: sie aus „Repairs“ löschen.</translation>
    </message>
    <message>
        <source>Replace the file</source>
        <translation>Die Datei ersetzen</translation>
    </message>
    <message>
        <source>Replace the files</source>
        <translation>Die Dateien ersetzen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Result that is shown as colours, with a legend</source>
        <translation>Ergebnis, das als Farben mit Legende gezeigt wird</translation>
    </message>
    <message>
        <source>Results cannot be written as '{0}'. Choose {1}.</source>
        <translation>Ergebnisse können nicht als „{0}“ geschrieben werden. {1} wählen.</translation>
    </message>
    <message>
        <source>Results written to {}</source>
        <translation>Ergebnisse nach {} geschrieben</translation>
    </message>
    <message>
        <source>Rim</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Ring that kinks where its weld creases</source>
        <translation>Ring, der einknickt, wo seine Naht knittert</translation>
    </message>
    <message>
        <source>Ring that warps</source>
        <translation>Ring, der sich verwindet</translation>
    </message>
    <message>
        <source>Roland with crop marks (vinyl cutter)</source>
        <translation>Roland mit Schnittmarken (Folienschneider)</translation>
    </message>
    <message>
        <source>Round pieces up to</source>
        <translation>Um Stücke bis</translation>
    </message>
    <message>
        <source>Round this hole the balloon may kink: with a weld creased to {percent} of its stiffness the outline moves by up to {length}; with one {wanted} wide, creased as much, by {less}.</source>
        <translation>Um dieses Loch kann der Ballon einknicken: Mit einer Naht, die geknittert nur {percent} ihrer Steifigkeit behält, verschiebt sich der Umriss um bis zu {length}; mit einer {wanted} breiten, ebenso geknitterten um {less}.</translation>
    </message>
    <message>
        <source>Round this hole the balloon will not lie flat: a closed tube wants to curve more and twists out of its plane, here by about {length}. Open the ring, or seal the hole's area without cutting it out and keep it small.</source>
        <translation>Um dieses Loch liegt der Ballon nicht flach: Ein geschlossener Schlauch will sich stärker krümmen und verwindet sich aus seiner Ebene, hier um etwa {length}. Den Ring öffnen, oder die Fläche des Lochs verschweißen statt ausschneiden und sie klein halten.</translation>
    </message>
    <message>
        <source>Round this hole the balloon will not lie quite flat: a closed tube wants to curve more and twists out of its plane, here by about {length}.</source>
        <translation>Um dieses Loch liegt der Ballon nicht ganz flach: Ein geschlossener Schlauch will sich stärker krümmen und verwindet sich aus seiner Ebene, hier um etwa {length}.</translation>
    </message>
    <message>
        <source>Round with a radius of</source>
        <translation>Runden mit einem Radius von</translation>
    </message>
    <message>
        <source>Row {0}: {1}</source>
        <translation>Zeile {0}: {1}</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Rows from below: {0}</source>
        <translation>Zeilen von unten: {0}</translation>
    </message>
    <message>
        <source>Rows: {0}, of these make no sense: {1}</source>
        <translation>Zeilen: {0}, davon ohne Sinn: {1}</translation>
    </message>
    <message>
        <source>Rows: {0}, without a balloon: {1}</source>
        <translation>Zeilen: {0}, ohne Ballon: {1}</translation>
    </message>
    <message>
        <source>S at full power</source>
        <translation>S bei voller Leistung</translation>
    </message>
    <message>
        <source>STL, OBJ, PLY, 3MF or STEP</source>
        <translation>STL, OBJ, PLY, 3MF oder STEP</translation>
    </message>
    <message>
        <source>SVG files can be written but not read without it; pictures, DXF and JSON can be read.</source>
        <translation>SVG-Dateien können ohne es geschrieben, aber nicht gelesen werden; Bilder, DXF und JSON schon.</translation>
    </message>
    <message>
        <source>SVG files need the Python package svgelements. Install it with 'pip install svgelements', or save the drawing as DXF.</source>
        <translation>SVG-Dateien brauchen das Python-Paket svgelements. Mit „pip install svgelements“ installieren oder die Zeichnung als DXF speichern.</translation>
    </message>
    <message>
        <source>SVG, DXF or JSON</source>
        <translation>SVG, DXF oder JSON</translation>
    </message>
    <message>
        <source>Safe pressure</source>
        <translation>Sicherer Druck</translation>
    </message>
    <message>
        <source>Safe pressure: {0}</source>
        <translation>Sicherer Druck: {0}</translation>
    </message>
    <message>
        <source>Safe pressure: {0}, less than its {1}</source>
        <translation>Sicherer Druck: {0}, weniger als seine {1}</translation>
    </message>
    <message>
        <source>Safe to</source>
        <translation>Sicher bis</translation>
    </message>
    <message>
        <source>Samples need scipy: install it with pip install scipy.</source>
        <translation>Stichproben brauchen scipy: mit pip install scipy installieren.</translation>
    </message>
    <message>
        <source>Samples of a {0} need scipy: install it with pip install scipy, or take {1} ones.</source>
        <translation>Stichproben der Art {0} brauchen scipy: mit pip install scipy installieren, oder {1} nehmen.</translation>
    </message>
    <message>
        <source>Samples: {0}, of these failed: {1}, not at rest: {2}</source>
        <translation>Stichproben: {0}, davon gescheitert: {1}, nicht in Ruhe: {2}</translation>
    </message>
    <message>
        <source>Save as GIF or MP4</source>
        <translation>Als GIF oder MP4 speichern</translation>
    </message>
    <message>
        <source>Save files…</source>
        <translation>Dateien speichern…</translation>
    </message>
    <message>
        <source>Save results</source>
        <translation>Ergebnisse speichern</translation>
    </message>
    <message>
        <source>Save results…</source>
        <translation>Ergebnisse speichern…</translation>
    </message>
    <message>
        <source>Save the inflation</source>
        <translation>Das Aufblasen speichern</translation>
    </message>
    <message>
        <source>Scale to fit</source>
        <translation>Passend verkleinern</translation>
    </message>
    <message>
        <source>Scaled to fit: the balloon is {0} wide instead of {1}.</source>
        <translation>Passend verkleinert: Der Ballon ist {0} breit statt {1}.</translation>
    </message>
    <message>
        <source>Scaled to fit: the drawing is {0} wide instead of {1}.</source>
        <translation>Passend verkleinert: Die Zeichnung ist {0} breit statt {1}.</translation>
    </message>
    <message>
        <source>Scaled to fit: {} wide instead of {}.</source>
        <translation>Passend verkleinert: {} breit statt {}.</translation>
    </message>
    <message>
        <source>SciPy triangulates instead, a little slower.</source>
        <translation>Stattdessen vernetzt SciPy, etwas langsamer.</translation>
    </message>
    <message>
        <source>Seal a disc on each point where four panels or more meet.</source>
        <translation>Auf jeden Punkt, an dem vier Bahnen oder mehr zusammenkommen, eine Scheibe siegeln.</translation>
    </message>
    <message>
        <source>Seal across the neck along its line, through panels and strips. The field keeps the channel open.</source>
        <translation>Quer über den Hals entlang seiner Linie schweißen, durch Bahnen und Streifen. Das Feld hält den Kanal offen.</translation>
    </message>
    <message>
        <source>Seal the lines inside.</source>
        <translation>Die Linien innen schweißen.</translation>
    </message>
    <message>
        <source>Seal the outline, {seal} wide, all but the mouth of the neck.</source>
        <translation>Den Umriss schweißen, {seal} breit, alles außer der Mündung des Halses.</translation>
    </message>
    <message>
        <source>Seal the outline, {seal} wide, all the way round.</source>
        <translation>Den Umriss schweißen, {seal} breit, ganz herum.</translation>
    </message>
    <message>
        <source>Seal the seams in the order of the pictures along the dashed line, {seal} wide, from end to end.</source>
        <translation>Die Nähte in der Reihenfolge der Bilder entlang der gestrichelten Linie schweißen, {seal} breit, von Ende zu Ende.</translation>
    </message>
    <message>
        <source>Seal the seams in the order of the pictures along the dashed line, {seal} wide, from end to end. Leave the mouth of the neck open.</source>
        <translation>Die Nähte in der Reihenfolge der Bilder entlang der gestrichelten Linie schweißen, {seal} breit, von Ende zu Ende. Die Mündung des Füllhalses offen lassen.</translation>
    </message>
    <message>
        <source>Seal width</source>
        <translation>Nahtbreite</translation>
    </message>
    <message>
        <source>Seal width (0: the film's)</source>
        <translation>Nahtbreite (0: die der Folie)</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Seam edit {0}</source>
        <translation>Nahtänderung {0}</translation>
    </message>
    <message>
        <source>Seam length</source>
        <translation>Nahtlänge</translation>
    </message>
    <message>
        <source>Seam length: {0}</source>
        <translation>Nahtlänge: {0}</translation>
    </message>
    <message>
        <source>Seam or edge</source>
        <translation>Naht oder Kante</translation>
    </message>
    <message>
        <source>Seam {0} has no length: it begins and ends where {1} begins. Give two points; a whole loop is written as two seams.</source>
        <translation>Naht {0} hat keine Länge: sie beginnt und endet, wo {1} beginnt. Zwei Punkte angeben; ein ganzer Rand wird als zwei Nähte geschrieben.</translation>
    </message>
    <message>
        <source>Seam {0} is along a panel {1}, but there are {2}.</source>
        <translation>Naht {0} liegt an einer Bahn {1}, aber es gibt {2}.</translation>
    </message>
    <message>
        <source>Seam {0} is along vertices that panel {1} does not have.</source>
        <translation>Naht {0} liegt an Ecken, die Bahn {1} nicht hat.</translation>
    </message>
    <message>
        <source>Seam {0} is at an end that stays open: say another one for the opening.</source>
        <translation>Naht {0} ist an einem Ende, das offen bleibt: eine andere für die Öffnung angeben.</translation>
    </message>
    <message>
        <source>Seam {0} is on hole {1} of panel '{2}', which has {3}. Check its sides.</source>
        <translation>Naht {0} liegt am Loch {1} der Bahn „{2}“, die {3} hat. Ihre Seiten prüfen.</translation>
    </message>
    <message>
        <source>Seam {0} is on panel {1}, but there are {2}. Check its sides.</source>
        <translation>Naht {0} liegt an Bahn {1}, aber es gibt {2}. Ihre Seiten prüfen.</translation>
    </message>
    <message>
        <source>Seam {0} is on point {1} of panel '{2}', whose points there are 0 to {3}. Check its sides.</source>
        <translation>Naht {0} liegt am Punkt {1} der Bahn „{2}“, deren Punkte dort 0 bis {3} sind. Ihre Seiten prüfen.</translation>
    </message>
    <message>
        <source>Seam {0} joins holes of panels {1} and {2}, where no intake can be: say another seam.</source>
        <translation>Naht {0} verbindet Löcher der Bahnen {1} und {2}, wo kein Füllhals sein kann: eine andere Naht angeben.</translation>
    </message>
    <message>
        <source>Seam {0} joins the outside of the film to its inside, as in a Moebius strip. Turn one of its sides round.</source>
        <translation>Naht {0} verbindet die Außenseite der Folie mit ihrer Innenseite wie bei einem Möbiusband. Eine ihrer Seiten umdrehen.</translation>
    </message>
    <message>
        <source>Seam {0} joins {1} vertices to {2}. Divide both sides into equally many parts.</source>
        <translation>Naht {0} verbindet {1} Ecken mit {2}. Beide Seiten in gleich viele Teile teilen.</translation>
    </message>
    <message>
        <source>Seam {0} leaves the boundary of panel {1}. Give its vertices in a row along it.</source>
        <translation>Naht {0} verlässt den Rand von Bahn {1}. Ihre Ecken der Reihe nach am Rand entlang angeben.</translation>
    </message>
    <message>
        <source>Seam {0} of panels {1} is {2} long, and the intake takes {3} with its welds: make it narrower, or say another edge for the opening.</source>
        <translation>Naht {0} der Bahnen {1} ist {2} lang, und der Füllhals braucht mit seinen Schweißnähten {3}: ihn schmaler machen oder eine andere Kante für die Öffnung angeben.</translation>
    </message>
    <message>
        <source>Seam {0} of the JSON file has no two sides 'a' and 'b'. {1}</source>
        <translation>Naht {0} der JSON-Datei hat keine zwei Seiten 'a' und 'b'. {1}</translation>
    </message>
    <message>
        <source>Seam {0} of the list does none of {1}. {2}</source>
        <translation>Naht {0} der Liste tut nichts von {1}. {2}</translation>
    </message>
    <message>
        <source>Seam {0} of the list has a place that is not [x, y, z]. {1}</source>
        <translation>Naht {0} der Liste hat eine Stelle, die nicht [x, y, z] ist. {1}</translation>
    </message>
    <message>
        <source>Seam {0} of the list has an unknown '{1}'. Use {2}.</source>
        <translation>Naht {0} der Liste hat ein unbekanntes „{1}“. {2} benutzen.</translation>
    </message>
    <message>
        <source>Seam {0} of the list: 'side' is '{1}' or '{2}', 'mirrored' is true or false.</source>
        <translation>Naht {0} der Liste: 'side' ist „{1}“ oder „{2}“, 'mirrored' ist true oder false.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, last, with the opening.</source>
        <translation>Naht {0}: {1} an {2}, zuletzt, mit der Öffnung.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, last.</source>
        <translation>Naht {0}: {1} an {2}, zuletzt.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, lying flat.</source>
        <translation>Naht {0}: {1} an {2}, flach liegend.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, one edge turned round the other.</source>
        <translation>Naht {0}: {1} an {2}, eine Kante um die andere gewendet.</translation>
    </message>
    <message>
        <source>Seam {}: {}</source>
        <translation>Naht {}: {}</translation>
    </message>
    <message>
        <source>Seam {}: {}; {}</source>
        <translation>Naht {}: {}; {}</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>Seams and centres apart</source>
        <translation>Abstand von Nähten und Mitten</translation>
    </message>
    <message>
        <source>Seams and middles of gores: {0} apart at most</source>
        <translation>Nähte und Mitten der Segmente: höchstens {0} auseinander</translation>
    </message>
    <message>
        <source>Seams that do not lie flat: {0}. Seal them bit by bit.</source>
        <translation>Nähte, die nicht flach liegen: {0}. Sie Stück für Stück schweißen.</translation>
    </message>
    <message>
        <source>Seams that do not lie flat: {0}. Their allowance is cut into tabs that turn.</source>
        <translation>Nähte, die nicht flach liegen: {0}. Ihre Zugabe ist in Laschen geschnitten, die sich wenden.</translation>
    </message>
    <message>
        <source>Seams {0} and {1} hold the same piece of the boundary of panel {2}. Seal each piece once.</source>
        <translation>Die Nähte {0} und {1} halten dasselbe Stück des Randes von Bahn {2}. Jedes Stück einmal verschweißen.</translation>
    </message>
    <message>
        <source>Seams: {0}, where an edge must turn: {1}</source>
        <translation>Nähte: {0}, davon muss sich eine Kante wenden: {1}</translation>
    </message>
    <message>
        <source>Second panel, mirrored</source>
        <translation>Zweite Bahn, gespiegelt</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Select a sketch of half the outline, or choose where the profile comes from.</source>
        <translation>Eine Skizze des halben Umrisses wählen, oder woher das Profil kommt.</translation>
    </message>
    <message>
        <source>Select a sketch, a wire or a face in the tree or the 3D view.</source>
        <translation>Eine Skizze, einen Draht oder eine Fläche im Baum oder in der 3D-Ansicht wählen.</translation>
    </message>
    <message>
        <source>Select a solid or a mesh, or choose a file.</source>
        <translation>Einen Volumenkörper oder ein Netz wählen, oder eine Datei nehmen.</translation>
    </message>
    <message>
        <source>Select all (Ctrl+A)</source>
        <translation>Alles auswählen (Strg+A)</translation>
    </message>
    <message>
        <source>Select another</source>
        <translation>Andere wählen</translation>
    </message>
    <message>
        <source>Select sketches or flat faces, or take a ready body or a file.</source>
        <translation>Skizzen oder ebene Flächen wählen, oder einen fertigen Körper oder eine Datei nehmen.</translation>
    </message>
    <message>
        <source>Select sketches, wires or flat faces first.</source>
        <translation>Zuerst Skizzen, Drähte oder ebene Flächen wählen.</translation>
    </message>
    <message>
        <source>Self-sealing film valve</source>
        <translation>Selbstschließendes Folienventil</translation>
    </message>
    <message>
        <source>Set X0 Y0 at the lower left corner of the film, and Z0 where the tool touches it; nothing homes. A laser wants laser mode, $32=1.</source>
        <translation>X0 Y0 auf die linke untere Ecke der Folie setzen und Z0 dorthin, wo das Werkzeug sie berührt; die Datei macht keine Referenzfahrt. Ein Laser braucht den Lasermodus, $32=1.</translation>
    </message>
    <message>
        <source>Set X0 Y0 at the lower left corner of the film, and Z0 where the tool touches it; nothing homes. For a swivel knife set its offset in a machine file of your own.</source>
        <translation>X0 Y0 auf die linke untere Ecke der Folie setzen und Z0 dorthin, wo das Werkzeug sie berührt; die Datei macht keine Referenzfahrt. Bei einem Schleppmesser dessen Versatz in einer eigenen Maschinendatei einstellen.</translation>
    </message>
    <message>
        <source>Set the opening</source>
        <translation>Die Öffnung setzen</translation>
    </message>
    <message>
        <source>Set up machines of your own</source>
        <translation>Eigene Maschinen einrichten</translation>
    </message>
    <message>
        <source>Shadows on the background were taken off.</source>
        <translation>Schatten auf dem Hintergrund wurden entfernt.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Shape that stays flat</source>
        <translation>Form, die flach bleibt</translation>
    </message>
    <message>
        <source>Share of the feed near corners and in narrow bends</source>
        <translation>Anteil des Vorschubs nahe Ecken und in engen Bögen</translation>
    </message>
    <message>
        <source>Share of the laser's full power; empty: not known yet</source>
        <translation>Anteil der vollen Leistung des Lasers; leer: noch nicht bekannt</translation>
    </message>
    <message>
        <source>Sharp or round (S)</source>
        <translation>Spitz oder rund (S)</translation>
    </message>
    <message>
        <source>Sheet length</source>
        <translation>Bogenlänge</translation>
    </message>
    <message>
        <source>Sheet {} of {}</source>
        <translation>Bogen {} von {}</translation>
    </message>
    <message>
        <source>Show all (0)</source>
        <translation>Alles zeigen (0)</translation>
    </message>
    <message>
        <source>Show all pieces (0)</source>
        <translation>Alle Stücke zeigen (0)</translation>
    </message>
    <message>
        <source>Show the drawing and the silhouette over each other</source>
        <translation>Zeichnung und Silhouette übereinander zeigen</translation>
    </message>
    <message>
        <source>Show the whole paper (0)</source>
        <translation>Das ganze Papier zeigen (0)</translation>
    </message>
    <message>
        <source>Shown on the pieces</source>
        <translation>Gezeigt auf den Stücken</translation>
    </message>
    <message>
        <source>Shown sheet</source>
        <translation>Gezeigter Bogen</translation>
    </message>
    <message>
        <source>Shown side</source>
        <translation>Gezeigte Seite</translation>
    </message>
    <message>
        <source>Side '{0}' of seam {1} is not the name of a panel and two points. {2}</source>
        <translation>Die Seite '{0}' der Naht {1} ist nicht der Name einer Bahn und zwei Punkte. {2}</translation>
    </message>
    <message>
        <source>Side '{0}' of seam {1} is on a panel '{2}' that is not there. {3}</source>
        <translation>Die Seite '{0}' der Naht {1} liegt an einer Bahn „{2}“, die es nicht gibt. {3}</translation>
    </message>
    <message>
        <source>Side band</source>
        <translation>Seitenband</translation>
    </message>
    <message>
        <source>Side {0} of seam {1} runs the wrong way at {2}, which would seal the outside of the film to its inside, as in a Moebius strip: it goes {3} its loop. Swap the two points of {4}.</source>
        <translation>Die Seite {0} der Naht {1} läuft bei {2} falsch herum, was die Außenseite der Folie mit ihrer Innenseite verschweißen würde, wie bei einem Möbiusband: sie geht {3} ihres Rands. Die zwei Punkte von {4} vertauschen.</translation>
    </message>
    <message>
        <source>Silhouette Cameo 5 Alpha from Inkscape</source>
        <translation>Silhouette Cameo 5 Alpha aus Inkscape</translation>
    </message>
    <message>
        <source>Silhouette Studio (vinyl cutter)</source>
        <translation>Silhouette Studio (Folienschneider)</translation>
    </message>
    <message>
        <source>Silhouette error, largest</source>
        <translation>Abweichung der Silhouette, größte</translation>
    </message>
    <message>
        <source>Silhouette error, mean</source>
        <translation>Abweichung der Silhouette, mittlere</translation>
    </message>
    <message>
        <source>Silhouette from Inkscape</source>
        <translation>Silhouette aus Inkscape</translation>
    </message>
    <message>
        <source>Silhouette off the drawing</source>
        <translation>Silhouette neben der Zeichnung</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Simulations use NumPy. "What works here" in the menu fetches the native solver later.</source>
        <translation>Simulationen benutzen NumPy. „Was hier funktioniert“ im Menü lädt den nativen Löser später herunter.</translation>
    </message>
    <message>
        <source>Six gores from half an outline in a sketch: change their number</source>
        <translation>Sechs Segmente aus einem halben Umriss in einer Skizze: ihre Zahl ändern</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size from</source>
        <translation>Größe aus</translation>
    </message>
    <message>
        <source>Size unknown</source>
        <translation>Größe unbekannt</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>Glätte</translation>
    </message>
    <message>
        <source>So far it is a line. Close it, or paint an area, and it becomes a balloon.</source>
        <translation>Bisher ist es eine Linie. Sie schließen oder eine Fläche malen, dann wird es ein Ballon.</translation>
    </message>
    <message>
        <source>Soft PVC film, 0.2 mm</source>
        <translation>Weich-PVC-Folie, 0,2 mm</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>Solver: {0}.</source>
        <translation>Löser: {0}.</translation>
    </message>
    <message>
        <source>Solver: {0}. {1}</source>
        <translation>Löser: {0}. {1}</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>Split over beds</source>
        <translation>Auf Betten aufteilen</translation>
    </message>
    <message>
        <source>Split over beds of {0}, the pattern leaves no waste film for two crosses {1} apart by which it is laid on anew: choose a larger bed, or lay the pieces out on sheets.</source>
        <translation>Auf Betten von {0} aufgeteilt, lässt das Schnittmuster keine Abfallfolie für zwei Kreuze im Abstand {1}, nach denen sie neu aufgelegt wird: wählen Sie ein größeres Bett oder verteilen Sie die Stücke auf Bögen.</translation>
    </message>
    <message>
        <source>Spot in 16 panels</source>
        <translation>Kuh Spot aus 16 Bahnen</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>Stempel</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stern</translation>
    </message>
    <message>
        <source>Start values for welding: {0} ({1}).</source>
        <translation>Startwerte zum Schweißen: {0} ({1}).</translation>
    </message>
    <message>
        <source>Start values, not tried on your film and tool: {start_values} ({start_sources}).</source>
        <translation>Startwerte, nicht auf Ihrer Folie und mit Ihrem Werkzeug erprobt: {start_values} ({start_sources}).</translation>
    </message>
    <message>
        <source>Stated is: {0} ({1}).</source>
        <translation>Angegeben ist: {0} ({1}).</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Stiffer across the web than along it (up to 4.5 against 2.5 GPa): cut both panels in the same direction. Only grades with a sealing layer weld; the gas barrier is poor.</source>
        <translation>Quer zur Bahn steifer als längs (bis 4,5 gegen 2,5 GPa): beide Bahnen in gleicher Richtung schneiden. Nur Sorten mit Siegelschicht lassen sich schweißen; die Gassperre ist schlecht.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>Anhalten (Esc)</translation>
    </message>
    <message>
        <source>Stop and keep the last result</source>
        <translation>Anhalten und das letzte Ergebnis behalten</translation>
    </message>
    <message>
        <source>Stopped. Your painting is still here.</source>
        <translation>Angehalten. Das Gemalte ist noch da.</translation>
    </message>
    <message>
        <source>Stopping ...</source>
        <translation>Wird angehalten ...</translation>
    </message>
    <message>
        <source>Straight from the front, from far away, on a plain background of another colour</source>
        <translation>Gerade von vorn, von weit weg, vor einfarbigem Hintergrund in anderer Farbe</translation>
    </message>
    <message>
        <source>Straw neck</source>
        <translation>Strohhalm-Hals</translation>
    </message>
    <message>
        <source>Stretch of the film: {0}</source>
        <translation>Dehnung der Folie: {0}</translation>
    </message>
    <message>
        <source>Strips</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Strips welded together</source>
        <translation>Streifen miteinander verschweißt</translation>
    </message>
    <message>
        <source>Studies on Dask need {0}: install it with pip install {1}, or leave --dask and --scheduler out ({2}).</source>
        <translation>Studien auf Dask brauchen {0}: mit pip install {1} installieren oder --dask und --scheduler weglassen ({2}).</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Such as Tip for PE</source>
        <translation>Etwa Spitze für PE</translation>
    </message>
    <message>
        <source>Summa with OPOS (vinyl cutter)</source>
        <translation>Summa mit OPOS (Folienschneider)</translation>
    </message>
    <message>
        <source>Summa with OPOS XY (vinyl cutter)</source>
        <translation>Summa mit OPOS XY (Folienschneider)</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>TPU-coated nylon fabric (70 den), 170 g/m²</source>
        <translation>TPU-beschichtetes Nylongewebe (70 den), 170 g/m²</translation>
    </message>
    <message>
        <source>Tab to tie it to</source>
        <translation>Lasche zum Anbinden</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Stege</translation>
    </message>
    <message>
        <source>Tabs are left by a machine that cuts: give --machine too, and one that does.</source>
        <translation>Stege lässt eine Maschine, die schneidet: geben Sie auch --machine, und zwar eine solche.</translation>
    </message>
    <message>
        <source>Tacked to one panel</source>
        <translation>An eine Bahn geheftet</translation>
    </message>
    <message>
        <source>Take a colour from the painting, or the picture under it</source>
        <translation>Eine Farbe aus dem Gemalten nehmen, oder aus dem Bild darunter</translation>
    </message>
    <message>
        <source>Take a tool to change the seams, or choose one and press Delete to merge.</source>
        <translation>Ein Werkzeug nehmen, um die Nähte zu ändern, oder eine wählen und mit Entf ihre Bahnen vereinen.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Take everything off the paper</source>
        <translation>Alles vom Papier nehmen</translation>
    </message>
    <message>
        <source>Take paint off</source>
        <translation>Farbe wegnehmen</translation>
    </message>
    <message>
        <source>Take seam apart</source>
        <translation>Naht lösen</translation>
    </message>
    <message>
        <source>Take the last change of a seam back (Ctrl+Z in the 3D view)</source>
        <translation>Die letzte Änderung einer Naht zurücknehmen (Strg+Z in der 3D-Ansicht)</translation>
    </message>
    <message>
        <source>Take the numbers of one of FreeCAD's material cards</source>
        <translation>Die Zahlen einer FreeCAD-Materialkarte übernehmen</translation>
    </message>
    <message>
        <source>Take the picture away</source>
        <translation>Das Bild wegnehmen</translation>
    </message>
    <message>
        <source>Take this row</source>
        <translation>Diese Zeile übernehmen</translation>
    </message>
    <message>
        <source>Take what is selected</source>
        <translation>Nehmen, was gewählt ist</translation>
    </message>
    <message>
        <source>Take {0} gores.</source>
        <translation>{0} Segmente nehmen.</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Klebeband</translation>
    </message>
    <message>
        <source>Tape along the dashed line, {seal} wide, all the way round.</source>
        <translation>Entlang der gestrichelten Linie mit Klebeband verbinden, {seal} breit, rundherum.</translation>
    </message>
    <message>
        <source>Tape along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>Entlang der gestrichelten Linie mit Klebeband verbinden, {seal} breit; die Mündung des Halses offen lassen.</translation>
    </message>
    <message>
        <source>Taped seam</source>
        <translation>Naht mit Klebeband</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Zielkörper</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Temperatures need scipy: install it with pip install scipy.</source>
        <translation>Temperaturen brauchen scipy: mit pip install scipy installieren.</translation>
    </message>
    <message>
        <source>Tension field</source>
        <translation>Zugfeld</translation>
    </message>
    <message>
        <source>Test card</source>
        <translation>Testkarte</translation>
    </message>
    <message>
        <source>Test card written to {}</source>
        <translation>Testkarte nach {} geschrieben</translation>
    </message>
    <message>
        <source>Test cards</source>
        <translation>Testkarten</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>That of the front</source>
        <translation>Das der Vorderseite</translation>
    </message>
    <message>
        <source>That of the outline</source>
        <translation>Das des Umrisses</translation>
    </message>
    <message>
        <source>That of the page</source>
        <translation>Der der Seite</translation>
    </message>
    <message>
        <source>That wide</source>
        <translation>So breit</translation>
    </message>
    <message>
        <source>That would take {0} pages: choose larger paper or a smaller balloon.</source>
        <translation>Das würden {0} Seiten: größeres Papier oder einen kleineren Ballon wählen.</translation>
    </message>
    <message>
        <source>The "as_made" of the film {0} cannot be read: delete it from the file.</source>
        <translation>Das „as_made“ der Folie {0} ist nicht lesbar: es aus der Datei löschen.</translation>
    </message>
    <message>
        <source>The 'at' of seam {0} of the list is no list of places. {1}</source>
        <translation>'at' der Naht {0} der Liste ist keine Liste von Stellen. {1}</translation>
    </message>
    <message>
        <source>The 'cut' of panel '{0}' is neither true nor false. Write one of them.</source>
        <translation>Das 'cut' der Bahn „{0}“ ist weder true noch false. Eines davon schreiben.</translation>
    </message>
    <message>
        <source>The 'ease' of the JSON file is no part of a length. Give a number from 0 to 1.</source>
        <translation>Das 'ease' der JSON-Datei ist kein Teil einer Länge. Eine Zahl von 0 bis 1 angeben.</translation>
    </message>
    <message>
        <source>The 'holes' of panel '{0}' are not a list of loops. {1}</source>
        <translation>Die 'holes' der Bahn „{0}“ sind keine Liste von Rändern. {1}</translation>
    </message>
    <message>
        <source>The 'natural_shape' of the JSON file is no length. Give the length of its gores.</source>
        <translation>Die 'natural_shape' der JSON-Datei ist keine Länge. Die Länge ihrer Segmente angeben.</translation>
    </message>
    <message>
        <source>The 'opening' of the JSON file has no panel and point. {0}</source>
        <translation>Die 'opening' der JSON-Datei hat keine Bahn und keinen Punkt. {0}</translation>
    </message>
    <message>
        <source>The 'panels' of seam {0} of the list are no names. {1}</source>
        <translation>Die 'panels' der Naht {0} der Liste sind keine Namen. {1}</translation>
    </message>
    <message>
        <source>The 'parts' of the JSON file are not a list of shapes. {0}</source>
        <translation>„parts“ der JSON-Datei ist keine Liste von Formen. {0}</translation>
    </message>
    <message>
        <source>The 'profile' of the JSON file needs at least two points. {0}</source>
        <translation>Das 'profile' der JSON-Datei braucht mindestens zwei Punkte. {0}</translation>
    </message>
    <message>
        <source>The '{0}' of the JSON file are not a list of {1}. {2}</source>
        <translation>„{0}“ der JSON-Datei ist keine Liste von {1}. {2}</translation>
    </message>
    <message>
        <source>The '{0}' of the body '{1}' is out of range. Choose {2}.</source>
        <translation>'{0}' des Körpers „{1}“ liegt außerhalb des Bereichs. {2} wählen.</translation>
    </message>
    <message>
        <source>The 3MF file has more than {0} bodies. Leave one of them in it.</source>
        <translation>Die 3MF-Datei hat mehr als {0} Körper. Einen davon darin lassen.</translation>
    </message>
    <message>
        <source>The 3MF file has no bodies. Save the body as a mesh of triangles.</source>
        <translation>Die 3MF-Datei hat keine Körper. Den Körper als Netz aus Dreiecken speichern.</translation>
    </message>
    <message>
        <source>The 3MF file is damaged ({}). Save it once more.</source>
        <translation>Die 3MF-Datei ist beschädigt ({}). Noch einmal speichern.</translation>
    </message>
    <message>
        <source>The 3MF file is too large. Simplify the mesh in the program it comes from.</source>
        <translation>Die 3MF-Datei ist zu groß. Das Netz im Programm vereinfachen, aus dem es stammt.</translation>
    </message>
    <message>
        <source>The DXF file has errors; what could be read was taken from it.</source>
        <translation>Die DXF-Datei hat Fehler; was lesbar war, wurde übernommen.</translation>
    </message>
    <message>
        <source>The DXF file {0}; millimetres are assumed.</source>
        <translation>Die DXF-Datei {0}; Millimeter werden angenommen.</translation>
    </message>
    <message>
        <source>The G-code turns the tool by {0}. FreeCAD takes that axis for one that turns the work: its 3D view shows the path turned.</source>
        <translation>Der G-Code dreht das Werkzeug mit {0}. FreeCAD hält diese Achse für eine, die das Werkstück dreht: Seine 3D-Ansicht zeigt den Weg verdreht.</translation>
    </message>
    <message>
        <source>The JSON file cannot be read ({0}). {1}</source>
        <translation>Die JSON-Datei ist nicht lesbar ({0}). {1}</translation>
    </message>
    <message>
        <source>The JSON file does not name its unit; millimetres are assumed.</source>
        <translation>Die JSON-Datei nennt keine Einheit; Millimeter werden angenommen.</translation>
    </message>
    <message>
        <source>The JSON file has no 'outer' loop. {0}</source>
        <translation>Die JSON-Datei hat keine Linie „outer“. {0}</translation>
    </message>
    <message>
        <source>The JSON file has no list of 'panels'. {0}</source>
        <translation>Die JSON-Datei hat keine Liste 'panels'. {0}</translation>
    </message>
    <message>
        <source>The JSON file has no list of 'seams'. {0}</source>
        <translation>Die JSON-Datei hat keine Liste 'seams'. {0}</translation>
    </message>
    <message>
        <source>The JSON file has the unknown unit {0}. Use one of {1}.</source>
        <translation>Die JSON-Datei hat die unbekannte Einheit {0}. {1} benutzen.</translation>
    </message>
    <message>
        <source>The JSON file's {0} needs at least {1}. {2}</source>
        <translation>{0} der JSON-Datei braucht mindestens {1}. {2}</translation>
    </message>
    <message>
        <source>The OBJ file has a face that is no list of points. Save it once more.</source>
        <translation>Die OBJ-Datei hat eine Fläche, die keine Liste von Punkten ist. Noch einmal speichern.</translation>
    </message>
    <message>
        <source>The OBJ file has no faces. Save the body as a mesh of triangles.</source>
        <translation>Die OBJ-Datei hat keine Flächen. Den Körper als Netz aus Dreiecken speichern.</translation>
    </message>
    <message>
        <source>The PLY file has no faces. Save the body as a mesh of triangles.</source>
        <translation>Die PLY-Datei hat keine Flächen. Den Körper als Netz aus Dreiecken speichern.</translation>
    </message>
    <message>
        <source>The PLY file is damaged: {} Save it once more.</source>
        <translation>Die PLY-Datei ist beschädigt: {} Noch einmal speichern.</translation>
    </message>
    <message>
        <source>The Poisson's ratio {0} is not between 0 and 0.5: give one such as 0.38.</source>
        <translation>Die Querkontraktionszahl {0} liegt nicht zwischen 0 und 0,5: zum Beispiel 0.38 angeben.</translation>
    </message>
    <message>
        <source>The Python package {0} is missing. {1} To get it: pip install {2}</source>
        <translation>Das Python-Paket {0} fehlt. {1} So kommt es: pip install {2}</translation>
    </message>
    <message>
        <source>The STL file is damaged, as it ends too early, or no STL file at all. Save it once more.</source>
        <translation>Die STL-Datei ist beschädigt, denn sie endet zu früh, oder keine STL-Datei. Noch einmal speichern.</translation>
    </message>
    <message>
        <source>The STL file is damaged: it has no triangles, or half of one. Save it once more.</source>
        <translation>Die STL-Datei ist beschädigt: sie hat keine Dreiecke oder ein halbes. Noch einmal speichern.</translation>
    </message>
    <message>
        <source>The SVG file cannot be read ({0}). Save it as plain SVG once more.</source>
        <translation>Die SVG-Datei ist nicht lesbar ({0}). Noch einmal als einfaches SVG speichern.</translation>
    </message>
    <message>
        <source>The SVG file defines entities, which are not read. Save it as plain SVG.</source>
        <translation>Die SVG-Datei definiert Entitäten, die nicht gelesen werden. Als einfaches SVG speichern.</translation>
    </message>
    <message>
        <source>The SVG file has a '{0}' of endless length. Save it as plain SVG once more.</source>
        <translation>Die SVG-Datei hat ein „{0}“ von endloser Länge. Noch einmal als einfaches SVG speichern.</translation>
    </message>
    <message>
        <source>The SVG file has too many attributes. Save it as plain SVG once more.</source>
        <translation>Die SVG-Datei hat zu viele Attribute. Noch einmal als einfaches SVG speichern.</translation>
    </message>
    <message>
        <source>The SVG file has too many styles. Save it as plain SVG once more.</source>
        <translation>Die SVG-Datei hat zu viele Stile. Noch einmal als einfaches SVG speichern.</translation>
    </message>
    <message>
        <source>The SVG file is damaged ({0}). Save it once more.</source>
        <translation>Die SVG-Datei ist beschädigt ({0}). Noch einmal speichern.</translation>
    </message>
    <message>
        <source>The Young's modulus across the grain {0} is too large for one along it of {1}: turn the grain by 90 degrees and exchange the two.</source>
        <translation>Der Elastizitätsmodul quer zur Laufrichtung {0} ist zu groß für den längs von {1}: die Laufrichtung um 90 Grad drehen und beide tauschen.</translation>
    </message>
    <message>
        <source>The accuracy decides the number of panels: give one of them.</source>
        <translation>Die Genauigkeit bestimmt die Zahl der Bahnen: nur eines von beiden angeben.</translation>
    </message>
    <message>
        <source>The accuracy must be above 0 and below 1: 0.003 is within 0.3 % of the diagonal.</source>
        <translation>Die Genauigkeit muss über 0 und unter 1 liegen: 0.003 heißt innerhalb von 0,3 % der Diagonale.</translation>
    </message>
    <message>
        <source>The accuracy must be above 0 and below 1: 0.01 is within 1 % of the profile.</source>
        <translation>Die Genauigkeit muss über 0 und unter 1 liegen: 0.01 ist innerhalb von 1 % des Profils.</translation>
    </message>
    <message>
        <source>The altitude {0} m is out of range: give one up to 11000 m.</source>
        <translation>Die Höhe {0} m ist außerhalb des Bereichs: bis 11000 m angeben.</translation>
    </message>
    <message>
        <source>The axis that turns the wheel or knife along the path, 0 along X, counter-clockwise from above; none for one that swivels or is round</source>
        <translation>Die Achse, die Rad oder Messer in die Richtung des Wegs dreht, 0 längs X, von oben gesehen gegen den Uhrzeigersinn; keine, wenn das Werkzeug sich von selbst dreht oder rund ist</translation>
    </message>
    <message>
        <source>The bag has no opening through which it is filled. Name the edge at which it stays open, such as edge 1 of panel '{0}', or make it without an intake.</source>
        <translation>Der Beutel hat keine Öffnung, durch die er gefüllt wird. Die Kante nennen, an der er offen bleibt, etwa Kante 1 der Bahn „{0}“, oder ihn ohne Füllhals machen.</translation>
    </message>
    <message>
        <source>The bag has {0} panels, more than {1}. Make it of fewer, larger ones.</source>
        <translation>Der Beutel hat {0} Bahnen, mehr als {1}. Ihn aus weniger und größeren machen.</translation>
    </message>
    <message>
        <source>The balloon</source>
        <translation>Der Ballon</translation>
    </message>
    <message>
        <source>The balloon has no opening: say at which edge it is filled, or choose no intake.</source>
        <translation>Der Ballon hat keine Öffnung: sagen, an welcher Kante er gefüllt wird, oder keinen Füllhals wählen.</translation>
    </message>
    <message>
        <source>The balloon has nothing that is called '{0}': {1}.</source>
        <translation>Der Ballon hat nichts, was „{0}“ heißt: {1}.</translation>
    </message>
    <message>
        <source>The balloon has parts too thin to fit the film with: use a wider shape.</source>
        <translation>Der Ballon hat Teile, die zu dünn sind, um die Folie daran anzupassen: eine breitere Form benutzen.</translation>
    </message>
    <message>
        <source>The balloon is not near rest. Inflate it anew.</source>
        <translation>Der Ballon ist nicht annähernd in Ruhe. Ihn neu aufblasen.</translation>
    </message>
    <message>
        <source>The balloon is nowhere {0} wide behind its intake: choose another intake angle or a narrower intake, else air enters slowly.</source>
        <translation>Der Ballon ist hinter seinem Füllhals nirgends {0} breit: eine andere Richtung oder einen schmaleren Hals wählen, sonst strömt Luft langsam ein.</translation>
    </message>
    <message>
        <source>The balloon must be thicker than 0, not {0}. Give its thickness.</source>
        <translation>Der Ballon muss dicker als 0 sein, nicht {0}. Seine Dicke angeben.</translation>
    </message>
    <message>
        <source>The balloon of {0} gores is {1} of its diagonal away from the profile on average, and {2} was asked for: its seams stand out by up to {3} over the middle of the gores. {4}</source>
        <translation>Der Ballon aus {0} Segmenten liegt im Mittel {1} seiner Diagonale neben dem Profil, und {2} waren verlangt: seine Nähte stehen bis zu {3} über die Mitte der Segmente hinaus. {4}</translation>
    </message>
    <message>
        <source>The balloon stays {0} from the body on average, {1} of its diagonal: flat panels bulge between their seams. Take more than {2} panels.</source>
        <translation>Der Ballon bleibt im Mittel {0} vom Körper entfernt, {1} von dessen Diagonale: flache Bahnen wölben sich zwischen ihren Nähten. Mehr als {2} Bahnen nehmen.</translation>
    </message>
    <message>
        <source>The balloon whose weld creases did not come to rest; what is told of it is its last good state.</source>
        <translation>Der Ballon mit knitternder Naht kam nicht zur Ruhe; die Angaben über ihn gelten für seinen letzten guten Stand.</translation>
    </message>
    <message>
        <source>The bar of {0} does not fit between marks that are {1} apart: make the balloon larger, or print several beside each other.</source>
        <translation>Der Balken von {0} passt nicht zwischen Marken im Abstand {1}: machen Sie den Ballon größer oder drucken Sie mehrere nebeneinander.</translation>
    </message>
    <message>
        <source>The bending floor must be between 0 and 1, not {0}. Usual is {1}.</source>
        <translation>Die Untergrenze der Biegesteifigkeit muss zwischen 0 und 1 liegen, nicht bei {0}. Üblich ist {1}.</translation>
    </message>
    <message>
        <source>The bleed must be from 0 to {0}, not {1}.</source>
        <translation>Der Anschnitt muss 0 bis {0} sein, nicht {1}.</translation>
    </message>
    <message>
        <source>The body '{0}' has no '{1}'. It has {2}.</source>
        <translation>Der Körper „{0}“ hat kein '{1}'. Er hat {2}.</translation>
    </message>
    <message>
        <source>The body has no plane of symmetry.</source>
        <translation>Der Körper hat keine Symmetrieebene.</translation>
    </message>
    <message>
        <source>The body has no seam. Draw seams, or take 2 panels or more.</source>
        <translation>Der Körper hat keine Naht. Nähte zeichnen oder mindestens 2 Bahnen nehmen.</translation>
    </message>
    <message>
        <source>The body has no seam. Draw seams, or take 2 panels or more.{0}</source>
        <translation>Der Körper hat keine Naht. Nähte zeichnen oder mindestens 2 Bahnen nehmen.{0}</translation>
    </message>
    <message>
        <source>The body has nothing near {0}. Give a place on its surface.</source>
        <translation>Der Körper hat nahe {0} nichts. Eine Stelle auf seiner Oberfläche angeben.</translation>
    </message>
    <message>
        <source>The body is thinner than {0} over {1} of its surface: film bulges there. Make such parts of two panels of their own, or thicker.</source>
        <translation>Der Körper ist auf {1} seiner Oberfläche dünner als {0}: Dort wölbt sich Film. Solche Teile aus zwei eigenen Bahnen machen, oder dicker.</translation>
    </message>
    <message>
        <source>The body is {0} long. Give a width or a height, so that it is between {1} and {2}.</source>
        <translation>Der Körper ist {0} lang. Eine Breite oder Höhe angeben, sodass er zwischen {1} und {2} liegt.</translation>
    </message>
    <message>
        <source>The body of the mesh is flat: it encloses {0} % of its size. Give a closed body, or a drawing for two equal panels.</source>
        <translation>Der Körper des Netzes ist flach: er umschließt {0} % seiner Größe. Einen geschlossenen Körper geben oder eine Zeichnung für zwei gleiche Bahnen.</translation>
    </message>
    <message>
        <source>The body of the profile is {0} high and {1} wide: no balloon is so flat. Draw its profile higher, or make it of two panels.</source>
        <translation>Der Körper des Profils ist {0} hoch und {1} breit: so flach ist kein Ballon. Sein Profil höher zeichnen oder ihn aus zwei Bahnen machen.</translation>
    </message>
    <message>
        <source>The camera finds the dots round a print, on the layer Register; the fifth tells how the sheet lies. The layer Register is not cut.</source>
        <translation>Die Kamera findet die Punkte um einen Druck, auf der Ebene Register; der fünfte sagt, wie der Bogen liegt. Die Ebene Register wird nicht geschnitten.</translation>
    </message>
    <message>
        <source>The caps are too large for the ball. Choose a smaller diameter for them.</source>
        <translation>Die Kappen sind zu groß für den Ball. Einen kleineren Durchmesser für sie wählen.</translation>
    </message>
    <message>
        <source>The card has no field {0}: choose one of {1}.</source>
        <translation>Die Karte hat kein Feld {0}: Wählen Sie eines von {1}.</translation>
    </message>
    <message>
        <source>The cluster cannot be made ({0}): check the file that --cluster names.</source>
        <translation>Der Cluster kann nicht erzeugt werden ({0}): die Datei prüfen, die --cluster nennt.</translation>
    </message>
    <message>
        <source>The colour would run out: close the line around this place first.</source>
        <translation>Die Farbe liefe aus: zuerst die Linie um diese Stelle schließen.</translation>
    </message>
    <message>
        <source>The connection to {0} ended before the whole native solver had come. Try again. {1}</source>
        <translation>Die Verbindung zu {0} endete, bevor der ganze native Löser da war. Noch einmal versuchen. {1}</translation>
    </message>
    <message>
        <source>The copied picture</source>
        <translation>Das kopierte Bild</translation>
    </message>
    <message>
        <source>The cutter finds the four discs round a print itself. VersaWorks prints discs of its own: give it the PDF for print and cut instead. The layer REGISTRATION is not cut.</source>
        <translation>Die Schneidemaschine findet die vier Scheiben um einen Druck selbst. VersaWorks druckt eigene Scheiben: geben Sie ihm stattdessen das PDF zum Drucken und Schneiden. Die Ebene REGISTRATION wird nicht geschnitten.</translation>
    </message>
    <message>
        <source>The cutter finds the squares at both sides of a print itself, on the layer Regmark, which is not cut. Set their size of 3 mm and their distances there, where its program does not read them. Feed the sheet with its lower edge first.</source>
        <translation>Die Schneidemaschine findet die Quadrate an beiden Seiten eines Drucks selbst, auf der Ebene Regmark, die nicht geschnitten wird. Stellen Sie dort ihre Größe von 3 mm und ihre Abstände ein, wo ihr Programm sie nicht liest. Legen Sie den Bogen mit der Unterkante voran ein.</translation>
    </message>
    <message>
        <source>The drawing cannot be reached everywhere: the silhouette is up to {} off it.</source>
        <translation>Die Zeichnung ist nicht überall erreichbar: Die Silhouette weicht bis zu {} ab.</translation>
    </message>
    <message>
        <source>The drawing has a curve through more than {0} points. Save it as a polyline.</source>
        <translation>Die Zeichnung hat eine Kurve durch mehr als {0} Punkte. Sie als Polylinie speichern.</translation>
    </message>
    <message>
        <source>The drawing has blocks or copies that show themselves. Remove those from it.</source>
        <translation>Die Zeichnung hat Blöcke oder Kopien, die sich selbst zeigen. Diese entfernen.</translation>
    </message>
    <message>
        <source>The drawing has more than {0} elements, with those of its blocks and copies. Leave only the outline and its holes in it.</source>
        <translation>Die Zeichnung hat mehr als {0} Elemente, die ihrer Blöcke und Kopien mitgezählt. Nur den Umriss und seine Löcher darin lassen.</translation>
    </message>
    <message>
        <source>The drawing has more than {0} groups or blocks inside each other. Take them apart in the program it comes from.</source>
        <translation>In der Zeichnung stecken mehr als {0} Gruppen oder Blöcke ineinander. Sie im Programm auflösen, aus dem sie stammt.</translation>
    </message>
    <message>
        <source>The drawing has more than {0} points. Simplify it in the program it comes from, or leave only the outline and its holes in it.</source>
        <translation>Die Zeichnung hat mehr als {0} Punkte. Sie im Programm vereinfachen, aus dem sie stammt, oder nur den Umriss und seine Löcher darin lassen.</translation>
    </message>
    <message>
        <source>The drawing has no closed line. Draw one, and turn texts and groups into paths.</source>
        <translation>Die Zeichnung hat keine geschlossene Linie. Eine zeichnen, und Texte und Gruppen in Pfade umwandeln.</translation>
    </message>
    <message>
        <source>The drawing has no line. {0}</source>
        <translation>Die Zeichnung hat keine Linie. {0}</translation>
    </message>
    <message>
        <source>The drawing has points more than {0} km from its origin. Move it there, and give it a size between 1 mm and 100 m.</source>
        <translation>Die Zeichnung hat Punkte weiter als {0} km vom Ursprung. Sie dorthin verschieben und ihr eine Größe von 1 mm bis 100 m geben.</translation>
    </message>
    <message>
        <source>The drawing has too much text in its styles and transforms. Save it as plain SVG once more.</source>
        <translation>Die Zeichnung hat zu viel Text in ihren Stilen und Transformationen. Noch einmal als einfaches SVG speichern.</translation>
    </message>
    <message>
        <source>The drawing has {0} lines beside the axis, not one. {1}</source>
        <translation>Die Zeichnung hat {0} Linien neben der Achse statt einer. {1}</translation>
    </message>
    <message>
        <source>The drawing has {0} shape and no number {1}: choose another Part, or delete this balloon.</source>
        <translation>Die Zeichnung hat {0} Form und keine Nummer {1}: unter „Part“ eine andere wählen oder diesen Ballon löschen.</translation>
    </message>
    <message>
        <source>The drawing has {0} shapes and no number {1}: choose another Part, or delete this balloon.</source>
        <translation>Die Zeichnung hat {0} Formen und keine Nummer {1}: unter „Part“ eine andere wählen oder diesen Ballon löschen.</translation>
    </message>
    <message>
        <source>The drawing is open: a line starts at {0} and ends {1} away at {2}. Close it.</source>
        <translation>Die Zeichnung ist offen: Eine Linie beginnt bei {0} und endet {1} entfernt bei {2}. Sie schließen.</translation>
    </message>
    <message>
        <source>The drawing takes more than {0} s to read. Simplify it in the program it comes from, or leave only the outline and its holes in it.</source>
        <translation>Die Zeichnung zu lesen dauert länger als {0} s. Sie im Programm vereinfachen, aus dem sie stammt, oder nur den Umriss und seine Löcher darin lassen.</translation>
    </message>
    <message>
        <source>The drawing was made symmetric: its halves were {0} apart, the left one was kept.</source>
        <translation>Die Zeichnung wurde symmetrisch gemacht: Ihre Hälften lagen {0} auseinander, die linke blieb.</translation>
    </message>
    <message>
        <source>The drawing would be smaller than {0}: choose a larger lift.</source>
        <translation>Die Zeichnung würde kleiner als {0}: einen größeren Auftrieb wählen.</translation>
    </message>
    <message>
        <source>The drawing; a copy of it travels in the document</source>
        <translation>Die Zeichnung; eine Kopie davon liegt im Dokument</translation>
    </message>
    <message>
        <source>The edges of the chosen seam are free again</source>
        <translation>Die Kanten der gewählten Naht sind wieder frei</translation>
    </message>
    <message>
        <source>The end of a seam cannot be moved alone. Take hold of the seam between its ends.</source>
        <translation>Das Ende einer Naht lässt sich nicht allein verschieben. Die Naht zwischen ihren Enden anfassen.</translation>
    </message>
    <message>
        <source>The error of {0} is of the whole contour: leave "along" out.</source>
        <translation>Die Abweichung von {0} gilt der ganzen Kontur: „along“ weglassen.</translation>
    </message>
    <message>
        <source>The error of {0} is per {1}: write "{2}" or "{3}".</source>
        <translation>Die Abweichung von {0} gilt je {1}: „{2}“ oder „{3}“ schreiben.</translation>
    </message>
    <message>
        <source>The faces of {0} cannot be told from each other in a mesh. Repair the solid, or give a mesh of it.</source>
        <translation>Die Flächen von {0} lassen sich in einem Netz nicht voneinander unterscheiden. Den Volumenkörper reparieren oder ein Netz davon geben.</translation>
    </message>
    <message>
        <source>The field {0} of this card makes no machine: {1}</source>
        <translation>Das Feld {0} dieser Karte ergibt keine Maschine: {1}</translation>
    </message>
    <message>
        <source>The file does not name its unit: the largest size in it, {0}, is taken as metres. Give a width to have another one.</source>
        <translation>Die Datei nennt ihre Einheit nicht: Das größte Maß darin, {0}, wird als Meter genommen. Für eine andere Größe eine Breite angeben.</translation>
    </message>
    <message>
        <source>The file has no solid that can be read. Save it once more as STEP.</source>
        <translation>Die Datei hat keinen lesbaren Volumenkörper. Noch einmal als STEP speichern.</translation>
    </message>
    <message>
        <source>The file is XML but no SVG drawing. Choose a drawing.</source>
        <translation>Die Datei ist XML, aber keine SVG-Zeichnung. Eine Zeichnung wählen.</translation>
    </message>
    <message>
        <source>The file is damaged or not a DXF file. Save it once more.</source>
        <translation>Die Datei ist beschädigt oder keine DXF-Datei. Noch einmal speichern.</translation>
    </message>
    <message>
        <source>The file of gases {0} is of no use: {1}. Install it anew.</source>
        <translation>Die Gasdatei {0} ist unbrauchbar: {1}. Sie neu installieren.</translation>
    </message>
    <message>
        <source>The file of rules {0} is of no use: {1}. Install it anew.</source>
        <translation>Die Regeldatei {0} ist unbrauchbar: {1}. Sie neu installieren.</translation>
    </message>
    <message>
        <source>The file of the pattern</source>
        <translation>Die Ausgabe der Schnittmuster</translation>
    </message>
    <message>
        <source>The file of what is left of another layout: pieces are laid inside it first</source>
        <translation>Die Datei dessen, was von einer anderen Anordnung übrig ist: Stücke werden zuerst hineingelegt</translation>
    </message>
    <message>
        <source>The file test-card.json that was written with the card</source>
        <translation>Die Datei test-card.json, die mit der Karte geschrieben wurde</translation>
    </message>
    <message>
        <source>The file {0} is of no use: {1}. Install it anew.</source>
        <translation>Die Datei {0} ist unbrauchbar: {1}. Sie neu installieren.</translation>
    </message>
    <message>
        <source>The files that it, or its program, opens</source>
        <translation>Die Dateien, die sie oder ihr Programm öffnet</translation>
    </message>
    <message>
        <source>The film '{0}' has no mass. Give its areal density.</source>
        <translation>Die Folie „{0}“ hat keine Masse. Ihr Flächengewicht angeben.</translation>
    </message>
    <message>
        <source>The film came to rest</source>
        <translation>Die Folie kam zur Ruhe</translation>
    </message>
    <message>
        <source>The film comes as near as {0} to the body, and a margin of {1} was asked for. Take more panels, or a larger margin.</source>
        <translation>Die Folie kommt dem Körper bis auf {0} nahe, verlangt war ein Abstand von {1}. Mehr Bahnen nehmen oder einen größeren Abstand.</translation>
    </message>
    <message>
        <source>The film did not come to rest: its numbers are estimates.</source>
        <translation>Die Folie kam nicht zur Ruhe: Ihre Zahlen sind Schätzungen.</translation>
    </message>
    <message>
        <source>The film file {0} calls itself "{1}": give both the same name.</source>
        <translation>Die Foliendatei {0} nennt sich „{1}“: beiden denselben Namen geben.</translation>
    </message>
    <message>
        <source>The film file {0} is of no use: {1}</source>
        <translation>Die Foliendatei {0} ist unbrauchbar: {1}</translation>
    </message>
    <message>
        <source>The film file {0} lacks {1}: add it.</source>
        <translation>In der Foliendatei {0} fehlt {1}: es ergänzen.</translation>
    </message>
    <message>
        <source>The film folds up and nothing of it is seen from above: make the shape thicker.</source>
        <translation>Die Folie faltet sich, und von oben ist nichts von ihr zu sehen: die Form dicker machen.</translation>
    </message>
    <message>
        <source>The film lies from {0} to {1} outside of the body</source>
        <translation>Die Folie liegt von {0} bis {1} außerhalb des Körpers</translation>
    </message>
    <message>
        <source>The film needs a width of more than two spacings, and no spacing below 0.</source>
        <translation>Die Folie muss breiter sein als zwei Abstände, und kein Abstand kleiner als 0.</translation>
    </message>
    <message>
        <source>The film of shop-bought foil balloons: 15 µm oriented nylon 6 with an aluminium coat, 15 µm polyethylene inside. Weld PE to PE. Nylon takes up moisture and is then softer.</source>
        <translation>Die Folie der Ballons aus dem Laden: 15 µm orientiertes Nylon 6 mit Aluminiumschicht, innen 15 µm Polyethylen. PE auf PE schweißen. Nylon nimmt Feuchtigkeit auf und wird dann weicher.</translation>
    </message>
    <message>
        <source>The film passes through itself near {0}, which the simulation does not feel: the balloon will look otherwise there. Move those parts away from each other.</source>
        <translation>Die Folie geht bei {0} durch sich selbst hindurch, was die Simulation nicht merkt: der Ballon wird dort anders aussehen. Diese Teile voneinander entfernen.</translation>
    </message>
    <message>
        <source>The film stays up to {0} away from the profile, even half way between the seams and the middle of the gores: it cannot take this shape. Round the profile where it is flat, hollow or sharp.</source>
        <translation>Die Folie bleibt bis zu {0} vom Profil entfernt, auch auf halbem Weg zwischen den Nähten und der Mitte der Segmente: sie kann diese Form nicht annehmen. Das Profil runden, wo es flach, hohl oder spitz ist.</translation>
    </message>
    <message>
        <source>The first {0} of {1} rows, without a balloon: {2}</source>
        <translation>Die ersten {0} von {1} Zeilen, ohne Ballon: {2}</translation>
    </message>
    <message>
        <source>The first {0} rows; the others are in table.csv.</source>
        <translation>Die ersten {0} Zeilen; die übrigen stehen in table.csv.</translation>
    </message>
    <message>
        <source>The folder '{0}' has vanished: bring it back or choose another one, and start the study again.</source>
        <translation>Der Ordner „{0}“ ist verschwunden: ihn zurückholen oder einen anderen wählen und die Studie noch einmal starten.</translation>
    </message>
    <message>
        <source>The free edition opens DXF, not SVG. Choose "as is" for the size in the import preferences. Silhouette adds the knife's offset and overcut. Nothing is in the file that may not be cut. Studio draws registration marks itself, print them from there; or set page A4, inset 10.01 mm, length 8.38 mm and thickness 0.99 mm there (0.394, 0.33 and 0.039 in) and lay the file's marks on them, not to be cut: a print has the same. Nothing is cut outside them.</source>
        <translation>Die kostenlose Ausgabe öffnet DXF, nicht SVG. Wählen Sie "wie es ist" für die Größe in den Importeinstellungen. Silhouette fügt Messerversatz und Überschnitt selbst hinzu. In der Datei ist nichts, was nicht geschnitten werden darf. Studio zeichnet Passermarken selbst, drucken Sie sie von dort; oder stellen Sie dort Seite A4, Abstand 10,01 mm, Länge 8,38 mm und Dicke 0,99 mm ein (0,394, 0,33 und 0,039 Zoll) und legen Sie die Marken der Datei darauf, nicht zum Schneiden: ein Druck hat dieselben. Außerhalb davon wird nichts geschnitten.</translation>
    </message>
    <message>
        <source>The goal has {0} combinations to choose from, of which each is tried: list 1 to {1}.</source>
        <translation>Das Ziel hat {0} Kombinationen zur Auswahl, von denen jede probiert wird: 1 bis {1} aufzählen.</translation>
    </message>
    <message>
        <source>The goal is no JSON object: write {0}.</source>
        <translation>Das Ziel ist kein JSON-Objekt: {0} schreiben.</translation>
    </message>
    <message>
        <source>The grain's angle {0} is no number: give degrees from the x axis.</source>
        <translation>Der Winkel der Laufrichtung {0} ist keine Zahl: Grad ab der x-Achse angeben.</translation>
    </message>
    <message>
        <source>The gussets are deeper than the pouch is high. Choose a smaller depth.</source>
        <translation>Die Seitenfalten sind tiefer, als der Beutel hoch ist. Eine kleinere Tiefe wählen.</translation>
    </message>
    <message>
        <source>The hand beside the shape is as large as a grown-up's</source>
        <translation>Die Hand neben der Form ist so groß wie die eines Erwachsenen</translation>
    </message>
    <message>
        <source>The hole at {0} is too small for a {1} seal, and its weld reaches {2} into the balloon: make the hole at least {3} wide, or the seal narrower.</source>
        <translation>Das Loch bei {0} ist zu klein für eine Naht von {1}, und seine Schweißnaht reicht {2} in den Ballon: das Loch mindestens {3} breit machen oder die Naht schmaler.</translation>
    </message>
    <message>
        <source>The hole at {0} is welded but not cut out: for that, make it wider than two seals with their allowances, {1}.</source>
        <translation>Das Loch bei {0} wird geschweißt, aber nicht ausgeschnitten: dafür breiter machen als zwei Nähte mit Zugabe, {1}.</translation>
    </message>
    <message>
        <source>The hole at {0} lies in another hole; remove one of them.</source>
        <translation>Das Loch bei {0} liegt in einem anderen Loch; eines davon entfernen.</translation>
    </message>
    <message>
        <source>The hole at {0} lies outside the outline; move it inside.</source>
        <translation>Das Loch bei {0} liegt außerhalb des Umrisses; nach innen verschieben.</translation>
    </message>
    <message>
        <source>The holes of a filled shape stay, the lines of a pen drawing are filled inside</source>
        <translation>Die Löcher einer gefüllten Form bleiben, die Linien einer Strichzeichnung werden innen gefüllt</translation>
    </message>
    <message>
        <source>The inflated outline stays {0} from the drawing on average: film cannot follow this shape everywhere. Round off notches and widen thin parts.</source>
        <translation>Der aufgeblasene Umriss bleibt im Mittel {0} von der Zeichnung entfernt: Die Folie kann dieser Form nicht überall folgen. Kerben runden und dünne Teile verbreitern.</translation>
    </message>
    <message>
        <source>The inflated outline stays {0} from the drawing on average: the balloon folds across a hole or a spot.</source>
        <translation>Der aufgeblasene Umriss bleibt im Mittel {0} von der Zeichnung entfernt: Der Ballon faltet sich quer über ein Loch oder einen Schweißpunkt.</translation>
    </message>
    <message>
        <source>The intake cannot lead into a hole of panel {0}: say another edge for the opening.</source>
        <translation>Der Füllhals kann nicht in ein Loch der Bahn {0} führen: eine andere Kante für die Öffnung angeben.</translation>
    </message>
    <message>
        <source>The intake file {0} calls itself "{1}": give both the same name.</source>
        <translation>Die Füllhals-Datei {0} nennt sich „{1}“: beiden denselben Namen geben.</translation>
    </message>
    <message>
        <source>The intake file {0} is of no use: {1}</source>
        <translation>Die Füllhals-Datei {0} ist unbrauchbar: {1}</translation>
    </message>
    <message>
        <source>The intake file {0} lacks {1}: add it.</source>
        <translation>In der Füllhals-Datei {0} fehlt {1}: es ergänzen.</translation>
    </message>
    <message>
        <source>The intake is at the farthest point, on a part that becomes {measured} as thick as the balloon: there it is tied, hangs and is held. A low place carries it better.</source>
        <translation>Der Füllhals sitzt am fernsten Punkt, an einem Teil, der nur {measured} der Dicke des Ballons erreicht: Dort wird der Ballon angebunden, aufgehängt und gehalten. Ein Ort unten trägt ihn besser.</translation>
    </message>
    <message>
        <source>The intake opens into a part with {percent} of the film; the rest fills through something narrower than the intake. Move it to the largest part.</source>
        <translation>Der Füllhals mündet in einen Teil mit {percent} der Folie; der Rest füllt sich durch etwas Engeres als der Hals. Ihn zum größten Teil verlegen.</translation>
    </message>
    <message>
        <source>The intake was left out of the comparison.</source>
        <translation>Der Füllhals wurde beim Vergleich weggelassen.</translation>
    </message>
    <message>
        <source>The intake would run into another part of the balloon: choose another angle or length for it.</source>
        <translation>Der Füllhals liefe in einen anderen Teil des Ballons: einen anderen Winkel oder eine andere Länge wählen.</translation>
    </message>
    <message>
        <source>The intake's angle must be a number.</source>
        <translation>Der Winkel des Füllhalses muss eine Zahl sein.</translation>
    </message>
    <message>
        <source>The intake's direction is of two equal panels: of many, say a seam and how far along it.</source>
        <translation>Die Richtung des Füllhalses gilt bei zwei gleichen Bahnen: bei vielen eine Naht angeben und wie weit daran entlang.</translation>
    </message>
    <message>
        <source>The intake's length must be above 0, up to 100 m: give it about 30 mm.</source>
        <translation>Die Länge des Füllhalses muss über 0 liegen, bis 100 m: etwa 30 mm angeben.</translation>
    </message>
    <message>
        <source>The intake's place along the seam must be a length.</source>
        <translation>Der Ort des Füllhalses entlang der Naht muss eine Länge sein.</translation>
    </message>
    <message>
        <source>The intake's place cannot be "{0}": choose {1}.</source>
        <translation>Der Ort des Füllhalses kann nicht „{0}“ sein: {1} wählen.</translation>
    </message>
    <message>
        <source>The intake's width must be between 0.01 mm and 10 m: give it about 10 mm.</source>
        <translation>Die Breite des Füllhalses muss zwischen 0,01 mm und 10 m liegen: etwa 10 mm angeben.</translation>
    </message>
    <message>
        <source>The intakes of two chambers run into each other: leave a gap in the weld between them, or choose another place for the first.</source>
        <translation>Die Füllhälse zweier Kammern stoßen aneinander: eine Lücke in der Naht dazwischen lassen oder den ersten anderswo anbringen.</translation>
    </message>
    <message>
        <source>The label "{0}" is {1} long, and the film is only {2} wide: take a shorter text or lower letters.</source>
        <translation>Die Beschriftung „{0}“ ist {1} lang, und die Folie nur {2} breit: einen kürzeren Text oder niedrigere Buchstaben nehmen.</translation>
    </message>
    <message>
        <source>The last {length} of this tip stay flat. A radius of {wanted} makes it rounder.</source>
        <translation>Das Ende dieser Spitze bleibt flach, auf {length}. Ein Radius von {wanted} macht es runder.</translation>
    </message>
    <message>
        <source>The layer MARK of the machine file {0}.json takes notches only. Rename it NOTCH, and where your machine can draw, add the layers FOLD and PEN.</source>
        <translation>Die Ebene MARK der Maschinendatei {0}.json nimmt nur Passkerben auf. Sie in NOTCH umbenennen, und wenn die Maschine zeichnen kann, die Ebenen FOLD und PEN ergänzen.</translation>
    </message>
    <message>
        <source>The layout failed: give the pieces more room.</source>
        <translation>Das Auslegen ist gescheitert: den Stücken mehr Platz geben.</translation>
    </message>
    <message>
        <source>The layout of {0} is older than its patterns: recompute it.</source>
        <translation>Die Anordnung von {0} ist älter als ihre Schnittmuster: neu berechnen.</translation>
    </message>
    <message>
        <source>The layout on film</source>
        <translation>Die Anordnung auf Folie</translation>
    </message>
    <message>
        <source>The layout was stopped; nothing was changed.</source>
        <translation>Das Auslegen wurde angehalten; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The line at {0} divides no panel.</source>
        <translation>Die Linie bei {0} teilt keine Bahn.</translation>
    </message>
    <message>
        <source>The line at {0} misses the body.</source>
        <translation>Die Linie bei {0} verfehlt den Körper.</translation>
    </message>
    <message>
        <source>The lines make up for a kerf of {0} already: leave LightBurn's kerf offset at 0.</source>
        <translation>Die Linien gleichen eine Schnittfuge von {0} schon aus: den Schnittfugenversatz (Kerf) von LightBurn auf 0 lassen.</translation>
    </message>
    <message>
        <source>The lines of the drawing do not close around anything: the outline follows the lines.</source>
        <translation>Die Linien der Zeichnung umschließen nichts: Der Umriss folgt den Linien.</translation>
    </message>
    <message>
        <source>The machine file {0} calls itself "{1}": give both the same name.</source>
        <translation>Die Maschinendatei {0} nennt sich „{1}“: beiden denselben Namen geben.</translation>
    </message>
    <message>
        <source>The machine file {0} is of no use: {1}</source>
        <translation>Die Maschinendatei {0} ist unbrauchbar: {1}</translation>
    </message>
    <message>
        <source>The machine file {0} lacks {1}: add it.</source>
        <translation>In der Maschinendatei {0} fehlt {1}: es ergänzen.</translation>
    </message>
    <message>
        <source>The machine that finds the print again by its registration marks, printed round it</source>
        <translation>Die Maschine, die den Druck an seinen Passermarken wiederfindet, die um ihn gedruckt werden</translation>
    </message>
    <message>
        <source>The marks round the print span {0}, and {1} takes at most {2}: make the balloon smaller, or print and cut it on another machine.</source>
        <translation>Die Marken um den Druck spannen {0}, und {1} nimmt höchstens {2}: machen Sie den Ballon kleiner oder drucken und schneiden Sie ihn auf einer anderen Maschine.</translation>
    </message>
    <message>
        <source>The mesh has a triangle with a point that is not there. Save it once more.</source>
        <translation>Das Netz hat ein Dreieck mit einem Punkt, den es nicht gibt. Noch einmal speichern.</translation>
    </message>
    <message>
        <source>The mesh has a vertex without triangles. Mesh the outline anew.</source>
        <translation>Das Netz hat einen Knoten ohne Dreieck. Den Umriss neu vernetzen.</translation>
    </message>
    <message>
        <source>The mesh has no triangle. Save the body as a mesh of triangles.</source>
        <translation>Das Netz hat kein Dreieck. Den Körper als Netz aus Dreiecken speichern.</translation>
    </message>
    <message>
        <source>The mesh has too many triangles, more than {0}. Simplify it in the program that it comes from.</source>
        <translation>Das Netz hat zu viele Dreiecke, mehr als {0}. Es in dem Programm vereinfachen, aus dem es kommt.</translation>
    </message>
    <message>
        <source>The mesh is flat. Give a closed body, or a drawing for two equal panels.</source>
        <translation>Das Netz ist flach. Einen geschlossenen Körper geben oder eine Zeichnung für zwei gleiche Bahnen.</translation>
    </message>
    <message>
        <source>The mesh is not closed: a hole is {0} % of its size long round. Close it in the program that the mesh comes from.</source>
        <translation>Das Netz ist nicht geschlossen: ein Loch misst rundum {0} % seiner Größe. Es in dem Programm schließen, aus dem das Netz kommt.</translation>
    </message>
    <message>
        <source>The mesh size is {0}: give one above 0.</source>
        <translation>Die Netzweite ist {0}: einen Wert über 0 angeben.</translation>
    </message>
    <message>
        <source>The mesh was made simpler. Its triangles were: {0}.</source>
        <translation>Das Netz wurde vereinfacht. Es hatte so viele Dreiecke: {0}.</translation>
    </message>
    <message>
        <source>The moving picture was stopped.</source>
        <translation>Das bewegte Bild wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The native solver cannot be saved. {0}</source>
        <translation>Der native Löser kann nicht gespeichert werden. {0}</translation>
    </message>
    <message>
        <source>The native solver could not be fetched from {0} ({1}). Try again when the network is there. {2}</source>
        <translation>Der native Löser konnte nicht von {0} heruntergeladen werden ({1}). Noch einmal versuchen, wenn das Netzwerk da ist. {2}</translation>
    </message>
    <message>
        <source>The native solver is here already.</source>
        <translation>Der native Löser ist schon da.</translation>
    </message>
    <message>
        <source>The native solver is in use now.</source>
        <translation>Der native Löser wird jetzt benutzt.</translation>
    </message>
    <message>
        <source>The native solver is not available: {0} Use the NumPy solver.</source>
        <translation>Der native Löser ist nicht verfügbar: {0} Den NumPy-Löser benutzen.</translation>
    </message>
    <message>
        <source>The native solver is not installed. Everything works without it, but simulations take 20 to 30 times longer. Fetch it now?</source>
        <translation>Der native Löser ist nicht installiert. Alles funktioniert ohne ihn, aber Simulationen dauern 20- bis 30-mal so lange. Ihn jetzt herunterladen?</translation>
    </message>
    <message>
        <source>The native solver was fetched, but does not run here: {0}</source>
        <translation>Der native Löser wurde heruntergeladen, läuft hier aber nicht: {0}</translation>
    </message>
    <message>
        <source>The native solver was not fetched: stopped.</source>
        <translation>Der native Löser wurde nicht heruntergeladen: angehalten.</translation>
    </message>
    <message>
        <source>The native solver, which is faster, is not available: {0}</source>
        <translation>Der schnellere native Löser ist nicht verfügbar: {0}</translation>
    </message>
    <message>
        <source>The nozzle's flange must be wider than its bore.</source>
        <translation>Der Flansch des Stutzens muss breiter sein als seine Bohrung.</translation>
    </message>
    <message>
        <source>The number that the controller takes for full power: $30 of GRBL</source>
        <translation>Die Zahl, die die Steuerung für volle Leistung nimmt: $30 bei GRBL</translation>
    </message>
    <message>
        <source>The opening is at point {0} of panel '{1}', whose points are 0 to {2}. Choose one of them.</source>
        <translation>Die Öffnung ist am Punkt {0} der Bahn „{1}“, deren Punkte 0 bis {2} sind. Einen davon wählen.</translation>
    </message>
    <message>
        <source>The opening is on a panel '{0}' that is not there. {1}</source>
        <translation>Die Öffnung ist an einer Bahn „{0}“, die es nicht gibt. {1}</translation>
    </message>
    <message>
        <source>The opening is on panel {0}, but there are {1}. Choose one of them.</source>
        <translation>Die Öffnung ist an Bahn {0}, aber es gibt {1}. Eine davon wählen.</translation>
    </message>
    <message>
        <source>The options cannot be used ({0}). See --help.</source>
        <translation>Die Optionen sind nicht brauchbar ({0}). Siehe --help.</translation>
    </message>
    <message>
        <source>The outline cannot be mirrored about its axis: draw it symmetric, or leave that.</source>
        <translation>Der Umriss kann nicht an seiner Achse gespiegelt werden: ihn symmetrisch zeichnen oder so lassen.</translation>
    </message>
    <message>
        <source>The outline comes to its axis more than once. {0}</source>
        <translation>Der Umriss kommt mehr als einmal an seine Achse. {0}</translation>
    </message>
    <message>
        <source>The outline crosses or nearly touches itself near {0}: separate the parts that meet there.</source>
        <translation>Der Umriss kreuzt oder berührt sich fast nahe {0}: die Teile dort trennen.</translation>
    </message>
    <message>
        <source>The outline crosses or touches itself and cannot be meshed: separate the parts that meet.</source>
        <translation>Der Umriss kreuzt oder berührt sich und kann nicht vernetzt werden: die Teile trennen.</translation>
    </message>
    <message>
        <source>The outline crosses or touches itself and cannot be mirrored; part the lines.</source>
        <translation>Der Umriss kreuzt oder berührt sich und kann nicht gespiegelt werden; die Linien trennen.</translation>
    </message>
    <message>
        <source>The outline does not pass there any more: delete the edit.</source>
        <translation>Der Umriss läuft dort nicht mehr entlang: die Bearbeitung löschen.</translation>
    </message>
    <message>
        <source>The outline encloses no area; draw a closed shape with at least three corners.</source>
        <translation>Der Umriss umschließt keine Fläche; eine geschlossene Form mit mindestens drei Ecken zeichnen.</translation>
    </message>
    <message>
        <source>The outline has a coordinate that is not a number; correct it in the drawing.</source>
        <translation>Der Umriss hat eine Koordinate, die keine Zahl ist; sie in der Zeichnung berichtigen.</translation>
    </message>
    <message>
        <source>The outline has no straight upright side on its left, so its axis is missing. {0}</source>
        <translation>Der Umriss hat links keine gerade, aufrechte Seite, also fehlt seine Achse. {0}</translation>
    </message>
    <message>
        <source>The outline runs another way there: delete the edit.</source>
        <translation>Der Umriss läuft dort anders: die Bearbeitung löschen.</translation>
    </message>
    <message>
        <source>The outline's {0} of {1} cannot be made; bring it to a size between 1 mm and 100 m.</source>
        <translation>Der Umriss kann keine {0} von {1} haben; ihn auf eine Größe zwischen 1 mm und 100 m bringen.</translation>
    </message>
    <message>
        <source>The page will be in English, as no font here has the letters of your language: install IPAexGothic or Noto Sans CJK JP, and open this panel again.</source>
        <translation>Die Seite wird englisch, denn keine Schrift hat hier die Zeichen Ihrer Sprache: IPAexGothic oder Noto Sans CJK JP installieren und dieses Fenster neu öffnen.</translation>
    </message>
    <message>
        <source>The painting cannot be written to '{}': is the disk full?</source>
        <translation>Das Gemalte kann nicht nach „{}“ geschrieben werden: Ist der Datenträger voll?</translation>
    </message>
    <message>
        <source>The panels are sealed to {0} bodies. Inflate each by itself.</source>
        <translation>Die Bahnen sind zu {0} Körpern verschweißt. Jeden für sich aufblasen.</translation>
    </message>
    <message>
        <source>The panels are sealed to {0} bodies: panel '{1}' does not hang together with panel '{2}'. Make a bag of each body.</source>
        <translation>Die Bahnen sind zu {0} Körpern verschweißt: Bahn „{1}“ hängt nicht mit Bahn „{2}“ zusammen. Aus jedem Körper einen eigenen Beutel machen.</translation>
    </message>
    <message>
        <source>The panels have no names. {0}</source>
        <translation>Die Bahnen haben keine Namen. {0}</translation>
    </message>
    <message>
        <source>The panels have other points than those that were meshed. Mesh the bag anew.</source>
        <translation>Die Bahnen haben andere Punkte als die vernetzten. Den Beutel neu vernetzen.</translation>
    </message>
    <message>
        <source>The panels have {0} points, more than {1}. Simplify them in the program that they come from.</source>
        <translation>Die Bahnen haben {0} Punkte, mehr als {1}. Sie in dem Programm vereinfachen, aus dem sie kommen.</translation>
    </message>
    <message>
        <source>The part round {0} has no rim for an intake: leave a gap in the welds round it.</source>
        <translation>Der Teil um {0} hat keinen Rand für einen Füllhals: in den Schweißnähten darum eine Lücke lassen.</translation>
    </message>
    <message>
        <source>The pattern becomes too thin for its mesh. Widen the thin parts, or use a finer mesh.</source>
        <translation>Das Schnittmuster wird zu dünn für sein Netz. Dünne Teile verbreitern oder ein feineres Netz benutzen.</translation>
    </message>
    <message>
        <source>The pattern crosses itself near {0}: simplify the drawing there.</source>
        <translation>Das Schnittmuster kreuzt sich nahe {0}: die Zeichnung dort vereinfachen.</translation>
    </message>
    <message>
        <source>The pattern has no lines for {0}, which takes {1}: choose another machine.</source>
        <translation>Das Schnittmuster hat keine Linien für {0}, das {1} verarbeitet: eine andere Maschine wählen.</translation>
    </message>
    <message>
        <source>The pattern is being fitted to the painting ...</source>
        <translation>Das Schnittmuster wird an das Gemalte angepasst ...</translation>
    </message>
    <message>
        <source>The pattern measures {0}, the bed of {1} is {2}</source>
        <translation>Das Schnittmuster misst {0}, das Bett von {1} {2}</translation>
    </message>
    <message>
        <source>The photograph shows the back: it was mirrored.</source>
        <translation>Das Foto zeigt die Rückseite: es wurde gespiegelt.</translation>
    </message>
    <message>
        <source>The photograph shows too many shapes: take one of the balloon alone, on a plain background.</source>
        <translation>Das Foto zeigt zu viele Formen: eines vom Ballon allein aufnehmen, vor einem einfarbigen Hintergrund.</translation>
    </message>
    <message>
        <source>The picture has a single colour. Choose one that shows a shape on a background.</source>
        <translation>Das Bild hat nur eine Farbe. Eines wählen, das eine Form vor einem Hintergrund zeigt.</translation>
    </message>
    <message>
        <source>The picture has no plain background around the shape. Use one with a background of one colour or a transparent one.</source>
        <translation>Das Bild hat um die Form keinen einfarbigen Hintergrund. Eines mit einfarbigem oder durchsichtigem Hintergrund benutzen.</translation>
    </message>
    <message>
        <source>The picture is empty: all of it is transparent. Choose a picture that shows a shape.</source>
        <translation>Das Bild ist leer: Es ist ganz durchsichtig. Eines wählen, das eine Form zeigt.</translation>
    </message>
    <message>
        <source>The picture is too small to see a shape. Use {0} pixels or more across.</source>
        <translation>Das Bild ist zu klein, um eine Form zu erkennen. Mindestens {0} Pixel Breite benutzen.</translation>
    </message>
    <message>
        <source>The picture is traced as it is without a choice of yours</source>
        <translation>Das Bild wird nachgezeichnet wie ohne Ihre Wahl</translation>
    </message>
    <message>
        <source>The picture of a body of gores goes all round: leave out --artwork-back.</source>
        <translation>Das Bild eines Körpers aus Segmenten geht ringsherum: --artwork-back weglassen.</translation>
    </message>
    <message>
        <source>The picture was read as a pen drawing: the inside of its lines is filled.</source>
        <translation>Das Bild wurde als Strichzeichnung gelesen: Das Innere der Linien ist gefüllt.</translation>
    </message>
    <message>
        <source>The picture, and all figures as JSON</source>
        <translation>Das Bild, und alle Zahlen als JSON</translation>
    </message>
    <message>
        <source>The pieces of the intake "{0}" are cut from {1}: they have a file of their own, with all of them for each balloon.</source>
        <translation>Die Stücke des Füllhalses „{0}“ werden aus {1} geschnitten: Sie haben eine eigene Datei, mit allen Stücken für jeden Ballon.</translation>
    </message>
    <message>
        <source>The pieces of the intake "{0}" are of {1}, which does not weld to {2}: choose another intake, or a film that it welds to: {3}.</source>
        <translation>Die Stücke des Füllhalses „{0}“ sind aus {1}, das nicht mit {2} verschweißt: einen anderen Füllhals wählen oder eine Folie, mit der es verschweißt: {3}.</translation>
    </message>
    <message>
        <source>The place {0} is not on panels {1}, between which the seam lies.</source>
        <translation>Die Stelle {0} liegt nicht auf den Bahnen {1}, zwischen denen die Naht verläuft.</translation>
    </message>
    <message>
        <source>The plane through {0} divides no panel.</source>
        <translation>Die Ebene durch {0} teilt keine Bahn.</translation>
    </message>
    <message>
        <source>The plane through {0} does not meet the body.</source>
        <translation>Die Ebene durch {0} trifft den Körper nicht.</translation>
    </message>
    <message>
        <source>The plotter finds the marks of a print itself. Set mark type 1 and a size of 10 mm there. The layer REGISTRATION is not cut. The knife's offset belongs into the plotter.</source>
        <translation>Der Plotter findet die Marken eines Drucks selbst. Stellen Sie dort Markenart 1 und eine Größe von 10 mm ein. Die Ebene REGISTRATION wird nicht geschnitten. Der Messerversatz gehört in den Plotter.</translation>
    </message>
    <message>
        <source>The plotter finds the marks of a print itself. Set shape 1 and a size of 10 mm there. FineCut takes marks only that it made itself: let it make them in the place of these. The layer REGISTRATION is not cut.</source>
        <translation>Der Plotter findet die Marken eines Drucks selbst. Stellen Sie dort Form 1 und eine Größe von 10 mm ein. FineCut nimmt nur Marken, die es selbst gemacht hat: lassen Sie es sie anstelle dieser machen. Die Ebene REGISTRATION wird nicht geschnitten.</translation>
    </message>
    <message>
        <source>The pressure at the lower end must be 0 or more.</source>
        <translation>Der Druck am unteren Ende muss 0 oder mehr sein.</translation>
    </message>
    <message>
        <source>The pressure must be positive and at most {0}, not {1}. A party balloon has about 2 kPa.</source>
        <translation>Der Druck muss positiv und höchstens {0} sein, nicht {1}. Ein Partyballon hat etwa 2 kPa.</translation>
    </message>
    <message>
        <source>The pressure must grow upwards: give a gradient of 0 or more.</source>
        <translation>Der Druck muss nach oben zunehmen: eine Zunahme von 0 oder mehr angeben.</translation>
    </message>
    <message>
        <source>The preview picture needs matplotlib: install it with pip install matplotlib.</source>
        <translation>Das Vorschaubild braucht matplotlib: mit pip install matplotlib installieren.</translation>
    </message>
    <message>
        <source>The print has {0}, and {1} looks for others: print once more with its marks ({2}).</source>
        <translation>Der Druck hat {0}, und {1} sucht andere: drucken Sie noch einmal mit deren Marken ({2}).</translation>
    </message>
    <message>
        <source>The print measures {0}, and between the marks of {1} there are {2} on paper of {3}: make the balloon smaller, or give larger paper as page_mm of the marks in a file of your machine.</source>
        <translation>Der Druck misst {0}, und zwischen den Marken von {1} sind {2} auf Papier von {3}: machen Sie den Ballon kleiner oder geben Sie größeres Papier als page_mm der Marken in einer Datei Ihrer Maschine.</translation>
    </message>
    <message>
        <source>The print measures {0}, and {1} takes at most {2}: make the balloon smaller, or print and cut it on another machine.</source>
        <translation>Der Druck misst {0}, und {1} nimmt höchstens {2}: machen Sie den Ballon kleiner oder drucken und schneiden Sie ihn auf einer anderen Maschine.</translation>
    </message>
    <message>
        <source>The print on film</source>
        <translation>Der Druck auf Folie</translation>
    </message>
    <message>
        <source>The print reaches into the marks of {0}, or comes nearer than {1}: make the balloon smaller, or give larger paper as page_mm of the marks in a file of your machine.</source>
        <translation>Der Druck reicht in die Marken von {0} oder kommt näher als {1}: machen Sie den Ballon kleiner oder geben Sie größeres Papier als page_mm der Marken in einer Datei Ihrer Maschine.</translation>
    </message>
    <message>
        <source>The profile crosses or touches itself at {0}. Draw a simple line.</source>
        <translation>Das Profil kreuzt oder berührt sich selbst bei {0}. Eine einfache Linie zeichnen.</translation>
    </message>
    <message>
        <source>The profile goes to the other side of its axis at the height {0}: the radius is {1}. Draw one half only.</source>
        <translation>Das Profil geht auf der Höhe {0} auf die andere Seite seiner Achse: der Radius ist {1}. Nur eine Hälfte zeichnen.</translation>
    </message>
    <message>
        <source>The profile has more than {0} points. Simplify it.</source>
        <translation>Das Profil hat mehr als {0} Punkte. Es vereinfachen.</translation>
    </message>
    <message>
        <source>The profile is a closed line that does not run along its axis. Draw one half of the section, from the lower to the upper end.</source>
        <translation>Das Profil ist eine geschlossene Linie, die nicht entlang ihrer Achse läuft. Eine Hälfte des Schnitts zeichnen, vom unteren zum oberen Ende.</translation>
    </message>
    <message>
        <source>The profile is too slender for a disc of {0} at its {1} end. Let the gores meet in a point there.</source>
        <translation>Das Profil ist zu schlank für eine Scheibe von {0} an seinem Ende ({1}). Die Segmente dort in einem Punkt zusammenkommen lassen.</translation>
    </message>
    <message>
        <source>The profile is {0} large. Give it a size between {1} and {2}, and check its unit.</source>
        <translation>Das Profil ist {0} groß. Ihm eine Größe zwischen {1} und {2} geben und seine Einheit prüfen.</translation>
    </message>
    <message>
        <source>The profile lies on its axis. Draw the half outline at a distance from it.</source>
        <translation>Das Profil liegt auf seiner Achse. Den halben Umriss in einem Abstand von ihr zeichnen.</translation>
    </message>
    <message>
        <source>The profile needs at least two points, each a pair of numbers: radius and height.</source>
        <translation>Das Profil braucht mindestens zwei Punkte, jeder ein Zahlenpaar: Radius und Höhe.</translation>
    </message>
    <message>
        <source>The profile touches its axis at the height {0}, which parts the balloon in two. Keep it away from the axis there.</source>
        <translation>Das Profil berührt auf der Höhe {0} seine Achse, was den Ballon in zwei teilt. Es dort von der Achse fernhalten.</translation>
    </message>
    <message>
        <source>The radius of the corner relief must be 0 or above.</source>
        <translation>Der Radius des Eckenfreistichs muss 0 oder größer sein.</translation>
    </message>
    <message>
        <source>The remnant is of {0} film, and no piece here is cut from that.</source>
        <translation>Das Reststück ist aus Folie {0}, und daraus wird hier kein Stück geschnitten.</translation>
    </message>
    <message>
        <source>The remnant {0} is of no use: {1}</source>
        <translation>Das Reststück {0} ist nicht zu gebrauchen: {1}</translation>
    </message>
    <message>
        <source>The remnant {0} lacks {1}: add it.</source>
        <translation>Dem Reststück {0} fehlt {1}: fügen Sie es hinzu.</translation>
    </message>
    <message>
        <source>The repair at {0} no longer fits, {1}: take it back or draw that part anew.</source>
        <translation>Die Reparatur bei {0} passt nicht mehr, {1}: sie zurücknehmen oder den Teil neu zeichnen.</translation>
    </message>
    <message>
        <source>The rest of the job</source>
        <translation>Das Übrige</translation>
    </message>
    <message>
        <source>The rim is the width of the weld and of the film beside it: give 0 to 1 m.</source>
        <translation>Der Rand ist die Breite der Schweißnaht und der Folie daneben: geben Sie 0 bis 1 m.</translation>
    </message>
    <message>
        <source>The row has more cells than there are columns: leave out what is too much.</source>
        <translation>Die Zeile hat mehr Zellen, als es Spalten gibt: weglassen, was zu viel ist.</translation>
    </message>
    <message>
        <source>The row has no input: give it the name of a drawing.</source>
        <translation>Die Zeile hat keine Eingabe: den Namen einer Zeichnung angeben.</translation>
    </message>
    <message>
        <source>The same in all rows</source>
        <translation>In allen Zeilen gleich</translation>
    </message>
    <message>
        <source>The same length as it is, such as 300 mm</source>
        <translation>Dieselbe Länge, wie sie ist, etwa 300 mm</translation>
    </message>
    <message>
        <source>The scale '{0}' cannot be used: {1}.</source>
        <translation>Der Maßstab „{0}“ ist unbrauchbar: {1}.</translation>
    </message>
    <message>
        <source>The scale of {0} over {1} pixels has no length: mark two points that are far apart, and give the distance between them.</source>
        <translation>Der Maßstab von {0} auf {1} Pixel hat keine Länge: zwei Punkte markieren, die weit auseinander liegen, und den Abstand zwischen ihnen angeben.</translation>
    </message>
    <message>
        <source>The scheduler of Dask went away: start it and the study again; nothing is lost.</source>
        <translation>Der Scheduler von Dask ist weg: ihn und die Studie noch einmal starten; nichts geht verloren.</translation>
    </message>
    <message>
        <source>The seal width must be between 0.01 mm and 1 m, the allowance between 0 and 1 m.</source>
        <translation>Die Nahtbreite muss zwischen 0,01 mm und 1 m liegen, die Zugabe zwischen 0 und 1 m.</translation>
    </message>
    <message>
        <source>The seam near {0} divides no panel.</source>
        <translation>Die Naht nahe {0} teilt keine Bahn.</translation>
    </message>
    <message>
        <source>The seam near {0} is one of {1}, not of {2}.</source>
        <translation>Die Naht nahe {0} gehört zu {1}, nicht zu {2}.</translation>
    </message>
    <message>
        <source>The seam near {0} would divide panels {1}, not {2}.</source>
        <translation>Die Naht nahe {0} würde die Bahnen {1} teilen, nicht {2}.</translation>
    </message>
    <message>
        <source>The seams of {0} gores stand out by up to {1} over their middles. More gores make the body rounder.</source>
        <translation>Die Nähte von {0} Segmenten stehen bis zu {1} über deren Mitten hinaus. Mehr Segmente machen den Körper runder.</translation>
    </message>
    <message>
        <source>The search for a goal asks for a few balloons at a time, of this machine: leave out --scheduler and --dask.</source>
        <translation>Die Suche nach einem Ziel braucht jeweils wenige Ballons, von diesem Rechner: --scheduler und --dask weglassen.</translation>
    </message>
    <message>
        <source>The search for a goal finds its balloons one after the other: leave out --shard, --script, --dry-run and --collect; what is there already is not made again.</source>
        <translation>Die Suche nach einem Ziel findet ihre Ballons nacheinander: --shard, --script, --dry-run und --collect weglassen; was schon da ist, wird nicht noch einmal gemacht.</translation>
    </message>
    <message>
        <source>The search for a goal needs scipy: install it with pip install scipy.</source>
        <translation>Die Suche nach einem Ziel braucht scipy: mit pip install scipy installieren.</translation>
    </message>
    <message>
        <source>The search was stopped; what was made stays.</source>
        <translation>Die Suche wurde angehalten; was fertig ist, bleibt.</translation>
    </message>
    <message>
        <source>The search with optuna needs its package: install it with pip install optuna, or leave out "search".</source>
        <translation>Die Suche mit optuna braucht dessen Paket: mit pip install optuna installieren oder "search" weglassen.</translation>
    </message>
    <message>
        <source>The seed is a whole number from 0 up, not {0}.</source>
        <translation>Der Startwert ist eine ganze Zahl ab 0, nicht {0}.</translation>
    </message>
    <message>
        <source>The selected sketches, wires and flat faces become the panels</source>
        <translation>Die gewählten Skizzen, Drähte und ebenen Flächen werden die Bahnen</translation>
    </message>
    <message>
        <source>The settings lack "{0}": write {"{1}": {2}} into their file.</source>
        <translation>Den Einstellungen fehlt „{0}“: {"{1}": {2}} in ihre Datei schreiben.</translation>
    </message>
    <message>
        <source>The shape has the colour of a shadow: shadows on the background count as part of it.</source>
        <translation>Die Form hat die Farbe eines Schattens: Schatten auf dem Hintergrund zählen zu ihr.</translation>
    </message>
    <message>
        <source>The shape in the photograph measures {0}, {1} were expected: check the scale, or whether it is the right photograph.</source>
        <translation>Die Form auf dem Foto misst {0}, erwartet wurden {1}: den Maßstab prüfen, oder ob es das richtige Foto ist.</translation>
    </message>
    <message>
        <source>The shape in the picture is too frayed to trace. Use a clearer picture.</source>
        <translation>Die Form im Bild ist zu ausgefranst zum Nachzeichnen. Ein klareres Bild benutzen.</translation>
    </message>
    <message>
        <source>The shape is only {0} thick near {1}, too thin for a mesh of {2}: make it thicker there, or use a mesh size of at most {3}.</source>
        <translation>Die Form ist nahe {1} nur {0} dick, zu dünn für ein Netz von {2}: dort verdicken oder höchstens {3} Netzweite benutzen.</translation>
    </message>
    <message>
        <source>The shape touches the {0} border of the photograph: take one that shows all of it on a plain background.</source>
        <translation>Die Form berührt den Rand des Fotos ({0}): eines aufnehmen, das sie ganz zeigt, vor einem einfarbigen Hintergrund.</translation>
    </message>
    <message>
        <source>The shape touches the {0} border of the picture; if it was cut off there, leave more margin.</source>
        <translation>Die Form berührt den Bildrand ({0}); wenn sie dort abgeschnitten wurde, mehr Rand lassen.</translation>
    </message>
    <message>
        <source>The side band has no width: give its width, or the thickness of the balloon.</source>
        <translation>Das Seitenband hat keine Breite: seine Breite oder die Dicke des Ballons angeben.</translation>
    </message>
    <message>
        <source>The side band is too wide for this drawing, whose parts are about {0} wide: give it at most {1}.</source>
        <translation>Das Seitenband ist zu breit für diese Zeichnung, deren Teile etwa {0} breit sind: höchstens {1} nehmen.</translation>
    </message>
    <message>
        <source>The side band must be wider than 0, not {0}. Give it 20 mm or so.</source>
        <translation>Das Seitenband muss breiter als 0 sein, nicht {0}. Ihm etwa 20 mm geben.</translation>
    </message>
    <message>
        <source>The side band of {0} leaves nothing of the front, whose widest part is {1} wide: give it at most {2}.</source>
        <translation>Das Seitenband von {0} lässt von der Vorderseite nichts übrig, deren breitester Teil {1} breit ist: ihm höchstens {2} geben.</translation>
    </message>
    <message>
        <source>The sides of seam {0} are not equally long: {1}, {2}. Make them equally long, or allow them ease.</source>
        <translation>Die Seiten der Naht {0} sind nicht gleich lang: {1}, {2}. Sie gleich lang machen oder Spiel zulassen.</translation>
    </message>
    <message>
        <source>The sides of seam {0} are {1} and {2} long. Make them equally long.</source>
        <translation>Die Seiten von Naht {0} sind {1} und {2} lang. Gleich lang machen.</translation>
    </message>
    <message>
        <source>The simulation cannot take its first step. Check the outline for degenerate parts.</source>
        <translation>Die Simulation kann ihren ersten Schritt nicht tun. Den Umriss auf entartete Teile prüfen.</translation>
    </message>
    <message>
        <source>The simulation did not come to rest; the shape shown is its last good state. Try a coarser mesh.</source>
        <translation>Die Simulation kam nicht zur Ruhe; gezeigt wird ihr letzter guter Stand. Ein gröberes Netz versuchen.</translation>
    </message>
    <message>
        <source>The simulation failed: {0}. Check the outline for degenerate parts.</source>
        <translation>Die Simulation ist gescheitert: {0}. Den Umriss auf entartete Teile prüfen.</translation>
    </message>
    <message>
        <source>The simulation has no finite start. Check the outline for degenerate parts.</source>
        <translation>Die Simulation hat keinen endlichen Anfang. Den Umriss auf entartete Teile prüfen.</translation>
    </message>
    <message>
        <source>The simulation was stopped.</source>
        <translation>Die Simulation wurde angehalten.</translation>
    </message>
    <message>
        <source>The size comes from {0}: make it smaller there, or of more and narrower panels.</source>
        <translation>Die Größe kommt von {0}: ihn dort kleiner machen oder aus mehr und schmaleren Bahnen.</translation>
    </message>
    <message>
        <source>The size comes from {0}: make it smaller there.</source>
        <translation>Die Größe kommt von {0}: sie dort verkleinern.</translation>
    </message>
    <message>
        <source>The size follows from a volume or a lift: choose a smaller one.</source>
        <translation>Ein Volumen oder ein Auftrieb bestimmt die Größe: dort weniger wählen.</translation>
    </message>
    <message>
        <source>The size of {0} is set by an expression: change the value that it uses.</source>
        <translation>Die Größe von {0} folgt einem Ausdruck: ändern, worauf er sich bezieht.</translation>
    </message>
    <message>
        <source>The slant of a cone is longer than its radius. Choose a longer slant.</source>
        <translation>Die Mantellinie eines Kegels ist länger als sein Radius. Eine längere wählen.</translation>
    </message>
    <message>
        <source>The smallest radius is {0}, near {1}; {2} follows {3}. It will come out rounder there.</source>
        <translation>Der kleinste Radius ist {0}, nahe {1}; {2} folgt {3}. Dort wird es runder.</translation>
    </message>
    <message>
        <source>The solver '{0}' needs the Python package scipy. Install it or use the native solver.</source>
        <translation>Der Löser „{0}“ braucht das Python-Paket scipy. Es installieren oder den nativen Löser benutzen.</translation>
    </message>
    <message>
        <source>The speed of welding must be above 0, and the time for each seam not below it.</source>
        <translation>Die Schweißgeschwindigkeit muss über 0 liegen, und die Zeit für jede Naht darf nicht darunter liegen.</translation>
    </message>
    <message>
        <source>The spread of {0} cannot be {1}: write it with its unit, such as "{2}".</source>
        <translation>Die Streuung von {0} kann nicht {1} sein: mit Einheit schreiben, zum Beispiel „{2}“.</translation>
    </message>
    <message>
        <source>The spread of {0} has "{1}", which is none of {2}.</source>
        <translation>Die Streuung von {0} hat „{1}“, das keines von {2} ist.</translation>
    </message>
    <message>
        <source>The spread of {0} is {1}: give one above 0, or leave it out.</source>
        <translation>Die Streuung von {0} ist {1}: eine über 0 angeben oder sie weglassen.</translation>
    </message>
    <message>
        <source>The spread of {0} is {1}: write one {2}.</source>
        <translation>Die Streuung von {0} ist {1}: eine schreiben, {2}.</translation>
    </message>
    <message>
        <source>The step of {0} has another unit than its ends: write the same one.</source>
        <translation>Der Schritt von {0} hat eine andere Einheit als seine Enden: dieselbe schreiben.</translation>
    </message>
    <message>
        <source>The strips of valves are not here: lay them out on a sheet of their own, with "Valve film".</source>
        <translation>Die Streifen von Ventilen sind nicht dabei: sie auf einem eigenen Bogen auslegen, mit „Ventilfolie“.</translation>
    </message>
    <message>
        <source>The study cannot go on ({0}).</source>
        <translation>Die Studie kann nicht weitergehen ({0}).</translation>
    </message>
    <message>
        <source>The study has no inputs: give it a column 'input' with the names of drawings.</source>
        <translation>Die Studie hat keine Eingaben: ihr eine Spalte „input“ mit den Namen von Zeichnungen geben.</translation>
    </message>
    <message>
        <source>The study has no rows.</source>
        <translation>Die Studie hat keine Zeilen.</translation>
    </message>
    <message>
        <source>The study has the column {0} twice.</source>
        <translation>Die Studie hat die Spalte {0} zweimal.</translation>
    </message>
    <message>
        <source>The study has {0} rows, more than {1}: take fewer values, or give --most {2} if that is meant.</source>
        <translation>Die Studie hat {0} Zeilen, mehr als {1}: weniger Werte nehmen, oder --most {2} angeben, wenn das so gemeint ist.</translation>
    </message>
    <message>
        <source>The study has {0} rows, more than {1}: take fewer values.</source>
        <translation>Die Studie hat {0} Zeilen, mehr als {1}: weniger Werte nehmen.</translation>
    </message>
    <message>
        <source>The study is no JSON object: begin it with {"vary": ...}.</source>
        <translation>Die Studie ist kein JSON-Objekt: sie mit {"vary": ...} beginnen.</translation>
    </message>
    <message>
        <source>The study was stopped.</source>
        <translation>Die Studie wurde angehalten.</translation>
    </message>
    <message>
        <source>The summary cannot be shown ({0}); {1}.</source>
        <translation>Die Zusammenfassung kann nicht angezeigt werden ({0}); {1}.</translation>
    </message>
    <message>
        <source>The surface cannot be laid flat: some of its triangles have no area, or a panel hangs together in a point only. Repair the body, or take another number of panels.</source>
        <translation>Die Oberfläche lässt sich nicht abwickeln: einige ihrer Dreiecke haben keine Fläche, oder eine Bahn hängt nur in einem Punkt zusammen. Den Körper reparieren oder eine andere Zahl von Bahnen nehmen.</translation>
    </message>
    <message>
        <source>The surface crosses itself, at ({0}) of the mesh. Film cannot follow it there. Triangles that cross others: {1}.</source>
        <translation>Die Oberfläche kreuzt sich selbst, bei ({0}) des Netzes. Folie kann ihr dort nicht folgen. Dreiecke, die andere kreuzen: {1}.</translation>
    </message>
    <message>
        <source>The surface of the mesh has no outside, as a Moebius strip. Give the mesh of a solid.</source>
        <translation>Die Oberfläche des Netzes hat keine Außenseite, wie ein Möbiusband. Das Netz eines Volumenkörpers geben.</translation>
    </message>
    <message>
        <source>The temperature of the {0}, {1} degrees Celsius, is out of range: give one such as 20C.</source>
        <translation>Die Temperatur ({0}) von {1} Grad Celsius ist außerhalb des Bereichs: zum Beispiel 20C angeben.</translation>
    </message>
    <message>
        <source>The test card measures {0}, the bed of {1} is {2}: try fewer values, or say with --bed how large it is.</source>
        <translation>Die Testkarte misst {0}, die Fläche von {1} {2}: Versuchen Sie weniger Werte, oder sagen Sie mit --bed, wie groß sie ist.</translation>
    </message>
    <message>
        <source>The thickness of the balloon decides the width of its side band: give one of them.</source>
        <translation>Die Dicke des Ballons bestimmt die Breite seines Seitenbands: eines von beiden angeben.</translation>
    </message>
    <message>
        <source>The tie tab at {0} degrees would run into another part: choose another angle.</source>
        <translation>Die Lasche bei {0} Grad liefe in einen anderen Teil: einen anderen Winkel wählen.</translation>
    </message>
    <message>
        <source>The valve reaches {0} into the balloon, past the weld at {1}: put the intake where the balloon is longer, or take another one.</source>
        <translation>Das Ventil reicht {0} in den Ballon, über die Schweißnaht bei {1} hinaus: den Füllhals dort anbringen, wo der Ballon länger ist, oder einen anderen nehmen.</translation>
    </message>
    <message>
        <source>The vertices along both sides of seam {0} are up to {1} apart. Put them at equal lengths along it.</source>
        <translation>Die Ecken auf beiden Seiten von Naht {0} liegen bis zu {1} auseinander. In gleichen Abständen an ihr anordnen.</translation>
    </message>
    <message>
        <source>The volume must be positive, not {0}.</source>
        <translation>Das Volumen muss positiv sein, nicht {0}.</translation>
    </message>
    <message>
        <source>The way from the intake into the balloon narrows to {0}, and the intake is {1} wide: put it where the balloon is wider, else air enters slowly.</source>
        <translation>Der Weg vom Füllhals in den Ballon verengt sich auf {0}, und der Hals ist {1} breit: ihn dorthin setzen, wo der Ballon breiter ist, sonst strömt Luft langsam ein.</translation>
    </message>
    <message>
        <source>The weld draws the seam inward by {0}</source>
        <translation>Die Schweißnaht zieht die Naht nach innen, um {0}</translation>
    </message>
    <message>
        <source>The width and the height must be more than 0.</source>
        <translation>Breite und Höhe müssen mehr als 0 sein.</translation>
    </message>
    <message>
        <source>The width of the passages must be 0 or above.</source>
        <translation>Die Breite der Durchgänge muss 0 oder größer sein.</translation>
    </message>
    <message>
        <source>The worker on {0}</source>
        <translation>Der Worker auf {0}</translation>
    </message>
    <message>
        <source>The worker on {0} cannot work: {1}</source>
        <translation>Der Worker auf {0} kann nicht arbeiten: {1}</translation>
    </message>
    <message>
        <source>The {0} "{1}" of the material card {2} cannot be read: correct the card.</source>
        <translation>{0} „{1}“ der Materialkarte {2} ist nicht lesbar: die Karte berichtigen.</translation>
    </message>
    <message>
        <source>The {0} bears {1} here with a margin of {2}, and the pressure is {3}. Inflate it to less, or take a stronger film.</source>
        <translation>{0}: trägt hier {1} mit einem Sicherheitsfaktor von {2}, und der Druck ist {3}. Weniger aufblasen oder eine stärkere Folie nehmen.</translation>
    </message>
    <message>
        <source>The {0} crosses or touches itself at {1}; part the lines there.</source>
        <translation>Kreuzung oder Berührung ({0}) bei {1}; die Linien dort trennen.</translation>
    </message>
    <message>
        <source>The {0} encloses no area; draw a closed shape with at least three corners.</source>
        <translation>Keine Fläche umschlossen ({0}); eine geschlossene Form mit mindestens drei Ecken zeichnen.</translation>
    </message>
    <message>
        <source>The {0} end of the profile is '{1}'. Use one of {2}.</source>
        <translation>Das Ende ({0}) des Profils ist „{1}“. Eines von {2} benutzen.</translation>
    </message>
    <message>
        <source>The {0} end of the profile is {1} away from the axis, so no gores can meet there in a point. Close it with a disc, or leave it open.</source>
        <translation>Das Ende ({0}) des Profils ist {1} von der Achse entfernt, also können sich dort keine Segmente in einem Punkt treffen. Es mit einer Scheibe schließen oder offen lassen.</translation>
    </message>
    <message>
        <source>The {0} file has a point that is no three numbers. Save it once more.</source>
        <translation>Die {0}-Datei hat einen Punkt, der nicht aus drei Zahlen besteht. Noch einmal speichern.</translation>
    </message>
    <message>
        <source>The {0} is {1} mm: give one above 0, for example 300 mm.</source>
        <translation>Das Maß ({0}) ist {1} mm: einen Wert über 0 angeben, zum Beispiel 300 mm.</translation>
    </message>
    <message>
        <source>The {0} is {1} off its goal: change the goal by as much.</source>
        <translation>Das Ziel ({0}) wurde um {1} verfehlt: es um ebenso viel berichtigen.</translation>
    </message>
    <message>
        <source>The {0} is {1}, not between {2} and {3} {4}: give one such as {5}.</source>
        <translation>Der Wert ({0}) ist {1} und liegt nicht zwischen {2} und {3} {4}: zum Beispiel {5} angeben.</translation>
    </message>
    <message>
        <source>The {0} line crosses itself near {1}: simplify the drawing there.</source>
        <translation>Die Linie {0} kreuzt sich nahe {1}: die Zeichnung dort vereinfachen.</translation>
    </message>
    <message>
        <source>The {0} line runs back along itself near {1}: simplify the drawing there.</source>
        <translation>Die Linie {0} läuft nahe {1} auf sich selbst zurück: die Zeichnung dort vereinfachen.</translation>
    </message>
    <message>
        <source>The {0} line that begins at {1} is open: programs fill, offset and cut closed lines only. Close it.</source>
        <translation>Die Linie {0}, die bei {1} beginnt, ist offen: Programme füllen, versetzen und schneiden nur geschlossene. Sie schließen.</translation>
    </message>
    <message>
        <source>The {0} must be between 0 and {1}.</source>
        <translation>{0} muss zwischen 0 und {1} liegen.</translation>
    </message>
    <message>
        <source>The {0} of a {1} must be from {2} to {3}.</source>
        <translation>Für {1} muss {0} von {2} bis {3} sein.</translation>
    </message>
    <message>
        <source>The {0} strays by {1} % in sample {2}, which leaves nothing of it: give a smaller spread.</source>
        <translation>In Stichprobe {2} weicht ein Wert um {1} % ab, sodass nichts übrig bleibt ({0}): eine kleinere Streuung angeben.</translation>
    </message>
    <message>
        <source>Their depth</source>
        <translation>Ihre Tiefe</translation>
    </message>
    <message>
        <source>There are no panels: choose sketches or flat faces.</source>
        <translation>Es gibt keine Bahnen: Skizzen oder ebene Flächen wählen.</translation>
    </message>
    <message>
        <source>There are seams in the planes of symmetry already.</source>
        <translation>In den Symmetrieebenen sind schon Nähte.</translation>
    </message>
    <message>
        <source>There can be 0 to {0} notches, not {1}, with a depth above 0.</source>
        <translation>Möglich sind 0 bis {0} Passkerben, nicht {1}, mit einer Tiefe über 0.</translation>
    </message>
    <message>
        <source>There can be 1 to {0} copies, not {1}.</source>
        <translation>Möglich sind 1 bis {0} Stück, nicht {1}.</translation>
    </message>
    <message>
        <source>There is a machine {0} already: give this one another name.</source>
        <translation>Eine Maschine {0} gibt es schon: geben Sie dieser einen anderen Namen.</translation>
    </message>
    <message>
        <source>There is advice about two equal panels only: of many, the warnings tell.</source>
        <translation>Ratschläge gibt es nur zu zwei gleichen Bahnen: bei vielen sagen es die Warnungen.</translation>
    </message>
    <message>
        <source>There is no "{0}" to repair in {1}: see its advice.</source>
        <translation>Es gibt in {1} kein „{0}“ zu reparieren: dessen Ratschläge ansehen.</translation>
    </message>
    <message>
        <source>There is no column '{0}': {1}.</source>
        <translation>Es gibt keine Spalte „{0}“: {1}.</translation>
    </message>
    <message>
        <source>There is no file '{0}'. Check the name and the folder.</source>
        <translation>Es gibt keine Datei „{0}“. Name und Ordner prüfen.</translation>
    </message>
    <message>
        <source>There is no file {0}, and no such ready body: check the name and the folder.</source>
        <translation>Es gibt keine Datei {0} und keinen solchen fertigen Körper: Namen und Ordner prüfen.</translation>
    </message>
    <message>
        <source>There is no file {0}: check the name and the folder.</source>
        <translation>Es gibt keine Datei {0}: Name und Ordner prüfen.</translation>
    </message>
    <message>
        <source>There is no file {}: check the name and the folder.</source>
        <translation>Es gibt keine Datei {}: Name und Ordner prüfen.</translation>
    </message>
    <message>
        <source>There is no film "{0}": choose one of {1}.</source>
        <translation>Es gibt keine Folie „{0}“: eine von {1} wählen.</translation>
    </message>
    <message>
        <source>There is no gas "{0}": choose one of {1}.</source>
        <translation>Es gibt kein Gas „{0}“: eines von {1} wählen.</translation>
    </message>
    <message>
        <source>There is no hole any more: delete the edit.</source>
        <translation>Dort ist kein Loch mehr: die Bearbeitung löschen.</translation>
    </message>
    <message>
        <source>There is no hole at {0}: give a place on its edge.</source>
        <translation>Bei {0} ist kein Loch: eine Stelle auf seinem Rand angeben.</translation>
    </message>
    <message>
        <source>There is no intake "{0}": choose one of {1}.</source>
        <translation>Es gibt keinen Füllhals „{0}“: einen von {1} wählen.</translation>
    </message>
    <message>
        <source>There is no joining "{0}": choose one of {1}.</source>
        <translation>Es gibt keine Verbindung „{0}“: eine von {1} wählen.</translation>
    </message>
    <message>
        <source>There is no language "{0}": choose one of {1}.</source>
        <translation>Es gibt keine Sprache „{0}“: eine von {1} wählen.</translation>
    </message>
    <message>
        <source>There is no look "{0}": choose one of {1}.</source>
        <translation>Es gibt kein Aussehen „{0}“: eines von {1} wählen.</translation>
    </message>
    <message>
        <source>There is no machine "{0}": choose one of {1}, or give a .json file.</source>
        <translation>Es gibt keine Maschine „{0}“: eine von {1} wählen oder eine .json-Datei angeben.</translation>
    </message>
    <message>
        <source>There is no native solver for {0}. {1}</source>
        <translation>Es gibt keinen nativen Löser für {0}. {1}</translation>
    </message>
    <message>
        <source>There is no native solver to be fetched for this version yet. {0}</source>
        <translation>Für diese Version kann noch kein nativer Löser heruntergeladen werden. {0}</translation>
    </message>
    <message>
        <source>There is no node near {0}: add one there.</source>
        <translation>Nahe {0} ist kein Knoten: dort einen hinzufügen.</translation>
    </message>
    <message>
        <source>There is no outline at {0} degrees from the centre: choose another intake angle.</source>
        <translation>Bei {0} Grad von der Mitte liegt kein Umriss: einen anderen Winkel für den Füllhals wählen.</translation>
    </message>
    <message>
        <source>There is no panel. Give at least one.</source>
        <translation>Es gibt keine Bahn. Mindestens eine angeben.</translation>
    </message>
    <message>
        <source>There is no paper "{0}" for the assembly sheet: choose A4 or Letter.</source>
        <translation>Es gibt kein Papier „{0}“ für das Montageblatt: A4 oder Letter wählen.</translation>
    </message>
    <message>
        <source>There is no paper "{0}": choose A4, A3 or Letter.</source>
        <translation>Papier „{0}“ gibt es nicht: A4, A3 oder Letter wählen.</translation>
    </message>
    <message>
        <source>There is no picture to paste: copy one first.</source>
        <translation>Es gibt kein Bild zum Einfügen: zuerst eines kopieren.</translation>
    </message>
    <message>
        <source>There is no picture to print: choose one, as the balloon has none of its own.</source>
        <translation>Es gibt kein Bild zum Drucken: eines wählen, da der Ballon kein eigenes hat.</translation>
    </message>
    <message>
        <source>There is no picture to print: choose one, as the outline has none of its own.</source>
        <translation>Es gibt kein Bild zum Drucken: eines wählen, denn der Umriss hat kein eigenes.</translation>
    </message>
    <message>
        <source>There is no ready body '{0}'. Choose one of {1}.</source>
        <translation>Es gibt keinen fertigen Körper „{0}“. Einen von {1} wählen.</translation>
    </message>
    <message>
        <source>There is no result '{0}': take {1}.</source>
        <translation>Es gibt kein Ergebnis „{0}“: {1} nehmen.</translation>
    </message>
    <message>
        <source>There is no room for a flange of {0} in its middle: choose another panel or a smaller one.</source>
        <translation>In ihrer Mitte ist kein Platz für einen Flansch von {0}: eine andere Bahn oder einen kleineren wählen.</translation>
    </message>
    <message>
        <source>There is no room for a flange of {0} there: choose another place or a smaller one.</source>
        <translation>Dort ist kein Platz für einen Flansch von {0}: einen anderen Ort oder einen kleineren wählen.</translation>
    </message>
    <message>
        <source>There is no seam between panels {0}.</source>
        <translation>Zwischen den Bahnen {0} ist keine Naht.</translation>
    </message>
    <message>
        <source>There is no seam near {0}.</source>
        <translation>Nahe {0} ist keine Naht.</translation>
    </message>
    <message>
        <source>There is no seam {0} for the opening: the seams are 1 to {1}.</source>
        <translation>Es gibt keine Naht {0} für die Öffnung: die Nähte sind 1 bis {1}.</translation>
    </message>
    <message>
        <source>There is no share {0} of {1}: write one from 1/{2} on.</source>
        <translation>Es gibt keinen Teil {0} von {1}: einen ab 1/{2} schreiben.</translation>
    </message>
    <message>
        <source>There is no sheet {0}: give a number from 1 to {1}.</source>
        <translation>Es gibt keinen Bogen {0}: eine Zahl von 1 bis {1} angeben.</translation>
    </message>
    <message>
        <source>There is no solver named '{0}'. Use 'native', 'numpy' or 'newmark'.</source>
        <translation>Es gibt keinen Löser namens „{0}“. „native“, „numpy“ oder „newmark“ benutzen.</translation>
    </message>
    <message>
        <source>There is no symmetry "{0}": choose one of {1}.</source>
        <translation>Es gibt keine Symmetrie „{0}“: eine von {1} wählen.</translation>
    </message>
    <message>
        <source>There is nothing to copy: paint something, or select it.</source>
        <translation>Es gibt nichts zu kopieren: etwas malen oder auswählen.</translation>
    </message>
    <message>
        <source>There is too little memory for this: take a coarser mesh, or close other programs.</source>
        <translation>Dafür reicht der Speicher nicht: ein gröberes Netz nehmen oder andere Programme schließen.</translation>
    </message>
    <message>
        <source>There is too little memory for this: take a coarser mesh, or close other programs. Details are in '{0}'.</source>
        <translation>Dafür reicht der Speicher nicht: ein gröberes Netz nehmen oder andere Programme schließen. Einzelheiten stehen in „{0}“.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Thickness of the balloon</source>
        <translation>Dicke des Ballons</translation>
    </message>
    <message>
        <source>Thickness of the pen ([ thinner, ] thicker)</source>
        <translation>Strichdicke ([ dünner, ] dicker)</translation>
    </message>
    <message>
        <source>This Python has no working ctypes module, which SciPy and the native solver need: patterns can be changed and written, but no balloon can be inflated anew. Take another build of FreeCAD or of Python.</source>
        <translation>Dieses Python hat kein funktionierendes ctypes-Modul, das SciPy und der native Löser brauchen: Schnittmuster können geändert und geschrieben werden, aber kein Ballon kann neu aufgeblasen werden. Eine andere Ausgabe von FreeCAD oder von Python nehmen.</translation>
    </message>
    <message>
        <source>This arm is too thin to fill: drawn {width} wide, it becomes {measured} thick. Make it {wanted} wide.</source>
        <translation>Dieser Arm ist zu dünn zum Füllen: {width} breit gezeichnet, wird er {measured} dick. Ihn {wanted} breit machen.</translation>
    </message>
    <message>
        <source>This arm is too thin to fill: {}. Make it {}?</source>
        <translation>Dieser Arm ist zu dünn zum Füllen: {}. Auf {} verbreitern?</translation>
    </message>
    <message>
        <source>This arm stays much thinner than the rest: drawn {width} wide, it becomes {measured} thick. For a rounder one make it {wanted} wide.</source>
        <translation>Dieser Arm bleibt viel dünner als der Rest: {width} breit gezeichnet, wird er {measured} dick. Damit er runder wird, ihn {wanted} breit machen.</translation>
    </message>
    <message>
        <source>This balloon has not been worked out yet: start the study again.</source>
        <translation>Dieser Ballon ist noch nicht berechnet: die Studie noch einmal starten.</translation>
    </message>
    <message>
        <source>This balloon holds less than {0} at any pressure that suits its film: {1} at {2}. Change the size of the balloon or the volume.</source>
        <translation>Dieser Ballon fasst bei jedem Druck, den seine Folie verträgt, weniger als {0}: {1} bei {2}. Die Größe des Ballons oder das Volumen ändern.</translation>
    </message>
    <message>
        <source>This balloon holds more than {0} at any pressure that suits its film: {1} at {2}. Change the size of the balloon or the volume.</source>
        <translation>Dieser Ballon fasst bei jedem Druck, den seine Folie verträgt, mehr als {0}: {1} bei {2}. Die Größe des Ballons oder das Volumen ändern.</translation>
    </message>
    <message>
        <source>This cannot be shown ({0}).</source>
        <translation>Das kann nicht angezeigt werden ({0}).</translation>
    </message>
    <message>
        <source>This gas is not lighter than the air around, so the balloon never floats: choose another gas or a higher temperature of the gas.</source>
        <translation>Dieses Gas ist nicht leichter als die Luft ringsum, der Ballon schwebt also nie: ein anderes Gas oder eine höhere Temperatur des Gases wählen.</translation>
    </message>
    <message>
        <source>This gives no whole number: {}</source>
        <translation>Das ergibt keine ganze Zahl: {}</translation>
    </message>
    <message>
        <source>This is a fault of the program, not yours, and its details cannot be written anywhere. Please report it: {0}, {1}.</source>
        <translation>Das ist ein Fehler des Programms, nicht Ihrer, und seine Einzelheiten können nirgends geschrieben werden. Bitte melden: {0}, {1}.</translation>
    </message>
    <message>
        <source>This is a fault of the program, not yours. Its details are in '{0}': please report it with this file.</source>
        <translation>Das ist ein Fehler des Programms, nicht Ihrer. Seine Einzelheiten stehen in „{0}“: ihn bitte mit dieser Datei melden.</translation>
    </message>
    <message>
        <source>This is shape {0} of the {1} in the drawing.</source>
        <translation>Dies ist Form {0} von {1} in der Zeichnung.</translation>
    </message>
    <message>
        <source>This neck chokes the air: inside it is as wide as a tube of {measured} of film, the intake is {intake}. {behind} of the balloon fill through it. Make it {wanted} wide.</source>
        <translation>Diese Engstelle drosselt die Luft: Innen ist sie so weit wie ein Schlauch aus {measured} breiter Folie, der Füllhals hat {intake}. {behind} des Ballons füllen sich durch sie. Sie {wanted} breit machen.</translation>
    </message>
    <message>
        <source>This neck is too thin to let the air through: {}. Make it {}?</source>
        <translation>Diese Engstelle ist zu dünn für die Luft: {}. Auf {} verbreitern?</translation>
    </message>
    <message>
        <source>This neck slows the filling: inside it is as wide as a tube of {measured} of film, the intake is {intake}. {behind} of the balloon fill through it. For quicker filling make it {wanted} wide.</source>
        <translation>Diese Engstelle bremst das Füllen: Innen ist sie so weit wie ein Schlauch aus {measured} breiter Folie, der Füllhals hat {intake}. {behind} des Ballons füllen sich durch sie. Für schnelleres Füllen sie {wanted} breit machen.</translation>
    </message>
    <message>
        <source>This notch pulls the film {measured} as tight as elsewhere, so that it wrinkles there. A radius of {wanted} eases that.</source>
        <translation>Diese Kerbe spannt die Folie {measured} so straff wie anderswo, sodass sie dort Falten wirft. Ein Radius von {wanted} mildert das.</translation>
    </message>
    <message>
        <source>This notch pulls the film {measured} as tight as elsewhere; it wrinkles there and is where it would tear. Round it with a radius of {wanted}.</source>
        <translation>Diese Kerbe spannt die Folie {measured} so straff wie anderswo; sie wirft dort Falten und würde dort reißen. Sie mit einem Radius von {wanted} runden.</translation>
    </message>
    <message>
        <source>This row is not worked out: choose Work out.</source>
        <translation>Diese Zeile ist noch nicht berechnet: „Berechnen“ wählen.</translation>
    </message>
    <message>
        <source>This shape does not tell a stretch of the film from a weld that draws the seam inward: it is either a stretch of {0}, or a weld that draws it inward by {1}.</source>
        <translation>Diese Form unterscheidet eine Dehnung der Folie nicht von einer Schweißnaht, die die Naht nach innen zieht: es ist entweder eine Dehnung von {0} oder eine Schweißnaht, die sie nach innen zieht, um {1}.</translation>
    </message>
    <message>
        <source>This shape stays flat: it holds {percent} of the air that a round balloon of as much film would. Fewer and wider parts make it rounder.</source>
        <translation>Diese Form bleibt flach: Sie fasst {percent} der Luft, die ein runder Ballon aus ebenso viel Folie fassen würde. Weniger und breitere Teile machen sie runder.</translation>
    </message>
    <message>
        <source>This shape stays rather flat: it holds {percent} of the air that a round balloon of as much film would. Fewer and wider parts make it rounder.</source>
        <translation>Diese Form bleibt recht flach: Sie fasst {percent} der Luft, die ein runder Ballon aus ebenso viel Folie fassen würde. Weniger und breitere Teile machen sie runder.</translation>
    </message>
    <message>
        <source>This tip stays flat over {length}: it is too pointed. Round it with a radius of {wanted}.</source>
        <translation>Diese Spitze bleibt auf {length} flach: Sie ist zu spitz. Sie mit einem Radius von {wanted} runden.</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Tie a ribbon round the neck, and to it a weight heavier than the {lift} that {gas} lifts. No metallic ribbon on foil, never let it fly.</source>
        <translation>Ein Band um den Hals binden und daran ein Gewicht, schwerer als die {lift}, die {gas} hebt. Kein metallisches Band an Folie, nie fliegen lassen.</translation>
    </message>
    <message>
        <source>Tie a ribbon round the neck, to hang it up or to hold it: it does not float.</source>
        <translation>Ein Band um den Hals binden, zum Aufhängen oder Halten: er schwebt nicht.</translation>
    </message>
    <message>
        <source>Tip that stays flat</source>
        <translation>Spitze, die flach bleibt</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>To cut, your settings of {cut_machine}: {cut}.</source>
        <translation>Zum Schneiden Ihre Einstellungen von {cut_machine}: {cut}.</translation>
    </message>
    <message>
        <source>To let the gas out, cut the seal across the neck off.</source>
        <translation>Um das Gas abzulassen, die Naht quer über den Hals abschneiden.</translation>
    </message>
    <message>
        <source>To let the gas out, push a straw in through the neck until it hisses, and press gently. Keep the balloon flat, not folded: it can be filled again.</source>
        <translation>Um das Gas abzulassen, einen Strohhalm durch den Hals hineinschieben, bis es zischt, und sanft drücken. Den Ballon flach aufheben, nicht gefaltet: er kann wieder gefüllt werden.</translation>
    </message>
    <message>
        <source>To this value, with its unit</source>
        <translation>Bis zu diesem Wert, mit Einheit</translation>
    </message>
    <message>
        <source>To weld, your settings of {weld_machine}: {weld}.</source>
        <translation>Zum Schweißen Ihre Einstellungen von {weld_machine}: {weld}.</translation>
    </message>
    <message>
        <source>Tolerances are worked out for two equal panels of one shape: </source>
        <translation>Toleranzen werden für zwei gleiche Bahnen einer Form berechnet: </translation>
    </message>
    <message>
        <source>Tolerances are worked out for two equal panels, of which one is simulated: leave out --two-panels, and take a drawing.</source>
        <translation>Toleranzen werden für zwei gleiche Bahnen berechnet, von denen eine simuliert wird: --two-panels weglassen und eine Zeichnung nehmen.</translation>
    </message>
    <message>
        <source>Too many samples could not be made to say which pressure 95 of 100 balloons bear.</source>
        <translation>Zu viele Stichproben ließen sich nicht machen, um zu sagen, welchen Druck 95 von 100 Ballons aushalten.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Tool paths</source>
        <translation>Werkzeugwege</translation>
    </message>
    <message>
        <source>Tool paths are not split over beds: write the G-code, or choose a larger bed.</source>
        <translation>Werkzeugwege werden nicht auf Betten aufgeteilt: schreiben Sie den G-Code oder wählen Sie ein größeres Bett.</translation>
    </message>
    <message>
        <source>Tool paths, no file</source>
        <translation>Werkzeugwege, keine Datei</translation>
    </message>
    <message>
        <source>Tracing paper, 92 g/m²</source>
        <translation>Transparentpapier, 92 g/m²</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Triangle {0} of panel {1} has no area. Mesh the panel anew.</source>
        <translation>Dreieck {0} von Bahn {1} hat keine Fläche. Die Bahn neu vernetzen.</translation>
    </message>
    <message>
        <source>Triangle {0} of panel {1} runs clockwise. Mesh the panel anew.</source>
        <translation>Dreieck {0} von Bahn {1} läuft im Uhrzeigersinn. Die Bahn neu vernetzen.</translation>
    </message>
    <message>
        <source>Triangles of the mesh that lay on others were left out: {0}.</source>
        <translation>Dreiecke des Netzes, die auf anderen lagen, wurden weggelassen: {0}.</translation>
    </message>
    <message>
        <source>Triangles of the mesh that stood on its surface, or were walls inside it, were left out: {0}.</source>
        <translation>Dreiecke des Netzes, die auf seiner Oberfläche standen oder Wände in seinem Inneren waren, wurden weggelassen: {0}.</translation>
    </message>
    <message>
        <source>Triangles of the mesh that were the wrong way round were turned: {0}.</source>
        <translation>Dreiecke des Netzes, die falsch herum lagen, wurden gewendet: {0}.</translation>
    </message>
    <message>
        <source>Triangles of the mesh whose points are no numbers were left out: {0}.</source>
        <translation>Dreiecke des Netzes, deren Punkte keine Zahlen sind, wurden weggelassen: {0}.</translation>
    </message>
    <message>
        <source>Triangles that crossed others were cut out, and closed: {0}.</source>
        <translation>Dreiecke, die andere kreuzten, wurden herausgeschnitten und die Lücken geschlossen: {0}.</translation>
    </message>
    <message>
        <source>True length</source>
        <translation>Wahre Länge</translation>
    </message>
    <message>
        <source>Try temperature and time on two scraps: the weld must stretch or tear before it opens.</source>
        <translation>Temperatur und Zeit an zwei Reststücken ausprobieren: Die Naht muss sich dehnen oder reißen, bevor sie aufgeht.</translation>
    </message>
    <message>
        <source>Turn piece</source>
        <translation>Stück drehen</translation>
    </message>
    <message>
        <source>Turning axis</source>
        <translation>Drehachse</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Wendet sich</translation>
    </message>
    <message>
        <source>Turns a minute; empty: not known yet</source>
        <translation>Umdrehungen in der Minute; leer: noch nicht bekannt</translation>
    </message>
    <message>
        <source>Twelve panels that follow a solid: change its sizes in the spreadsheet</source>
        <translation>Zwölf Bahnen, die einem Volumenkörper folgen: seine Maße in der Tabelle ändern</translation>
    </message>
    <message>
        <source>Two circles: change their diameters in the sketch</source>
        <translation>Zwei Kreise: ihre Durchmesser in der Skizze ändern</translation>
    </message>
    <message>
        <source>Two equal panels have one seam: what is said of the seam or edge of the opening has no effect. Say the direction of the intake, or its place along the seam.</source>
        <translation>Zwei gleiche Bahnen haben eine einzige Naht: was zur Naht oder Kante der Öffnung angegeben ist, wirkt nicht. Die Richtung des Füllhalses angeben oder seinen Ort entlang der Naht.</translation>
    </message>
    <message>
        <source>Two equal panels lie flat and have no lower end. Give lift to a standing body.</source>
        <translation>Zwei gleiche Bahnen liegen flach und haben kein unteres Ende. Auftrieb nur einem stehenden Körper geben.</translation>
    </message>
    <message>
        <source>Two panels</source>
        <translation>Zwei Bahnen</translation>
    </message>
    <message>
        <source>Two panels of the JSON file are called '{0}'. Give each a name of its own.</source>
        <translation>Zwei Bahnen der JSON-Datei heißen „{0}“. Jeder einen eigenen Namen geben.</translation>
    </message>
    <message>
        <source>Two panels with a grain aslant are no mirror images. Turn the grain along x or y.</source>
        <translation>Zwei Bahnen mit schräger Laufrichtung sind keine Spiegelbilder. Die Laufrichtung längs x oder y drehen.</translation>
    </message>
    <message>
        <source>Two shapes meet at {0}; part them, or join them into one.</source>
        <translation>Zwei Formen berühren sich bei {0}; sie trennen oder zu einer verbinden.</translation>
    </message>
    <message>
        <source>Type = for an expression</source>
        <translation>Mit = einen Ausdruck eingeben</translation>
    </message>
    <message>
        <source>Type two places for a cut, such as 10 0 50; 10 20 50, or choose a seam and type one.</source>
        <translation>Zwei Stellen für einen Schnitt eingeben, etwa 10 0 50; 10 20 50, oder eine Naht wählen und eine eingeben.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Rückgängig (Strg+Z)</translation>
    </message>
    <message>
        <source>Uniform errors along a seam need scipy: pip install scipy.</source>
        <translation>Gleichverteilte Abweichungen entlang einer Naht brauchen scipy: pip install scipy.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Unit of the numbers in its files</source>
        <translation>Einheit der Zahlen in ihren Dateien</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>Upload the SVG as a cut image and compare the control bar: some versions read the size at 72 dpi. Nothing is in the file that may not be cut. It adds the knife's offset and overcut itself. Design Space prints marks of its own (Print Then Cut), round at most 9.25 x 6.75 in: a print has none, and is refused where it is larger. Where yours takes more, raise most_mm in a copy.</source>
        <translation>Laden Sie das SVG als Schneidebild hoch und vergleichen Sie den Kontrollbalken: manche Fassungen lesen die Größe mit 72 dpi. In der Datei ist nichts, was nicht geschnitten werden darf. Messerversatz und Überschnitt fügt es selbst hinzu. Design Space druckt eigene Marken (Print Then Cut), um höchstens 9,25 x 6,75 Zoll: ein Druck hat keine und wird verweigert, wo er größer ist. Wo Ihres mehr zulässt, erhöhen Sie most_mm in einer Kopie.</translation>
    </message>
    <message>
        <source>Upper end</source>
        <translation>Oberes Ende</translation>
    </message>
    <message>
        <source>Use it as --machine {0}; in FreeCAD it is among the machines.</source>
        <translation>Verwenden Sie sie als --machine {0}; in FreeCAD ist sie unter den Maschinen.</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Genutzt</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Valve film</source>
        <translation>Ventilfolie</translation>
    </message>
    <message>
        <source>Valve, on one panel</source>
        <translation>Ventil, auf einer Bahn</translation>
    </message>
    <message>
        <source>Vary</source>
        <translation>Verändern</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violett</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volume of the body: {0}, the balloon has {1} of it</source>
        <translation>Volumen des Körpers: {0}, der Ballon hat {1} davon</translation>
    </message>
    <message>
        <source>Warm air</source>
        <translation>Warmluft</translation>
    </message>
    <message>
        <source>Water column</source>
        <translation>Wassersäule</translation>
    </message>
    <message>
        <source>Weakest place</source>
        <translation>Schwächste Stelle</translation>
    </message>
    <message>
        <source>Weakest place: {0} at {1}</source>
        <translation>Schwächste Stelle: {0} bei {1}</translation>
    </message>
    <message>
        <source>Weakest place: {0} at {1}, estimated: the film did not come to rest</source>
        <translation>Schwächste Stelle: {0} bei {1}, geschätzt: Die Folie kam nicht zur Ruhe</translation>
    </message>
    <message>
        <source>Web page that turns the balloon (HTML)</source>
        <translation>Webseite, die den Ballon dreht (HTML)</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Weight of film, welds and valve</source>
        <translation>Gewicht von Folie, Schweißnähten und Ventil</translation>
    </message>
    <message>
        <source>Weld</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Weld TPU to TPU with an iron or hot air, 10 mm wide. Warp and weft are stiff, the bias is soft: the model takes one modulus for all directions. Stiffer after the first inflations.</source>
        <translation>TPU auf TPU mit Eisen oder Heißluft schweißen, 10 mm breit. Kette und Schuss sind steif, die Schräge ist weich: Das Modell nimmt einen Modul für alle Richtungen. Nach den ersten Füllungen steifer.</translation>
    </message>
    <message>
        <source>Weld across the neck along its line, through panels and strips: the field keeps the channel open. Pull the slip out and blow through the valve.</source>
        <translation>Quer über den Hals entlang seiner Linie schweißen, durch Bahnen und Streifen: Das Feld hält den Kanal offen. Das Backpapier herausziehen und durch das Ventil blasen.</translation>
    </message>
    <message>
        <source>Weld along the dashed line, {seal} wide, all the way round.</source>
        <translation>Entlang der gestrichelten Linie schweißen, {seal} breit, rundherum.</translation>
    </message>
    <message>
        <source>Weld along the dashed line, {seal} wide. Leave the mouth of the neck open.</source>
        <translation>Entlang der gestrichelten Linie schweißen, {seal} breit. Die Mündung des Halses offen lassen.</translation>
    </message>
    <message>
        <source>Weld and cut</source>
        <translation>Naht und Schnitt</translation>
    </message>
    <message>
        <source>Weld overrun</source>
        <translation>Überlauf der Schweißnaht</translation>
    </message>
    <message>
        <source>Weld rigidity</source>
        <translation>Nahtsteifigkeit</translation>
    </message>
    <message>
        <source>Weld the lines inside the balloon.</source>
        <translation>Die Linien im Inneren des Ballons schweißen.</translation>
    </message>
    <message>
        <source>Weld the two strips together along their lines; over the marked field, heat-resistant ink or a slip of baking paper keeps the channel open. Tack them to one panel, their end at the mouth; then weld round the balloon and across the neck. Fill with a 6 mm tube: the pressure closes the strips.</source>
        <translation>Die zwei Streifen entlang ihrer Linien miteinander verschweißen; auf dem markierten Feld hält hitzefeste Tinte oder ein Stück Backpapier den Kanal offen. An eine Bahn heften, das Ende an der Mündung; dann um den Ballon und quer über den Hals schweißen. Mit einem Röhrchen von 6 mm füllen: Der Druck schließt die Streifen.</translation>
    </message>
    <message>
        <source>Weld with high frequency along the dashed line, {seal} wide, all the way round.</source>
        <translation>Mit Hochfrequenz entlang der gestrichelten Linie schweißen, {seal} breit, rundherum.</translation>
    </message>
    <message>
        <source>Weld with high frequency along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>Mit Hochfrequenz entlang der gestrichelten Linie schweißen, {seal} breit; die Mündung des Halses offen lassen.</translation>
    </message>
    <message>
        <source>Weld: {}</source>
        <translation>Schweißnaht: {}</translation>
    </message>
    <message>
        <source>Welded across, last</source>
        <translation>Quer verschweißt, zuletzt</translation>
    </message>
    <message>
        <source>Welding</source>
        <translation>Schweißen</translation>
    </message>
    <message>
        <source>Welding: {0}</source>
        <translation>Schweißen: {0}</translation>
    </message>
    <message>
        <source>Welds easily with an impulse sealer or an iron. Yields at about 9 MPa, half its tensile strength, and creeps: keep the pressure low.</source>
        <translation>Lässt sich leicht mit Impulssiegler oder Bügeleisen schweißen. Fließt bei etwa 9 MPa, der Hälfte seiner Zugfestigkeit, und kriecht: den Druck niedrig halten.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>What is behind the balloon</source>
        <translation>Was hinter dem Ballon ist</translation>
    </message>
    <message>
        <source>What is cut is a line in the spot colour CutContour, which prints over the picture and leaves no gap in it. With artwork both are in artwork-print-and-cut-pdf.pdf. The shop's program adds marks of its own.</source>
        <translation>Was geschnitten wird, ist eine Linie in der Schmuckfarbe CutContour, die über das Bild druckt und keine Lücke darin lässt. Mit Bildvorlage ist beides in artwork-print-and-cut-pdf.pdf. Das Programm der Druckerei fügt eigene Marken hinzu.</translation>
    </message>
    <message>
        <source>What is left of other film is of one film: choose patterns of one film for it.</source>
        <translation>Reststücke bestehen aus einer einzigen Folie: dafür Schnittmuster aus nur einer Folie wählen.</translation>
    </message>
    <message>
        <source>What it can work on, such as 600 x 400 mm, or 600 mm for a roll; empty where there is no limit</source>
        <translation>Worauf sie arbeiten kann, etwa 600 x 400 mm, oder 600 mm für eine Rolle; leer, wo es keine Grenze gibt</translation>
    </message>
    <message>
        <source>What it holds</source>
        <translation>Was sie hält</translation>
    </message>
    <message>
        <source>What it takes to make it</source>
        <translation>Was er zum Bauen braucht</translation>
    </message>
    <message>
        <source>What most shops ask for: R12, closed polylines, nothing on the sheet that is not cut. R12 knows no unit, so the file's name tells it.</source>
        <translation>Was die meisten Betriebe wollen: R12, geschlossene Polylinien, nichts auf dem Bogen, was nicht geschnitten wird. R12 kennt keine Einheit, darum nennt sie der Dateiname.</translation>
    </message>
    <message>
        <source>What shows the balloon</source>
        <translation>Was den Ballon zeigt</translation>
    </message>
    <message>
        <source>What the chosen gas carries besides</source>
        <translation>Was das gewählte Gas darüber hinaus trägt</translation>
    </message>
    <message>
        <source>What this film costs, without what is left over</source>
        <translation>Was diese Folie kostet, ohne den Verschnitt</translation>
    </message>
    <message>
        <source>What this gas costs</source>
        <translation>Was dieses Gas kostet</translation>
    </message>
    <message>
        <source>What this machine can work on, such as 600 x 400 mm, or 600 mm for a roll; empty where there is no limit. It is kept for this machine</source>
        <translation>Was diese Maschine bearbeiten kann, etwa 600 x 400 mm, oder 600 mm für eine Rolle; leer, wo es keine Grenze gibt. Es wird für diese Maschine behalten</translation>
    </message>
    <message>
        <source>What works here</source>
        <translation>Was hier funktioniert</translation>
    </message>
    <message>
        <source>What you want to read when you choose this machine, such as film and separating layer</source>
        <translation>Was Sie lesen wollen, wenn Sie diese Maschine wählen, etwa Folie und Trennschicht</translation>
    </message>
    <message>
        <source>What {0} sent is not the native solver of this release: its SHA-256 is another one. It was not kept. {1}</source>
        <translation>Was {0} geschickt hat, ist nicht der native Löser dieser Version: Die SHA-256 ist eine andere. Es wurde nicht behalten. {1}</translation>
    </message>
    <message>
        <source>When all shards are done, --collect writes the table.</source>
        <translation>Wenn alle Teile fertig sind, schreibt --collect die Tabelle.</translation>
    </message>
    <message>
        <source>Where an edge is cut into tabs, turn it round the other one tab by tab while you seal.</source>
        <translation>Wo eine Kante in Laschen geschnitten ist, sie beim Schweißen Lasche für Lasche um die andere legen.</translation>
    </message>
    <message>
        <source>Where the film wrinkles</source>
        <translation>Wo die Folie Falten wirft</translation>
    </message>
    <message>
        <source>Whether the {0} of the intake's pieces welds to {1} is not known: try it on a scrap first.</source>
        <translation>Ob {0}, das Material der Stücke des Füllhalses, mit {1} verschweißt, ist unbekannt: zuerst an einem Reststück ausprobieren.</translation>
    </message>
    <message>
        <source>While this is pressed, the edge that you pick is where it is filled</source>
        <translation>Solange dies gedrückt ist, ist die gewählte Kante die, an der er gefüllt wird</translation>
    </message>
    <message>
        <source>While this is pressed, the ring in the 3D view moves the intake</source>
        <translation>Solange dies gedrückt ist, verschiebt der Ring in der 3D-Ansicht den Füllhals</translation>
    </message>
    <message>
        <source>While this is pressed, what you select becomes the source</source>
        <translation>Solange dies gedrückt ist, wird das Ausgewählte zur Quelle</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width hidden in wrinkles</source>
        <translation>In Falten verborgene Breite</translation>
    </message>
    <message>
        <source>Width of film that the beam or cutter takes away: cuts are moved outward by half of it</source>
        <translation>Breite an Folie, die Strahl oder Messer wegnimmt: Schnitte werden um die Hälfte nach außen verschoben</translation>
    </message>
    <message>
        <source>Width of the balloon when it is inflated</source>
        <translation>Breite des aufgeblasenen Ballons</translation>
    </message>
    <message>
        <source>Will it float?</source>
        <translation>Schwebt er?</translation>
    </message>
    <message>
        <source>Will it float? {0}</source>
        <translation>Schwebt er? {0}</translation>
    </message>
    <message>
        <source>With --scale {0} the size tells nothing of the film: give the photograph's scale to fit it.</source>
        <translation>Mit --scale {0} sagt die Größe nichts über die Folie: den Maßstab des Fotos angeben, um sie anzupassen.</translation>
    </message>
    <message>
        <source>With a side band the balloon of this drawing becomes {0} to {1} thick, not {2}. Choose a thickness between, or draw its parts wider or narrower.</source>
        <translation>Mit einem Seitenband wird der Ballon dieser Zeichnung {0} bis {1} dick, nicht {2}. Eine Dicke dazwischen wählen oder seine Teile breiter oder schmaler zeichnen.</translation>
    </message>
    <message>
        <source>With so few samples, {0}, nobody can say which pressure 95 of 100 balloons bear: take {1} or more.</source>
        <translation>{0} Stichproben sind zu wenige, um zu sagen, welchen Druck 95 von 100 Ballons aushalten: {1} oder mehr nehmen.</translation>
    </message>
    <message>
        <source>With the fonts of this computer {0} cannot be drawn, letter by letter from left to right: leave that out of the label, or install a font that has it and start again.</source>
        <translation>Mit den Schriften dieses Rechners lässt sich {0} nicht zeichnen, Buchstabe für Buchstabe von links nach rechts: es in der Beschriftung weglassen oder eine Schrift installieren, die es hat, und neu starten.</translation>
    </message>
    <message>
        <source>With {0} panels some would cross themselves when laid flat: the body has {1}.</source>
        <translation>Mit {0} Bahnen würden sich manche flach ausgelegt selbst kreuzen: Der Körper hat {1}.</translation>
    </message>
    <message>
        <source>With {0} to {1} panels some would cross themselves when laid flat: give more panels.</source>
        <translation>Mit {0} bis {1} Bahnen würden sich manche flach ausgelegt selbst kreuzen: mehr Bahnen angeben.</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Innerhalb von</translation>
    </message>
    <message>
        <source>Without this seam panel {0} goes round the body and cannot be laid flat.</source>
        <translation>Ohne diese Naht läuft Bahn {0} um den Körper herum und lässt sich nicht flach auslegen.</translation>
    </message>
    <message>
        <source>Work out</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Work out how near balloons of 6 to 60 panels come to the body</source>
        <translation>Ausrechnen, wie nahe Ballons aus 6 bis 60 Bahnen dem Körper kommen</translation>
    </message>
    <message>
        <source>Wrinkles</source>
        <translation>Falten</translation>
    </message>
    <message>
        <source>Write all results for ParaView (.vtu) or NumPy (.npz), or the shape alone (.stl)</source>
        <translation>Alle Ergebnisse für ParaView (.vtu) oder NumPy (.npz) schreiben, oder nur die Form (.stl)</translation>
    </message>
    <message>
        <source>Write anyway</source>
        <translation>Trotzdem schreiben</translation>
    </message>
    <message>
        <source>Write files…</source>
        <translation>Dateien schreiben…</translation>
    </message>
    <message>
        <source>Write several files, each as large as the bed. Crosses in waste film tell how the film is laid on anew for the next one</source>
        <translation>Mehrere Dateien schreiben, jede so groß wie das Bett. Kreuze in der Abfallfolie sagen, wie die Folie für die nächste neu aufgelegt wird</translation>
    </message>
    <message>
        <source>Write the file although it is larger than the bed</source>
        <translation>Die Datei schreiben, obwohl sie größer als das Bett ist</translation>
    </message>
    <message>
        <source>Write the pieces as they lie, and the artwork if it is shown, to a PDF in real size</source>
        <translation>Die Stücke, wie sie liegen, und die Bildvorlage, wenn sie gezeigt wird, in wahrer Größe in ein PDF schreiben</translation>
    </message>
    <message>
        <source>Write these frames as a moving picture, with the artwork, on white</source>
        <translation>Diese Bilder als bewegtes Bild schreiben, mit Aufdruck, auf Weiß</translation>
    </message>
    <message>
        <source>Write what is left of the film to a file, for another layout</source>
        <translation>Was von der Folie übrig ist in eine Datei schreiben, für eine andere Anordnung</translation>
    </message>
    <message>
        <source>Write {"a": ["top", 0, 1], "b": ["side", 3, 2]}.</source>
        <translation>{"a": ["top", 0, 1], "b": ["side", 3, 2]} schreiben.</translation>
    </message>
    <message>
        <source>Write {"do": "add", "at": [[0.3, 0.5]]}.</source>
        <translation>{"do": "add", "at": [[0.3, 0.5]]} schreiben.</translation>
    </message>
    <message>
        <source>Write {"do": "cut", "at": [[0, 0, 50], [100, 0, 20]]}.</source>
        <translation>{"do": "cut", "at": [[0, 0, 50], [100, 0, 20]]} schreiben.</translation>
    </message>
    <message>
        <source>Write {"name": "top", "outer": [[0, 0], [300, 0], [150, 200]]}.</source>
        <translation>{"name": "top", "outer": [[0, 0], [300, 0], [150, 200]]} schreiben.</translation>
    </message>
    <message>
        <source>Write {"panel": "side", "at": 2}.</source>
        <translation>{"panel": "side", "at": 2} schreiben.</translation>
    </message>
    <message>
        <source>Write {"unit": "mm", "outer": [[0, 0], [300, 0], [150, 200]]}.</source>
        <translation>So schreiben: {"unit": "mm", "outer": [[0, 0], [300, 0], [150, 200]]}.</translation>
    </message>
    <message>
        <source>Write {"unit": "mm", "profile": [[0, 0], [150, 200], [0, 400]]}.</source>
        <translation>{"unit": "mm", "profile": [[0, 0], [150, 200], [0, 400]]} schreiben.</translation>
    </message>
    <message>
        <source>Writing DXF needs ezdxf: install it with pip install ezdxf, or use the SVG file.</source>
        <translation>DXF zu schreiben braucht ezdxf: mit pip install ezdxf installieren oder die SVG-Datei benutzen.</translation>
    </message>
    <message>
        <source>Writing PDF needs matplotlib: install it with pip install matplotlib, or use the SVG file.</source>
        <translation>PDF zu schreiben braucht matplotlib: mit pip install matplotlib installieren oder die SVG-Datei verwenden.</translation>
    </message>
    <message>
        <source>Writing the test card</source>
        <translation>Die Testkarte wird geschrieben</translation>
    </message>
    <message>
        <source>Writing {0}</source>
        <translation>{0} wird geschrieben</translation>
    </message>
    <message>
        <source>Written to {}</source>
        <translation>Geschrieben nach {}</translation>
    </message>
    <message>
        <source>Written to {}, in real size on {}: print it at 100 %.</source>
        <translation>Geschrieben nach {}, in wahrer Größe auf {}: mit 100 % drucken.</translation>
    </message>
    <message>
        <source>Wrote {0}</source>
        <translation>{0} geschrieben</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>You paint on: {}</source>
        <translation>Gemalt wird auf: {}</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>Young's modulus across the grain</source>
        <translation>Elastizitätsmodul quer zur Laufrichtung</translation>
    </message>
    <message>
        <source>Young's modulus of the film</source>
        <translation>Elastizitätsmodul der Folie</translation>
    </message>
    <message>
        <source>Zünd Cut Center (flat bed)</source>
        <translation>Zünd Cut Center (Flachbett)</translation>
    </message>
    <message>
        <source>["200mm", "300mm"], {"linspace": ["1kPa", "3kPa", 5]} with how many, {"range": [6, 12, 2]} with the step, {"between": ["1kPa", "3kPa"]} for samples, or {"glob": "drawings/*.png"}</source>
        <translation>["200mm", "300mm"], {"linspace": ["1kPa", "3kPa", 5]} mit der Anzahl, {"range": [6, 12, 2]} mit dem Schritt, {"between": ["1kPa", "3kPa"]} für Stichproben oder {"glob": "drawings/*.png"}</translation>
    </message>
    <message>
        <source>a LightBurn project has layers up to {0}: change the pen.</source>
        <translation>ein LightBurn-Projekt hat Ebenen bis {0}: den Stift ändern.</translation>
    </message>
    <message>
        <source>a body consists of itself, or of one that is not there</source>
        <translation>ein Körper besteht aus sich selbst oder aus einem, den es nicht gibt</translation>
    </message>
    <message>
        <source>a body hangs together</source>
        <translation>ein Körper hängt zusammen</translation>
    </message>
    <message>
        <source>a comma, quote or bracket is missing or too much in line {0}</source>
        <translation>in Zeile {0} fehlt ein Komma, Anführungszeichen oder eine Klammer, oder es ist eines zu viel</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>eine Koordinate ist keine Zahl</translation>
    </message>
    <message>
        <source>a density</source>
        <translation>eine Dichte</translation>
    </message>
    <message>
        <source>a face is no list of points.</source>
        <translation>eine Fläche ist keine Liste von Punkten.</translation>
    </message>
    <message>
        <source>a force</source>
        <translation>eine Kraft</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>eine Länge</translation>
    </message>
    <message>
        <source>a loop is no list of at least three points [x, y].</source>
        <translation>eine Schleife ist keine Liste von mindestens drei Punkten [x, y].</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>eine Masse</translation>
    </message>
    <message>
        <source>a number without a unit</source>
        <translation>eine Zahl ohne Einheit</translation>
    </message>
    <message>
        <source>a point is no three numbers.</source>
        <translation>ein Punkt besteht nicht aus drei Zahlen.</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>ein Druck</translation>
    </message>
    <message>
        <source>a sleeve has an end</source>
        <translation>ein Schlauch hat ein Ende</translation>
    </message>
    <message>
        <source>a temperature</source>
        <translation>eine Temperatur</translation>
    </message>
    <message>
        <source>a transform is not a number</source>
        <translation>eine Transformation ist keine Zahl</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>ein Volumen</translation>
    </message>
    <message>
        <source>a {0} file has a unit of its own: give "unit": "mm".</source>
        <translation>eine {0}-Datei hat ihre eigene Einheit: "unit": "mm" angeben.</translation>
    </message>
    <message>
        <source>about {}</source>
        <translation>etwa {}</translation>
    </message>
    <message>
        <source>about {} x {}, {} thick, {}</source>
        <translation>etwa {} x {}, {} dick, {}</translation>
    </message>
    <message>
        <source>air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>all files were written before to {0}</source>
        <translation>alle Dateien waren vorher nach {0} geschrieben</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>ein Winkel</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>eine Fläche</translation>
    </message>
    <message>
        <source>another run has been writing there for a minute</source>
        <translation>ein anderer Lauf schreibt dort seit einer Minute</translation>
    </message>
    <message>
        <source>another unit</source>
        <translation>eine andere Einheit</translation>
    </message>
    <message>
        <source>any accuracy</source>
        <translation>beliebige Genauigkeit</translation>
    </message>
    <message>
        <source>apart {} in the mean, 95 % below {}, at most {}</source>
        <translation>Abstand im Mittel {}, 95 % unter {}, höchstens {}</translation>
    </message>
    <message>
        <source>areal density</source>
        <translation>Flächengewicht</translation>
    </message>
    <message>
        <source>artwork.pdf was left out. {0}</source>
        <translation>artwork.pdf wurde weggelassen. {0}</translation>
    </message>
    <message>
        <source>as made is larger</source>
        <translation>hergestellt größer</translation>
    </message>
    <message>
        <source>as made is smaller</source>
        <translation>hergestellt kleiner</translation>
    </message>
    <message>
        <source>at most </source>
        <translation>höchstens </translation>
    </message>
    <message>
        <source>at most {0}</source>
        <translation>höchstens {0}</translation>
    </message>
    <message>
        <source>at most {} ({})</source>
        <translation>höchstens {} ({})</translation>
    </message>
    <message>
        <source>at most {} {}</source>
        <translation>höchstens {} {}</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>back</source>
        <translation>Rückseite</translation>
    </message>
    <message>
        <source>baking paper</source>
        <translation>Backpapier</translation>
    </message>
    <message>
        <source>balloon {0} of {1}</source>
        <translation>Ballon {0} von {1}</translation>
    </message>
    <message>
        <source>balloon {0} of {1} at most</source>
        <translation>Ballon {0} von höchstens {1}</translation>
    </message>
    <message>
        <source>balloon {0} of {1}, {2}</source>
        <translation>Ballon {0} von {1}, {2}</translation>
    </message>
    <message>
        <source>balloons</source>
        <translation>Ballons</translation>
    </message>
    <message>
        <source>bar or iron {0}</source>
        <translation>Schweißbalken oder Bügeleisen {0}</translation>
    </message>
    <message>
        <source>bed_mm is {0}: give [width, height], [width, null] for a roll, or null where there is no limit.</source>
        <translation>bed_mm ist {0}: geben Sie [Breite, Höhe], [Breite, null] für eine Rolle oder null, wo es keine Grenze gibt.</translation>
    </message>
    <message>
        <source>both lie on borders of one piece</source>
        <translation>beide liegen am Rand desselben Stücks</translation>
    </message>
    <message>
        <source>choose Drawn as filled shape</source>
        <translation>„Gezeichnet als“ auf „Gefüllte Form“ stellen</translation>
    </message>
    <message>
        <source>colour index {0} and pen {1} of {2} must be from 1 to 255.</source>
        <translation>Farbindex {0} und Stift {1} von {2} müssen von 1 bis 255 reichen.</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>crosses for the eye</source>
        <translation>Kreuze fürs Auge</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>cut inside</source>
        <translation>Schnitt innen</translation>
    </message>
    <message>
        <source>cutting error</source>
        <translation>Abweichung beim Schneiden</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>designing a balloon</source>
        <translation>Entwurf eines Ballons</translation>
    </message>
    <message>
        <source>does not name its unit</source>
        <translation>nennt ihre Einheit nicht</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>drawn mark</source>
        <translation>gezeichnete Marke</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>Wartezeit</translation>
    </message>
    <message>
        <source>edge {0} of {1}panel '{2}'</source>
        <translation>Kante {0} von {1}Bahn „{2}“</translation>
    </message>
    <message>
        <source>edges {0} to {1}</source>
        <translation>Kanten {0} bis {1}</translation>
    </message>
    <message>
        <source>empty: </source>
        <translation>leer: </translation>
    </message>
    <message>
        <source>feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>feed in corners</source>
        <translation>Vorschub in Ecken</translation>
    </message>
    <message>
        <source>fetch the native solver from the network, where the workbench came without it</source>
        <translation>den nativen Löser aus dem Netz herunterladen, wo der Arbeitsbereich ohne ihn kam</translation>
    </message>
    <message>
        <source>fetching</source>
        <translation>Herunterladen</translation>
    </message>
    <message>
        <source>few panels</source>
        <translation>wenige Bahnen</translation>
    </message>
    <message>
        <source>film</source>
        <translation>Folie</translation>
    </message>
    <message>
        <source>film and valve weigh {0}</source>
        <translation>Folie und Ventil wiegen {0}</translation>
    </message>
    <message>
        <source>fitted to {0}</source>
        <translation>angepasst an {0}</translation>
    </message>
    <message>
        <source>fold</source>
        <translation>Faltlinie</translation>
    </message>
    <message>
        <source>front</source>
        <translation>Vorderseite</translation>
    </message>
    <message>
        <source>gas</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>given by the user</source>
        <translation>vom Benutzer angegeben</translation>
    </message>
    <message>
        <source>glued seam</source>
        <translation>geklebte Naht</translation>
    </message>
    <message>
        <source>glued seam inside</source>
        <translation>geklebte Naht innen</translation>
    </message>
    <message>
        <source>grain at {}°</source>
        <translation>Laufrichtung {}°</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>helium</source>
        <translation>Helium</translation>
    </message>
    <message>
        <source>hide {} of the film's width</source>
        <translation>verbergen {} der Folienbreite</translation>
    </message>
    <message>
        <source>hint</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>Loch</translation>
    </message>
    <message>
        <source>hole {0} of panel '{1}'</source>
        <translation>Loch {0} der Bahn „{1}“</translation>
    </message>
    <message>
        <source>hot tip</source>
        <translation>heiße Spitze</translation>
    </message>
    <message>
        <source>hot tip at {0}</source>
        <translation>heiße Spitze bei {0}</translation>
    </message>
    <message>
        <source>hot wheel</source>
        <translation>heißes Rad</translation>
    </message>
    <message>
        <source>hydrogen</source>
        <translation>Wasserstoff</translation>
    </message>
    <message>
        <source>if the weld creases: {0}</source>
        <translation>wenn die Naht knittert: {0}</translation>
    </message>
    <message>
        <source>in both sides of seam {0}</source>
        <translation>in beiden Seiten der Naht {0}</translation>
    </message>
    <message>
        <source>in seams {0} and {1}</source>
        <translation>in den Nähten {0} und {1}</translation>
    </message>
    <message>
        <source>in the mean {}</source>
        <translation>im Mittel {}</translation>
    </message>
    <message>
        <source>in the mean {} ({})</source>
        <translation>im Mittel {} ({})</translation>
    </message>
    <message>
        <source>in the mean {}, 95 % below {}, at most {}</source>
        <translation>im Mittel {}, 95 % unter {}, höchstens {}</translation>
    </message>
    <message>
        <source>in {}</source>
        <translation>in {}</translation>
    </message>
    <message>
        <source>inflated</source>
        <translation>aufgeblasen</translation>
    </message>
    <message>
        <source>inflated {0}, {1}</source>
        <translation>aufgeblasen {0}, {1}</translation>
    </message>
    <message>
        <source>inflating</source>
        <translation>Aufblasen</translation>
    </message>
    <message>
        <source>inflating in time</source>
        <translation>zeitliches Aufblasen</translation>
    </message>
    <message>
        <source>intake piece {0}</source>
        <translation>Füllhals-Stück {0}</translation>
    </message>
    <message>
        <source>it ends too early.</source>
        <translation>sie endet zu früh.</translation>
    </message>
    <message>
        <source>it has {0} shapes: give 1 to {1}.</source>
        <translation>es hat {0} Formen: geben Sie 1 bis {1}.</translation>
    </message>
    <message>
        <source>it is nested too deeply</source>
        <translation>sie ist zu tief verschachtelt</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>das ist keine Datei</translation>
    </message>
    <message>
        <source>it is thinner than any film. Make it wider.</source>
        <translation>sie ist dünner als jede Folie. Sie breiter machen.</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>sie ist zu groß</translation>
    </message>
    <message>
        <source>it would grow together with another part</source>
        <translation>sie würde mit einem anderen Teil zusammenwachsen</translation>
    </message>
    <message>
        <source>its header cannot be understood.</source>
        <translation>ihr Dateikopf ist nicht zu verstehen.</translation>
    </message>
    <message>
        <source>its header has no end.</source>
        <translation>ihr Dateikopf hat kein Ende.</translation>
    </message>
    <message>
        <source>its lines cross or touch: give the edge of one piece of film, and its holes.</source>
        <translation>seine Linien kreuzen oder berühren sich: geben Sie den Rand eines einzigen Stücks Folie und seine Löcher.</translation>
    </message>
    <message>
        <source>its points have lists.</source>
        <translation>ihre Punkte haben Listen.</translation>
    </message>
    <message>
        <source>its points have no x, y and z.</source>
        <translation>ihre Punkte haben kein x, y und z.</translation>
    </message>
    <message>
        <source>knife</source>
        <translation>Messer</translation>
    </message>
    <message>
        <source>known of two equal panels alone</source>
        <translation>nur bei zwei gleichen Bahnen bekannt</translation>
    </message>
    <message>
        <source>laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>layer {0} of the LightBurn project has two speeds or powers: give its roles one.</source>
        <translation>Ebene {0} des LightBurn-Projekts hat zwei Geschwindigkeiten oder Leistungen: ihren Aufgaben nur eine geben.</translation>
    </message>
    <message>
        <source>laying out</source>
        <translation>Auslegen</translation>
    </message>
    <message>
        <source>laying out, {0} so far</source>
        <translation>Auslegen, bisher {0}</translation>
    </message>
    <message>
        <source>lead-in</source>
        <translation>Einlauf</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>less than</source>
        <translation>weniger als</translation>
    </message>
    <message>
        <source>less than its {} with a margin of {} ({})</source>
        <translation>weniger als seine {} mit Reserve {} ({})</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>Auftrieb</translation>
    </message>
    <message>
        <source>lift of the tool</source>
        <translation>Hub des Werkzeugs</translation>
    </message>
    <message>
        <source>line_mm of marks is {0}, and size_mm {1}: a line is at most half as wide as its mark.</source>
        <translation>line_mm der Marken ist {0}, und size_mm {1}: eine Linie ist höchstens halb so breit wie ihre Marke.</translation>
    </message>
    <message>
        <source>loose: {}</source>
        <translation>schlaff: {}</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>making a balloon of a study</source>
        <translation>beim Herstellen eines Ballons einer Studie</translation>
    </message>
    <message>
        <source>making the document</source>
        <translation>beim Erzeugen des Dokuments</translation>
    </message>
    <message>
        <source>marks is {0}: give {"style": ...}, or leave it out for crosses.</source>
        <translation>marks ist {0}: geben Sie {"style": ...} oder lassen Sie es für Kreuze weg.</translation>
    </message>
    <message>
        <source>marks of size_mm {0} and inset_mm {1} do not fit on a page_mm of {2}: give a larger page or smaller marks.</source>
        <translation>Marken mit size_mm {0} und inset_mm {1} passen nicht auf page_mm {2}: geben Sie eine größere Seite oder kleinere Marken.</translation>
    </message>
    <message>
        <source>marks of style {0} have no "{1}": only {2}.</source>
        <translation>Marken der Art {0} haben kein "{1}": nur {2}.</translation>
    </message>
    <message>
        <source>marks of style {0} lack {1}: add it.</source>
        <translation>Marken der Art {0} fehlt {1}: fügen Sie es hinzu.</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>may be cut</source>
        <translation>darf geschnitten werden</translation>
    </message>
    <message>
        <source>min_power_percent of {0} is more than max_power_percent: exchange the two.</source>
        <translation>min_power_percent von {0} ist mehr als max_power_percent: beide tauschen.</translation>
    </message>
    <message>
        <source>mirrored: its other side is up, with its print and sealing side</source>
        <translation>gespiegelt: Ihre andere Seite liegt oben, mit Druck und Siegelseite</translation>
    </message>
    <message>
        <source>more than</source>
        <translation>mehr als</translation>
    </message>
    <message>
        <source>moved at {0}</source>
        <translation>bewegt mit {0}</translation>
    </message>
    <message>
        <source>name a property of the balloon</source>
        <translation>eine Eigenschaft des Ballons angeben</translation>
    </message>
    <message>
        <source>names the unit {0}, which is not a usual one</source>
        <translation>nennt die Einheit {0}, die unüblich ist</translation>
    </message>
    <message>
        <source>near {0} two of its edges are closer than {1}, and their welds run into each other: make the balloon larger or the seal narrower.</source>
        <translation>bei {0} liegen zwei ihrer Kanten näher als {1} beieinander, und ihre Schweißnähte laufen ineinander: den Ballon größer machen oder die Naht schmaler.</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>no drawing to compare with</source>
        <translation>keine Zeichnung zum Vergleichen</translation>
    </message>
    <message>
        <source>no file was written</source>
        <translation>es wurde keine Datei geschrieben</translation>
    </message>
    <message>
        <source>no layer is written: name at least CUT.</source>
        <translation>keine Ebene wird geschrieben: wenigstens CUT nennen.</translation>
    </message>
    <message>
        <source>nobody knows "{0}" of a tool: it may be one of {1}.</source>
        <translation>niemand kennt „{0}“ eines Werkzeugs: möglich sind {1}.</translation>
    </message>
    <message>
        <source>nobody knows "{0}": it may be one of {1}.</source>
        <translation>niemand kennt „{0}“: möglich sind {1}.</translation>
    </message>
    <message>
        <source>nobody knows the start value "{0}": it may be one of {1}.</source>
        <translation>den Startwert "{0}" kennt niemand: er kann einer von {1} sein.</translation>
    </message>
    <message>
        <source>not converged: </source>
        <translation>nicht konvergiert: </translation>
    </message>
    <message>
        <source>notch</source>
        <translation>Passkerbe</translation>
    </message>
    <message>
        <source>nothing is left that is large enough to be used again</source>
        <translation>nichts ist übrig, was groß genug ist, um wieder gebraucht zu werden</translation>
    </message>
    <message>
        <source>number for full power</source>
        <translation>Zahl für volle Leistung</translation>
    </message>
    <message>
        <source>one of its values is of another kind than it must be</source>
        <translation>einer ihrer Werte ist von anderer Art, als er sein muss</translation>
    </message>
    <message>
        <source>only a PDF has spot colours: give "format": "pdf", or leave them out.</source>
        <translation>nur ein PDF hat Schmuckfarben: geben Sie "format": "pdf" oder lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>outward of marks is {0}: write true or false.</source>
        <translation>outward der Marken ist {0}: schreiben Sie true oder false.</translation>
    </message>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>pass {0}: {1}</source>
        <translation>Durchgang {0}: {1}</translation>
    </message>
    <message>
        <source>passes of {0} is {1}: give a whole number.</source>
        <translation>passes von {0} ist {1}: eine ganze Zahl angeben.</translation>
    </message>
    <message>
        <source>pieces {0}, on a remnant of {1}, {2} used</source>
        <translation>Stücke {0}, auf einem Reststück von {1}, {2} genutzt</translation>
    </message>
    <message>
        <source>pieces {0}, on {1}, {2} used</source>
        <translation>Stücke {0}, auf {1}, {2} genutzt</translation>
    </message>
    <message>
        <source>place "{0}" is neither {1} nor {2}.</source>
        <translation>place „{0}“ ist weder {1} noch {2}.</translation>
    </message>
    <message>
        <source>power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>pressed for {0}</source>
        <translation>gedrückt für {0}</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>pressure at filling</source>
        <translation>Druck beim Füllen</translation>
    </message>
    <message>
        <source>printing</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>reading the photograph</source>
        <translation>Foto lesen</translation>
    </message>
    <message>
        <source>reading the solid</source>
        <translation>beim Lesen des Volumenkörpers</translation>
    </message>
    <message>
        <source>remnants {0}, {1}</source>
        <translation>Reststücke {0}, {1}</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>safe to {}, margin {}</source>
        <translation>sicher bis {}, Reserve {}-fach</translation>
    </message>
    <message>
        <source>safe to: is being worked out</source>
        <translation>sicher bis: wird berechnet</translation>
    </message>
    <message>
        <source>seal width</source>
        <translation>Nahtbreite</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>seam inside</source>
        <translation>Naht innen</translation>
    </message>
    <message>
        <source>serious</source>
        <translation>ernst</translation>
    </message>
    <message>
        <source>size {0}, {1}</source>
        <translation>Größe {0}, {1}</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>speed of the spindle</source>
        <translation>Drehzahl der Spindel</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>square_mm of marks is larger than size_mm, {0}: make it smaller.</source>
        <translation>square_mm der Marken ist größer als size_mm, {0}: machen Sie es kleiner.</translation>
    </message>
    <message>
        <source>stale: </source>
        <translation>veraltet: </translation>
    </message>
    <message>
        <source>stale: belongs to earlier values</source>
        <translation>veraltet: gehört zu früheren Werten</translation>
    </message>
    <message>
        <source>start_values are of films that are welded by heat: give "joining": "heat" too.</source>
        <translation>start_values haben Folien, die mit Hitze geschweißt werden: geben Sie auch "joining": "heat".</translation>
    </message>
    <message>
        <source>start_values are {0}: give the values with their sources, or leave them out.</source>
        <translation>start_values sind {0}: geben Sie die Werte mit ihren Quellen oder lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>stopped; {0}.</source>
        <translation>angehalten; {0}.</translation>
    </message>
    <message>
        <source>strain {}</source>
        <translation>Dehnung {}</translation>
    </message>
    <message>
        <source>strength</source>
        <translation>Festigkeit</translation>
    </message>
    <message>
        <source>strength of film and weld</source>
        <translation>Festigkeit von Folie und Schweißnaht</translation>
    </message>
    <message>
        <source>strength of the film not known</source>
        <translation>Festigkeit der Folie unbekannt</translation>
    </message>
    <message>
        <source>such as {"normal": "{0}"}</source>
        <translation>zum Beispiel {"normal": "{0}"}</translation>
    </message>
    <message>
        <source>taped seam</source>
        <translation>Naht mit Klebeband</translation>
    </message>
    <message>
        <source>taped seam inside</source>
        <translation>Naht mit Klebeband innen</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>temperature after filling</source>
        <translation>Temperatur nach dem Füllen</translation>
    </message>
    <message>
        <source>test-card.json</source>
        <translation>test-card.json</translation>
    </message>
    <message>
        <source>the answer is not HTTP</source>
        <translation>die Antwort ist kein HTTP</translation>
    </message>
    <message>
        <source>the balloons that were made stay, and the same command goes on</source>
        <translation>die fertigen Ballons bleiben, und derselbe Befehl macht weiter</translation>
    </message>
    <message>
        <source>the colour "{0}" is not written like #ff0000.</source>
        <translation>die Farbe „{0}“ ist nicht wie #ff0000 geschrieben.</translation>
    </message>
    <message>
        <source>the columns are the options of the command line</source>
        <translation>die Spalten sind die Optionen der Befehlszeile</translation>
    </message>
    <message>
        <source>the connection ended too soon</source>
        <translation>die Verbindung endete zu früh</translation>
    </message>
    <message>
        <source>the connection timed out</source>
        <translation>keine Antwort in der erlaubten Zeit</translation>
    </message>
    <message>
        <source>the file name "{0}" may have letters, digits, spaces, _, - and . only.</source>
        <translation>der Dateiname „{0}“ darf nur Buchstaben, Ziffern, Leerzeichen, _, - und . haben.</translation>
    </message>
    <message>
        <source>the film weighs {0}</source>
        <translation>die Folie wiegt {0}</translation>
    </message>
    <message>
        <source>the last line of each piece is its CUT.</source>
        <translation>die letzte Linie jedes Stücks ist sein CUT.</translation>
    </message>
    <message>
        <source>the layer name "{0}" may have 1 to 31 of A-Z, a-z, 0-9, _, - and $ only.</source>
        <translation>der Name der Ebene "{0}" darf 1 bis 31 Zeichen aus A-Z, a-z, 0-9, _, - und $ haben.</translation>
    </message>
    <message>
        <source>the layer {0} lacks {1}: give speed and power together, or neither.</source>
        <translation>der Ebene {0} fehlt {1}: Geschwindigkeit und Leistung zusammen angeben, oder keine von beiden.</translation>
    </message>
    <message>
        <source>the marks of {0}</source>
        <translation>die Marken von {0}</translation>
    </message>
    <message>
        <source>the name "{0}" of the stock goes into file names: take letters a to z.</source>
        <translation>der Name „{0}“ in stock kommt in Dateinamen: Buchstaben a bis z nehmen.</translation>
    </message>
    <message>
        <source>the nearest are {0}</source>
        <translation>am ähnlichsten sind {0}</translation>
    </message>
    <message>
        <source>the sealing side {0} is no polymer: give one such as "PE", or "none".</source>
        <translation>die Siegelseite {0} ist kein Polymer: zum Beispiel „PE“ angeben, oder „none“.</translation>
    </message>
    <message>
        <source>the separating layer "{0}" is none of {1}: take one.</source>
        <translation>die Trennschicht "{0}" ist keine von {1}: nehmen Sie eine.</translation>
    </message>
    <message>
        <source>the spot colour "{0}" may have letters, digits, _ and - only.</source>
        <translation>die Schmuckfarbe "{0}" darf nur Buchstaben, Ziffern, _ und - haben.</translation>
    </message>
    <message>
        <source>the style of marks</source>
        <translation>die Art der Marken</translation>
    </message>
    <message>
        <source>the tool "{0}" is none of {1}.</source>
        <translation>das Werkzeug „{0}“ ist keines von {1}.</translation>
    </message>
    <message>
        <source>the weld rigidity lacks its source: write where it is from, or "assumed".</source>
        <translation>der Nahtsteifigkeit fehlt ihre Quelle: angeben, woher sie stammt, oder „assumed“.</translation>
    </message>
    <message>
        <source>there is no model in it</source>
        <translation>sie enthält kein Modell</translation>
    </message>
    <message>
        <source>there is no such corner</source>
        <translation>es gibt keine solche Ecke</translation>
    </message>
    <message>
        <source>there is no such part</source>
        <translation>es gibt keinen solchen Teil</translation>
    </message>
    <message>
        <source>there is no unit "{0}": write "mm".</source>
        <translation>es gibt keine Einheit "{0}": schreiben Sie "mm".</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>thickness of the film</source>
        <translation>Dicke der Folie</translation>
    </message>
    <message>
        <source>thin PE film, 30 to 50 µm</source>
        <translation>dünne PE-Folie, 30 bis 50 µm</translation>
    </message>
    <message>
        <source>through a layer of {0}</source>
        <translation>durch eine Schicht {0}</translation>
    </message>
    <message>
        <source>tight: {}</source>
        <translation>straff: {}</translation>
    </message>
    <message>
        <source>times that of flat film</source>
        <translation>mal dem Wert flacher Folie</translation>
    </message>
    <message>
        <source>trial of the pattern: {0}</source>
        <translation>Probe des Schnittmusters: {0}</translation>
    </message>
    <message>
        <source>trial {0}, {1}</source>
        <translation>Versuch {0}, {1}</translation>
    </message>
    <message>
        <source>true to shape</source>
        <translation>formtreu</translation>
    </message>
    <message>
        <source>turned by {}°</source>
        <translation>gedreht um {}°</translation>
    </message>
    <message>
        <source>unknown: this film has no strength</source>
        <translation>unbekannt: Diese Folie hat keine Festigkeit</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>warm air</source>
        <translation>Warmluft</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>weld</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>weld inside</source>
        <translation>Naht innen</translation>
    </message>
    <message>
        <source>welding error</source>
        <translation>Abweichung beim Schweißen</translation>
    </message>
    <message>
        <source>what came out</source>
        <translation>was herauskam</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>width_mm must be above 0, and taper from 0.2 to 1.</source>
        <translation>width_mm muss über 0 liegen, taper zwischen 0,2 und 1.</translation>
    </message>
    <message>
        <source>without a word</source>
        <translation>ohne ein Wort</translation>
    </message>
    <message>
        <source>wrinkled: {}</source>
        <translation>faltig: {}</translation>
    </message>
    <message>
        <source>writing files</source>
        <translation>Dateien schreiben</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>{0} "{1}" is none of {2}.</source>
        <translation>{0} „{1}“ ist keines von {2}.</translation>
    </message>
    <message>
        <source>{0} ({1}, margin {2})</source>
        <translation>{0} ({1}, Reserve {2})</translation>
    </message>
    <message>
        <source>{0} It is left out.</source>
        <translation>{0} Sie wird weggelassen.</translation>
    </message>
    <message>
        <source>{0} and {1} lines meet near {2}: move the hole inward or make the allowance narrower.</source>
        <translation>Linien {0} und {1} treffen sich nahe {2}: das Loch nach innen verschieben oder die Zugabe schmaler machen.</translation>
    </message>
    <message>
        <source>{0} at least {1}</source>
        <translation>{0} mindestens {1}</translation>
    </message>
    <message>
        <source>{0} at most {1}</source>
        <translation>{0} höchstens {1}</translation>
    </message>
    <message>
        <source>{0} balloons cannot be laid out: give 1 or more.</source>
        <translation>{0} Ballons können nicht ausgelegt werden: 1 oder mehr angeben.</translation>
    </message>
    <message>
        <source>{0} begins in {1} and ends in {2}: write both in one unit.</source>
        <translation>{0} beginnt in {1} und endet in {2}: beides in einer Einheit schreiben.</translation>
    </message>
    <message>
        <source>{0} belongs to no balloon: choose an outline, a balloon or a pattern.</source>
        <translation>{0} gehört zu keinem Ballon: einen Umriss, einen Ballon oder ein Schnittmuster wählen.</translation>
    </message>
    <message>
        <source>{0} cannot be "{1}": {2}</source>
        <translation>{0} kann nicht „{1}“ sein: {2}</translation>
    </message>
    <message>
        <source>{0} cannot be deleted: {1}. See who may write there.</source>
        <translation>{0} kann nicht gelöscht werden: {1}. Sehen Sie nach, wer dort schreiben darf.</translation>
    </message>
    <message>
        <source>{0} cannot be loaded ({1}).</source>
        <translation>{0} kann nicht geladen werden ({1}).</translation>
    </message>
    <message>
        <source>{0} cannot be read ({1}): write {2}.</source>
        <translation>{0} ist nicht zu lesen ({1}): {2} schreiben.</translation>
    </message>
    <message>
        <source>{0} cannot be varied: choose a number, a word or a choice.</source>
        <translation>{0} lässt sich nicht verändern: eine Zahl, ein Wort oder eine Auswahl wählen.</translation>
    </message>
    <message>
        <source>{0} cannot make crosses in the film to lay it on anew (layer REGISTRATION): choose another machine, or make the balloon smaller.</source>
        <translation>{0} kann keine Kreuze in die Folie machen, um sie neu aufzulegen (Ebene REGISTRATION): wählen Sie eine andere Maschine oder machen Sie den Ballon kleiner.</translation>
    </message>
    <message>
        <source>{0} cannot work: {1}</source>
        <translation>{0} kann nicht arbeiten: {1}</translation>
    </message>
    <message>
        <source>{0} changed since. Choose Inflate now in its context menu, or switch Live on.</source>
        <translation>Geändert wurde: {0}. Im Kontextmenü „Jetzt aufblasen“ wählen oder Live einschalten.</translation>
    </message>
    <message>
        <source>{0} does not have the native solver (answer {1}). Try again later. {2}</source>
        <translation>{0} hat den nativen Löser nicht (Antwort {1}). Später noch einmal versuchen. {2}</translation>
    </message>
    <message>
        <source>{0} does not see the folder '{1}': choose one that all machines share.</source>
        <translation>{0} sieht den Ordner „{1}“ nicht: einen wählen, den alle Rechner teilen.</translation>
    </message>
    <message>
        <source>{0} dots per inch cannot be printed well: give {1} to {2}.</source>
        <translation>{0} Punkte je Zoll lassen sich nicht gut drucken: {1} bis {2} angeben.</translation>
    </message>
    <message>
        <source>{0} follows itself: choose something that is not made of it.</source>
        <translation>{0} folgt sich selbst: etwas wählen, das nicht daraus gemacht ist.</translation>
    </message>
    <message>
        <source>{0} follows {1}: edit that.</source>
        <translation>{0} folgt {1}: das dort bearbeiten.</translation>
    </message>
    <message>
        <source>{0} gap between the lines closed, the widest {1} of the drawing's width.</source>
        <translation>{0} Lücke zwischen den Linien geschlossen, {1} der Breite der Zeichnung weit.</translation>
    </message>
    <message>
        <source>{0} gaps between the lines closed, the widest {1} of the drawing's width.</source>
        <translation>{0} Lücken zwischen den Linien geschlossen, die weiteste {1} der Breite der Zeichnung.</translation>
    </message>
    <message>
        <source>{0} goes up to {1}, and {2} bears {3}: give less.</source>
        <translation>{0} geht bis {1}, und {2} verträgt {3}: geben Sie weniger.</translation>
    </message>
    <message>
        <source>{0} has a point that is no number or farther away than {1}. Check its coordinates and the unit.</source>
        <translation>{0} hat einen Punkt, der keine Zahl oder weiter weg als {1} ist. Koordinaten und Einheit prüfen.</translation>
    </message>
    <message>
        <source>{0} has a speed and a power, which only layers below {1} of a LightBurn project have: remove them.</source>
        <translation>{0} hat eine Geschwindigkeit und eine Leistung, die nur Ebenen unter {1} eines LightBurn-Projekts haben: sie entfernen.</translation>
    </message>
    <message>
        <source>{0} has an error: repair it.</source>
        <translation>{0} hat einen Fehler: ihn beheben.</translation>
    </message>
    <message>
        <source>{0} has fewer than three points. Give all of its corners.</source>
        <translation>{0} hat weniger als drei Punkte. Alle Ecken angeben.</translation>
    </message>
    <message>
        <source>{0} has interface {1}, but {2} is needed.</source>
        <translation>{0} hat die Schnittstelle {1}, nötig ist {2}.</translation>
    </message>
    <message>
        <source>{0} has no "{1}": it has {2}.</source>
        <translation>{0} hat kein „{1}“: Es gibt {2}.</translation>
    </message>
    <message>
        <source>{0} has no area: all of its points lie on a line. Check its coordinates.</source>
        <translation>{0} hat keine Fläche: alle Punkte liegen auf einer Linie. Die Koordinaten prüfen.</translation>
    </message>
    <message>
        <source>{0} has no balloon: choose the one that is to be varied.</source>
        <translation>{0} hat keinen Ballon: den wählen, der verändert werden soll.</translation>
    </message>
    <message>
        <source>{0} has no drawing yet: choose a picture.</source>
        <translation>{0} hat noch keine Zeichnung: ein Bild wählen.</translation>
    </message>
    <message>
        <source>{0} has no outline to edit: choose a balloon from a picture.</source>
        <translation>{0} hat keinen Umriss zum Bearbeiten: einen Ballon aus einem Bild wählen.</translation>
    </message>
    <message>
        <source>{0} has no pattern: choose a balloon.</source>
        <translation>{0} hat kein Schnittmuster: einen Ballon wählen.</translation>
    </message>
    <message>
        <source>{0} has no piece {1}: its pieces are {2}.</source>
        <translation>{0} hat kein Stück {1}: Die Stücke sind {2}.</translation>
    </message>
    <message>
        <source>{0} has no result yet: recompute it.</source>
        <translation>{0} hat noch kein Ergebnis: neu berechnen.</translation>
    </message>
    <message>
        <source>{0} has no room between its ends: write the smaller one first.</source>
        <translation>{0} hat keinen Raum zwischen seinen Enden: das kleinere zuerst schreiben.</translation>
    </message>
    <message>
        <source>{0} has no rows: write the values of each balloon below the headings.</source>
        <translation>{0} hat keine Zeilen: unter die Überschriften die Werte jedes Ballons schreiben.</translation>
    </message>
    <message>
        <source>{0} has no shape. Choose a solid or a mesh.</source>
        <translation>{0} hat keine Form. Einen Volumenkörper oder ein Netz wählen.</translation>
    </message>
    <message>
        <source>{0} has no shape: select a sketch, a wire or a face.</source>
        <translation>{0} hat keine Form: eine Skizze, einen Draht oder eine Fläche wählen.</translation>
    </message>
    <message>
        <source>{0} has no table: choose a spreadsheet of the document.</source>
        <translation>{0} hat keine Tabelle: eine Kalkulationstabelle des Dokuments wählen.</translation>
    </message>
    <message>
        <source>{0} has no values: write {1}.</source>
        <translation>{0} hat keine Werte: {1} schreiben.</translation>
    </message>
    <message>
        <source>{0} has not been built.</source>
        <translation>{0} wurde nicht gebaut.</translation>
    </message>
    <message>
        <source>{0} has several faces: select one of them.</source>
        <translation>{0} hat mehrere Flächen: eine davon wählen.</translation>
    </message>
    <message>
        <source>{0} has several faces: select those that are panels.</source>
        <translation>{0} hat mehrere Flächen: die wählen, die Bahnen sind.</translation>
    </message>
    <message>
        <source>{0} has two columns for {1}: leave one out.</source>
        <translation>{0} hat zwei Spalten für {1}: eine weglassen.</translation>
    </message>
    <message>
        <source>{0} has version {1}, not {2}: install the same one everywhere.</source>
        <translation>{0} hat Version {1} statt {2}: überall dieselbe installieren.</translation>
    </message>
    <message>
        <source>{0} has {1} bodies: choose one of them.</source>
        <translation>{0} hat {1} Körper: einen davon wählen.</translation>
    </message>
    <message>
        <source>{0} has {1} construction lines: leave one of them, which is the axis.</source>
        <translation>{0} hat {1} Hilfslinien: eine davon lassen, das ist die Achse.</translation>
    </message>
    <message>
        <source>{0} has {1} pieces now: delete it.</source>
        <translation>{0} hat jetzt {1} Stücke: dieses Stück löschen.</translation>
    </message>
    <message>
        <source>{0} hole with a thin line round it was filled, as a pen's: choose Drawn as filled shape to keep it.</source>
        <translation>{0} Loch mit dünner Linie darum wurde gefüllt wie bei einer Strichzeichnung: „Gezeichnet als“ auf „Gefüllte Form“ stellen, um es zu behalten.</translation>
    </message>
    <message>
        <source>{0} holes with a thin line round them were filled, as a pen's: choose Drawn as filled shape to keep them.</source>
        <translation>{0} Löcher mit dünner Linie darum wurden gefüllt wie bei einer Strichzeichnung: „Gezeichnet als“ auf „Gefüllte Form“ stellen, um sie zu behalten.</translation>
    </message>
    <message>
        <source>{0} is a file</source>
        <translation>{0} ist eine Datei</translation>
    </message>
    <message>
        <source>{0} is a folder</source>
        <translation>{0} ist ein Ordner</translation>
    </message>
    <message>
        <source>{0} is an edge of a hole: choose one of an outer loop as the opening.</source>
        <translation>{0} ist eine Kante eines Lochs: eine des äußeren Rands als Öffnung wählen.</translation>
    </message>
    <message>
        <source>{0} is at an end of its range: a wider one may hold a better balloon.</source>
        <translation>{0} liegt an einem Ende seines Bereichs: Ein weiterer enthält vielleicht einen besseren Ballon.</translation>
    </message>
    <message>
        <source>{0} is curved both ways: it is cut into {1} strips.</source>
        <translation>{0} ist in beide Richtungen gekrümmt: in {1} Streifen geschnitten.</translation>
    </message>
    <message>
        <source>{0} is damaged or incomplete ({1}). Install the workbench anew.</source>
        <translation>{0} ist beschädigt oder unvollständig ({1}). Den Arbeitsbereich neu installieren.</translation>
    </message>
    <message>
        <source>{0} is damaged or incomplete. Install the workbench anew.</source>
        <translation>{0} ist beschädigt oder unvollständig. Den Arbeitsbereich neu installieren.</translation>
    </message>
    <message>
        <source>{0} is damaged: install the workbench anew, or go on without the native solver.</source>
        <translation>{0} ist beschädigt: den Arbeitsbereich neu installieren oder ohne den nativen Löser weitermachen.</translation>
    </message>
    <message>
        <source>{0} is damaged: remove it and start the study again.</source>
        <translation>{0} ist beschädigt: entfernen und die Studie noch einmal starten.</translation>
    </message>
    <message>
        <source>{0} is empty: draw a closed line in it.</source>
        <translation>{0} ist leer: eine geschlossene Linie hineinzeichnen.</translation>
    </message>
    <message>
        <source>{0} is empty: draw a line in it.</source>
        <translation>{0} ist leer: eine Linie darin zeichnen.</translation>
    </message>
    <message>
        <source>{0} is empty: draw half an outline in it, beside the vertical axis.</source>
        <translation>{0} ist leer: darin einen halben Umriss neben der senkrechten Achse zeichnen.</translation>
    </message>
    <message>
        <source>{0} is hollow: choose a solid without a space inside.</source>
        <translation>{0} ist hohl: einen Volumenkörper ohne Hohlraum wählen.</translation>
    </message>
    <message>
        <source>{0} is in no seam. Seal it to another edge.</source>
        <translation>{0} ist in keiner Naht. Sie mit einer anderen Kante verschweißen.</translation>
    </message>
    <message>
        <source>{0} is in no seam: join it to another edge.</source>
        <translation>{0} ist in keiner Naht: mit einer anderen Kante verbinden.</translation>
    </message>
    <message>
        <source>{0} is in the document {1}: copy it into {2} first.</source>
        <translation>{0} ist im Dokument {1}: zuerst nach {2} kopieren.</translation>
    </message>
    <message>
        <source>{0} is in two seams: take one of them away.</source>
        <translation>{0} ist in zwei Nähten: eine davon lösen.</translation>
    </message>
    <message>
        <source>{0} is left out. {1}</source>
        <translation>{0} wird weggelassen. {1}</translation>
    </message>
    <message>
        <source>{0} is neither DXF nor SVG: let the name end in .dxf or .svg.</source>
        <translation>{0} ist weder DXF noch SVG: den Namen auf .dxf oder .svg enden lassen.</translation>
    </message>
    <message>
        <source>{0} is neither VTU, NPZ nor STL: let the name end in .vtu, .npz or .stl.</source>
        <translation>{0} ist weder VTU noch NPZ noch STL: den Namen auf .vtu, .npz oder .stl enden lassen.</translation>
    </message>
    <message>
        <source>{0} is no body: give a solid, a mesh or the path of a file.</source>
        <translation>{0} ist kein Körper: einen Volumenkörper, ein Netz oder den Pfad einer Datei geben.</translation>
    </message>
    <message>
        <source>{0} is no file for the web: let the name end in .glb, .html, .png, .gif or .mp4.</source>
        <translation>{0} ist keine Datei fürs Web: Der Name muss auf .glb, .html, .png, .gif oder .mp4 enden.</translation>
    </message>
    <message>
        <source>{0} is no number</source>
        <translation>{0} ist keine Zahl</translation>
    </message>
    <message>
        <source>{0} is no number: list its values.</source>
        <translation>{0} ist keine Zahl: die Werte aufzählen.</translation>
    </message>
    <message>
        <source>{0} is no number: write its values into the table.</source>
        <translation>{0} ist keine Zahl: die Werte in die Tabelle schreiben.</translation>
    </message>
    <message>
        <source>{0} is none of the names that are known</source>
        <translation>{0} ist keiner der bekannten Namen</translation>
    </message>
    <message>
        <source>{0} is not a coordinate</source>
        <translation>{0} ist keine Koordinate</translation>
    </message>
    <message>
        <source>{0} is not closed: film can only be filled where it is. Choose a solid.</source>
        <translation>{0} ist nicht geschlossen: Folie lässt sich nur füllen, wenn sie geschlossen ist. Einen Volumenkörper wählen.</translation>
    </message>
    <message>
        <source>{0} is not flat: a balloon is cut from flat film, so draw it in one plane.</source>
        <translation>{0} ist nicht eben: Ein Ballon wird aus flacher Folie geschnitten, also in einer Ebene zeichnen.</translation>
    </message>
    <message>
        <source>{0} is not flat: draw half the outline in a sketch.</source>
        <translation>{0} ist nicht eben: den halben Umriss in einer Skizze zeichnen.</translation>
    </message>
    <message>
        <source>{0} is not joined by heat: {1} is not made for it.</source>
        <translation>{0} wird nicht mit Wärme verbunden: {1} ist nicht dafür gemacht.</translation>
    </message>
    <message>
        <source>{0} is not printed on {1}: choose an artwork of this pattern.</source>
        <translation>{0} wird nicht auf {1} gedruckt: nehmen Sie eine Bildvorlage dieses Schnittmusters.</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1}</source>
        <translation>{0} ist nicht aktuell. {1}</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1} Repair that and recompute.</source>
        <translation>{0} ist nicht aktuell. {1} Das beheben und neu berechnen.</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1} Repair that, recompute and export again.</source>
        <translation>{0} ist nicht aktuell. {1} Das beheben, neu berechnen und noch einmal ausgeben.</translation>
    </message>
    <message>
        <source>{0} is not worked out yet: recompute the document.</source>
        <translation>{0} ist noch nicht berechnet: Berechnen Sie das Dokument neu.</translation>
    </message>
    <message>
        <source>{0} is open: close its line.</source>
        <translation>{0} ist offen: die Linie schließen.</translation>
    </message>
    <message>
        <source>{0} is too large a number, or none</source>
        <translation>{0} ist eine zu große Zahl oder keine</translation>
    </message>
    <message>
        <source>{0} is {1} long, {2} is {3}: make them equally long.</source>
        <translation>{0} ist {1} lang, {2} {3}: beide gleich lang machen.</translation>
    </message>
    <message>
        <source>{0} is {1} long. Scale it, so that it is between {2} and {3}.</source>
        <translation>{0} ist {1} lang. So skalieren, dass es zwischen {2} und {3} liegt.</translation>
    </message>
    <message>
        <source>{0} is {1}. Seal each edge once: side a goes along its loop from its first point to its second, b against it.</source>
        <translation>{0} ist {1}. Jede Kante einmal verschweißen: Seite a geht entlang ihres Rands vom ersten zum zweiten Punkt, b gegen ihn.</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number from {2} to {3}.</source>
        <translation>{0} ist {1}: eine Zahl von {2} bis {3} angeben.</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number, or [least, most].</source>
        <translation>{0} ist {1}: geben Sie eine Zahl oder [kleinste, größte].</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number.</source>
        <translation>{0} ist {1}: eine Zahl angeben.</translation>
    </message>
    <message>
        <source>{0} is {1}: give numbers from {2} to {3}, the smaller one first.</source>
        <translation>{0} ist {1}: geben Sie Zahlen von {2} bis {3}, die kleinere zuerst.</translation>
    </message>
    <message>
        <source>{0} is {1}: give {2}, or leave it out.</source>
        <translation>{0} ist {1}: {2} angeben oder es weglassen.</translation>
    </message>
    <message>
        <source>{0} is {1}: write it as {"value": ..., "source": "who says so"}.</source>
        <translation>{0} ist {1}: schreiben Sie es als {"value": ..., "source": "wer es sagt"}.</translation>
    </message>
    <message>
        <source>{0} is {1}: write true or false.</source>
        <translation>{0} ist {1}: true oder false schreiben.</translation>
    </message>
    <message>
        <source>{0} lacks its source: write who states it. What nobody states is left out.</source>
        <translation>{0} fehlt die Quelle: schreiben Sie, wer es angibt. Was niemand angibt, wird weggelassen.</translation>
    </message>
    <message>
        <source>{0} left out ({1}).</source>
        <translation>{0} weggelassen ({1}).</translation>
    </message>
    <message>
        <source>{0} lies on both sides of its axis: draw half the outline, on one side.</source>
        <translation>{0} liegt auf beiden Seiten der Achse: den halben Umriss auf einer Seite zeichnen.</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: no, at no size.</source>
        <translation>{0} trägt {1}, {2}: nein, in keiner Größe.</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: no. From {3} width on it would.</source>
        <translation>{0} trägt {1}, {2}: nein. Ab {3} Breite schon.</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: yes, and it carries {3}.</source>
        <translation>{0} trägt {1}, {2}: ja, und der Ballon trägt noch {3}.</translation>
    </message>
    <message>
        <source>{0} mm on paper = {1} of film</source>
        <translation>{0} mm auf Papier = {1} Folie</translation>
    </message>
    <message>
        <source>{0} mm with an error of {1} mm</source>
        <translation>{0} mm mit einem Fehler von {1} mm</translation>
    </message>
    <message>
        <source>{0} must never be cut with a laser: choose a machine with a knife.</source>
        <translation>{0} darf nie mit dem Laser geschnitten werden: eine Maschine mit Messer wählen.</translation>
    </message>
    <message>
        <source>{0} needs a unit: write {1} instead of {2}.</source>
        <translation>{0} braucht eine Einheit: {1} statt {2} schreiben.</translation>
    </message>
    <message>
        <source>{0} never gets from '{1}' to '{2}' by '{3}'.</source>
        <translation>{0} kommt mit „{3}“ nie von „{1}“ nach „{2}“.</translation>
    </message>
    <message>
        <source>{0} notches are closer than {1}: take fewer.</source>
        <translation>{0} Passkerben liegen enger als {1}: weniger nehmen.</translation>
    </message>
    <message>
        <source>{0} of a roll {1} wide</source>
        <translation>{0} einer {1} breiten Rolle</translation>
    </message>
    <message>
        <source>{0} of its size</source>
        <translation>{0} ihrer Größe</translation>
    </message>
    <message>
        <source>{0} of marks is {1}: give [width, height], or leave it out.</source>
        <translation>{0} der Marken ist {1}: geben Sie [Breite, Höhe] oder lassen Sie es weg.</translation>
    </message>
    <message>
        <source>{0} of marks is {1}: give a number from {2} to {3}.</source>
        <translation>{0} der Marken ist {1}: geben Sie eine Zahl von {2} bis {3}.</translation>
    </message>
    <message>
        <source>{0} of {1} cannot be {2}: take another value.</source>
        <translation>{0} von {1} kann nicht {2} sein: einen anderen Wert nehmen.</translation>
    </message>
    <message>
        <source>{0} of {1} follows the expression '{2}': vary what that is made of.</source>
        <translation>{0} von {1} folgt dem Ausdruck „{2}“: verändern, woraus dieser besteht.</translation>
    </message>
    <message>
        <source>{0} of {1} is {2}, but its expression '{3}' gives {4}: change the expression.</source>
        <translation>{0} von {1} ist {2}, das Ergebnis des Ausdrucks „{3}“ ist aber {4}: den Ausdruck ändern.</translation>
    </message>
    <message>
        <source>{0} open line was left out.</source>
        <translation>{0} offene Linie wurde weggelassen.</translation>
    </message>
    <message>
        <source>{0} open lines were left out.</source>
        <translation>{0} offene Linien wurden weggelassen.</translation>
    </message>
    <message>
        <source>{0} over {1}</source>
        <translation>{0} über {1}</translation>
    </message>
    <message>
        <source>{0} panels meet at one point, which no weld closes: seal the cap from the sheet over it, or tape it.</source>
        <translation>{0} Bahnen treffen sich in einem Punkt, den keine Naht schließt: die Kappe vom Bogen darübersiegeln oder ihn abkleben.</translation>
    </message>
    <message>
        <source>{0} reads no G-code: choose a machine that does.</source>
        <translation>{0} liest keinen G-Code: Wählen Sie eine Maschine, die das tut.</translation>
    </message>
    <message>
        <source>{0} reads {1}, which has no pages: choose paper.</source>
        <translation>{0} liest {1}, das keine Seiten hat: Papier wählen.</translation>
    </message>
    <message>
        <source>{0} runs between two ends: say how to take samples in "{1}".</source>
        <translation>{0} läuft zwischen zwei Enden: in „{1}“ angeben, wie Stichproben zu nehmen sind.</translation>
    </message>
    <message>
        <source>{0} seams cannot be sealed lying flat, least of all seam {1} of panels {2}: one edge turns by {3} in all to follow the other. Seal them bit by bit, or round the corners.</source>
        <translation>{0} Nähte lassen sich nicht flach liegend schweißen, am wenigsten Naht {1} der Bahnen {2}: eine Kante dreht sich insgesamt um {3}, um der anderen zu folgen. Sie Stück für Stück schweißen oder die Ecken runden.</translation>
    </message>
    <message>
        <source>{0} small speck was dropped.</source>
        <translation>{0} kleiner Fleck wurde weggelassen.</translation>
    </message>
    <message>
        <source>{0} small specks were dropped.</source>
        <translation>{0} kleine Flecken wurden weggelassen.</translation>
    </message>
    <message>
        <source>{0} takes from 1 to {1} equal parts, not '{2}'.</source>
        <translation>{0} nimmt 1 bis {1} gleiche Teile, nicht „{2}“.</translation>
    </message>
    <message>
        <source>{0} thin line is</source>
        <translation>{0} dünne Linie</translation>
    </message>
    <message>
        <source>{0} thin lines are</source>
        <translation>{0} dünne Linien</translation>
    </message>
    <message>
        <source>{0} times</source>
        <translation>{0}-mal</translation>
    </message>
    <message>
        <source>{0} tiny hole was filled.</source>
        <translation>{0} winziges Loch wurde gefüllt.</translation>
    </message>
    <message>
        <source>{0} tiny holes were filled.</source>
        <translation>{0} winzige Löcher wurden gefüllt.</translation>
    </message>
    <message>
        <source>{0} turns a minute</source>
        <translation>{0} Umdrehungen je Minute</translation>
    </message>
    <message>
        <source>{0} was left out. {1}</source>
        <translation>{0} wurde weggelassen. {1}</translation>
    </message>
    <message>
        <source>{0} weld outside the shapes left out.</source>
        <translation>{0} Schweißnaht außerhalb der Formen weggelassen.</translation>
    </message>
    <message>
        <source>{0} welds outside the shapes left out.</source>
        <translation>{0} Schweißnähte außerhalb der Formen weggelassen.</translation>
    </message>
    <message>
        <source>{0} wide, {1} long</source>
        <translation>{0} breit, {1} lang</translation>
    </message>
    <message>
        <source>{0} with an error of {1}</source>
        <translation>{0} mit einem Fehler von {1}</translation>
    </message>
    <message>
        <source>{0} with valve {1}</source>
        <translation>{0} mit Ventil von {1}</translation>
    </message>
    <message>
        <source>{0}, inflated: {1}</source>
        <translation>{0}, aufgeblasen: {1}</translation>
    </message>
    <message>
        <source>{0}: '{1}' is no number, write one such as 20.</source>
        <translation>{0}: '{1}' ist keine Zahl, schreiben Sie eine wie 20.</translation>
    </message>
    <message>
        <source>{0}: it is split over several files. Cut them in their order, and lay the film on anew each time so that its crosses are where the next file has them.</source>
        <translation>{0}: es ist auf mehrere Dateien verteilt. Schneiden Sie sie in ihrer Reihenfolge und legen Sie die Folie jedes Mal so auf, dass ihre Kreuze dort sind, wo die nächste Datei sie hat.</translation>
    </message>
    <message>
        <source>{0}: its file lacks {1}: add it.</source>
        <translation>{0}: der Datei fehlt {1}: fügen Sie es hinzu.</translation>
    </message>
    <message>
        <source>{0}: lay its pieces out on sheets of that size, make the balloon smaller, or write the file anyway.</source>
        <translation>{0}: die Stücke auf Bögen dieser Größe auslegen, den Ballon kleiner machen oder die Datei trotzdem schreiben lassen.</translation>
    </message>
    <message>
        <source>{0}: make the balloon smaller, choose another machine or paper, or write the file anyway.</source>
        <translation>{0}: den Ballon kleiner machen, eine andere Maschine oder anderes Papier wählen oder die Datei trotzdem schreiben lassen.</translation>
    </message>
    <message>
        <source>{0}: the file is written anyway.</source>
        <translation>{0}: Die Datei wird trotzdem geschrieben.</translation>
    </message>
    <message>
        <source>{0}: what changes it most</source>
        <translation>{0}: was am meisten ausmacht</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}: {1}</translation>
    </message>
    <message>
        <source>{0}: {1} mm is out of range, give {2} to {3} mm.</source>
        <translation>{0}: {1} mm liegt außerhalb, geben Sie {2} bis {3} mm.</translation>
    </message>
    <message>
        <source>{0}; wider than the usual roll</source>
        <translation>{0}; breiter als die übliche Rolle</translation>
    </message>
    <message>
        <source>{0}take a drawing, without a side band or gores.</source>
        <translation>{0}eine Zeichnung nehmen, ohne Seitenband oder Segmente.</translation>
    </message>
    <message>
        <source>{0}this drawing has {1} shapes, study one at a time.</source>
        <translation>{0}diese Zeichnung hat {1} Formen, jede einzeln untersuchen.</translation>
    </message>
    <message>
        <source>{0}what is shown is the last good state. Lower the pressure or change the mesh size.</source>
        <translation>{0}gezeigt wird der letzte gute Stand. Den Druck senken oder die Netzweite ändern.</translation>
    </message>
    <message>
        <source>{0}{1} has no length. Take one of its points out.</source>
        <translation>{0}{1} hat keine Länge. Einen ihrer Punkte herausnehmen.</translation>
    </message>
    <message>
        <source>{} (unusable)</source>
        <translation>{} (unbrauchbar)</translation>
    </message>
    <message>
        <source>{} ({})</source>
        <translation>{} ({})</translation>
    </message>
    <message>
        <source>{} MB from {}; the file is checked before it is used, and nothing is sent.</source>
        <translation>{} MB von {}; die Datei wird geprüft, bevor sie benutzt wird, und nichts wird gesendet.</translation>
    </message>
    <message>
        <source>{} at ({})</source>
        <translation>{} bei ({})</translation>
    </message>
    <message>
        <source>{} gores are enough for {} of the profile's diagonal</source>
        <translation>{} Segmente reichen für {} der Diagonale des Profils</translation>
    </message>
    <message>
        <source>{} gores, as many as {} of the profile's diagonal need</source>
        <translation>{} Segmente, so viele wie {} der Diagonale des Profils brauchen</translation>
    </message>
    <message>
        <source>{} in the mean, at most {}</source>
        <translation>{} im Mittel, höchstens {}</translation>
    </message>
    <message>
        <source>{} inside</source>
        <translation>{} innen</translation>
    </message>
    <message>
        <source>{} is among the films</source>
        <translation>{} ist unter den Folien</translation>
    </message>
    <message>
        <source>{} is among the machines of Export pattern</source>
        <translation>{} ist unter den Maschinen von Schnittmuster ausgeben</translation>
    </message>
    <message>
        <source>{} is in the tree</source>
        <translation>{} steht im Baum</translation>
    </message>
    <message>
        <source>{} is there already: give another name.</source>
        <translation>{} gibt es schon: einen anderen Namen angeben.</translation>
    </message>
    <message>
        <source>{} is there already: tick "Replace the file", or give another name.</source>
        <translation>{} gibt es schon: „Die Datei ersetzen“ ankreuzen oder einen anderen Namen angeben.</translation>
    </message>
    <message>
        <source>{} is there already: tick "Replace the files", or choose another folder.</source>
        <translation>{} gibt es schon: kreuzen Sie "Die Dateien ersetzen" an oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>{} ms, {}, frame {} of {}</source>
        <translation>{} ms, {}, Bild {} von {}</translation>
    </message>
    <message>
        <source>{} of it wrinkles, {} is loose</source>
        <translation>{} faltig, {} schlaff</translation>
    </message>
    <message>
        <source>{} of the profile's diagonal take {} gores</source>
        <translation>{} der Diagonale des Profils brauchen {} Segmente</translation>
    </message>
    <message>
        <source>{} of them cannot be made:</source>
        <translation>Davon {} ohne Ballon:</translation>
    </message>
    <message>
        <source>{} of {}</source>
        <translation>{} {}</translation>
    </message>
    <message>
        <source>{} of {} rows are worked out.</source>
        <translation>{} von {} Zeilen sind berechnet.</translation>
    </message>
    <message>
        <source>{} outside</source>
        <translation>{} außen</translation>
    </message>
    <message>
        <source>{} panels, {} of seams, {} inside</source>
        <translation>{} Bahnen, {} Nähte, {} Inhalt</translation>
    </message>
    <message>
        <source>{} panels, {} seams of {}</source>
        <translation>{} Bahnen, {} Nähte mit {} Länge</translation>
    </message>
    <message>
        <source>{} panels: about {} off, {} of seams, {} h of welding</source>
        <translation>{} Bahnen: etwa {} daneben, {} Nähte, {} h Schweißen</translation>
    </message>
    <message>
        <source>{} px</source>
        <translation>{} px</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{} bis {}</translation>
    </message>
    <message>
        <source>{} x {}, {} thick, {}</source>
        <translation>{} x {}, {} dick, {}</translation>
    </message>
    <message>
        <source>{}, at most {}</source>
        <translation>{}, höchstens {}</translation>
    </message>
    <message>
        <source>{}, carries {} with {}</source>
        <translation>{0}, trägt mit {2} {1}</translation>
    </message>
    <message>
        <source>{}, floats from {} width on with {}</source>
        <translation>{0}, schwebt mit {2} ab {1} Breite</translation>
    </message>
    <message>
        <source>{}, never floats with {}</source>
        <translation>{}, schwebt nie mit {}</translation>
    </message>
    <message>
        <source>{}, row {}</source>
        <translation>{}, Zeile {}</translation>
    </message>
    <message>
        <source>{}, seam {}</source>
        <translation>{}, Naht {}</translation>
    </message>
    <message>
        <source>{}: film {}, seam and neck {}</source>
        <translation>{}: Folie {}, Naht und Hals {}</translation>
    </message>
    <message>
        <source>{}: film {}, seam and neck {}, valve {}</source>
        <translation>{}: Folie {}, Naht und Hals {}, Ventil {}</translation>
    </message>
    <message>
        <source>{}: they differ by {}</source>
        <translation>{}: sie unterscheiden sich um {}</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>{}: {}, flat</source>
        <translation>{}: {}, flach</translation>
    </message>
    <message>
        <source>{}: {}, nodes</source>
        <translation>{}: {}, Knoten</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Advice</name>
    <message>
        <source>Advice</source>
        <translation>Ratschläge</translation>
    </message>
    <message>
        <source>Show which parts of a shape will inflate badly, and repair them</source>
        <translation>Zeigt, welche Teile einer Form sich schlecht füllen, und repariert sie</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Animate</name>
    <message>
        <source>Animate inflation</source>
        <translation>Aufblasen animieren</translation>
    </message>
    <message>
        <source>Play how the balloon inflates, from the flat film to rest, with a slider</source>
        <translation>Spielt ab, wie sich der Ballon aufbläst, von der flachen Folie bis zur Ruhe, mit Schieberegler</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Artwork</name>
    <message>
        <source>Artwork</source>
        <translation>Bildvorlage</translation>
    </message>
    <message>
        <source>Print a picture on the film so that it reads right on the inflated balloon</source>
        <translation>Ein Bild so auf die Folie drucken, dass es auf dem aufgeblasenen Ballon richtig erscheint</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_AssemblySheet</name>
    <message>
        <source>Assembly sheet</source>
        <translation>Montageblatt</translation>
    </message>
    <message>
        <source>Tell what the balloon takes and whether it floats, and write one page on how to make it</source>
        <translation>Sagt, was der Ballon braucht und ob er schwebt, und schreibt eine Seite, wie er gemacht wird</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ColourMap</name>
    <message>
        <source>Colour map</source>
        <translation>Farbkarte</translation>
    </message>
    <message>
        <source>Show tension, wrinkles, thickness and other results as colours on the balloon</source>
        <translation>Zeigt Spannung, Falten, Dicke und andere Ergebnisse als Farben auf dem Ballon</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Compare</name>
    <message>
        <source>Compare with a photograph</source>
        <translation>Mit einem Foto vergleichen</translation>
    </message>
    <message>
        <source>Lay a photograph of the finished balloon over the simulated one, and see how near it came</source>
        <translation>Ein Foto des fertigen Ballons über den simulierten legen und sehen, wie nahe er kam</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_EditOutline</name>
    <message>
        <source>Edit outline</source>
        <translation>Umriss bearbeiten</translation>
    </message>
    <message>
        <source>Move, add and remove nodes of the outline over its picture, and set how the picture is read</source>
        <translation>Knoten des Umrisses über seinem Bild verschieben, hinzufügen und entfernen, und einstellen, wie das Bild gelesen wird</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Equipment</name>
    <message>
        <source>Show the solver in use, and which packages are missing and what that costs</source>
        <translation>Zeigt den benutzten Löser und welche Pakete fehlen und was das kostet</translation>
    </message>
    <message>
        <source>What works here</source>
        <translation>Was hier funktioniert</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Examples</name>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Open a finished balloon, to look at it and to change it</source>
        <translation>Öffnet einen fertigen Ballon zum Ansehen und Ändern</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ExportForWeb</name>
    <message>
        <source>Export for the web</source>
        <translation>Fürs Web ausgeben</translation>
    </message>
    <message>
        <source>Write the balloon with its artwork as a web page that turns it, as a 3D model or as a picture</source>
        <translation>Den Ballon mit seinem Aufdruck schreiben: als Webseite, die ihn dreht, als 3D-Modell oder als Bild</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ExportPattern</name>
    <message>
        <source>Export pattern</source>
        <translation>Schnittmuster ausgeben</translation>
    </message>
    <message>
        <source>Write the flat pattern of a balloon for a cutter, a plotter, a heat sealer or a printer</source>
        <translation>Schreibt das flache Schnittmuster eines Ballons für Schneidemaschine, Plotter, Heißsiegler oder Drucker</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromBody</name>
    <message>
        <source>Find the panels of a balloon that fills the selected solid or mesh</source>
        <translation>Die Bahnen eines Ballons finden, der den gewählten Volumenkörper oder das gewählte Netz füllt</translation>
    </message>
    <message>
        <source>New balloon from body</source>
        <translation>Neuer Ballon aus Volumenkörper</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromPanels</name>
    <message>
        <source>New bag of panels</source>
        <translation>Neuer Beutel aus Bahnen</translation>
    </message>
    <message>
        <source>Seal flat panels along their edges: selected sketches and faces, a ready body or a file</source>
        <translation>Flache Bahnen entlang ihrer Kanten verschweißen: gewählte Skizzen und Flächen, ein fertiger Körper oder eine Datei</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromPicture</name>
    <message>
        <source>New balloon from picture</source>
        <translation>Neuer Ballon aus Bild</translation>
    </message>
    <message>
        <source>Trace a picture, SVG, DXF or JSON file and design the balloon that looks like it</source>
        <translation>Zeichnet Bild, SVG-, DXF- oder JSON-Datei nach und entwirft den Ballon, der so aussieht</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromProfile</name>
    <message>
        <source>Design the gores of a ball, an airship or another round body from half its outline</source>
        <translation>Die Segmente eines Balls, eines Luftschiffs oder eines anderen runden Körpers aus seinem halben Umriss entwerfen</translation>
    </message>
    <message>
        <source>New body of gores</source>
        <translation>Neuer Körper aus Segmenten</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromSketch</name>
    <message>
        <source>Design the balloon that looks like the selected sketch, wire or face and follows it</source>
        <translation>Entwirft den Ballon, der wie die gewählte Skizze, der Draht oder die Fläche aussieht und ihr folgt</translation>
    </message>
    <message>
        <source>New balloon from sketch</source>
        <translation>Neuer Ballon aus Skizze</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Machines</name>
    <message>
        <source>My machines</source>
        <translation>Meine Maschinen</translation>
    </message>
    <message>
        <source>Set up cutters, lasers, sealers and printers of your own: bed, file format, kerf, knife and tool</source>
        <translation>Eigene Schneidemaschinen, Laser, Heißsiegler und Drucker einrichten: Bett, Dateiformat, Schnittfuge, Messer und Werkzeug</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Nest</name>
    <message>
        <source>Lay out on film</source>
        <translation>Auf Folie auslegen</translation>
    </message>
    <message>
        <source>Lay the panels of one or several balloons closely on a roll or on sheets of film</source>
        <translation>Die Bahnen eines oder mehrerer Ballons dicht auf einer Rolle oder auf Bögen auslegen</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Paint</name>
    <message>
        <source>Draw with pen and brush, and watch the balloon and its pattern grow beside it</source>
        <translation>Mit Stift und Pinsel malen und zusehen, wie Ballon und Schnittmuster daneben wachsen</translation>
    </message>
    <message>
        <source>Paint a balloon</source>
        <translation>Einen Ballon malen</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_PatternView</name>
    <message>
        <source>Pattern view</source>
        <translation>Schnittmuster ansehen</translation>
    </message>
    <message>
        <source>Show all panels flat in a tab of their own: pick an edge to see its partner, and measure</source>
        <translation>Alle Bahnen flach in einem eigenen Reiter zeigen: Eine Kante anklicken zeigt ihr Gegenstück; auch messen</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Study</name>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Work out many variants of a balloon from a spreadsheet, and compare them</source>
        <translation>Viele Varianten eines Ballons aus einer Kalkulationstabelle berechnen und vergleichen</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_TestCard</name>
    <message>
        <source>Find feed, power, temperature or depth of a tool for a film: weld or cut a card of fields</source>
        <translation>Vorschub, Leistung, Temperatur oder Tiefe eines Werkzeugs für eine Folie finden: eine Karte von Feldern schweißen oder schneiden</translation>
    </message>
    <message>
        <source>Test card</source>
        <translation>Testkarte</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Film &amp;Balloon</source>
        <translation>Folien&amp;ballon</translation>
    </message>
    <message>
        <source>Film Balloon</source>
        <translation>Folienballon</translation>
    </message>
</context>
</TS>

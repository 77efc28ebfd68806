<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es-ES" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>A line of text where the film is widest, as outlines</source>
        <translation>Una línea de texto donde la película es más ancha, como contornos</translation>
    </message>
    <message>
        <source>A ready body, made to measure</source>
        <translation>Un cuerpo listo, a medida</translation>
    </message>
    <message>
        <source>A size of the ready body</source>
        <translation>Una medida del cuerpo listo</translation>
    </message>
    <message>
        <source>A tab with a hole to tie the balloon to, outside the weld</source>
        <translation>Una lengüeta con agujero para atar el globo, fuera de la soldadura</translation>
    </message>
    <message>
        <source>Add what the balloon is filled through</source>
        <translation>Añade aquello por lo que se llena el globo</translation>
    </message>
    <message>
        <source>Air that it holds, as a share of what a round balloon of as much film would</source>
        <translation>Aire que contiene, como parte del que tendría un globo redondo con igual película</translation>
    </message>
    <message>
        <source>Another picture for the back; empty takes that of the front</source>
        <translation>Otra imagen para el dorso; vacío toma la del frente</translation>
    </message>
    <message>
        <source>Area of film inside the welds, all panels</source>
        <translation>Superficie de película dentro de las soldaduras, todos los paneles</translation>
    </message>
    <message>
        <source>Area of the piece of film</source>
        <translation>Superficie de la pieza de película</translation>
    </message>
    <message>
        <source>Around the balloon, in degrees Celsius</source>
        <translation>Alrededor del globo, en grados Celsius</translation>
    </message>
    <message>
        <source>Automatic evens out a nearly symmetric picture, Forced any drawing: its left half is mirrored</source>
        <translation>«Automática» iguala una imagen casi simétrica, «Forzada» cualquier dibujo: se refleja su mitad izquierda</translation>
    </message>
    <message>
        <source>Corner relief: corners of the cuts are rounded so; the weld is not</source>
        <translation>Alivio de esquinas: así se redondean las esquinas de los cortes; la soldadura no</translation>
    </message>
    <message>
        <source>Corners of all loops</source>
        <translation>Vértices de todos los lazos</translation>
    </message>
    <message>
        <source>Corners of all welds</source>
        <translation>Vértices de todas las soldaduras</translation>
    </message>
    <message>
        <source>Corners of the pattern's seam</source>
        <translation>Vértices de la costura del patrón</translation>
    </message>
    <message>
        <source>Corners of the triangles on the flat film; z is not 0 where a face does not unroll</source>
        <translation>Vértices de los triángulos en la película plana; z no es 0 donde una cara no se desarrolla</translation>
    </message>
    <message>
        <source>Corners of the welds inside</source>
        <translation>Vértices de las soldaduras interiores</translation>
    </message>
    <message>
        <source>Correct the pattern until the balloon looks like the drawing, or not</source>
        <translation>Corregir o no el patrón hasta que el globo se parezca al dibujo</translation>
    </message>
    <message>
        <source>Corrections of the pattern</source>
        <translation>Correcciones del patrón</translation>
    </message>
    <message>
        <source>Diameter of a body from a file; 0 follows from the height, or the file</source>
        <translation>Diámetro de un cuerpo de un archivo; 0 resulta de la altura, o del archivo</translation>
    </message>
    <message>
        <source>Direction of the grain, from the x axis of the drawing</source>
        <translation>Dirección de la fibra, desde el eje x del dibujo</translation>
    </message>
    <message>
        <source>Direction of the neck, counter-clockwise from the x axis</source>
        <translation>Dirección del cuello, en sentido antihorario desde el eje x</translation>
    </message>
    <message>
        <source>Direction of the tab from the middle of the pattern</source>
        <translation>Dirección de la lengüeta desde el centro del patrón</translation>
    </message>
    <message>
        <source>Display mode when no map is shown</source>
        <translation>Modo de visualización cuando no se muestra ningún mapa</translation>
    </message>
    <message>
        <source>Distance that 95 % of the silhouette keep to</source>
        <translation>Distancia que respeta el 95 % de la silueta</translation>
    </message>
    <message>
        <source>Distance that 95 % of the silhouette keep to if the weld creases</source>
        <translation>Distancia que respeta el 95 % de la silueta si la soldadura se arruga</translation>
    </message>
    <message>
        <source>Dots per inch of the files</source>
        <translation>Puntos por pulgada de los archivos</translation>
    </message>
    <message>
        <source>Edge at which the bag is filled, such as Sketch.Edge3; of a file or ready body: the panel and the number of a point, such as side.2, or the number of a seam; empty: as the file or body says</source>
        <translation>Borde por el que se llena la bolsa, como Sketch.Edge3; de un archivo o cuerpo listo: el panel y el número de un punto, como side.2, o el número de una costura; vacío: como dice el archivo o el cuerpo</translation>
    </message>
    <message>
        <source>Edges that are joined, such as Sketch.Edge1=Sketch001.Edge3; edges that faces share need no word</source>
        <translation>Bordes que se unen, como Sketch.Edge1=Sketch001.Edge3; los bordes que comparten las caras no hace falta nombrarlos</translation>
    </message>
    <message>
        <source>Edges that stand for pieces of curves</source>
        <translation>Bordes que representan trozos de curvas</translation>
    </message>
    <message>
        <source>Film left between pieces, and at the edges</source>
        <translation>Película que queda entre piezas y en los bordes</translation>
    </message>
    <message>
        <source>Film left outside the weld</source>
        <translation>Película que queda fuera de la soldadura</translation>
    </message>
    <message>
        <source>Film of both panels with weld and intake, in grams</source>
        <translation>Película de ambos paneles con soldadura y boca, en gramos</translation>
    </message>
    <message>
        <source>Film that wrinkles where it is compressed, or a shell that does not, for comparison</source>
        <translation>Película que se arruga donde se comprime, o una lámina que no lo hace, para comparar</translation>
    </message>
    <message>
        <source>Film, model and solver of the result</source>
        <translation>Película, modelo y solucionador del resultado</translation>
    </message>
    <message>
        <source>Find the place of the intake</source>
        <translation>Buscar el lugar de la boca</translation>
    </message>
    <message>
        <source>Fit inside width and height instead of stretching to both</source>
        <translation>Encajar en anchura y altura en vez de estirar a ambas</translation>
    </message>
    <message>
        <source>Flat panels and their seams as JSON, in metres</source>
        <translation>Paneles planos y sus costuras como JSON, en metros</translation>
    </message>
    <message>
        <source>Folder that keeps finished balloons; empty: FreeCAD's cache folder</source>
        <translation>Carpeta que guarda los globos acabados; vacío: la carpeta de caché de FreeCAD</translation>
    </message>
    <message>
        <source>Follow every change at once; switch it off for heavy models and inflate when you ask for it</source>
        <translation>Seguir cada cambio al instante; desactívelo en modelos pesados e infle cuando lo pida</translation>
    </message>
    <message>
        <source>FreeCAD's material card that the values were taken from</source>
        <translation>Ficha de material de FreeCAD de la que proceden los valores</translation>
    </message>
    <message>
        <source>Gores that the accuracy needs, foretold from the profile</source>
        <translation>Gajos que necesita la precisión, previstos a partir del perfil</translation>
    </message>
    <message>
        <source>Height above the sea</source>
        <translation>Altura sobre el nivel del mar</translation>
    </message>
    <message>
        <source>Height of a body from a file, along z; 0 follows</source>
        <translation>Altura de un cuerpo de un archivo, según z; 0 resulta</translation>
    </message>
    <message>
        <source>Height of a body from a file; 0 follows</source>
        <translation>Altura de un cuerpo de un archivo; 0 resulta</translation>
    </message>
    <message>
        <source>Height of all that is cut</source>
        <translation>Altura de todo lo que se corta</translation>
    </message>
    <message>
        <source>Height of its capital letters</source>
        <translation>Altura de las mayúsculas</translation>
    </message>
    <message>
        <source>Height of the drawing; 0 follows from the width</source>
        <translation>Altura del dibujo; 0 se deduce de la anchura</translation>
    </message>
    <message>
        <source>Height of the inflated balloon</source>
        <translation>Altura del globo inflado</translation>
    </message>
    <message>
        <source>Height of the outline</source>
        <translation>Altura del contorno</translation>
    </message>
    <message>
        <source>Height of the piece of film</source>
        <translation>Altura de la pieza de película</translation>
    </message>
    <message>
        <source>Height of the print with its marks</source>
        <translation>Altura de la impresión con sus marcas</translation>
    </message>
    <message>
        <source>Height of the profile</source>
        <translation>Altura del perfil</translation>
    </message>
    <message>
        <source>How a picture is read: holes of a filled shape stay, lines of a pen drawing are filled inside</source>
        <translation>Cómo se lee una imagen: los agujeros de una forma rellena quedan, las líneas de un dibujo a línea se rellenan por dentro</translation>
    </message>
    <message>
        <source>How far along that seam, from 0 to 1 of its length; 0 takes its middle, or that of the edge</source>
        <translation>A qué distancia a lo largo de esa costura, de 0 a 1 de su longitud; 0 toma su mitad, o la del borde</translation>
    </message>
    <message>
        <source>How far from the background what is drawn must be, of the greatest difference; 0 finds it</source>
        <translation>Cuánto debe distinguirse lo dibujado del fondo, en parte de la mayor diferencia; 0 lo encuentra</translation>
    </message>
    <message>
        <source>How far the balloon may be from its profile or body on average, in parts of the diagonal</source>
        <translation>Cuánto puede apartarse de media el globo de su perfil o cuerpo, en partes de la diagonal</translation>
    </message>
    <message>
        <source>How far the print goes past the cut</source>
        <translation>Cuánto sobrepasa la impresión el corte</translation>
    </message>
    <message>
        <source>How far the seams of a body of gores are farther out than the gores' centres</source>
        <translation>Cuánto sobresalen las costuras de un cuerpo de gajos respecto del centro de los gajos</translation>
    </message>
    <message>
        <source>How its lower and its upper end are closed</source>
        <translation>Cómo se cierran sus extremos inferior y superior</translation>
    </message>
    <message>
        <source>How large each was then [mm]</source>
        <translation>Tamaño que tenía entonces cada una [mm]</translation>
    </message>
    <message>
        <source>How long the ripples are that are smoothed away, in pixels; 0 keeps all</source>
        <translation>Longitud de las ondas que se alisan, en píxeles; 0 las conserva todas</translation>
    </message>
    <message>
        <source>How many balloons are cut from the sheet</source>
        <translation>Cuántos globos se cortan de la lámina</translation>
    </message>
    <message>
        <source>How many balloons are worked out at a time; 0: one for each processor</source>
        <translation>Cuántos globos se calculan a la vez; 0: uno por procesador</translation>
    </message>
    <message>
        <source>How many balloons of each pattern</source>
        <translation>Cuántos globos de cada patrón</translation>
    </message>
    <message>
        <source>How many gores; 0 takes as many as the accuracy needs</source>
        <translation>Cuántos gajos; 0 toma tantos como necesita la precisión</translation>
    </message>
    <message>
        <source>How much longer one side of a seam may be, as a part of its length</source>
        <translation>Cuánto más largo puede ser un lado de una costura, como parte de su longitud</translation>
    </message>
    <message>
        <source>How the balloon is filled and closed</source>
        <translation>Cómo se llena y se cierra el globo</translation>
    </message>
    <message>
        <source>How the grain of pieces lies, where their film has one</source>
        <translation>Cómo queda la fibra de las piezas, si su película la tiene</translation>
    </message>
    <message>
        <source>How the intake is made and used</source>
        <translation>Cómo se hace y se usa la boca</translation>
    </message>
    <message>
        <source>How the lower end is closed</source>
        <translation>Cómo se cierra el extremo inferior</translation>
    </message>
    <message>
        <source>How the outline was edited by hand: nodes moved, added and removed, one JSON text each</source>
        <translation>Cómo se editó a mano el contorno: nodos movidos, añadidos y quitados, un texto JSON cada uno</translation>
    </message>
    <message>
        <source>How the seams were changed: panels merged, seams cut and moved, one JSON text each</source>
        <translation>Cómo se cambiaron las costuras: paneles unidos, costuras cortadas y movidas, un texto JSON cada una</translation>
    </message>
    <message>
        <source>How the upper end is closed</source>
        <translation>Cómo se cierra el extremo superior</translation>
    </message>
    <message>
        <source>How two panels of this film are joined</source>
        <translation>Cómo se unen dos paneles de esta película</translation>
    </message>
    <message>
        <source>Inner width of the neck, or bore of the nozzle</source>
        <translation>Anchura interior del cuello, o calibre de la boquilla</translation>
    </message>
    <message>
        <source>Into how many panels the body is divided; 0 takes the faces of a solid, 16 panels of a mesh; 1 takes only the seams that are drawn</source>
        <translation>En cuántos paneles se divide el cuerpo; 0 toma las caras de un sólido, o 16 paneles de una malla; 1 toma solo las costuras dibujadas</translation>
    </message>
    <message>
        <source>It carries itself</source>
        <translation>Se sostiene por sí mismo</translation>
    </message>
    <message>
        <source>Its place, seen from its sketch</source>
        <translation>Su posición respecto a su croquis</translation>
    </message>
    <message>
        <source>JSON file of panels and seams; a copy travels in the document</source>
        <translation>Archivo JSON de paneles y costuras; una copia viaja en el documento</translation>
    </message>
    <message>
        <source>Label of the values the mesh belongs to</source>
        <translation>Marca de los valores a los que pertenece la malla</translation>
    </message>
    <message>
        <source>Label of what was laid out</source>
        <translation>Marca de lo que se colocó</translation>
    </message>
    <message>
        <source>Label that the workbench has given it</source>
        <translation>Etiqueta que le ha dado el banco de trabajo</translation>
    </message>
    <message>
        <source>Larger dimension before repairs, in mm</source>
        <translation>Dimensión mayor antes de las reparaciones, en mm</translation>
    </message>
    <message>
        <source>Largest diameter of the profile</source>
        <translation>Mayor diámetro del perfil</translation>
    </message>
    <message>
        <source>Largest distance between drawing and silhouette</source>
        <translation>Mayor distancia entre dibujo y silueta</translation>
    </message>
    <message>
        <source>Largest distance between drawing and silhouette if the weld creases</source>
        <translation>Mayor distancia entre dibujo y silueta si la soldadura se arruga</translation>
    </message>
    <message>
        <source>Largest membrane tension in N/m</source>
        <translation>Mayor tensión de membrana en N/m</translation>
    </message>
    <message>
        <source>Largest strain of the film</source>
        <translation>Mayor deformación de la película</translation>
    </message>
    <message>
        <source>Lay panels first onto what is left of another layout, as its file says; the rest on the film</source>
        <translation>Colocar los paneles primero en lo que queda de otra colocación, según dice su archivo; el resto en la película</translation>
    </message>
    <message>
        <source>Least bending stiffness, in units of the usual least one</source>
        <translation>Rigidez a flexión mínima, en unidades de la mínima habitual</translation>
    </message>
    <message>
        <source>Left open in welds that would cut off a part, so wide; 0 gives each part an intake of its own</source>
        <translation>Anchura que queda abierta en las soldaduras que aislarían una parte; 0 da a cada parte su propia boca</translation>
    </message>
    <message>
        <source>Length of a notch; at most the allowance</source>
        <translation>Longitud de una muesca; como mucho el margen</translation>
    </message>
    <message>
        <source>Length of a sheet; 0 is a roll</source>
        <translation>Longitud de una lámina; 0 es un rollo</translation>
    </message>
    <message>
        <source>Length of all seams on the body</source>
        <translation>Longitud de todas las costuras sobre el cuerpo</translation>
    </message>
    <message>
        <source>Length of all welds on it</source>
        <translation>Longitud de todas las soldaduras</translation>
    </message>
    <message>
        <source>Length of its welds</source>
        <translation>Longitud de sus soldaduras</translation>
    </message>
    <message>
        <source>Length of the natural shape's gores, from its lower to its upper end</source>
        <translation>Longitud de los gajos de la forma natural, del extremo inferior al superior</translation>
    </message>
    <message>
        <source>Length of the neck from the seam outward, or diameter of the flange; 0 takes the usual one</source>
        <translation>Longitud del cuello desde la costura hacia fuera, o diámetro de la brida; 0 toma el valor habitual</translation>
    </message>
    <message>
        <source>Length of the profile from end to end</source>
        <translation>Longitud del perfil de extremo a extremo</translation>
    </message>
    <message>
        <source>Length of the roll that is used</source>
        <translation>Longitud de rollo usada</translation>
    </message>
    <message>
        <source>Length of the weld</source>
        <translation>Longitud de la soldadura</translation>
    </message>
    <message>
        <source>Lengths of both sides of each seam in mm</source>
        <translation>Longitudes de ambos lados de cada costura en mm</translation>
    </message>
    <message>
        <source>Lines and arcs within 0.02 mm in place of many short lines</source>
        <translation>Rectas y arcos con 0,02 mm de tolerancia en lugar de muchas líneas cortas</translation>
    </message>
    <message>
        <source>Longest piece of the side band; 0 is the width of the film</source>
        <translation>Pieza más larga de la banda lateral; 0 es el ancho de la película</translation>
    </message>
    <message>
        <source>Mean distance between drawing and silhouette</source>
        <translation>Distancia media entre dibujo y silueta</translation>
    </message>
    <message>
        <source>Mean distance between drawing and silhouette if the weld creases</source>
        <translation>Distancia media entre dibujo y silueta si la soldadura se arruga</translation>
    </message>
    <message>
        <source>Names of the panels</source>
        <translation>Nombres de los paneles</translation>
    </message>
    <message>
        <source>Names of the panels and other pieces</source>
        <translation>Nombres de los paneles y de las demás piezas</translation>
    </message>
    <message>
        <source>Names of the pieces that have been arranged</source>
        <translation>Nombres de las piezas que se han colocado</translation>
    </message>
    <message>
        <source>Notches to lay both films on each other by, evenly along the cut; of many panels, groups of them on each seam, 0 as many as its length needs</source>
        <translation>Muescas para poner las dos películas una sobre otra, repartidas por igual a lo largo del corte; con muchos paneles, grupos de ellas en cada costura, 0 tantas como necesita su longitud</translation>
    </message>
    <message>
        <source>Number of balloons in the table</source>
        <translation>Número de globos en la tabla</translation>
    </message>
    <message>
        <source>Number of balloons that are worked out</source>
        <translation>Número de globos calculados</translation>
    </message>
    <message>
        <source>Number of balloons that cannot be made</source>
        <translation>Número de globos que no se pueden hacer</translation>
    </message>
    <message>
        <source>Number of corners of each loop</source>
        <translation>Número de vértices de cada lazo</translation>
    </message>
    <message>
        <source>Number of corners of each seam</source>
        <translation>Número de vértices de cada costura</translation>
    </message>
    <message>
        <source>Number of corners of each weld</source>
        <translation>Número de vértices de cada soldadura</translation>
    </message>
    <message>
        <source>Number of flat panels that it is made of; 0: two equal ones</source>
        <translation>Número de paneles planos de que se compone; 0: dos iguales</translation>
    </message>
    <message>
        <source>Number of holes</source>
        <translation>Número de agujeros</translation>
    </message>
    <message>
        <source>Number of panels</source>
        <translation>Número de paneles</translation>
    </message>
    <message>
        <source>Number of pieces on what is shown</source>
        <translation>Número de piezas en lo que se muestra</translation>
    </message>
    <message>
        <source>Number of seams between them</source>
        <translation>Número de costuras entre ellos</translation>
    </message>
    <message>
        <source>Number of seams, then the number of vertices of each seam and weld</source>
        <translation>Número de costuras, luego número de nodos de cada costura y soldadura</translation>
    </message>
    <message>
        <source>Number of sheets</source>
        <translation>Número de láminas</translation>
    </message>
    <message>
        <source>Number of the sheet that is shown and exported</source>
        <translation>Número de la lámina que se muestra y exporta</translation>
    </message>
    <message>
        <source>Of many panels, for each seam: both panels, number of vertices, then those of either side</source>
        <translation>Con muchos paneles, por cada costura: ambos paneles, número de nodos y los de cada lado</translation>
    </message>
    <message>
        <source>Of many panels, for each: number of vertices, of triangles and of loops</source>
        <translation>Con muchos paneles, por cada uno: número de nodos, de triángulos y de contornos</translation>
    </message>
    <message>
        <source>Of many panels, how much longer one side of a seam may be</source>
        <translation>Con muchos paneles, cuánto más largo puede ser un lado de una costura</translation>
    </message>
    <message>
        <source>Of warm air, in degrees Celsius</source>
        <translation>Del aire caliente, en grados Celsius</translation>
    </message>
    <message>
        <source>On which remnant each sheet is, -1 for none</source>
        <translation>En qué retal está cada lámina, -1 si en ninguno</translation>
    </message>
    <message>
        <source>Only one side of this film can be joined so</source>
        <translation>Solo una cara de esta película se puede unir así</translation>
    </message>
    <message>
        <source>Panel of each triangle</source>
        <translation>Panel de cada triángulo</translation>
    </message>
    <message>
        <source>Panels and seams as JSON, in metres</source>
        <translation>Paneles y costuras como JSON, en metros</translation>
    </message>
    <message>
        <source>Panels that are cut, each with what is equal to it</source>
        <translation>Paneles que se cortan, cada uno con los que son iguales a él</translation>
    </message>
    <message>
        <source>Part of the film that the pieces take, in per cent</source>
        <translation>Parte de la película que ocupan las piezas, en por ciento</translation>
    </message>
    <message>
        <source>Part of the film's area that hangs loose</source>
        <translation>Parte del área de película que está floja</translation>
    </message>
    <message>
        <source>Part of the film's area that is wrinkled</source>
        <translation>Parte del área de película que está arrugada</translation>
    </message>
    <message>
        <source>Picture, SVG, DXF or JSON file; a copy travels in the document</source>
        <translation>Imagen, archivo SVG, DXF o JSON; una copia viaja en el documento</translation>
    </message>
    <message>
        <source>Place of the intake: counter-clockwise along the outer seam from its rightmost point</source>
        <translation>Lugar de la boca: por la costura exterior, en sentido antihorario desde su punto más a la derecha</translation>
    </message>
    <message>
        <source>Places of the outline that move if the weld creases, the worst first</source>
        <translation>Lugares del contorno que se mueven si la soldadura se arruga, el peor primero</translation>
    </message>
    <message>
        <source>Points of the body's triangles</source>
        <translation>Puntos de los triángulos del cuerpo</translation>
    </message>
    <message>
        <source>Points of the profile: radius, 0, height</source>
        <translation>Puntos del perfil: radio, 0, altura</translation>
    </message>
    <message>
        <source>Poisson's ratio of the film</source>
        <translation>Coeficiente de Poisson de la película</translation>
    </message>
    <message>
        <source>Polymer of the side that is welded, such as PE; none where it does not weld, empty: not known</source>
        <translation>Polímero de la cara que se suelda, como PE; none si no se suelda, vacío: desconocido</translation>
    </message>
    <message>
        <source>Pressure in the inflated balloon</source>
        <translation>Presión en el globo inflado</translation>
    </message>
    <message>
        <source>Pressure inside, above that outside</source>
        <translation>Presión interior, por encima de la exterior</translation>
    </message>
    <message>
        <source>Put the tab opposite the intake</source>
        <translation>Poner la lengüeta enfrente de la boca</translation>
    </message>
    <message>
        <source>Remarks made during the design</source>
        <translation>Observaciones hechas durante el diseño</translation>
    </message>
    <message>
        <source>Remarks made while the body was read</source>
        <translation>Observaciones al leer el cuerpo</translation>
    </message>
    <message>
        <source>Remarks made while the outline was found</source>
        <translation>Observaciones hechas al buscar el contorno</translation>
    </message>
    <message>
        <source>Remarks made while the panels were read</source>
        <translation>Observaciones al leer los paneles</translation>
    </message>
    <message>
        <source>Remarks made while the pattern was drawn</source>
        <translation>Observaciones hechas al trazar el patrón</translation>
    </message>
    <message>
        <source>Remarks made while the profile was read</source>
        <translation>Observaciones al leer el perfil</translation>
    </message>
    <message>
        <source>Remarks on the layout</source>
        <translation>Observaciones sobre la colocación</translation>
    </message>
    <message>
        <source>Repairs that were made in the drawing, one each; delete an entry to take it back</source>
        <translation>Reparaciones hechas en el dibujo, una por entrada; borre una entrada para deshacerla</translation>
    </message>
    <message>
        <source>Result that is shown as colours, with a legend</source>
        <translation>Resultado que se muestra en colores, con leyenda</translation>
    </message>
    <message>
        <source>STL, OBJ, PLY, 3MF, STEP, IGES or BREP file of a closed body; a copy travels in the document</source>
        <translation>Archivo STL, OBJ, PLY, 3MF, STEP, IGES o BREP de un cuerpo cerrado; una copia viaja en el documento</translation>
    </message>
    <message>
        <source>SVG, DXF or JSON file of half the outline; a copy travels in the document</source>
        <translation>Archivo SVG, DXF o JSON de medio contorno; una copia viaja en el documento</translation>
    </message>
    <message>
        <source>Seams by the number on both edges, with their lengths</source>
        <translation>Costuras por el número en ambos bordes, con sus longitudes</translation>
    </message>
    <message>
        <source>Show the drawing and the silhouette over each other</source>
        <translation>Mostrar dibujo y silueta superpuestos</translation>
    </message>
    <message>
        <source>Simulate both panels instead of one and its mirror image</source>
        <translation>Simular ambos paneles en vez de uno y su imagen especular</translation>
    </message>
    <message>
        <source>Size of the body along x, y and z</source>
        <translation>Tamaño del cuerpo según x, y y z</translation>
    </message>
    <message>
        <source>Size of the triangles; 0 is automatic</source>
        <translation>Tamaño de los triángulos; 0 es automático</translation>
    </message>
    <message>
        <source>Sketch or wire of half the outline, which the body follows</source>
        <translation>Croquis o alambre de medio contorno, que sigue el cuerpo</translation>
    </message>
    <message>
        <source>Sketch, wire or face that the outline follows instead of a file</source>
        <translation>Croquis, alambre o cara que sigue el contorno en vez de un archivo</translation>
    </message>
    <message>
        <source>Sketches are projected onto the side that is nearer to them only</source>
        <translation>Los croquis se proyectan solo sobre el lado más cercano a ellos</translation>
    </message>
    <message>
        <source>Sketches whose lines are seams: they are projected onto the body along the normal of their plane</source>
        <translation>Croquis cuyas líneas son costuras: se proyectan sobre el cuerpo según la normal de su plano</translation>
    </message>
    <message>
        <source>Sketches, wires and flat faces that are the panels, each seen from outside</source>
        <translation>Croquis, alambres y caras planas que son los paneles, cada uno visto desde fuera</translation>
    </message>
    <message>
        <source>Smaller holes, of the area of their shape, are filled</source>
        <translation>Los agujeros menores, en parte del área de su forma, se rellenan</translation>
    </message>
    <message>
        <source>Smooth stretches as single splines in place of arcs</source>
        <translation>Tramos suaves como una sola spline en lugar de arcos</translation>
    </message>
    <message>
        <source>So far outside of the body, or inside, the film lies at least</source>
        <translation>Distancia mínima de la película al cuerpo, por fuera o por dentro</translation>
    </message>
    <message>
        <source>Solid or mesh that the balloon is to fill, which it follows</source>
        <translation>Sólido o malla que el globo ha de llenar y al que sigue</translation>
    </message>
    <message>
        <source>Solver that was used</source>
        <translation>Solucionador utilizado</translation>
    </message>
    <message>
        <source>Solver: compiled, NumPy, or the best of them; Newmark follows the inflation in time, slowly</source>
        <translation>Solucionador: compilado, NumPy o el mejor de ellos; Newmark sigue el inflado en el tiempo, despacio</translation>
    </message>
    <message>
        <source>Steps of the solver in the last inflation</source>
        <translation>Pasos del solucionador en el último inflado</translation>
    </message>
    <message>
        <source>Stiffness of a weld in its plane, in parts of what both films have there when they stay flat</source>
        <translation>Rigidez de una soldadura en su plano, en proporción a la que tienen ahí ambas películas cuando quedan planas</translation>
    </message>
    <message>
        <source>Tension over the section at which the film tears; 0: not known</source>
        <translation>Tensión en la sección a la que se rompe la película; 0: desconocida</translation>
    </message>
    <message>
        <source>The balloon of a row that was shown last</source>
        <translation>El globo de una fila mostrado por última vez</translation>
    </message>
    <message>
        <source>The balloon shown has come to rest</source>
        <translation>El globo que se muestra llegó al reposo</translation>
    </message>
    <message>
        <source>The balloon that is cut from this pattern</source>
        <translation>El globo que se corta de este patrón</translation>
    </message>
    <message>
        <source>The balloon that is varied</source>
        <translation>El globo que se varía</translation>
    </message>
    <message>
        <source>The film resists bending</source>
        <translation>La película resiste la flexión</translation>
    </message>
    <message>
        <source>The machine that finds the print again by its registration marks; empty has crosses for the eye</source>
        <translation>La máquina que vuelve a encontrar la impresión por sus marcas de registro; vacío: cruces a ojo</translation>
    </message>
    <message>
        <source>The outline whose drawing this one shares; empty: its own</source>
        <translation>El contorno cuyo dibujo comparte este; vacío: el suyo</translation>
    </message>
    <message>
        <source>The pattern that is printed</source>
        <translation>El patrón que se imprime</translation>
    </message>
    <message>
        <source>The pattern that it is a piece of</source>
        <translation>El patrón del que es una pieza</translation>
    </message>
    <message>
        <source>The patterns that are laid out</source>
        <translation>Los patrones que se colocan</translation>
    </message>
    <message>
        <source>The pressure is that at the lower end and rises with the height, as the gas is lighter than air</source>
        <translation>La presión es la del extremo inferior y crece con la altura, porque el gas es más ligero que el aire</translation>
    </message>
    <message>
        <source>The seams in the order of the work</source>
        <translation>Las costuras en el orden del trabajo</translation>
    </message>
    <message>
        <source>The second panel beside the first, mirrored; else cut twice</source>
        <translation>El segundo panel junto al primero, reflejado; si no, se corta dos veces</translation>
    </message>
    <message>
        <source>The side that is shown and exported for a cutter</source>
        <translation>La cara que se muestra y se exporta para una cortadora</translation>
    </message>
    <message>
        <source>The silhouette is within the tolerance of the drawing</source>
        <translation>La silueta está dentro de la tolerancia del dibujo</translation>
    </message>
    <message>
        <source>The spreadsheet: headings in its first row, a balloon in each below</source>
        <translation>La hoja de cálculo: encabezados en la primera fila, un globo en cada una de las siguientes</translation>
    </message>
    <message>
        <source>The whole report as JSON</source>
        <translation>El informe completo en JSON</translation>
    </message>
    <message>
        <source>The workbench has given it a place</source>
        <translation>Tiene un lugar; a un objeto nuevo se le da uno</translation>
    </message>
    <message>
        <source>Thickness of the balloon, from which the side band follows; 0 takes the band's own width</source>
        <translation>Espesor del globo, del que resulta la banda lateral; 0 toma el ancho propio de la banda</translation>
    </message>
    <message>
        <source>Thickness of the film</source>
        <translation>Espesor de la película</translation>
    </message>
    <message>
        <source>Thickness of the inflated balloon</source>
        <translation>Grosor del globo inflado</translation>
    </message>
    <message>
        <source>Three places on each of these, flat</source>
        <translation>Tres puntos en cada uno de ellos, en plano</translation>
    </message>
    <message>
        <source>Three points of each triangle</source>
        <translation>Tres puntos de cada triángulo</translation>
    </message>
    <message>
        <source>Two points of each edge at which a panel is cut open</source>
        <translation>Dos puntos de cada borde por el que se abre con un corte un panel</translation>
    </message>
    <message>
        <source>Up to date, or what is wrong</source>
        <translation>Al día, o qué falla</translation>
    </message>
    <message>
        <source>Version of this object's properties</source>
        <translation>Versión de las propiedades de este objeto</translation>
    </message>
    <message>
        <source>Vertices along all seams, then along all welds inside</source>
        <translation>Nodos por todas las costuras, luego por las soldaduras interiores</translation>
    </message>
    <message>
        <source>Vertices of each triangle</source>
        <translation>Nodos de cada triángulo</translation>
    </message>
    <message>
        <source>Vertices of the flat panel</source>
        <translation>Nodos del panel plano</translation>
    </message>
    <message>
        <source>Vertices of the inflated upper film</source>
        <translation>Nodos de la película superior inflada</translation>
    </message>
    <message>
        <source>Vertices of the lower film where both were simulated</source>
        <translation>Nodos de la película inferior cuando se simularon ambas</translation>
    </message>
    <message>
        <source>Volume of the balloon, from which the pressure follows</source>
        <translation>Volumen del globo, del que se deduce la presión</translation>
    </message>
    <message>
        <source>Volume of the body</source>
        <translation>Volumen del cuerpo</translation>
    </message>
    <message>
        <source>Volume of the inflated balloon</source>
        <translation>Volumen del globo inflado</translation>
    </message>
    <message>
        <source>Volume that decides the size</source>
        <translation>Volumen que decide el tamaño</translation>
    </message>
    <message>
        <source>Weight of the film in kg per square metre</source>
        <translation>Peso de la película en kg por metro cuadrado</translation>
    </message>
    <message>
        <source>Weld that resists bending in its plane, or film that crumples there freely, the worst for a ring</source>
        <translation>Soldadura que resiste la flexión en su plano, o película que ahí se arruga libremente, lo peor para un anillo</translation>
    </message>
    <message>
        <source>What decides the size: the outline as it is, a volume to hold or a load to carry</source>
        <translation>Qué decide el tamaño: el contorno tal cual, un volumen o una carga</translation>
    </message>
    <message>
        <source>What does not fit yet, a sentence each</source>
        <translation>Lo que aún no encaja, una frase por cada cosa</translation>
    </message>
    <message>
        <source>What each edge of the shape is called</source>
        <translation>Cómo se llama cada borde de la forma</translation>
    </message>
    <message>
        <source>What fills it when it shall float</source>
        <translation>Con qué se llena cuando debe flotar</translation>
    </message>
    <message>
        <source>What is given: the pressure, or the volume that it shall reach</source>
        <translation>Qué se da: la presión o el volumen que debe alcanzar</translation>
    </message>
    <message>
        <source>What is printed; empty takes the picture or painting of the outline</source>
        <translation>Qué se imprime; vacío toma la imagen o pintura del contorno</translation>
    </message>
    <message>
        <source>What is thinner, of the size of the drawing, is a line whose inside is filled; 0 keeps all holes</source>
        <translation>Lo más delgado, en parte del tamaño del dibujo, es una línea cuyo interior se rellena; 0 conserva todos los agujeros</translation>
    </message>
    <message>
        <source>What it carries with its gas, in grams; below 0 it sinks</source>
        <translation>Lo que levanta con su gas, en gramos; por debajo de 0 cae</translation>
    </message>
    <message>
        <source>What it is called on the pattern</source>
        <translation>Cómo se llama en el patrón</translation>
    </message>
    <message>
        <source>What it is to be: an outline, a body of gores or a bag</source>
        <translation>Qué ha de ser: un contorno, un cuerpo de gajos o una bolsa</translation>
    </message>
    <message>
        <source>What it shall carry besides itself, in grams; 0 makes it float just so</source>
        <translation>Lo que debe levantar además de sí mismo, en gramos; con 0 flota justo</translation>
    </message>
    <message>
        <source>What tells where the intake is</source>
        <translation>Qué indica el lugar de la boca</translation>
    </message>
    <message>
        <source>What the balloon is made of; Custom lets you give your own values</source>
        <translation>De qué está hecho el globo; «Personalizada» permite valores propios</translation>
    </message>
    <message>
        <source>What the body was read from</source>
        <translation>De dónde se leyó el cuerpo</translation>
    </message>
    <message>
        <source>What the design of many panels has figures, as JSON</source>
        <translation>Cifras del diseño de muchos paneles, como JSON</translation>
    </message>
    <message>
        <source>What the outline was read from</source>
        <translation>De dónde se leyó el contorno</translation>
    </message>
    <message>
        <source>What the panels were read from</source>
        <translation>De dónde se leyeron los paneles</translation>
    </message>
    <message>
        <source>What the profile was read from</source>
        <translation>De dónde se leyó el perfil</translation>
    </message>
    <message>
        <source>What to do along each wire of the shape</source>
        <translation>Qué hacer a lo largo de cada alambre de la forma</translation>
    </message>
    <message>
        <source>What would make the balloon better</source>
        <translation>Qué haría mejor el globo</translation>
    </message>
    <message>
        <source>Where a balloon of many panels is filled: the number of a seam, or a panel and the point at which an edge begins, such as top.2; a panel alone has a nozzle in its middle</source>
        <translation>Por dónde se llena un globo de muchos paneles: el número de una costura, o un panel y el punto donde empieza un borde, como top.2; un panel solo tiene una boquilla en su centro</translation>
    </message>
    <message>
        <source>Where all pieces lie, as JSON</source>
        <translation>Dónde están todas las piezas, como JSON</translation>
    </message>
    <message>
        <source>Where it is found: farthest from the centre, or low, where a tied balloon hangs straight</source>
        <translation>Dónde se busca: lo más lejos del centro, o abajo, donde un globo atado cuelga derecho</translation>
    </message>
    <message>
        <source>Where the middle of each lies, turned and mirrored</source>
        <translation>Dónde está el centro de cada una, girada y reflejada</translation>
    </message>
    <message>
        <source>Where the profile comes from without a sketch: a file, or the shape of a balloon without weight</source>
        <translation>De dónde viene el perfil sin croquis: de un archivo, o de la forma de un globo sin peso</translation>
    </message>
    <message>
        <source>Where the workbench put it</source>
        <translation>Dónde se colocó de forma automática, si no lo movió el usuario</translation>
    </message>
    <message>
        <source>Whether a laser may cut this film</source>
        <translation>Si un láser puede cortar esta película</translation>
    </message>
    <message>
        <source>Whether the balloon follows the body, encloses or lines it</source>
        <translation>Si el globo sigue el cuerpo, lo envuelve o lo reviste por dentro</translation>
    </message>
    <message>
        <source>Which edges are joined</source>
        <translation>Qué bordes se unen</translation>
    </message>
    <message>
        <source>Which film is laid out: pieces of a valve are on one of their own</source>
        <translation>Qué película se coloca: las piezas de una válvula van en una propia</translation>
    </message>
    <message>
        <source>Which of them each wire belongs to; 0: a copy</source>
        <translation>A cuál de ellos pertenece cada alambre; 0: una copia</translation>
    </message>
    <message>
        <source>Which piece of the pattern it is, from 1</source>
        <translation>Qué pieza del patrón es, desde 1</translation>
    </message>
    <message>
        <source>Which shape of the drawing it is; 1 is the largest</source>
        <translation>Qué forma del dibujo es; 1 es la mayor</translation>
    </message>
    <message>
        <source>Width from which it carries itself; 0 when never</source>
        <translation>Anchura desde la que se sostiene; 0: nunca</translation>
    </message>
    <message>
        <source>Width of a body from a file, along x; 0 follows from the height, or the file</source>
        <translation>Anchura de un cuerpo de un archivo, según x; 0 resulta de la altura, o del archivo</translation>
    </message>
    <message>
        <source>Width of a side band between front and back; 0 is two panels</source>
        <translation>Ancho de una banda lateral entre delante y detrás; 0 son dos paneles</translation>
    </message>
    <message>
        <source>Width of all that is cut</source>
        <translation>Anchura de todo lo que se corta</translation>
    </message>
    <message>
        <source>Width of the drawing; 0 follows from the height</source>
        <translation>Anchura del dibujo; 0 se deduce de la altura</translation>
    </message>
    <message>
        <source>Width of the inflated balloon</source>
        <translation>Anchura del globo inflado</translation>
    </message>
    <message>
        <source>Width of the outline</source>
        <translation>Anchura del contorno</translation>
    </message>
    <message>
        <source>Width of the piece of film</source>
        <translation>Anchura de la pieza de película</translation>
    </message>
    <message>
        <source>Width of the print with its marks</source>
        <translation>Anchura de la impresión con sus marcas</translation>
    </message>
    <message>
        <source>Width of the roll or sheet</source>
        <translation>Anchura del rollo o de la lámina</translation>
    </message>
    <message>
        <source>Width of the weld that this film needs</source>
        <translation>Anchura de soldadura que necesita esta película</translation>
    </message>
    <message>
        <source>Width of the weld; 0 takes the film's</source>
        <translation>Anchura de la soldadura; 0 toma la de la película</translation>
    </message>
    <message>
        <source>Young's modulus across the grain; 0 means no grain</source>
        <translation>Módulo de Young transversal a la fibra; 0 significa sin fibra</translation>
    </message>
    <message>
        <source>Young's modulus of the film</source>
        <translation>Módulo de Young de la película</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench</name>
    <message>
        <source> It may have lacked memory: take a coarser mesh.</source>
        <translation> Quizá faltó memoria: tome una malla más gruesa.</translation>
    </message>
    <message>
        <source> is not ready: </source>
        <translation> no está listo: </translation>
    </message>
    <message>
        <source>"hosts" is no list: write {0}.</source>
        <translation>«hosts» no es una lista: escriba {0}.</translation>
    </message>
    <message>
        <source>"{0}" cannot be read: write {"kind": "latin-hypercube", "rows": 100, "seed": 1}.</source>
        <translation>«{0}» no se puede leer: escriba {"kind": "latin-hypercube", "rows": 100, "seed": 1}.</translation>
    </message>
    <message>
        <source>"{0}" has one result and its value: write {"lift": "20 g"}.</source>
        <translation>«{0}» tiene un resultado y su valor: escriba {"lift": "20 g"}.</translation>
    </message>
    <message>
        <source>"{0}" is an edge of {1} panels: name the face too, as in {2}.</source>
        <translation>«{0}» es un borde de {1} paneles: nombre también la cara, como en {2}.</translation>
    </message>
    <message>
        <source>"{0}" is no choice for a pattern larger than the bed: choose {1}.</source>
        <translation>No hay modo «{0}» para un patrón grande: elija {1}.</translation>
    </message>
    <message>
        <source>"{0}" is no colour: give one such as "#cc294d".</source>
        <translation>«{0}» no es un color: indique por ejemplo «#cc294d».</translation>
    </message>
    <message>
        <source>"{0}" is no edge of a panel: write it as in {1}.0, or give the number of a seam, 1 to {2}. There are the panels {3}{4}.</source>
        <translation>«{0}» no es un borde de un panel: escríbalo como en {1}.0, o dé el número de una costura, de 1 a {2}. Hay los paneles {3}{4}.</translation>
    </message>
    <message>
        <source>"{0}" is no sum of L, W, S, A and millimetres, such as "0.5 W + 2".</source>
        <translation>«{0}» no es una suma de L, W, S, A y milímetros, como «0.5 W + 2».</translation>
    </message>
    <message>
        <source>"{0}" may not use {1}.</source>
        <translation>«{0}» no puede usar {1}.</translation>
    </message>
    <message>
        <source>"{0}" of "{1}" is no whole number: write one.</source>
        <translation>«{0}» de «{1}» no es un número entero: escriba uno.</translation>
    </message>
    <message>
        <source>"{0}" of the study is no JSON object: write {"width": ...}.</source>
        <translation>«{0}» del estudio no es un objeto JSON: escriba {"width": ...}.</translation>
    </message>
    <message>
        <source>"{0}" of the study is no list of JSON objects: write [{"input": ...}, ...].</source>
        <translation>«{0}» del estudio no es una lista de objetos JSON: escriba [{"input": ...}, ...].</translation>
    </message>
    <message>
        <source>"{0}" says what may be chosen: write {"width": ["100mm", "400mm"]}.</source>
        <translation>«{0}» dice qué se puede elegir: escriba {"width": ["100mm", "400mm"]}.</translation>
    </message>
    <message>
        <source>'{0}' cannot be kept: write {1} or {2}.</source>
        <translation>«{0}» no se puede conservar: escriba {1} o {2}.</translation>
    </message>
    <message>
        <source>'{0}' cannot be read ({1}). Check the name and its access.</source>
        <translation>«{0}» no se puede leer ({1}). Compruebe el nombre y el acceso.</translation>
    </message>
    <message>
        <source>'{0}' cannot be read ({1}): name a JSON file of settings.</source>
        <translation>«{0}» no se puede leer ({1}): indique un archivo JSON de ajustes.</translation>
    </message>
    <message>
        <source>'{0}' cannot be the name of a machine: take up to 40 letters, digits, spaces and - only.</source>
        <translation>'{0}' no puede ser el nombre de una máquina: use hasta 40 letras, cifras, espacios y - solamente.</translation>
    </message>
    <message>
        <source>'{0}' has a column twice.</source>
        <translation>«{0}» tiene una columna dos veces.</translation>
    </message>
    <message>
        <source>'{0}' has another unit than {1}: write it like {2}.</source>
        <translation>«{0}» tiene otra unidad que {1}: escríbalo como {2}.</translation>
    </message>
    <message>
        <source>'{0}' has its own panels: leave out what you give of gores or of a side band.</source>
        <translation>«{0}» tiene sus propios paneles: quite lo que indica de gajos o de una banda lateral.</translation>
    </message>
    <message>
        <source>'{0}' has its panels as they are to be cut: use inflate instead of design.</source>
        <translation>«{0}» tiene sus paneles tal como se cortan: use inflate en lugar de design.</translation>
    </message>
    <message>
        <source>'{0}' has no closed line: give the pattern as it was cut.</source>
        <translation>«{0}» no tiene ninguna línea cerrada: dé el patrón tal como se cortó.</translation>
    </message>
    <message>
        <source>'{0}' has no panels of its own: give gores, or the width of a side band.</source>
        <translation>«{0}» no tiene paneles propios: indique gajos, o el ancho de una banda lateral.</translation>
    </message>
    <message>
        <source>'{0}' has no profile: give half the outline of the body as an SVG, a DXF or JSON.</source>
        <translation>«{0}» no tiene perfil: dé medio contorno del cuerpo en SVG, DXF o JSON.</translation>
    </message>
    <message>
        <source>'{0}' has the size of its panels: leave out the width and the height.</source>
        <translation>«{0}» tiene el tamaño de sus paneles: quite la anchura y la altura.</translation>
    </message>
    <message>
        <source>'{0}' has {1} x {2} pixels, more than {3} million. Make it smaller; 2000 pixels across are plenty.</source>
        <translation>«{0}» tiene {1} x {2} píxeles, más de {3} millones. Redúzcala; 2000 píxeles de ancho bastan de sobra.</translation>
    </message>
    <message>
        <source>'{0}' is a body: leave out what you give of gores or of a side band.</source>
        <translation>«{0}» es un cuerpo: quite lo que indica de gajos o de una banda lateral.</translation>
    </message>
    <message>
        <source>'{0}' is a pipe or a device: save what comes from it, and name that file.</source>
        <translation>«{0}» es una tubería o un dispositivo: guarde lo que sale de él e indique ese archivo.</translation>
    </message>
    <message>
        <source>'{0}' is a profile, which has no side band: give a drawing for that.</source>
        <translation>«{0}» es un perfil, que no tiene banda lateral: dé un dibujo para eso.</translation>
    </message>
    <message>
        <source>'{0}' is colder than anything; write a temperature as 20C, 68F or 293K.</source>
        <translation>«{0}» es más frío que nada; escriba una temperatura como 20C, 68F o 293K.</translation>
    </message>
    <message>
        <source>'{0}' is damaged or not a picture ({1}). Save it as PNG, JPEG or BMP once more.</source>
        <translation>«{0}» está dañado o no es una imagen ({1}). Guárdelo de nuevo como PNG, JPEG o BMP.</translation>
    </message>
    <message>
        <source>'{0}' is damaged or not a picture. Save it as PNG, JPEG or BMP once more.</source>
        <translation>«{0}» está dañado o no es una imagen. Guárdelo de nuevo como PNG, JPEG o BMP.</translation>
    </message>
    <message>
        <source>'{0}' is damaged. Save it as PNG, JPEG or BMP once more.</source>
        <translation>«{0}» está dañado. Guárdelo de nuevo como PNG, JPEG o BMP.</translation>
    </message>
    <message>
        <source>'{0}' is empty. Choose another file.</source>
        <translation>«{0}» está vacío. Elija otro archivo.</translation>
    </message>
    <message>
        <source>'{0}' is larger than {1} MB. Make it simpler.</source>
        <translation>«{0}» supera {1} MB. Simplifique el contenido.</translation>
    </message>
    <message>
        <source>'{0}' is larger than {1} MB. Save it as JPEG or PNG.</source>
        <translation>«{0}» supera {1} MB. Guárdelo como JPEG o PNG.</translation>
    </message>
    <message>
        <source>'{0}' is neither SVG, DXF nor JSON. Save the drawing as one of these.</source>
        <translation>«{0}» no es SVG, DXF ni JSON. Guarde el dibujo como uno de ellos.</translation>
    </message>
    <message>
        <source>'{0}' is neither yes nor no: write one of them for {1}.</source>
        <translation>«{0}» no es ni yes ni no: escriba uno de ellos para {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no JSON ({1}{2}).</source>
        <translation>«{0}» no es JSON ({1}{2}).</translation>
    </message>
    <message>
        <source>'{0}' is no JSON object: write {"queue": ...}.</source>
        <translation>«{0}» no es un objeto JSON: escriba {"queue": ...}.</translation>
    </message>
    <message>
        <source>'{0}' is no closed body: leave out --panels, or give an STL, OBJ, PLY, 3MF or STEP.</source>
        <translation>«{0}» no es un cuerpo cerrado: quite --panels, o dé un STL, OBJ, PLY, 3MF o STEP.</translation>
    </message>
    <message>
        <source>'{0}' is no cluster: write one of {1}.</source>
        <translation>«{0}» no es un clúster: escriba uno de {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no command of a study: write {1} or {2}.</source>
        <translation>«{0}» no es una orden de un estudio: escriba {1} o {2}.</translation>
    </message>
    <message>
        <source>'{0}' is no difference of temperatures: write 5K, 5C or 9F.</source>
        <translation>«{0}» no es una diferencia de temperatura: escriba 5K, 5C o 9F.</translation>
    </message>
    <message>
        <source>'{0}' is no file: name one.</source>
        <translation>«{0}» no es un archivo: indique uno.</translation>
    </message>
    <message>
        <source>'{0}' is no number for {1}.</source>
        <translation>«{0}» no es un número para {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no single value for {1}.</source>
        <translation>«{0}» no es un valor único para {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no size: write 500mm for a width, 500mmx700mm for width and height.</source>
        <translation>«{0}» no es un tamaño: escriba 500mm para una anchura, 500mmx700mm para anchura y altura.</translation>
    </message>
    <message>
        <source>'{0}' is no table ({1}): save it as CSV.</source>
        <translation>«{0}» no es una tabla ({1}): guárdela como CSV.</translation>
    </message>
    <message>
        <source>'{0}' is no test card: name the test-card.json that was made with it.</source>
        <translation>'{0}' no es una tarjeta de prueba: indique el test-card.json que se hizo con ella.</translation>
    </message>
    <message>
        <source>'{0}' is no text in UTF-8: save it as one.</source>
        <translation>«{0}» no es un texto en UTF-8: guárdelo así.</translation>
    </message>
    <message>
        <source>'{0}' is no text in UTF-8: save the table as CSV in UTF-8.</source>
        <translation>«{0}» no es un texto en UTF-8: guarde la tabla como CSV en UTF-8.</translation>
    </message>
    <message>
        <source>'{0}' is no value for an option of sbatch: write one line.</source>
        <translation>«{0}» no es un valor para una opción de sbatch: escriba una sola línea.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}.</source>
        <translation>«{0}» no es un valor para {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number and its unit.</source>
        <translation>«{0}» no es un valor para {1}: escriba un número con su unidad.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number in its unit.</source>
        <translation>«{0}» no es un valor para {1}: escriba un número en su unidad.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number without a unit.</source>
        <translation>«{0}» no es un valor para {1}: escriba un número sin unidad.</translation>
    </message>
    <message>
        <source>'{0}' is no way to search: write {1} or {2}.</source>
        <translation>«{0}» no es una forma de buscar: escriba {1} o {2}.</translation>
    </message>
    <message>
        <source>'{0}' is no way to take samples: write {1} or {2}.</source>
        <translation>«{0}» no es una forma de tomar muestras: escriba {1} o {2}.</translation>
    </message>
    <message>
        <source>'{0}' is no whole number: write one for {1}.</source>
        <translation>«{0}» no es un número entero: escriba uno para {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no {1}: write {2}.</source>
        <translation>«{0}» no es una opción de {1}: escriba una de estas: {2}.</translation>
    </message>
    <message>
        <source>'{0}' is none of {1} for {2}.</source>
        <translation>«{0}» no es ninguno de {1} para {2}.</translation>
    </message>
    <message>
        <source>'{0}' is not a drawing that can be read. Use PNG, JPEG, BMP, SVG, DXF or JSON.</source>
        <translation>«{0}» no es un dibujo legible. Use PNG, JPEG, BMP, SVG, DXF o JSON.</translation>
    </message>
    <message>
        <source>'{0}' is not a file name: leave out the folder.</source>
        <translation>«{0}» no es un nombre de archivo: omita la carpeta.</translation>
    </message>
    <message>
        <source>'{0}' is not a picture that can be read. Save it as PNG, JPEG or BMP.</source>
        <translation>«{0}» no es una imagen legible. Guárdela como PNG, JPEG o BMP.</translation>
    </message>
    <message>
        <source>'{0}' is not a temperature; write it as 20C, 68F or 293K.</source>
        <translation>«{0}» no es una temperatura; escríbala como 20C, 68F o 293K.</translation>
    </message>
    <message>
        <source>'{0}' is not a {1}; write it like {2}.</source>
        <translation>«{0}» no sirve aquí ({1}); escríbalo como {2}.</translation>
    </message>
    <message>
        <source>'{0}' is read by FreeCAD, which is not there: install it for the Python that runs this, or give an STL of the solid.</source>
        <translation>«{0}» lo lee FreeCAD, que no está: instálelo para el Python que ejecuta esto, o dé un STL del sólido.</translation>
    </message>
    <message>
        <source>'{}' has {} x {} pixels, more than {} million. Make it smaller; 2000 across are plenty.</source>
        <translation>«{}» tiene {} x {} píxeles, más de {} millones. Redúzcala; 2000 píxeles de ancho bastan de sobra.</translation>
    </message>
    <message>
        <source>'{}' is not a picture. Save it as PNG, JPEG or BMP once more.</source>
        <translation>«{}» no es una imagen. Guárdela de nuevo como PNG, JPEG o BMP.</translation>
    </message>
    <message>
        <source>'{}' was painted with a newer release: update Film Balloon.</source>
        <translation>«{}» se pintó con una versión más nueva: actualice Film Balloon.</translation>
    </message>
    <message>
        <source>, about {0}</source>
        <translation>, unos {0}</translation>
    </message>
    <message>
        <source>, estimated: the film did not come to rest</source>
        <translation>, estimado: la película no llegó al reposo</translation>
    </message>
    <message>
        <source>, one edge must turn</source>
        <translation>, un borde debe volverse</translation>
    </message>
    <message>
        <source>, {0} of them mirrored</source>
        <translation>, {0} de ellos reflejados</translation>
    </message>
    <message>
        <source>--jobs and --timeout are numbers above 0.</source>
        <translation>--jobs y --timeout son números mayores que 0.</translation>
    </message>
    <message>
        <source>--oversize scale makes the balloon smaller until it fits, --oversize split writes several files between which the film is moved, --oversize write writes the file anyway, --bed tells how large the bed is.</source>
        <translation>--oversize scale reduce el globo hasta que quepa, --oversize split escribe varios archivos entre los que se mueve la película, --oversize write escribe el archivo de todos modos, --bed dice el tamaño de la cama.</translation>
    </message>
    <message>
        <source>--rim is the width of the weld and of the film beside it: give 0 to 1 m.</source>
        <translation>--rim es la anchura de la soldadura y de la película junto a ella: indique de 0 a 1 m.</translation>
    </message>
    <message>
        <source>--tabs-below is about tabs: give their width too, such as --tabs 0.4mm.</source>
        <translation>--tabs-below se refiere a los puentes: indique también su anchura, por ejemplo --tabs 0.4mm.</translation>
    </message>
    <message>
        <source>--target-volume and --target-lift decide the size: leave out --width and --height.</source>
        <translation>--target-volume y --target-lift deciden el tamaño: omita --width y --height.</translation>
    </message>
    <message>
        <source>1 to {0} pieces can be laid out, not {1}.</source>
        <translation>Se pueden colocar de 1 a {0} piezas, no {1}.</translation>
    </message>
    <message>
        <source>3D model (GLB)</source>
        <translation>Modelo 3D (GLB)</translation>
    </message>
    <message>
        <source>95 % below {} ({})</source>
        <translation>95 % por debajo de {} ({})</translation>
    </message>
    <message>
        <source>95 % of it below</source>
        <translation>95 % por debajo de</translation>
    </message>
    <message>
        <source>A GIF needs Pillow: install it with pip install pillow.</source>
        <translation>Un GIF necesita Pillow: instálelo con pip install pillow.</translation>
    </message>
    <message>
        <source>A balloon has no "{0}": it has {1}.</source>
        <translation>Un globo no tiene «{0}»: tiene {1}.</translation>
    </message>
    <message>
        <source>A balloon with a side band has no welds inside: its front and back are apart. Leave them out, or make it of two panels.</source>
        <translation>Un globo con banda lateral no tiene soldaduras dentro: su frente y su dorso están separados. Quítelas, o hágalo de dos paneles.</translation>
    </message>
    <message>
        <source>A bar is stated to weld {0} at {1}, this tool has {2}: peel a test card before you rely on it.</source>
        <translation>Se indica que una barra suelda {0} a {1}, esta herramienta tiene {2}: pele una tarjeta de prueba antes de confiar en ello.</translation>
    </message>
    <message>
        <source>A bed is that of a machine: give --machine too.</source>
        <translation>La cama es la de una máquina: indique también --machine.</translation>
    </message>
    <message>
        <source>A bed is {0} mm to {1} mm wide and high: write 600mmx400mm, 600mm for a roll, or {2}.</source>
        <translation>Una cama tiene de {0} mm a {1} mm de ancho y de alto: escriba 600mmx400mm, 600mm para un rollo, o {2}.</translation>
    </message>
    <message>
        <source>A bed of {0} is too small to lay so much film on anew: give a larger one, or make the balloon smaller.</source>
        <translation>Una cama de {0} es demasiado pequeña para recolocar tanta película: indique una mayor o reduzca el globo.</translation>
    </message>
    <message>
        <source>A body cannot be made of {0} gores. Take {1} to {2}.</source>
        <translation>Un cuerpo no se puede hacer de {0} gajos. Tome de {1} a {2}.</translation>
    </message>
    <message>
        <source>A body has 2 panels or more: these are the last ones.</source>
        <translation>Un cuerpo tiene 2 paneles o más: estos son los últimos.</translation>
    </message>
    <message>
        <source>A body is divided into 2 to {0} panels: say how many.</source>
        <translation>Un cuerpo se divide en 2 a {0} paneles: diga cuántos.</translation>
    </message>
    <message>
        <source>A body of gores has no side band: leave out what you give of the one or of the other.</source>
        <translation>Un cuerpo de gajos no tiene banda lateral: quite lo que indica de uno o de otra.</translation>
    </message>
    <message>
        <source>A closed body; a copy of it travels in the document</source>
        <translation>Un cuerpo cerrado; una copia de él viaja en el documento</translation>
    </message>
    <message>
        <source>A colour</source>
        <translation>Un color</translation>
    </message>
    <message>
        <source>A corner relief of {0} would cut into the weld: choose a smaller radius or a wider allowance.</source>
        <translation>Un alivio de esquinas de {0} cortaría la soldadura: elija un radio menor o un margen mayor.</translation>
    </message>
    <message>
        <source>A cow from a mesh, by Keenan Crane: change the number of panels</source>
        <translation>Una vaca a partir de una malla, de Keenan Crane: cambie el número de paneles</translation>
    </message>
    <message>
        <source>A drawing with welds inside is not made symmetric: draw it so, and turn this off.</source>
        <translation>Un dibujo con soldaduras interiores no se hace simétrico: dibújelo así y desactive esto.</translation>
    </message>
    <message>
        <source>A file of this name is there already</source>
        <translation>Ya hay un archivo con este nombre</translation>
    </message>
    <message>
        <source>A film of this name is there already: else it gets the mean of all</source>
        <translation>Ya existe una película con este nombre: si no, recibe la media de todas las fotografías</translation>
    </message>
    <message>
        <source>A film of your own beside the balloon's, with what was found; it changes no pattern</source>
        <translation>Una película propia junto a la del globo, con lo que se halló; no cambia ningún patrón</translation>
    </message>
    <message>
        <source>A fitted film is kept beside the numbers of a known one: choose the balloon's film in its panel.</source>
        <translation>Una película ajustada se guarda junto a los números de una conocida: elija la película del globo en su panel.</translation>
    </message>
    <message>
        <source>A fitted film is written beside the numbers of a known one: give it by --material.</source>
        <translation>Una película ajustada se escribe junto a los números de una conocida: indíquela con --material.</translation>
    </message>
    <message>
        <source>A flat panel has no pressure and no rim: leave out --fit, --rim and --uncorrected.</source>
        <translation>Un panel plano no tiene presión ni borde: omita --fit, --rim y --uncorrected.</translation>
    </message>
    <message>
        <source>A goal has no '{0}': it has one of {1}, and {2}, {3} and {4}.</source>
        <translation>Un objetivo no tiene «{0}»: tiene uno de {1}, y {2}, {3} y {4}.</translation>
    </message>
    <message>
        <source>A goal has one of {0}: write {1}.</source>
        <translation>Un objetivo tiene uno de {0}: escriba {1}.</translation>
    </message>
    <message>
        <source>A hole meets the outline or another hole at {0}; keep some film between them.</source>
        <translation>Un agujero toca el contorno u otro agujero en {0}; deje algo de película entre ellos.</translation>
    </message>
    <message>
        <source>A hole would open or close: draw that part anew.</source>
        <translation>Un agujero se abriría o cerraría: dibuje esa parte de nuevo.</translation>
    </message>
    <message>
        <source>A hot tip is stated to weld {0} at {1}, this tool has {2}: peel a test card before you rely on it.</source>
        <translation>Se indica que una punta caliente suelda {0} a {1}, esta herramienta tiene {2}: pele una tarjeta de prueba antes de confiar en ello.</translation>
    </message>
    <message>
        <source>A known length, in pixels of the picture</source>
        <translation>Una longitud conocida, en píxeles de la imagen</translation>
    </message>
    <message>
        <source>A label has up to {0} letters, between 0.1 mm and 10 m high: change it.</source>
        <translation>Una etiqueta tiene hasta {0} letras, de 0,1 mm a 10 m de alto: cámbiela.</translation>
    </message>
    <message>
        <source>A layout is as large as its film: give the film the size of the bed there.</source>
        <translation>Una colocación es tan grande como su película: dele allí a la película el tamaño de la cama.</translation>
    </message>
    <message>
        <source>A lift of {0} cannot be made: give one such as 5g.</source>
        <translation>Una sustentación de {0} no es posible: indique por ejemplo 5g.</translation>
    </message>
    <message>
        <source>A lift of {0} is out of reach: {1} large, this balloon would carry {2}. Choose a lighter film or gas, a smaller lift, or a rounder shape.</source>
        <translation>Una sustentación de {0} es inalcanzable: con {1}, este globo levantaría {2}. Elija película o gas más ligeros, menos sustentación o una forma más redonda.</translation>
    </message>
    <message>
        <source>A lift of {0} is out of reach: {1} large, this balloon would lack {2}. Choose a lighter film or gas, a smaller lift, or a rounder shape.</source>
        <translation>Una sustentación de {0} es inalcanzable: con {1}, a este globo le faltarían {2}. Elija película o gas más ligeros, menos sustentación o una forma más redonda.</translation>
    </message>
    <message>
        <source>A line that is projected needs a direction. Give one.</source>
        <translation>Una línea que se proyecta necesita una dirección. Indique una.</translation>
    </message>
    <message>
        <source>A line that is projected needs two points or more. Draw them.</source>
        <translation>Una línea que se proyecta necesita dos puntos o más. Dibújelos.</translation>
    </message>
    <message>
        <source>A mesh of {0} is too coarse for a shape of {1}: use at most {2}.</source>
        <translation>Una malla de {0} es demasiado gruesa para una forma de {1}: use como mucho {2}.</translation>
    </message>
    <message>
        <source>A mesh of {0} would need more than a million vertices for a shape of {1}: use at least {2}.</source>
        <translation>Una malla de {0} necesitaría más de un millón de nodos para una forma de {1}: use al menos {2}.</translation>
    </message>
    <message>
        <source>A mesh of {0} would need more than a million vertices for these panels: use at least {1}.</source>
        <translation>Una malla de {0} necesitaría más de un millón de nodos para estos paneles: use al menos {1}.</translation>
    </message>
    <message>
        <source>A new Sketcher sketch of lines and arcs, to go on with in FreeCAD</source>
        <translation>Un nuevo croquis de líneas y arcos, para seguir en FreeCAD</translation>
    </message>
    <message>
        <source>A node that moves needs a place to move to; nothing else does.</source>
        <translation>Un nodo que se mueve necesita un lugar adonde ir; nada más lo lleva.</translation>
    </message>
    <message>
        <source>A number of an intake is empty.</source>
        <translation>Un número de una boca está vacío.</translation>
    </message>
    <message>
        <source>A package for this cluster is missing: {0}</source>
        <translation>Falta un paquete para este clúster: {0}</translation>
    </message>
    <message>
        <source>A passage of {0} is left open in the weld at {1}, so that air reaches both sides.</source>
        <translation>Queda un paso de {0} abierto en la soldadura en {1}, para que el aire llegue a ambos lados.</translation>
    </message>
    <message>
        <source>A photograph</source>
        <translation>Una foto</translation>
    </message>
    <message>
        <source>A photograph on a page needs Pillow: install it with pip install pillow.</source>
        <translation>Una foto en una página necesita Pillow: instálelo con pip install pillow.</translation>
    </message>
    <message>
        <source>A picture cannot be drawn as "{0}": choose {1}.</source>
        <translation>Una imagen no puede estar dibujada como «{0}»: elija {1}.</translation>
    </message>
    <message>
        <source>A picture has no size of its own. Give the width or the height of the balloon.</source>
        <translation>Una imagen no tiene tamaño propio. Indique la anchura o la altura del globo.</translation>
    </message>
    <message>
        <source>A picture that covers what is behind the balloon, such as a photograph of a room</source>
        <translation>Una imagen que cubre lo que hay detrás del globo, como la foto de una habitación</translation>
    </message>
    <message>
        <source>A piece does not fit on the sheet: take a larger one.</source>
        <translation>Una pieza no cabe en la lámina: tome una mayor.</translation>
    </message>
    <message>
        <source>A piece of {0} x {1} does not fit on film of {2}{3}: take film at least {4} wide, or let the grain lie in another direction.</source>
        <translation>Una pieza de {0} x {1} no cabe en película de {2}{3}: tome película de al menos {4} de ancho o cambie la dirección de la fibra.</translation>
    </message>
    <message>
        <source>A pillow box cannot be deeper than wide. Choose a smaller depth.</source>
        <translation>Una caja almohada no puede ser más profunda que ancha. Elija una profundidad menor.</translation>
    </message>
    <message>
        <source>A plane needs its normal. Give one.</source>
        <translation>Un plano necesita su normal. Indique una.</translation>
    </message>
    <message>
        <source>A print is not cut in parts: choose a machine with a larger bed than {0}, or make the balloon smaller.</source>
        <translation>Una impresión no se corta por partes: elija una máquina con una cama mayor que {0} o reduzca el globo.</translation>
    </message>
    <message>
        <source>A process beside this one does not start: {0}</source>
        <translation>Un proceso junto a este no arranca: {0}</translation>
    </message>
    <message>
        <source>A process beside this one is of version {0}, not of {1}: install one of them anew.</source>
        <translation>Un proceso junto a este es de la versión {0}, no de {1}: instale de nuevo uno de ellos.</translation>
    </message>
    <message>
        <source>A remnant is left of a layout: give --nest too, such as --nest 500mm.</source>
        <translation>Un retal queda de una colocación: indique también --nest, por ejemplo --nest 500mm.</translation>
    </message>
    <message>
        <source>A script needs to know how many shards it has: give --shards a number.</source>
        <translation>Un script debe saber cuántas partes tiene: dé un número a --shards.</translation>
    </message>
    <message>
        <source>A seam cannot be moved so far: it would meet another one.</source>
        <translation>Una costura no se puede mover tan lejos: tocaría otra.</translation>
    </message>
    <message>
        <source>A seam cannot be moved so far: one of its panels would be lost.</source>
        <translation>Una costura no se puede mover tan lejos: se perdería uno de sus paneles.</translation>
    </message>
    <message>
        <source>A seam closes an edge of a triangle to a point. Check which runs it joins.</source>
        <translation>Una costura cierra el borde de un triángulo en un punto. Compruebe qué tramos une.</translation>
    </message>
    <message>
        <source>A seam near {0} has one place only. Draw it through two.</source>
        <translation>Una costura cerca de {0} tiene un solo lugar. Dibújela por dos.</translation>
    </message>
    <message>
        <source>A seam near {0} would pass the same place twice. Draw it in two parts.</source>
        <translation>Una costura cerca de {0} pasaría dos veces por el mismo lugar. Dibújela en dos partes.</translation>
    </message>
    <message>
        <source>A separating layer of PTFE gives off poisonous fumes above {0}, and baking paper chars above {1}: weld slower at a lower temperature, and air the room.</source>
        <translation>Una capa separadora de PTFE desprende humos tóxicos por encima de {0}, y el papel de hornear se quema por encima de {1}: suelde más despacio a menor temperatura y ventile el local.</translation>
    </message>
    <message>
        <source>A setting is tried with up to twelve values, each once.</source>
        <translation>Un ajuste se prueba con doce valores como máximo, cada uno una vez.</translation>
    </message>
    <message>
        <source>A sketch with dimensions: change a cell of the spreadsheet, and all follows</source>
        <translation>Un croquis con cotas: cambie una celda de la hoja y todo la sigue</translation>
    </message>
    <message>
        <source>A spread of {0} % leaves nothing of the {1}: give {2} at most {3} %.</source>
        <translation>Una dispersión del {0} % no deja nada ({1}): dé a {2} como mucho un {3} %.</translation>
    </message>
    <message>
        <source>A strict reader that wants plain polylines. Layers are told apart by colour: cut red, blue and orange, set the output of all others to no.</source>
        <translation>Un lector estricto que quiere polilíneas sencillas. Las capas se distinguen por el color: corte rojo, azul y naranja, y ponga en no la salida de todas las demás.</translation>
    </message>
    <message>
        <source>A study has no '{0}': it has {1} and {2}.</source>
        <translation>Un estudio no tiene «{0}»: tiene {1} y {2}.</translation>
    </message>
    <message>
        <source>A study of tolerances is about one balloon: give {0} a single value.</source>
        <translation>Un estudio de tolerancias trata de un solo globo: dé a {0} un valor único.</translation>
    </message>
    <message>
        <source>A study of tolerances says what strays, such as {"cut": {"normal": "0.2mm"}}.</source>
        <translation>Un estudio de tolerancias dice qué se desvía, por ejemplo {"cut": {"normal": "0.2mm"}}.</translation>
    </message>
    <message>
        <source>A study of tolerances takes 1 to {0} samples, not {1}: {2} tell a lot.</source>
        <translation>Un estudio de tolerancias toma de 1 a {0} muestras, no {1}: {2} ya dicen mucho.</translation>
    </message>
    <message>
        <source>A tab must be {0} to {1} wide, not {2}; 0 makes none.</source>
        <translation>Un puente debe tener de {0} a {1} de ancho, no {2}; 0 no hace ninguno.</translation>
    </message>
    <message>
        <source>A test card is for a machine, in a folder: give --machine and --out.</source>
        <translation>Una tarjeta de prueba es para una máquina, en una carpeta: dé --machine y --out.</translation>
    </message>
    <message>
        <source>A test card tries one or two settings: give several values of them, such as 200,300,400.</source>
        <translation>Una tarjeta de prueba prueba uno o dos ajustes: dé varios valores de ellos, como 200,300,400.</translation>
    </message>
    <message>
        <source>A tool has no "{0}": choose one of {1}.</source>
        <translation>Una herramienta no tiene "{0}": elija uno de {1}.</translation>
    </message>
    <message>
        <source>A tool is that of a machine that reads G-code: give --machine gcode-grbl or another.</source>
        <translation>La herramienta es la de una máquina que lee código G: indique --machine gcode-grbl u otra.</translation>
    </message>
    <message>
        <source>A tool that an axis turns does not swivel behind it: set knife_offset_mm to 0, or leave turning_axis out.</source>
        <translation>Una herramienta que un eje gira no pivota detrás de él: ponga knife_offset_mm a 0 u omita turning_axis.</translation>
    </message>
    <message>
        <source>A volume of {0} cannot be made: give one such as 10l.</source>
        <translation>Un volumen de {0} no es posible: indique por ejemplo 10l.</translation>
    </message>
    <message>
        <source>A volume or a lift decides the size, so the balloon cannot be scaled to fit: leave out --oversize scale, or what you give of --target-volume, --target-lift and --gas-volume.</source>
        <translation>Un volumen o una sustentación decide el tamaño, por eso el globo no se puede reducir para que quepa: omita --oversize scale, o lo que haya dado de --target-volume, --target-lift y --gas-volume.</translation>
    </message>
    <message>
        <source>A volume to inflate to and a goal for the size exclude each other: leave one out.</source>
        <translation>Un volumen de inflado y un objetivo de tamaño se excluyen: omita uno.</translation>
    </message>
    <message>
        <source>A web page came instead of the native solver, as some networks send before one has signed in. Open {0} in a browser, then try again. {1}</source>
        <translation>Llegó una página web en vez del solucionador nativo; algunas redes la envían hasta que se inicia sesión. Abra {0} en un navegador e inténtelo de nuevo. {1}</translation>
    </message>
    <message>
        <source>A weld has no length; draw a line, or a circle for a spot.</source>
        <translation>Una soldadura no tiene longitud; dibuje una línea, o un círculo para un punto.</translation>
    </message>
    <message>
        <source>A weld leaves the film at {0}; keep it inside.</source>
        <translation>Una soldadura sale de la película en {0}; manténgala dentro.</translation>
    </message>
    <message>
        <source>A weld meets the outline, itself or another weld at {0}; keep some film between them.</source>
        <translation>Una soldadura toca el contorno, a sí misma o a otra en {0}; deje algo de película entre ellas.</translation>
    </message>
    <message>
        <source>A weld runs too near to another one or to the outline at {0} for this mesh: move it away, or use a smaller mesh size.</source>
        <translation>Una soldadura pasa demasiado cerca de otra o del contorno en {0} para esta malla: apártela o use una malla más fina.</translation>
    </message>
    <message>
        <source>A weld that crumples can be simulated of one panel and its mirror image alone: choose the elastic weld, or one panel and its mirror image.</source>
        <translation>Una soldadura que se arruga solo se puede simular con un panel y su imagen especular: elija la soldadura elástica, o un panel y su imagen especular.</translation>
    </message>
    <message>
        <source>A worker does not have this program ({0}): install it everywhere.</source>
        <translation>Un worker no tiene este programa ({0}): instálelo en todas partes.</translation>
    </message>
    <message>
        <source>A worker of Dask failed ({0}: {1}).</source>
        <translation>Un worker de Dask falló ({0}: {1}).</translation>
    </message>
    <message>
        <source>A {0} of {1} cannot be made; choose one between 1 mm and 100 m.</source>
        <translation>Una {0} de {1} no es posible; elija una entre 1 mm y 100 m.</translation>
    </message>
    <message>
        <source>About {} thick</source>
        <translation>Unos {} de espesor</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>A través</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Consejos</translation>
    </message>
    <message>
        <source>Advice ({0}), at {1}: {2}</source>
        <translation>Consejo ({0}), en {1}: {2}</translation>
    </message>
    <message>
        <source>Advice on many panels is measured on the balloon: inflate it first.</source>
        <translation>Los consejos sobre muchos paneles se miden en el globo: ínflelo primero.</translation>
    </message>
    <message>
        <source>Air intake</source>
        <translation>Boca de inflado</translation>
    </message>
    <message>
        <source>Airship</source>
        <translation>Dirigible</translation>
    </message>
    <message>
        <source>All packages are installed.</source>
        <translation>Todos los paquetes están instalados.</translation>
    </message>
    <message>
        <source>All panels are on the sheet once: none is drawn a second time, mirrored.</source>
        <translation>Todos los paneles están una vez en la lámina: ninguno se dibuja otra vez reflejado.</translation>
    </message>
    <message>
        <source>All points of the mesh are in one place. Save the body as a mesh of triangles.</source>
        <translation>Todos los puntos de la malla están en un mismo lugar. Guarde el cuerpo como malla de triángulos.</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>A lo largo</translation>
    </message>
    <message>
        <source>Along the seam</source>
        <translation>A lo largo de la costura</translation>
    </message>
    <message>
        <source>Also on the other side</source>
        <translation>También en el otro lado</translation>
    </message>
    <message>
        <source>Aluminised BOPP foil, 30 µm</source>
        <translation>Película BOPP aluminizada, 30 µm</translation>
    </message>
    <message>
        <source>Aluminised PET ("Mylar"), 25 µm</source>
        <translation>PET aluminizado («Mylar»), 25 µm</translation>
    </message>
    <message>
        <source>Aluminised nylon/PE foil (party balloon), 30 µm</source>
        <translation>Película de nailon/PE aluminizada (globo de fiesta), 30 µm</translation>
    </message>
    <message>
        <source>An accuracy is for a balloon that follows its body: give the number of panels of one that encloses or lines it.</source>
        <translation>La precisión vale para un globo que sigue su cuerpo: si lo envuelve o lo reviste por dentro, indique el número de paneles.</translation>
    </message>
    <message>
        <source>An animation needs at least two frames, not {0}.</source>
        <translation>Una animación necesita al menos dos fotogramas, no {0}.</translation>
    </message>
    <message>
        <source>An intake of {0} does not reach past the cut: give it at least {1}.</source>
        <translation>Una boca de {0} no sobrepasa el corte: dele al menos {1}.</translation>
    </message>
    <message>
        <source>An outline cannot be edited by "{0}": choose one of {1}.</source>
        <translation>Un contorno no se puede editar con «{0}»: elija uno de {1}.</translation>
    </message>
    <message>
        <source>An outline keeps three nodes: move them instead.</source>
        <translation>Un contorno conserva tres nodos: muévalos en vez de quitarlos.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Animate inflation</source>
        <translation>Animar el inflado</translation>
    </message>
    <message>
        <source>Another study is running in '{0}': wait for it, or choose another folder.</source>
        <translation>Otro estudio se ejecuta en «{0}»: espere a que acabe o elija otra carpeta.</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Cualquiera</translation>
    </message>
    <message>
        <source>Any colour</source>
        <translation>Cualquier color</translation>
    </message>
    <message>
        <source>Any colour (K)</source>
        <translation>Cualquier color (K)</translation>
    </message>
    <message>
        <source>Any program (DXF)</source>
        <translation>Cualquier programa (DXF)</translation>
    </message>
    <message>
        <source>Any program (SVG)</source>
        <translation>Cualquier programa (SVG)</translation>
    </message>
    <message>
        <source>Any size</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Arcs in a sketch, as they hang over a party table</source>
        <translation>Arcos en un croquis, como los que cuelgan sobre una mesa de fiesta</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Arm too thin to fill</source>
        <translation>Brazo demasiado fino para llenarse</translation>
    </message>
    <message>
        <source>Artwork</source>
        <translation>Ilustración</translation>
    </message>
    <message>
        <source>As Summa with OPOS, and the bar between the lower squares shows the cutter whether the print is bent. Feed the sheet with the bar first. The layer Regmark is not cut.</source>
        <translation>Como Summa con OPOS, y la barra entre los cuadrados de abajo muestra a la cortadora si la impresión está curvada. Meta la lámina con la barra por delante. La capa Regmark no se corta.</translation>
    </message>
    <message>
        <source>As at first</source>
        <translation>Como al principio</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Como quedó</translation>
    </message>
    <message>
        <source>As made over what was expected</source>
        <translation>Lo hecho sobre lo esperado</translation>
    </message>
    <message>
        <source>As made: {0}, expected: {1}</source>
        <translation>Hecho: {0}, esperado: {1}</translation>
    </message>
    <message>
        <source>Assembly sheet</source>
        <translation>Hoja de montaje</translation>
    </message>
    <message>
        <source>Assembly sheet written to {}</source>
        <translation>Hoja de montaje escrita en {}</translation>
    </message>
    <message>
        <source>At least 95 of 100 balloons bear {0} with their margin, by {1} samples and with a confidence of 95 %.</source>
        <translation>Al menos 95 de 100 globos soportan {0} con su margen, según {1} muestras y con una confianza del 95 %.</translation>
    </message>
    <message>
        <source>At work the {0} is {1} above the film, and lifted {2} only: give it more depth, or a higher lift_mm.</source>
        <translation>Al trabajar, la herramienta ({0}) está {1} por encima de la película, y levantada solo {2}: dele más profundidad, o un lift_mm mayor.</translation>
    </message>
    <message>
        <source>At worst the film lies {0} on the wrong side of the body, and a margin of {1} was asked for. Take more panels, or a larger margin.</source>
        <translation>En el peor lugar la película está {0} en el lado equivocado del cuerpo y se pidió un margen de {1}. Tome más paneles o un margen mayor.</translation>
    </message>
    <message>
        <source>At {0} dots per inch the sheet would have {1} x {2} pixels: give a lower resolution.</source>
        <translation>Con {0} puntos por pulgada la lámina tendría {1} x {2} píxeles: indique menor resolución.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automática</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Dorso</translation>
    </message>
    <message>
        <source>Bag</source>
        <translation>Bolsa</translation>
    </message>
    <message>
        <source>Bag of panels</source>
        <translation>Bolsa de paneles</translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation>Globo</translation>
    </message>
    <message>
        <source>Balloon as a GLB file, for 3D programs</source>
        <translation>Globo como archivo GLB, para programas 3D</translation>
    </message>
    <message>
        <source>Balloon film</source>
        <translation>Película de globo</translation>
    </message>
    <message>
        <source>Balloon of row {0}</source>
        <translation>Globo de la fila {0}</translation>
    </message>
    <message>
        <source>Balloon pattern</source>
        <translation>Patrón del globo</translation>
    </message>
    <message>
        <source>Balloon: {0}, {1}, solver {2}</source>
        <translation>Globo: {0}, {1}, solucionador {2}</translation>
    </message>
    <message>
        <source>Balloons</source>
        <translation>Globos</translation>
    </message>
    <message>
        <source>Balloons of each</source>
        <translation>Globos de cada uno</translation>
    </message>
    <message>
        <source>Balloons: {0}, of these are there: {1}</source>
        <translation>Globos: {0}, de ellos ya hechos: {1}</translation>
    </message>
    <message>
        <source>Balloons: {0}, worked out now: {1}, of these failed: {2}</source>
        <translation>Globos: {0}, calculados ahora: {1}, de ellos fallidos: {2}</translation>
    </message>
    <message>
        <source>Bar of 100 mm to measure</source>
        <translation>Barra de 100 mm para medir</translation>
    </message>
    <message>
        <source>Bed</source>
        <translation>Cama</translation>
    </message>
    <message>
        <source>Before it is written</source>
        <translation>Antes de escribir</translation>
    </message>
    <message>
        <source>Bending stiffness</source>
        <translation>Rigidez a flexión</translation>
    </message>
    <message>
        <source>Beside the document</source>
        <translation>Junto al documento</translation>
    </message>
    <message>
        <source>Beside the pattern, to see whether the size was kept</source>
        <translation>Junto al patrón, para ver si se ha conservado el tamaño</translation>
    </message>
    <message>
        <source>Best field</source>
        <translation>Mejor campo</translation>
    </message>
    <message>
        <source>Best of {0} balloons: {1}, with {2}.</source>
        <translation>El mejor de {0} globos: {1}, con {2}.</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Negro</translation>
    </message>
    <message>
        <source>Bleed</source>
        <translation>Sangrado</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Azul</translation>
    </message>
    <message>
        <source>Blue 0, green {}, red {}</source>
        <translation>Azul 0, verde {}, rojo {}</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Cuerpos</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Cuerpo</translation>
    </message>
    <message>
        <source>Both halves of the body are made alike: they differ by {0} at most.</source>
        <translation>Las dos mitades del cuerpo se hacen iguales: difieren en {0} como mucho.</translation>
    </message>
    <message>
        <source>Both panels</source>
        <translation>Ambos paneles</translation>
    </message>
    <message>
        <source>Both panels are on the sheet: only the front one gets the hole of the nozzle. Cut it once.</source>
        <translation>Ambos paneles están en la lámina: solo el delantero lleva el agujero de la boquilla. Córtelo una vez.</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Ambos lados</translation>
    </message>
    <message>
        <source>Both sides of a seam must be equally long</source>
        <translation>Los dos lados de una costura deben ser igual de largos</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>Botella</translation>
    </message>
    <message>
        <source>Bring the 3D view of the document to the front first.</source>
        <translation>Ponga primero delante la vista 3D del documento.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>By at least</source>
        <translation>Distancia mínima</translation>
    </message>
    <message>
        <source>Cannot read '{0}' ({1}): name the file of a test card.</source>
        <translation>No se puede leer '{0}' ({1}): indique el archivo de una tarjeta de prueba.</translation>
    </message>
    <message>
        <source>Cannot write to '{0}' ({1}): choose another folder for the study.</source>
        <translation>No se puede escribir en «{0}» ({1}): elija otra carpeta para el estudio.</translation>
    </message>
    <message>
        <source>Cannot write to {0}: {1}. Choose another folder, or make room there.</source>
        <translation>No se puede escribir en {0}: {1}. Elija otra carpeta o haga sitio.</translation>
    </message>
    <message>
        <source>Cannot write {0}: {1}. Make room there and start the study again; no balloon is lost.</source>
        <translation>No se puede escribir {0}: {1}. Haga sitio allí e inicie el estudio de nuevo; no se pierde ningún globo.</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Tarjeta</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Check the size: the 100 mm bar on the cut file or print must measure 100 mm.</source>
        <translation>Compruebe el tamaño: la barra de 100 mm del archivo de corte o de la impresión debe medir 100 mm.</translation>
    </message>
    <message>
        <source>Check, {0}: {1}</source>
        <translation>Compruebe ({0}): {1}</translation>
    </message>
    <message>
        <source>Check: {0}</source>
        <translation>Compruebe: {0}</translation>
    </message>
    <message>
        <source>Checked: ready to make.</source>
        <translation>Comprobado: listo para hacer.</translation>
    </message>
    <message>
        <source>Checking the pattern</source>
        <translation>Comprobando el patrón</translation>
    </message>
    <message>
        <source>Choose a body</source>
        <translation>Elija un cuerpo</translation>
    </message>
    <message>
        <source>Choose a colour</source>
        <translation>Elegir un color</translation>
    </message>
    <message>
        <source>Choose a drawing</source>
        <translation>Elegir un dibujo</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Elegir un archivo</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Elegir una carpeta</translation>
    </message>
    <message>
        <source>Choose a material card</source>
        <translation>Elegir una ficha de material</translation>
    </message>
    <message>
        <source>Choose a photograph first: a PNG, JPEG or BMP file.</source>
        <translation>Elija antes una fotografía: un archivo PNG, JPEG o BMP.</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>Elegir una imagen</translation>
    </message>
    <message>
        <source>Choose a picture or a sketch.</source>
        <translation>Elija una imagen o un croquis.</translation>
    </message>
    <message>
        <source>Choose a remnant</source>
        <translation>Elegir un retal</translation>
    </message>
    <message>
        <source>Choose a row first.</source>
        <translation>Elija primero una fila.</translation>
    </message>
    <message>
        <source>Choose a sketch or a file with half the outline.</source>
        <translation>Elija un croquis o un archivo con medio contorno.</translation>
    </message>
    <message>
        <source>Choose a solid, a mesh or a file with one.</source>
        <translation>Elija un sólido, una malla o un archivo que contenga uno.</translation>
    </message>
    <message>
        <source>Choose a test card</source>
        <translation>Elegir una tarjeta de prueba</translation>
    </message>
    <message>
        <source>Choose sketches, a file or a ready body.</source>
        <translation>Elija croquis, un archivo o un cuerpo listo.</translation>
    </message>
    <message>
        <source>Choose the balloon that it belongs to.</source>
        <translation>Elija el globo al que pertenece.</translation>
    </message>
    <message>
        <source>Choose the outline to inflate.</source>
        <translation>Elija el contorno que se debe inflar.</translation>
    </message>
    <message>
        <source>Choose the pattern to print on.</source>
        <translation>Elija el patrón en el que se imprime.</translation>
    </message>
    <message>
        <source>Choose the patterns to lay out.</source>
        <translation>Elija los patrones que se van a colocar.</translation>
    </message>
    <message>
        <source>Choose the photograph that is behind the balloon.</source>
        <translation>Elija la foto que está detrás del globo.</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Círculo</translation>
    </message>
    <message>
        <source>Click a seam: its panels become one. Esc: done.</source>
        <translation>Haga clic en una costura: sus paneles se unen en uno. Esc: terminar.</translation>
    </message>
    <message>
        <source>Click a seam: the panels beside it become one</source>
        <translation>Haga clic en una costura: los paneles a sus lados se unen en uno</translation>
    </message>
    <message>
        <source>Click an edge to see what it is sealed to, drag a piece to move it.</source>
        <translation>Haga clic en un borde para ver con qué se sella, arrastre una pieza para moverla.</translation>
    </message>
    <message>
        <source>Click an edge to see what it is sealed to.</source>
        <translation>Haga clic en un borde para ver con qué se sella.</translation>
    </message>
    <message>
        <source>Click and type; pull it, its corner, or the ring that turns it. Enter paints it, Esc drops it.</source>
        <translation>Haga clic y escriba; arrástrelo, o su esquina, o el anillo que lo gira. Intro lo pinta, Esc lo descarta.</translation>
    </message>
    <message>
        <source>Click both ends of a length that you know; a third click moves the nearer mark.</source>
        <translation>Haga clic en ambos extremos de una longitud que conozca; un tercer clic mueve la marca más cercana.</translation>
    </message>
    <message>
        <source>Click both ends of a ruler in the picture, or of another known length</source>
        <translation>Haga clic en ambos extremos de una regla de la imagen, o de otra longitud conocida</translation>
    </message>
    <message>
        <source>Click on the paper, then type</source>
        <translation>Haga clic en el papel y escriba</translation>
    </message>
    <message>
        <source>Click the line for a new node; drag nodes; Delete removes them; S: sharp or round.</source>
        <translation>Haga clic en la línea para un nodo nuevo; arrastre nodos; Supr los quita; S: agudo o redondo.</translation>
    </message>
    <message>
        <source>Click to see it larger</source>
        <translation>Haga clic para verla más grande</translation>
    </message>
    <message>
        <source>Click two places: a seam runs between them</source>
        <translation>Haga clic en dos lugares: una costura va de uno a otro</translation>
    </message>
    <message>
        <source>Click two points to measure between them.</source>
        <translation>Haga clic en dos puntos para medir entre ellos.</translation>
    </message>
    <message>
        <source>Click where the new seam begins. Esc: done.</source>
        <translation>Haga clic donde empieza la nueva costura. Esc: terminar.</translation>
    </message>
    <message>
        <source>Click where the seam ends. Esc: another start.</source>
        <translation>Haga clic donde acaba la costura. Esc: otro comienzo.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close the open task panel first.</source>
        <translation>Cierre primero el panel de tareas abierto.</translation>
    </message>
    <message>
        <source>Cloud</source>
        <translation>Nube</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>Mapa de colores</translation>
    </message>
    <message>
        <source>Colour {}</source>
        <translation>Color {}</translation>
    </message>
    <message>
        <source>Columns from the left: {0}</source>
        <translation>Columnas desde la izquierda: {0}</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Compare with a photograph</source>
        <translation>Comparar con una fotografía</translation>
    </message>
    <message>
        <source>Comparing with the photograph</source>
        <translation>Comparando con la fotografía</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>Comparando…</translation>
    </message>
    <message>
        <source>Coordinates really are inches, and the header says so.</source>
        <translation>Las coordenadas son realmente pulgadas, y la cabecera lo dice.</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Copias</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation>Copiar (Ctrl+C)</translation>
    </message>
    <message>
        <source>Corner relief</source>
        <translation>Alivio de esquinas</translation>
    </message>
    <message>
        <source>Cricut Design Space</source>
        <translation>Cricut Design Space</translation>
    </message>
    <message>
        <source>Crosses, by eye</source>
        <translation>Cruces, a ojo</translation>
    </message>
    <message>
        <source>Crumpled</source>
        <translation>Arrugada</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizada</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Cut (Ctrl+X)</source>
        <translation>Cortar (Ctrl+X)</translation>
    </message>
    <message>
        <source>Cut all panels from {film}, as they are drawn: so they are seen from outside, with the sealing side below.</source>
        <translation>Corte todos los paneles de {film}, como están dibujados: así se ven desde fuera, con el lado sellable debajo.</translation>
    </message>
    <message>
        <source>Cut all panels from {film}. As they are drawn they are seen from outside.</source>
        <translation>Corte todos los paneles de {film}. Como están dibujados se ven desde fuera.</translation>
    </message>
    <message>
        <source>Cut each page along its left and lower crosses, lay it on the crosses of its neighbours, tape.</source>
        <translation>Corte cada página por sus cruces de la izquierda y de abajo, póngala sobre las cruces de las vecinas y péguela.</translation>
    </message>
    <message>
        <source>Cut out the hole of the nozzle, in the front panel only.</source>
        <translation>Recorte el agujero de la boquilla, solo en el panel delantero.</translation>
    </message>
    <message>
        <source>Cut out the holes inside.</source>
        <translation>Recorte los agujeros interiores.</translation>
    </message>
    <message>
        <source>Cut two panels from {film}, the second one mirrored, so that the sealing sides face each other.</source>
        <translation>Corte dos paneles ({film}), el segundo reflejado, para que las caras de sellado queden enfrentadas.</translation>
    </message>
    <message>
        <source>Cut two panels from {film}, the second one mirrored.</source>
        <translation>Corte dos paneles ({film}), el segundo reflejado.</translation>
    </message>
    <message>
        <source>Cuts without room for two tabs of {0} on a straight: {1}, the first near {2}. What they go round comes free.</source>
        <translation>Cortes sin sitio para dos puentes de {0} en un tramo recto: {1}, el primero cerca de {2}. Lo que rodean queda suelto.</translation>
    </message>
    <message>
        <source>Cutting shop (DXF R12)</source>
        <translation>Taller de corte (DXF R12)</translation>
    </message>
    <message>
        <source>Cutting shop in inches (DXF R2000)</source>
        <translation>Taller de corte en pulgadas (DXF R2000)</translation>
    </message>
    <message>
        <source>DXF files can be neither read nor written without it; SVG files can.</source>
        <translation>Sin él no se pueden leer ni escribir archivos DXF; los SVG sí.</translation>
    </message>
    <message>
        <source>DXF files need the Python package ezdxf. Install it with 'pip install ezdxf', or save the drawing as SVG.</source>
        <translation>Los archivos DXF necesitan el paquete de Python ezdxf. Instálelo con «pip install ezdxf» o guarde el dibujo como SVG.</translation>
    </message>
    <message>
        <source>Decoration</source>
        <translation>Decoración</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Eliminarla</translation>
    </message>
    <message>
        <source>Delete {}? Its file goes for good.</source>
        <translation>¿Eliminar {}? Su archivo se borra para siempre.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Diameter {}, height {}, gores {} long</source>
        <translation>Diámetro {}, altura {}, gajos de {} de largo</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Disco</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Distance from profile, drawing or body</source>
        <translation>Distancia al perfil, al dibujo o al cuerpo</translation>
    </message>
    <message>
        <source>Distance {}, across {}, up {}</source>
        <translation>Distancia {}, horizontal {}, vertical {}</translation>
    </message>
    <message>
        <source>Dividing a body needs scipy: install it with pip install scipy.</source>
        <translation>Dividir un cuerpo necesita scipy: instálelo con pip install scipy.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Hecho</translation>
    </message>
    <message>
        <source>Done (Esc)</source>
        <translation>Hecho (Esc)</translation>
    </message>
    <message>
        <source>Dots per inch</source>
        <translation>Puntos por pulgada</translation>
    </message>
    <message>
        <source>Double-click a row to see its balloon</source>
        <translation>Doble clic en una fila para ver su globo</translation>
    </message>
    <message>
        <source>Drag a seam to where it shall run. Esc: done.</source>
        <translation>Arrastre una costura adonde deba ir. Esc: terminar.</translation>
    </message>
    <message>
        <source>Drag a seam: it runs through the place</source>
        <translation>Arrastre una costura: pasará por ese lugar</translation>
    </message>
    <message>
        <source>Drag in the view</source>
        <translation>Arrastrar en la vista</translation>
    </message>
    <message>
        <source>Drag to turn, turn the wheel to zoom; keys: arrows, plus, minus, Home.</source>
        <translation>Arrastre para girar, la rueda amplía; teclas: flechas, más, menos, Inicio.</translation>
    </message>
    <message>
        <source>Draw a closed line, or paint an area: it becomes a balloon.</source>
        <translation>Dibuje una línea cerrada o pinte una superficie: se convierte en un globo.</translation>
    </message>
    <message>
        <source>Draw half of the outline, and its axis as a straight upright line on its left.</source>
        <translation>Dibuje la mitad del contorno, y su eje como una recta vertical a su izquierda.</translation>
    </message>
    <message>
        <source>Draw lines. A closed line becomes a balloon.</source>
        <translation>Dibujar líneas. Una línea cerrada se convierte en un globo.</translation>
    </message>
    <message>
        <source>Drawing and silhouette</source>
        <translation>Dibujo y silueta</translation>
    </message>
    <message>
        <source>Drawing over silhouette</source>
        <translation>Dibujo sobre la silueta</translation>
    </message>
    <message>
        <source>Drawing seams needs scipy: install it with pip install scipy.</source>
        <translation>Dibujar costuras necesita scipy: instálelo con pip install scipy.</translation>
    </message>
    <message>
        <source>Drawing {0}</source>
        <translation>Dibujando {0}</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Dibujos</translation>
    </message>
    <message>
        <source>Drawn as</source>
        <translation>Dibujado como</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Gota</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Espera</translation>
    </message>
    <message>
        <source>E across the grain</source>
        <translation>E transversal a la fibra</translation>
    </message>
    <message>
        <source>Each row of the table once with each of these values</source>
        <translation>Cada fila de la tabla una vez con cada uno de estos valores</translation>
    </message>
    <message>
        <source>Each stroke colour becomes an operation of its own: cut red, blue and orange, set all others to ignore. DXF is not read.</source>
        <translation>Cada color de trazo se convierte en una operación: corte rojo, azul y naranja, y ponga todos los demás en ignorar. No lee DXF.</translation>
    </message>
    <message>
        <source>Edges of the mesh at which more than two triangles meet: {0}, one of them at ({1}) of the mesh. Repair it in the program that it comes from, so that it is the surface of a solid.</source>
        <translation>Bordes de la malla en los que se juntan más de dos triángulos: {0}, uno de ellos en ({1}) de la malla. Repárela en el programa del que viene, para que sea la superficie de un sólido.</translation>
    </message>
    <message>
        <source>Edges of the panels</source>
        <translation>Bordes de los paneles</translation>
    </message>
    <message>
        <source>Edit artwork</source>
        <translation>Editar ilustración</translation>
    </message>
    <message>
        <source>Edit balloon</source>
        <translation>Editar globo</translation>
    </message>
    <message>
        <source>Edit film</source>
        <translation>Editar lámina de película</translation>
    </message>
    <message>
        <source>Edit outline</source>
        <translation>Editar contorno</translation>
    </message>
    <message>
        <source>Edit outline ...</source>
        <translation>Editar contorno ...</translation>
    </message>
    <message>
        <source>Edit study</source>
        <translation>Editar estudio</translation>
    </message>
    <message>
        <source>Eight panels for a solid with fillets: change its section or their number</source>
        <translation>Ocho paneles para un sólido con redondeos: cambie su sección o el número de paneles</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>Elástica</translation>
    </message>
    <message>
        <source>Elastic materials</source>
        <translation>Materiales elásticos</translation>
    </message>
    <message>
        <source>Encloses it</source>
        <translation>Lo envuelve</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Borrador</translation>
    </message>
    <message>
        <source>Errors as large as these leave no panel: give smaller ones.</source>
        <translation>Errores tan grandes no dejan ningún panel: indique otros menores.</translation>
    </message>
    <message>
        <source>Errors of {0} stay alike over a length above 0, such as 50mm.</source>
        <translation>Los errores de {0} se mantienen parecidos a lo largo de una longitud mayor que 0, como 50mm.</translation>
    </message>
    <message>
        <source>Errors that stay alike over {0} alone are too fine for a seam of {1}: give at least {2} as 'along'.</source>
        <translation>Errores que solo se mantienen parecidos en {0} son demasiado finos para una costura de {1}: dé a «along» al menos {2}.</translation>
    </message>
    <message>
        <source>Every layer becomes a colour of the cut list; layers that share a colour would be merged. Set the import unit to millimetres. Cut red, blue and orange only and switch the output of all others off; the LightBurn project has them on tool layers already.</source>
        <translation>Cada capa se convierte en un color de la lista de corte; las de igual color se unirían. Ponga la unidad de importación en milímetros. Corte solo rojo, azul y naranja y desactive la salida de todas las demás; el proyecto de LightBurn ya las tiene en capas de herramienta.</translation>
    </message>
    <message>
        <source>Expected thickness</source>
        <translation>Grosor esperado</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportación</translation>
    </message>
    <message>
        <source>Export begins with it</source>
        <translation>Exportar empieza con ella</translation>
    </message>
    <message>
        <source>Export for the web</source>
        <translation>Exportar para la web</translation>
    </message>
    <message>
        <source>Export pattern</source>
        <translation>Exportar patrón</translation>
    </message>
    <message>
        <source>Export pattern begins with this machine; it is a preference</source>
        <translation>Exportar patrón empieza con esta máquina; es una preferencia</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Expresión</translation>
    </message>
    <message>
        <source>Face{0} of {1} is curved so much that it would take {2} strips of film. Give a number of panels, or leave such details out of the solid.</source>
        <translation>Face{0} de {1} está tan curvada que necesitaría {2} tiras de película. Indique un número de paneles, o quite esos detalles del sólido.</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fallidos</translation>
    </message>
    <message>
        <source>Farthest off near {0}</source>
        <translation>Mayor desviación cerca de {0}</translation>
    </message>
    <message>
        <source>Farthest point</source>
        <translation>Punto más lejano</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Feed in corners</source>
        <translation>Avance en las esquinas</translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation>Descargar</translation>
    </message>
    <message>
        <source>Fetch the native solver ...</source>
        <translation>Descargar el solucionador nativo…</translation>
    </message>
    <message>
        <source>Fetches the native solver of this version, checks its SHA-256 and puts it in its place.</source>
        <translation>Descarga el solucionador nativo de esta versión, comprueba su SHA-256 y lo pone en su lugar.</translation>
    </message>
    <message>
        <source>Fetching the native solver</source>
        <translation>Descargando el solucionador nativo</translation>
    </message>
    <message>
        <source>Fetching {0} ({1} MB) into {2}; only the file with SHA-256 {3} is kept.</source>
        <translation>Descargando {0} ({1} MB) en {2}; solo se conserva el archivo con SHA-256 {3}.</translation>
    </message>
    <message>
        <source>Few panels or true to shape</source>
        <translation>Pocos paneles o fiel a la forma</translation>
    </message>
    <message>
        <source>Few panels or true to shape?</source>
        <translation>¿Pocos paneles o fiel a la forma?</translation>
    </message>
    <message>
        <source>Fields: {}, on {} of film</source>
        <translation>Campos: {}, en {} de película</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Files written to {}</source>
        <translation>Archivos escritos en {}</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Rellenar</translation>
    </message>
    <message>
        <source>Fill a closed line, or give an area another colour</source>
        <translation>Rellenar una línea cerrada o dar otro color a una superficie</translation>
    </message>
    <message>
        <source>Fill at the nozzle, to at most {column} of water.</source>
        <translation>Llene por la boquilla, hasta {column} de agua como mucho.</translation>
    </message>
    <message>
        <source>Fill through a straw in the neck, to at most {column} of water.</source>
        <translation>Llene con una pajita por el cuello, hasta {column} de agua como mucho.</translation>
    </message>
    <message>
        <source>Fill through a tube of 6 mm, its end cut aslant, pushed 25 mm past the seal across the neck, to at most {column} of water. Pull it out: the strips close by themselves.</source>
        <translation>Llene por un tubo de 6 mm con el extremo cortado al sesgo, metido 25 mm más allá de la soldadura a través del cuello, hasta {column} de agua como mucho. Sáquelo: las tiras se cierran solas.</translation>
    </message>
    <message>
        <source>Fill through a tube of 6 mm, its end cut aslant, pushed 25 mm past the weld across the neck. Pull it out: the pressure presses the strips together.</source>
        <translation>Llene por un tubo de 6 mm con el extremo cortado al sesgo, metido 25 mm más allá de la soldadura a través del cuello. Sáquelo: la presión aprieta las tiras.</translation>
    </message>
    <message>
        <source>Fill to {pressure}, never above {safe}: film and seam then keep a margin of {margin}.</source>
        <translation>Llene hasta {pressure}, nunca por encima de {safe}: película y costura conservan así un margen de {margin}.</translation>
    </message>
    <message>
        <source>Fill to {pressure}, never above {safe}: film and weld then keep a margin of {margin}.</source>
        <translation>Llene hasta {pressure}, nunca por encima de {safe}: película y soldadura conservan así un margen de {margin}.</translation>
    </message>
    <message>
        <source>Fill to {safe} at most: {pressure} is more than film and seam bear with a margin of {margin}. Mind your eyes.</source>
        <translation>Llene como mucho hasta {safe}: {pressure} es más de lo que película y costura aguantan con un margen de {margin}. Proteja sus ojos.</translation>
    </message>
    <message>
        <source>Fill to {safe} at most: {pressure} is more than film and weld bear with a margin of {margin}. Mind your eyes.</source>
        <translation>Llene como mucho hasta {safe}: {pressure} es más de lo que película y soldadura aguantan con un margen de {margin}. Proteja sus ojos.</translation>
    </message>
    <message>
        <source>Fill with air a little and brush soapy water along the weld: bubbles show leaks. Weld once more there.</source>
        <translation>Meta un poco de aire y pase agua jabonosa por la soldadura: las burbujas muestran las fugas. Vuelva a soldar ahí.</translation>
    </message>
    <message>
        <source>Filled shape</source>
        <translation>Forma rellena</translation>
    </message>
    <message>
        <source>Filleted housing</source>
        <translation>Carcasa con redondeos</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Película</translation>
    </message>
    <message>
        <source>Film Balloon {0} in FreeCAD {1}</source>
        <translation>Film Balloon {0} en FreeCAD {1}</translation>
    </message>
    <message>
        <source>Film needed</source>
        <translation>Película necesaria</translation>
    </message>
    <message>
        <source>Film needed: {0}</source>
        <translation>Película necesaria: {0}</translation>
    </message>
    <message>
        <source>Film of your own</source>
        <translation>Película propia</translation>
    </message>
    <message>
        <source>Film that it takes</source>
        <translation>Película que necesita</translation>
    </message>
    <message>
        <source>Film width</source>
        <translation>Anchura de la película</translation>
    </message>
    <message>
        <source>Film {0} large is too much: write 500mm.</source>
        <translation>Una película de {0} es demasiado: escriba 500mm.</translation>
    </message>
    <message>
        <source>Film: {0}</source>
        <translation>Película: {0}</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>Películas</translation>
    </message>
    <message>
        <source>Find how much the film stretched, and how far the weld draws the seam inward</source>
        <translation>Hallar cuánto se estiró la película y cuánto lleva la soldadura la costura hacia dentro</translation>
    </message>
    <message>
        <source>Find its place</source>
        <translation>Buscar su lugar</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Hallazgos</translation>
    </message>
    <message>
        <source>Fit the film, too</source>
        <translation>Ajustar también la película</translation>
    </message>
    <message>
        <source>Fit to drawing</source>
        <translation>Ajustar al dibujo</translation>
    </message>
    <message>
        <source>Fitting the pattern</source>
        <translation>Ajustando el patrón</translation>
    </message>
    <message>
        <source>Flat pieces</source>
        <translation>Piezas planas</translation>
    </message>
    <message>
        <source>Flattening needs scipy: install it with pip install scipy.</source>
        <translation>El aplanado necesita scipy: instálelo con pip install scipy.</translation>
    </message>
    <message>
        <source>Flower</source>
        <translation>Flor</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Folder for the artwork</source>
        <translation>Carpeta para la ilustración</translation>
    </message>
    <message>
        <source>Follow every change at once</source>
        <translation>Seguir cada cambio al instante</translation>
    </message>
    <message>
        <source>Follows the body</source>
        <translation>Sigue el cuerpo</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Tipo de letra</translation>
    </message>
    <message>
        <source>For Send to Silhouette of inkscape-silhouette. It looks for four marks, which lie on the layer Regmarks, are not cut, 10 mm from the edges of A4 and 190 and 277 mm apart: give that there, and four marks. Nothing is cut outside them. For other paper change page_mm in a copy.</source>
        <translation>Para «Send to Silhouette» de inkscape-silhouette. Busca cuatro marcas, que están en la capa Regmarks, no se cortan, a 10 mm de los bordes de A4 y separadas 190 y 277 mm: indíquelo allí, y cuatro marcas. Fuera de ellas no se corta nada. Para otro papel cambie page_mm en una copia.</translation>
    </message>
    <message>
        <source>For Send to Silhouette of inkscape-silhouette. The marks of a print lie on the layer Regmarks, which is not cut, 10 mm from the edges of A4 and 190 and 277 mm apart: give that there. Nothing is cut outside them. For other paper change page_mm in a copy.</source>
        <translation>Para «Send to Silhouette» de inkscape-silhouette. Las marcas de una impresión están en la capa Regmarks, que no se corta, a 10 mm de los bordes de A4 y separadas 190 y 277 mm: indíquelo allí. Fuera de ellas no se corta nada. Para otro papel cambie page_mm en una copia.</translation>
    </message>
    <message>
        <source>For {0} of {1} pieces there is no room on the remnant: give film for the rest too.</source>
        <translation>Para {0} de {1} piezas no hay sitio en el retal: indique también película para el resto.</translation>
    </message>
    <message>
        <source>For {0} the drawing would be {1} large: choose a volume that makes it {2} to {3}.</source>
        <translation>Para {0} el dibujo mediría {1}: elija un volumen que le dé de {2} a {3}.</translation>
    </message>
    <message>
        <source>Forced</source>
        <translation>Forzada</translation>
    </message>
    <message>
        <source>Forget earlier photographs</source>
        <translation>Olvidar las fotografías anteriores</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Frames are even in movement, not in time. Only the film has mass, the gas has none.</source>
        <translation>Los fotogramas son regulares en movimiento, no en tiempo. Solo la película tiene masa, el gas no.</translation>
    </message>
    <message>
        <source>FreeCAD does not start beside this one ({0}): install it for the Python that runs there.</source>
        <translation>No arranca otro FreeCAD junto a este ({0}): instálelo para el Python que se ejecuta allí.</translation>
    </message>
    <message>
        <source>FreeCAD failed while {0} ({1}). {2}</source>
        <translation>FreeCAD falló al {0} ({1}). {2}</translation>
    </message>
    <message>
        <source>FreeCAD has no material card "{0}": choose one of its material editor.</source>
        <translation>FreeCAD no tiene la ficha de material «{0}»: elija una de su editor de materiales.</translation>
    </message>
    <message>
        <source>FreeCAD needs a home folder and a temporary folder that it can write to, and enough memory.</source>
        <translation>Necesita una carpeta personal y una temporal en las que pueda escribir, y memoria.</translation>
    </message>
    <message>
        <source>FreeCAD stopped while {0} ({1}). {2}</source>
        <translation>FreeCAD se detuvo al {0} ({1}). {2}</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>From the flat film to the balloon at rest</source>
        <translation>De la película plana al globo en reposo</translation>
    </message>
    <message>
        <source>From this value, with its unit</source>
        <translation>Desde este valor, con su unidad</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Front and back as PNG and PDF, and as DXF and SVG with the same marks for the cutter</source>
        <translation>Frente y dorso como PNG y PDF, y como DXF y SVG con las mismas marcas para la cortadora</translation>
    </message>
    <message>
        <source>Front, back and a band between them: change its width</source>
        <translation>Frente, dorso y una banda entre ellos: cambie su ancho</translation>
    </message>
    <message>
        <source>G-code, and no other format, has a tool: give both or none.</source>
        <translation>Solo el formato de código G tiene herramienta, ningún otro: indique ambos o ninguno.</translation>
    </message>
    <message>
        <source>GRBL knows X, Y and Z only: leave turning_axis out, or take LinuxCNC or Marlin where an axis turns the tool.</source>
        <translation>GRBL solo conoce X, Y y Z: omita turning_axis, o use LinuxCNC o Marlin si un eje gira la herramienta.</translation>
    </message>
    <message>
        <source>GRBL machine (G-code)</source>
        <translation>Máquina GRBL (código G)</translation>
    </message>
    <message>
        <source>Gaps of up to {0} between lines were closed.</source>
        <translation>Se cerraron huecos de hasta {0} entre líneas.</translation>
    </message>
    <message>
        <source>Gas</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>Gas that it takes, at the pressure outside</source>
        <translation>Gas que necesita, a la presión exterior</translation>
    </message>
    <message>
        <source>Give --artwork for the front too.</source>
        <translation>Indique también --artwork para el frente.</translation>
    </message>
    <message>
        <source>Give --png or --report html with --ground: it is the ground of these.</source>
        <translation>Dé --png o --report html con --ground: es el fondo de estos.</translation>
    </message>
    <message>
        <source>Give a number of panels, into which the body is divided.</source>
        <translation>Indique un número de paneles en que se divida el cuerpo.</translation>
    </message>
    <message>
        <source>Give a study either "{0}" or "{1}".</source>
        <translation>Dé a un estudio «{0}» o «{1}», no ambos.</translation>
    </message>
    <message>
        <source>Give either --material, or all of --young, --poisson and --thickness.</source>
        <translation>Indique --material, o bien --young, --poisson y --thickness, los tres.</translation>
    </message>
    <message>
        <source>Give either --scheduler or --dask.</source>
        <translation>Indique --scheduler o --dask, no ambos.</translation>
    </message>
    <message>
        <source>Give either a volume or a lift as the goal.</source>
        <translation>Indique como objetivo un volumen o una sustentación.</translation>
    </message>
    <message>
        <source>Give one or two settings several values, such as 200, 300, 400, and each of the others one.</source>
        <translation>Dé a uno o dos ajustes varios valores, por ejemplo 200, 300, 400, y a cada uno de los demás uno solo.</translation>
    </message>
    <message>
        <source>Give the document the values of the chosen row</source>
        <translation>Dar al documento los valores de la fila elegida</translation>
    </message>
    <message>
        <source>Give {0} either "{1}" or "{2}", {3}.</source>
        <translation>Dé a {0} «{1}» o «{2}», {3}.</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Dado</translation>
    </message>
    <message>
        <source>Glowforge</source>
        <translation>Glowforge</translation>
    </message>
    <message>
        <source>Glue</source>
        <translation>Pegamento</translation>
    </message>
    <message>
        <source>Glue a strip of {seal} along the dashed line. Let it dry under a weight.</source>
        <translation>Pegue una franja de {seal} a lo largo de la línea discontinua. Deje secar bajo un peso.</translation>
    </message>
    <message>
        <source>Glue a strip of {seal} along the dashed line; leave the mouth of the neck open. Let it dry under a weight.</source>
        <translation>Pegue una franja de {seal} a lo largo de la línea discontinua; deje abierta la boca del cuello. Deje secar bajo un peso.</translation>
    </message>
    <message>
        <source>Glue the lines inside the balloon.</source>
        <translation>Pegue las líneas del interior del globo.</translation>
    </message>
    <message>
        <source>Glue the seams. Stiffer along the web than across it; E is the geometric mean. Does not hold gas for long and creases sharply.</source>
        <translation>Pegue las costuras. Más rígido a lo largo de la banda que a través; E es la media geométrica. No retiene el gas mucho tiempo y forma pliegues agudos.</translation>
    </message>
    <message>
        <source>Glue the seams. Stiffer along the web than across it; E is the geometric mean. Porous: for a moment's inflation or with a lining.</source>
        <translation>Pegue las costuras. Más rígido a lo largo de la banda que a través; E es la media geométrica. Poroso: para un inflado breve o con forro.</translation>
    </message>
    <message>
        <source>Glued seam</source>
        <translation>Costura pegada</translation>
    </message>
    <message>
        <source>Gores</source>
        <translation>Gajos</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Fibra</translation>
    </message>
    <message>
        <source>Grain lies</source>
        <translation>La fibra va</translation>
    </message>
    <message>
        <source>Graphtec with ARMS (vinyl cutter)</source>
        <translation>Graphtec con ARMS (cortador de vinilo)</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Verde</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>HPGL is written as polylines: give "arcs": false.</source>
        <translation>HPGL se escribe como polilíneas: indique "arcs": false.</translation>
    </message>
    <message>
        <source>HPGL plotter or vinyl cutter</source>
        <translation>Trazador HPGL o cortador de vinilo</translation>
    </message>
    <message>
        <source>Half the outline and its axis; a copy of it travels in the document</source>
        <translation>Medio contorno y su eje; una copia viaja en el documento</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Corazón</translation>
    </message>
    <message>
        <source>Heart from a spreadsheet</source>
        <translation>Corazón desde una hoja de cálculo</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Calor</translation>
    </message>
    <message>
        <source>Heat sealer on a plotter</source>
        <translation>Selladora térmica en un trazador</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Height between two lines; empty: 5 mm</source>
        <translation>Altura entre dos líneas; vacío: 5 mm</translation>
    </message>
    <message>
        <source>Helium</source>
        <translation>Helio</translation>
    </message>
    <message>
        <source>High frequency</source>
        <translation>Alta frecuencia</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}'</source>
        <translation>Agujero {0} del panel «{1}»</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}' lies outside its film. Move it, or take it out.</source>
        <translation>El agujero {0} del panel «{1}» queda fuera de su película. Muévalo, o quítelo.</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}' runs counter-clockwise. Turn the order of its points round.</source>
        <translation>El agujero {0} del panel «{1}» gira en sentido antihorario. Invierta el orden de sus puntos.</translation>
    </message>
    <message>
        <source>Holes from</source>
        <translation>Agujeros desde</translation>
    </message>
    <message>
        <source>Holes of the mesh that were closed: {0}.</source>
        <translation>Agujeros de la malla que se cerraron: {0}.</translation>
    </message>
    <message>
        <source>Home, then set X0 Y0 at the lower left corner of the film and Z0 where the tip touches the layer over it (G92); nothing homes. Lay baking paper or PTFE between tip and film, tape the film flat.</source>
        <translation>Lleve la máquina a su origen (home), luego ponga X0 Y0 en la esquina inferior izquierda de la película y Z0 donde la punta toca la capa que la cubre (G92); el archivo no busca el origen. Ponga papel de hornear o PTFE entre punta y película, y sujete la película plana con cinta.</translation>
    </message>
    <message>
        <source>Hot tip</source>
        <translation>Punta caliente</translation>
    </message>
    <message>
        <source>Hot wheel</source>
        <translation>Rueda caliente</translation>
    </message>
    <message>
        <source>Hours of welding, where they are known</source>
        <translation>Horas de soldadura, donde se conocen</translation>
    </message>
    <message>
        <source>How a balloon follows its pattern can be worked out for an elastic weld alone: choose that one.</source>
        <translation>Cómo sigue un globo a su patrón solo se puede calcular para una soldadura elástica: elija esa.</translation>
    </message>
    <message>
        <source>How far a closed cut runs past its start; empty: six times the knife's offset</source>
        <translation>Cuánto sigue un corte cerrado más allá de su inicio; vacío: seis veces el desvío de la cuchilla</translation>
    </message>
    <message>
        <source>How far a closed weld runs past its start, so that the joint is tight</source>
        <translation>Cuánto sigue una soldadura cerrada más allá de su inicio, para que la unión sea estanca</translation>
    </message>
    <message>
        <source>How far a swivel knife or wheel lies behind its axis; 0 where the machine makes up for it</source>
        <translation>Cuánto queda una cuchilla o rueda giratoria por detrás de su eje; 0 si la máquina ya lo compensa</translation>
    </message>
    <message>
        <source>How far along it</source>
        <translation>A qué distancia a lo largo</translation>
    </message>
    <message>
        <source>How far along its seam the opening is must be from 0 to 1.</source>
        <translation>La distancia de la abertura a lo largo de su costura debe ser de 0 a 1.</translation>
    </message>
    <message>
        <source>How far below the place where it touches the film it works: it presses so hard, or cuts so deep; of a laser its focus. Empty: not known yet</source>
        <translation>A qué distancia trabaja por debajo del punto donde toca la película: así de fuerte aprieta, o así de hondo corta; en un láser, su foco. Vacío: aún no se sabe</translation>
    </message>
    <message>
        <source>How far the balloon may be from the body on average, of the body's diagonal</source>
        <translation>Cuánto puede apartarse de media el globo del cuerpo, como parte de la diagonal del cuerpo</translation>
    </message>
    <message>
        <source>How far the outline moves if the weld creases could not be simulated. {0}</source>
        <translation>No se pudo simular cuánto se mueve el contorno si la soldadura se arruga. {0}</translation>
    </message>
    <message>
        <source>How far weld and film reach beyond the seam in the photograph; empty: as in the pattern, 0: folded back</source>
        <translation>Cuánto sobresalen soldadura y película de la costura en la fotografía; vacío: como en el patrón, 0: doblado hacia atrás</translation>
    </message>
    <message>
        <source>How fast it goes along a line; empty: not known yet</source>
        <translation>A qué velocidad va por una línea; vacío: aún no se sabe</translation>
    </message>
    <message>
        <source>How long a way from waste film to a weld may be; 0 for none</source>
        <translation>Qué longitud puede tener la entrada a una soldadura desde la película sobrante; 0 para ninguna</translation>
    </message>
    <message>
        <source>How long it waits before it moves along a line: film warms, a beam burns in, a spindle starts</source>
        <translation>Cuánto espera antes de moverse por una línea: la película se calienta, un haz perfora, un husillo arranca</translation>
    </message>
    <message>
        <source>How wide shall it be?</source>
        <translation>¿Qué anchura debe tener?</translation>
    </message>
    <message>
        <source>Hydrogen</source>
        <translation>Hidrógeno</translation>
    </message>
    <message>
        <source>If the weld creases</source>
        <translation>Si la soldadura se arruga</translation>
    </message>
    <message>
        <source>If the weld creases, the outline may lie up to {0} away near {1}.</source>
        <translation>Si la soldadura se arruga, el contorno puede desviarse hasta {0} cerca de {1}.</translation>
    </message>
    <message>
        <source>If the weld creases: {0} on average, at most {1}</source>
        <translation>Si la soldadura se arruga: {0} de media, como mucho {1}</translation>
    </message>
    <message>
        <source>In no seam yet: {}</source>
        <translation>Aún en ninguna costura: {}</translation>
    </message>
    <message>
        <source>In {0} of {1} samples the pressure is above the safe one: fill it less.</source>
        <translation>En {0} de {1} muestras la presión supera la segura: llénelo menos.</translation>
    </message>
    <message>
        <source>Inflate as drawn</source>
        <translation>Inflar tal como está dibujado</translation>
    </message>
    <message>
        <source>Inflate now</source>
        <translation>Inflar ahora</translation>
    </message>
    <message>
        <source>Inflate with these values and show the balloon</source>
        <translation>Inflar con estos valores y mostrar el globo</translation>
    </message>
    <message>
        <source>Inflated</source>
        <translation>Inflado</translation>
    </message>
    <message>
        <source>Inflating</source>
        <translation>Inflando</translation>
    </message>
    <message>
        <source>Inflating in time</source>
        <translation>Inflando en el tiempo</translation>
    </message>
    <message>
        <source>Inflating {0}</source>
        <translation>Inflando {0}</translation>
    </message>
    <message>
        <source>Inflation</source>
        <translation>Inflado</translation>
    </message>
    <message>
        <source>Ink, or a slip of baking paper</source>
        <translation>Tinta, o un trozo de papel de hornear</translation>
    </message>
    <message>
        <source>Inkscape</source>
        <translation>Inkscape</translation>
    </message>
    <message>
        <source>Intake</source>
        <translation>Boca</translation>
    </message>
    <message>
        <source>Intake in a side part</source>
        <translation>Boca en una parte lateral</translation>
    </message>
    <message>
        <source>Intake on a thin part</source>
        <translation>Boca en una parte fina</translation>
    </message>
    <message>
        <source>It came with the workbench: copy it to set it up as your own.</source>
        <translation>Venía con el banco de trabajo: cópiela para configurarla como propia.</translation>
    </message>
    <message>
        <source>It holds {} of the air that a round balloon of as much film would.</source>
        <translation>Contiene {} del aire que tendría un globo redondo con igual película.</translation>
    </message>
    <message>
        <source>It is filled to {0}, its safe pressure is {1}: fill it less.</source>
        <translation>Se llena a {0}, su presión segura es {1}: llénelo menos.</translation>
    </message>
    <message>
        <source>It is not inflated yet: choose Inflate now in its context menu, or switch Live on.</source>
        <translation>Aún no está inflado: elija «Inflar ahora» en su menú contextual o active En vivo.</translation>
    </message>
    <message>
        <source>It is not repeated on the other side. {0}</source>
        <translation>No se repite en el otro lado. {0}</translation>
    </message>
    <message>
        <source>It is wider now. Ctrl+Z takes that back.</source>
        <translation>Ahora es más ancho. Ctrl+Z lo deshace.</translation>
    </message>
    <message>
        <source>It lies</source>
        <translation>Queda</translation>
    </message>
    <message>
        <source>It meets what it was designed for</source>
        <translation>Cumple aquello para lo que se diseñó</translation>
    </message>
    <message>
        <source>It needs more places: give them all.</source>
        <translation>Necesita más lugares: indíquelos todos.</translation>
    </message>
    <message>
        <source>It takes {0} h at {1} m/min and {2} min for each seam.</source>
        <translation>Lleva {0} h a {1} m/min y {2} min por cada costura.</translation>
    </message>
    <message>
        <source>It took longer than {0} s: take a coarser mesh, or raise --timeout.</source>
        <translation>Tardó más de {0} s: tome una malla más gruesa o aumente --timeout.</translation>
    </message>
    <message>
        <source>Its pattern is gone: delete it.</source>
        <translation>Su patrón ya no existe: bórrelo.</translation>
    </message>
    <message>
        <source>Its process ended with {0} ({1}).</source>
        <translation>Su proceso terminó con {0} ({1}).</translation>
    </message>
    <message>
        <source>Its process was ended by {0}.</source>
        <translation>Su proceso fue terminado por {0}.</translation>
    </message>
    <message>
        <source>Its process was ended by {0}. It may have lacked memory: take a coarser mesh.</source>
        <translation>Su proceso fue terminado por {0}. Quizá faltó memoria: tome una malla más gruesa.</translation>
    </message>
    <message>
        <source>Its process was ended by {0}.{1}</source>
        <translation>Su proceso fue terminado por {0}.{1}</translation>
    </message>
    <message>
        <source>Its workers were killed again and again: take a coarser mesh, or start it again.</source>
        <translation>Sus workers fueron terminados una y otra vez: tome una malla más gruesa o inícielo de nuevo.</translation>
    </message>
    <message>
        <source>JSON</source>
        <translation>JSON</translation>
    </message>
    <message>
        <source>Jobs of a study is 0 or more: 0 takes one for each processor.</source>
        <translation>Jobs de un estudio es 0 o más: 0 toma uno por procesador.</translation>
    </message>
    <message>
        <source>Join the panels along the dashed line, {seal} wide, all the way round.</source>
        <translation>Una los paneles a lo largo de la línea discontinua, con {seal} de ancho, todo alrededor.</translation>
    </message>
    <message>
        <source>Join the panels along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>Una los paneles a lo largo de la línea discontinua, con {seal} de ancho; deje abierta la boca del cuello.</translation>
    </message>
    <message>
        <source>Join the panels along the lines inside the balloon.</source>
        <translation>Una los paneles por las líneas del interior del globo.</translation>
    </message>
    <message>
        <source>Joined</source>
        <translation>Unidas</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Conservarla</translation>
    </message>
    <message>
        <source>Keep the best</source>
        <translation>Conservar el mejor</translation>
    </message>
    <message>
        <source>Keep the film</source>
        <translation>Conservar la película</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Mantener las proporciones</translation>
    </message>
    <message>
        <source>Keep what is left</source>
        <translation>Guardar lo que queda</translation>
    </message>
    <message>
        <source>Keep what is left...</source>
        <translation>Guardar lo que queda...</translation>
    </message>
    <message>
        <source>Kept, and offered by Export pattern: {}</source>
        <translation>Guardada, y «Exportar patrón» la ofrece: {}</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Ancho de corte</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Cuchilla</translation>
    </message>
    <message>
        <source>Knife offset</source>
        <translation>Desvío de cuchilla</translation>
    </message>
    <message>
        <source>Kraft paper, 80 g/m²</source>
        <translation>Papel kraft, 80 g/m²</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <source>Labels need matplotlib: install it with pip install matplotlib, or leave the label empty.</source>
        <translation>Las etiquetas necesitan matplotlib: instálelo con pip install matplotlib o deje la etiqueta vacía.</translation>
    </message>
    <message>
        <source>Laid flat</source>
        <translation>Aplanado</translation>
    </message>
    <message>
        <source>Laid one piece after another: the package spyrrow (pip install spyrrow) often finds a closer layout.</source>
        <translation>Las piezas se colocaron una tras otra: el paquete spyrrow (pip install spyrrow) suele hallar una colocación más apretada.</translation>
    </message>
    <message>
        <source>Largest strain</source>
        <translation>Mayor deformación</translation>
    </message>
    <message>
        <source>Largest tension of the film</source>
        <translation>Mayor tensión de la película</translation>
    </message>
    <message>
        <source>Laser</source>
        <translation>Láser</translation>
    </message>
    <message>
        <source>Lay a picture under the paper for tracing; press again to take it away</source>
        <translation>Poner una imagen bajo el papel para calcarla; pulse otra vez para quitarla</translation>
    </message>
    <message>
        <source>Lay both valve strips on each other, their lines together. On the field marked on VALVE, INK put heat-resistant ink, or a slip of baking paper between the strips. Weld them along both long lines.</source>
        <translation>Ponga las dos tiras de la válvula una sobre otra, haciendo coincidir sus líneas. En el campo marcado en VALVE, INK ponga tinta resistente al calor, o un trozo de papel de hornear entre las tiras. Suéldelas por las dos líneas largas.</translation>
    </message>
    <message>
        <source>Lay edges of the same number on each other, inner sides together: arrows the same way, the lines across the weld and the notches on each other. Tape outside the cut.</source>
        <translation>Ponga uno sobre otro los bordes del mismo número, con las caras interiores juntas: flechas en el mismo sentido, rayas a través de la soldadura y muescas superpuestas. Fíjelos con cinta fuera del corte.</translation>
    </message>
    <message>
        <source>Lay out</source>
        <translation>Colocar</translation>
    </message>
    <message>
        <source>Lay out anew</source>
        <translation>Recolocar</translation>
    </message>
    <message>
        <source>Lay out on film</source>
        <translation>Colocar en la película</translation>
    </message>
    <message>
        <source>Lay the grain of all panels along the line with two arrowheads.</source>
        <translation>Ponga la dirección de la película de todos los paneles a lo largo de la línea con dos puntas de flecha.</translation>
    </message>
    <message>
        <source>Lay the grain of both panels the same way.</source>
        <translation>Ponga la fibra de ambos paneles en la misma dirección.</translation>
    </message>
    <message>
        <source>Lay the panels on each other, sealing sides inward. Line them up by the notches or edges; tape outside the cut.</source>
        <translation>Ponga los paneles uno sobre otro, con las caras de sellado hacia dentro. Alinéelos por las muescas o los bordes; sujételos con cinta fuera del corte.</translation>
    </message>
    <message>
        <source>Lay the panels on each other. Line them up by the notches or edges; tape outside the cut.</source>
        <translation>Ponga los paneles uno sobre otro. Alinéelos por las muescas o los bordes; sujételos con cinta fuera del corte.</translation>
    </message>
    <message>
        <source>Lay the strips into the neck of one panel, end at the mouth, line on line. Tack them to this panel only, with two spots of weld on the line, beside the channel.</source>
        <translation>Ponga las tiras en el cuello de un panel, con el extremo en la boca, línea sobre línea. Fíjelas solo a este panel, con dos puntos de soldadura en la línea, junto al canal.</translation>
    </message>
    <message>
        <source>Layers, millimetres and arcs, to go on drawing.</source>
        <translation>Capas, milímetros y arcos, para seguir dibujando.</translation>
    </message>
    <message>
        <source>Laying out {0}</source>
        <translation>Colocando {0}</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Leak test: fill with air through a tube in the neck, closed round it by hand or with tape, to at most {column} of water in a hose. Wait 15 min, brush soapy water along the seams. Mark with a pen where bubbles grow, let the air out, dry it, seal there once more, test again.</source>
        <translation>Prueba de fugas: llene con aire por un tubo en el cuello, cerrado a su alrededor con la mano o con cinta, hasta {column} de agua en una manguera como mucho. Espere 15 min, pase agua jabonosa por las costuras. Marque con un rotulador donde crezcan burbujas, saque el aire, séquelo, vuelva a sellar ahí, pruebe de nuevo.</translation>
    </message>
    <message>
        <source>Leak test: fill with air to at most {column} of water in a hose. Wait 15 min, brush soapy water along the seams. Mark with a pen where bubbles grow, let the air out, dry it, seal there once more, test again.</source>
        <translation>Prueba de fugas: llene con aire hasta {column} de agua en una manguera como mucho. Espere 15 min, pase agua jabonosa por las costuras. Marque con un rotulador donde crezcan burbujas, saque el aire, séquelo, vuelva a sellar ahí, pruebe de nuevo.</translation>
    </message>
    <message>
        <source>Leave tabs so wide in the cuts, such as 0.4 mm, on straights, two or more on each and one in 100 mm, so that pieces stay in the film. It is kept for this machine</source>
        <translation>Dejar en los cortes puentes de esta anchura, por ejemplo 0.4 mm, en tramos rectos, dos o más en cada uno y uno cada 100 mm, para que las piezas sigan en la película. Se guarda para esta máquina</translation>
    </message>
    <message>
        <source>Left out: {0}</source>
        <translation>Omitido: {0}</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Length of a gore</source>
        <translation>Longitud de un gajo</translation>
    </message>
    <message>
        <source>Length of the seams</source>
        <translation>Longitud de las costuras</translation>
    </message>
    <message>
        <source>Length of the usual roll that it takes</source>
        <translation>Longitud que necesita del rollo habitual</translation>
    </message>
    <message>
        <source>Let all pieces lie as the pattern lays them</source>
        <translation>Poner todas las piezas como las pone el patrón</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letra</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>Altura de letra</translation>
    </message>
    <message>
        <source>Letter with a side band</source>
        <translation>Letra con banda lateral</translation>
    </message>
    <message>
        <source>Letters on a ground that makes one balloon of them</source>
        <translation>Letras sobre un fondo que hace de ellas un solo globo</translation>
    </message>
    <message>
        <source>Letters, digits, spaces and - only</source>
        <translation>Solo letras, cifras, espacios y -</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Sustentación</translation>
    </message>
    <message>
        <source>Lift in g</source>
        <translation>Sustentación en g</translation>
    </message>
    <message>
        <source>Lift needs vertices of the balloon that hold it. Give those of its lower end.</source>
        <translation>La sustentación necesita nodos del globo que la retengan. Indique los de su extremo inferior.</translation>
    </message>
    <message>
        <source>LightBurn (laser)</source>
        <translation>LightBurn (láser)</translation>
    </message>
    <message>
        <source>LightBurn has too few layers for panels in holes of panels: lay out fewer.</source>
        <translation>LightBurn tiene muy pocas capas para piezas en agujeros de otras piezas: coloque menos.</translation>
    </message>
    <message>
        <source>LightBurn project (laser)</source>
        <translation>Proyecto de LightBurn (láser)</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Lines it inside</source>
        <translation>Lo reviste por dentro</translation>
    </message>
    <message>
        <source>Lines that close around nothing beside the shapes were left out.</source>
        <translation>Se omitieron las líneas junto a las formas que no encierran nada.</translation>
    </message>
    <message>
        <source>Lines up to</source>
        <translation>Líneas hasta</translation>
    </message>
    <message>
        <source>LinuxCNC machine (G-code)</source>
        <translation>Máquina LinuxCNC (código G)</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En vivo</translation>
    </message>
    <message>
        <source>Longest piece of the band</source>
        <translation>Pieza más larga de la banda</translation>
    </message>
    <message>
        <source>Look for the closest layout; Esc takes the best one so far</source>
        <translation>Buscar la colocación más apretada; Esc toma la mejor hasta el momento</translation>
    </message>
    <message>
        <source>Loose ends of lines were joined to the drawing.</source>
        <translation>Se unieron al dibujo extremos sueltos de líneas.</translation>
    </message>
    <message>
        <source>Loose film: {0}, wrinkled: {1}; wrinkles hide {2} of it</source>
        <translation>Película floja: {0}, arrugada: {1}; las arrugas ocultan {2} de ella</translation>
    </message>
    <message>
        <source>Low</source>
        <translation>Abajo</translation>
    </message>
    <message>
        <source>Lower end</source>
        <translation>Extremo inferior</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Made with brush and pen: double-click the Outline to paint on</source>
        <translation>Hecho con pincel y lápiz: doble clic en el contorno para seguir pintando</translation>
    </message>
    <message>
        <source>Make a card</source>
        <translation>Hacer una tarjeta</translation>
    </message>
    <message>
        <source>Make a machine of your own with the values of this one</source>
        <translation>Hacer una máquina propia con los valores de esta</translation>
    </message>
    <message>
        <source>Make a sketch of the cuts</source>
        <translation>Hacer un croquis de los cortes</translation>
    </message>
    <message>
        <source>Make a test card: nobody states a temperature for this film.</source>
        <translation>Haga una tarjeta de prueba: nadie indica una temperatura para esta película.</translation>
    </message>
    <message>
        <source>Make it!</source>
        <translation>¡Hazlo!</translation>
    </message>
    <message>
        <source>Make rows</source>
        <translation>Crear filas</translation>
    </message>
    <message>
        <source>Make the balloon smaller and inflate it again, until its pattern fits the bed. Weld and allowance keep their widths; one undo takes it back</source>
        <translation>Reducir el globo e inflarlo de nuevo hasta que su patrón quepa en la cama. Soldadura y margen conservan su anchura; se revierte con un solo «Deshacer»</translation>
    </message>
    <message>
        <source>Making tool paths</source>
        <translation>Creando trayectorias de herramienta</translation>
    </message>
    <message>
        <source>Mark a length</source>
        <translation>Marcar una longitud</translation>
    </message>
    <message>
        <source>Mark a length in the picture, and give its true length, such as 300 mm.</source>
        <translation>Marque una longitud en la imagen e indique su longitud real, por ejemplo 300 mm.</translation>
    </message>
    <message>
        <source>Mark a length…</source>
        <translation>Marcar una longitud…</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marcas</translation>
    </message>
    <message>
        <source>Marks for</source>
        <translation>Marcas para</translation>
    </message>
    <message>
        <source>Marlin printer (G-code)</source>
        <translation>Impresora Marlin (código G)</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>May be cut</source>
        <translation>Se puede cortar</translation>
    </message>
    <message>
        <source>Mean distance from the body</source>
        <translation>Distancia media al cuerpo</translation>
    </message>
    <message>
        <source>Measure (M)</source>
        <translation>Medir (M)</translation>
    </message>
    <message>
        <source>Measured on the inflated balloon.</source>
        <translation>Medido en el globo inflado.</translation>
    </message>
    <message>
        <source>Membrane tension</source>
        <translation>Tensión de membrana</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Unir</translation>
    </message>
    <message>
        <source>Mesh reuse needs scipy: install it with pip install scipy.</source>
        <translation>Reutilizar la malla necesita scipy: instálelo con pip install scipy.</translation>
    </message>
    <message>
        <source>Mesh size</source>
        <translation>Tamaño de malla</translation>
    </message>
    <message>
        <source>Mesh size (0: automatic)</source>
        <translation>Tamaño de malla (0: automático)</translation>
    </message>
    <message>
        <source>Meshing needs scipy: install it with pip install scipy.</source>
        <translation>El mallado necesita scipy: instálelo con pip install scipy.</translation>
    </message>
    <message>
        <source>Mimaki with register marks (vinyl cutter)</source>
        <translation>Mimaki con marcas de registro (cortador de vinilo)</translation>
    </message>
    <message>
        <source>Mind</source>
        <translation>Atención</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Reflejar</translation>
    </message>
    <message>
        <source>Mirror piece</source>
        <translation>Reflejar pieza</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>More gores hardly help: change the profile.</source>
        <translation>Más gajos apenas ayudan: cambie el perfil.</translation>
    </message>
    <message>
        <source>More: text, stamps, layers, symmetry, any colour (Q)</source>
        <translation>Más: texto, sellos, capas, simetría, cualquier color (Q)</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Move piece</source>
        <translation>Mover pieza</translation>
    </message>
    <message>
        <source>Move the pointer to bend the line, then click. Esc drops it.</source>
        <translation>Mueva el puntero para curvar la línea y haga clic. Esc la descarta.</translation>
    </message>
    <message>
        <source>Move, add and remove nodes of the outline in a tab, over the picture</source>
        <translation>Mover, añadir y quitar nodos del contorno en una pestaña, sobre la imagen</translation>
    </message>
    <message>
        <source>My machines</source>
        <translation>Mis máquinas</translation>
    </message>
    <message>
        <source>My {}</source>
        <translation>Mi {}</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Nombre de la máquina</translation>
    </message>
    <message>
        <source>Native</source>
        <translation>Nativo</translation>
    </message>
    <message>
        <source>Natural shape</source>
        <translation>Forma natural</translation>
    </message>
    <message>
        <source>Near {0} the film stays {1} from the body, which is too thin or too sharp there for panels. Cut such a part off, or divide the body along it.</source>
        <translation>Cerca de {0} la película queda a {1} del cuerpo, que ahí es demasiado delgado o agudo para paneles. Corte esa parte, o divida el cuerpo a lo largo de ella.</translation>
    </message>
    <message>
        <source>Near {0} the inflated outline stays up to {1} from the drawing, over a length of {2}: film cannot follow it there. Round it off or widen it.</source>
        <translation>Cerca de {0} el contorno inflado queda hasta a {1} del dibujo, a lo largo de {2}: la película no puede seguirlo ahí. Redondéelo o ensánchelo.</translation>
    </message>
    <message>
        <source>Near {0} the inflated outline stays up to {1} from the drawing, over a length of {2}: the balloon folds across a hole or a spot. Make that larger, or leave it out.</source>
        <translation>Cerca de {0} el contorno inflado queda hasta a {1} del dibujo, a lo largo de {2}: el globo se pliega a través de un agujero o de un punto de soldadura. Agrándelo o suprímalo.</translation>
    </message>
    <message>
        <source>Neck that chokes the air path</source>
        <translation>Cuello que estrangula el paso del aire</translation>
    </message>
    <message>
        <source>Needed</source>
        <translation>Necesario</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nunca</translation>
    </message>
    <message>
        <source>Never cut PVC with a laser: it gives off hydrogen chloride, which is toxic and ruins the machine. Weld with high frequency or hot air. Stretches visibly: at 2 kPa the shape depends on the grade and on the pressure.</source>
        <translation>No corte nunca PVC con láser: desprende cloruro de hidrógeno, tóxico y dañino para la máquina. Suelde por alta frecuencia o con aire caliente. Se estira a simple vista: a 2 kPa la forma depende de la calidad y de la presión.</translation>
    </message>
    <message>
        <source>Never cut this film with a laser.</source>
        <translation>No corte nunca esta película con láser.</translation>
    </message>
    <message>
        <source>New bag of panels</source>
        <translation>Nueva bolsa de paneles</translation>
    </message>
    <message>
        <source>New balloon from body</source>
        <translation>Nuevo globo desde un cuerpo</translation>
    </message>
    <message>
        <source>New balloon from picture</source>
        <translation>Nuevo globo desde imagen</translation>
    </message>
    <message>
        <source>New balloon from sketch</source>
        <translation>Nuevo globo desde croquis</translation>
    </message>
    <message>
        <source>New balloons</source>
        <translation>Globos nuevos</translation>
    </message>
    <message>
        <source>New body of gores</source>
        <translation>Nuevo cuerpo de gajos</translation>
    </message>
    <message>
        <source>New, laid beside the others: {}.</source>
        <translation>Nuevas, puestas junto a las demás: {}.</translation>
    </message>
    <message>
        <source>Newmark</source>
        <translation>Newmark</translation>
    </message>
    <message>
        <source>No axis turns a {0}: leave {1} out.</source>
        <translation>Ningún eje gira esta herramienta ({0}): omita {1}.</translation>
    </message>
    <message>
        <source>No balloon came within {0} of the body's diagonal: tried were {1} panels. This is the nearest one, {2}. Ask for less, or divide the body yourself where the film stays far from it.</source>
        <translation>Ningún globo quedó a menos de {0} de la diagonal del cuerpo: se probaron {1} paneles. Este es el más cercano, con {2}. Pida menos, o divida usted el cuerpo donde la película queda lejos de él.</translation>
    </message>
    <message>
        <source>No balloon can be inflated anew without it; patterns can be changed and written.</source>
        <translation>Sin él no se puede inflar ningún globo de nuevo; los patrones se pueden cambiar y escribir.</translation>
    </message>
    <message>
        <source>No balloon has {0} and {1}: these limits exclude each other.</source>
        <translation>Ningún globo tiene {0} y {1}: estos límites se excluyen.</translation>
    </message>
    <message>
        <source>No file could be made.</source>
        <translation>No se pudo crear ningún archivo.</translation>
    </message>
    <message>
        <source>No file for {0}: {1}</source>
        <translation>Sin archivo para {0}: {1}</translation>
    </message>
    <message>
        <source>No file is like '{0}' in '{1}'. Check the pattern and the folder.</source>
        <translation>No hay ningún archivo como «{0}» en «{1}». Revise el patrón de búsqueda y la carpeta.</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Sin límite</translation>
    </message>
    <message>
        <source>No longer in the pattern, with their places: {}.</source>
        <translation>Ya no están en el patrón, con sus lugares: {}.</translation>
    </message>
    <message>
        <source>No number of panels up to {} comes so near. {} panels: about {} off</source>
        <translation>Ningún número de paneles hasta {} se acerca tanto. {} paneles: desvío de unos {}</translation>
    </message>
    <message>
        <source>No panel has an edge "{0}": choose one of an outline or face of this bag.</source>
        <translation>Ningún panel tiene un borde «{0}»: elija uno de un contorno o de una cara de esta bolsa.</translation>
    </message>
    <message>
        <source>No panel of the balloon is cut: make at least one of film.</source>
        <translation>Ningún panel del globo se corta: haga al menos uno de película.</translation>
    </message>
    <message>
        <source>No pattern can be drawn anew without it; documents keep theirs.</source>
        <translation>Sin él no se puede trazar ningún patrón de nuevo; los documentos conservan los suyos.</translation>
    </message>
    <message>
        <source>No pattern here has pieces of "{0}": choose another film.</source>
        <translation>Ningún patrón de aquí tiene piezas de «{0}»: elija otra película.</translation>
    </message>
    <message>
        <source>No process can be started beside this one ({0}).</source>
        <translation>No se puede iniciar ningún proceso junto a este ({0}).</translation>
    </message>
    <message>
        <source>No row of {0} makes sense: {1}</source>
        <translation>Ninguna fila de {0} tiene sentido: {1}</translation>
    </message>
    <message>
        <source>No seam can be drawn near {0}.</source>
        <translation>No se puede dibujar ninguna costura cerca de {0}.</translation>
    </message>
    <message>
        <source>No shape in the photograph is like the one that was expected: take it straight from the front, on a plain background without anything else in it.</source>
        <translation>Ninguna forma de la fotografía se parece a la esperada: tómela justo de frente, sobre un fondo liso y sin nada más en ella.</translation>
    </message>
    <message>
        <source>No shape stands out in the picture. Use stronger colours or a plainer background.</source>
        <translation>Ninguna forma destaca en la imagen. Use colores más vivos o un fondo más liso.</translation>
    </message>
    <message>
        <source>No size of the balloon fits a bed of {0}: weld, allowance, intake and control bar keep their sizes. Choose another machine.</source>
        <translation>Ningún tamaño del globo cabe en una cama de {0}: soldadura, margen, boca y barra conservan el suyo. Elija otra máquina.</translation>
    </message>
    <message>
        <source>No solver works here.</source>
        <translation>Aquí no funciona ningún solucionador.</translation>
    </message>
    <message>
        <source>No solver works here: {0}</source>
        <translation>Aquí no funciona ningún solucionador: {0}</translation>
    </message>
    <message>
        <source>No solver works here: {0} Build it or install the package scipy.</source>
        <translation>Aquí no funciona ningún solucionador: {0} Compílelo o instale el paquete scipy.</translation>
    </message>
    <message>
        <source>No speed and power are known for {0}, so none are written: set them in LightBurn, or give speed_mm_s and max_power_percent in a file of your machine.</source>
        <translation>No se conocen velocidad ni potencia para {0}, así que no se escriben: ajústelas en LightBurn, o indique speed_mm_s y max_power_percent en un archivo de su máquina.</translation>
    </message>
    <message>
        <source>No triangle of the mesh has an area. Save the body as a mesh of triangles.</source>
        <translation>Ningún triángulo de la malla tiene área. Guarde el cuerpo como malla de triángulos.</translation>
    </message>
    <message>
        <source>No worker of Dask can be reached at '{0}' ({1}): start a scheduler and workers, and give its address.</source>
        <translation>No se alcanza ningún worker de Dask en «{0}» ({1}): inicie un planificador y workers e indique su dirección.</translation>
    </message>
    <message>
        <source>No, use NumPy</source>
        <translation>No, usar NumPy</translation>
    </message>
    <message>
        <source>Nobody but you knows the {0} of your {1} for this film: fill in My machines in FreeCAD, or give {2}.</source>
        <translation>Solo usted conoce esto de su herramienta ({1}) para esta película: {0}. Rellénelo en Mis máquinas de FreeCAD, o indique {2}.</translation>
    </message>
    <message>
        <source>Nobody but you knows this: {}. Give one value, or several to try.</source>
        <translation>Solo usted conoce esto: {}. Indique un valor, o varios para probar.</translation>
    </message>
    <message>
        <source>Nobody states a temperature for this film. Make a test card: weld strips with several temperatures and times, peel them, keep the best.</source>
        <translation>Nadie indica una temperatura para esta película. Haga una tarjeta de prueba: suelde tiras con varias temperaturas y tiempos, pélelas, quédese con la mejor.</translation>
    </message>
    <message>
        <source>Nodes of the outline</source>
        <translation>Nodos del contorno</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>None of {0} balloons could be made: the table says why.</source>
        <translation>No se pudo hacer ninguno de {0} globos: la tabla dice por qué.</translation>
    </message>
    <message>
        <source>None of {0} balloons is within the limits; the nearest: {1}, asked for {2}.</source>
        <translation>Ninguno de {0} globos está dentro de los límites; el más cercano: {1}, se pedía {2}.</translation>
    </message>
    <message>
        <source>Not all holes are seen in the photograph: those that are not count as wrong.</source>
        <translation>No todos los agujeros se ven en la fotografía: los que no se ven cuentan como error.</translation>
    </message>
    <message>
        <source>Not possible</source>
        <translation>No es posible</translation>
    </message>
    <message>
        <source>Notch with a stress peak</source>
        <translation>Entalla con pico de tensión</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Muescas</translation>
    </message>
    <message>
        <source>Notches of {0} do not end before the weld: the allowance is {1}.</source>
        <translation>Las muescas de {0} no terminan antes de la soldadura: el margen es {1}.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Note: {0}</source>
        <translation>Nota: {0}</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Nothing can be computed without it; documents open and keep their shapes.</source>
        <translation>Sin él no se puede calcular nada; los documentos se abren y conservan sus formas.</translation>
    </message>
    <message>
        <source>Nothing here writes an MP4: choose a GIF, or install opencv-python-headless with pip.</source>
        <translation>Aquí nada escribe un MP4: elija un GIF o instale opencv-python-headless con pip.</translation>
    </message>
    <message>
        <source>Nothing strays that is called "{0}": choose of {1}.</source>
        <translation>Nada de lo que se desvía se llama «{0}»: elija entre {1}.</translation>
    </message>
    <message>
        <source>Nothing to improve.</source>
        <translation>Nada que mejorar.</translation>
    </message>
    <message>
        <source>Nothing varies in {0}: write into its first row what does, such as Width.</source>
        <translation>Nada varía en {0}: escriba en su primera fila qué se varía, por ejemplo Width.</translation>
    </message>
    <message>
        <source>Nothing varies: give "{0}" a column.</source>
        <translation>Nada varía: dé una columna a «{0}».</translation>
    </message>
    <message>
        <source>Now pick the partner of {}.</source>
        <translation>Elija ahora la pareja de {}.</translation>
    </message>
    <message>
        <source>Nowhere on the seam is room for an intake of {0}: choose a narrower one, or a place for it.</source>
        <translation>En ningún lugar de la costura cabe una boca de {0}: elija una más estrecha, o un lugar para ella.</translation>
    </message>
    <message>
        <source>Nozzle with flange</source>
        <translation>Boquilla con brida</translation>
    </message>
    <message>
        <source>NumPy computes the same, 20 to 30 times slower.</source>
        <translation>NumPy calcula lo mismo, de 20 a 30 veces más despacio.</translation>
    </message>
    <message>
        <source>NumPy took 20 to 30 times longer than the native solver, which fetch-solver fetches.</source>
        <translation>NumPy tardó de 20 a 30 veces más que el solucionador nativo, que se descarga con fetch-solver.</translation>
    </message>
    <message>
        <source>Number of panels</source>
        <translation>Número de paneles</translation>
    </message>
    <message>
        <source>Number of values, both ends among them</source>
        <translation>Número de valores, con ambos extremos</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Cifras</translation>
    </message>
    <message>
        <source>OK, then {}</source>
        <translation>Aceptar y luego {}</translation>
    </message>
    <message>
        <source>Of a card one field is kept: give --keep B3, or another one, and --name.</source>
        <translation>De una tarjeta se guarda un campo: dé --keep B3, u otro, y --name.</translation>
    </message>
    <message>
        <source>Of a symmetric outline the other side is edited, too</source>
        <translation>En un contorno simétrico se edita también el otro lado</translation>
    </message>
    <message>
        <source>Of the bodies of the mesh only the largest is made; all in all there are: {0}.</source>
        <translation>De los cuerpos de la malla solo se hace el mayor; en total hay: {0}.</translation>
    </message>
    <message>
        <source>Of the film of {0} nothing is left that is large enough to be used again.</source>
        <translation>De la película de {0} no queda nada bastante grande para volver a usarse.</translation>
    </message>
    <message>
        <source>Of the tip or wheel, 40 to 400 °C. Above 260 °C a layer of PTFE gives off poisonous fumes</source>
        <translation>De la punta o la rueda, de 40 a 400 °C. Por encima de 260 °C una capa de PTFE desprende humos tóxicos</translation>
    </message>
    <message>
        <source>Of {0}: sheet {1}.</source>
        <translation>De {0}: lámina {1}.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Desactivada</translation>
    </message>
    <message>
        <source>Off at most</source>
        <translation>Desvío máximo</translation>
    </message>
    <message>
        <source>Off it at most</source>
        <translation>Desvío máximo</translation>
    </message>
    <message>
        <source>Off on average</source>
        <translation>Desvío medio</translation>
    </message>
    <message>
        <source>Off the body</source>
        <translation>Desvío del cuerpo</translation>
    </message>
    <message>
        <source>Off the drawing</source>
        <translation>Desvío del dibujo</translation>
    </message>
    <message>
        <source>Off the drawing, profile or body on average</source>
        <translation>Desvío medio del dibujo, perfil o cuerpo</translation>
    </message>
    <message>
        <source>Off the drawing: {0} on average, at most {1}</source>
        <translation>Desvío del dibujo: {0} de media, como mucho {1}</translation>
    </message>
    <message>
        <source>Off the profile</source>
        <translation>Desvío del perfil</translation>
    </message>
    <message>
        <source>Off the {0}: {1} on average, 95 % below {2}, at most {3}</source>
        <translation>Desvío del {0}: {1} de media, 95 % por debajo de {2}, como mucho {3}</translation>
    </message>
    <message>
        <source>Offer the native solver where it is missing</source>
        <translation>Ofrecer el solucionador nativo cuando falte</translation>
    </message>
    <message>
        <source>On a symmetric body a change is repeated where its mirror image lies</source>
        <translation>En un cuerpo simétrico, un cambio se repite donde está su imagen especular</translation>
    </message>
    <message>
        <source>On the way of the valve the balloon narrows to {0} at {1}; its channel takes {2} with its welds there. Make the neck wider or put it elsewhere, else the weld closes the valve.</source>
        <translation>En el camino de la válvula el globo se estrecha a {0} en {1}; su canal ocupa ahí {2} con sus soldaduras. Ensanche el cuello o póngalo en otro lugar; si no, la soldadura cierra la válvula.</translation>
    </message>
    <message>
        <source>Once the seam is closed, turn the tail in through itself with a straw, at the mark beside the balloon, and fill through it up to the second mark. Pull the straw out: the air in the balloon presses the tail flat.</source>
        <translation>Una vez cerrada la costura, vuelva la cola hacia dentro con una pajita, en la marca junto al globo, y llene por ella hasta la segunda marca. Saque la pajita: el aire del globo aplasta la cola.</translation>
    </message>
    <message>
        <source>One large page</source>
        <translation>Una página grande</translation>
    </message>
    <message>
        <source>One-way tail</source>
        <translation>Cola antirretorno</translation>
    </message>
    <message>
        <source>Only a film with another stiffness across has a grain: give --young-across too.</source>
        <translation>Solo una película con otra rigidez transversal tiene fibra: indique también --young-across.</translation>
    </message>
    <message>
        <source>Only balloons of two equal panels are compared with a photograph: compare the panels of others one by one with --flat.</source>
        <translation>Solo los globos de dos paneles iguales se comparan con una fotografía: compare los paneles de otros uno por uno con --flat.</translation>
    </message>
    <message>
        <source>Only balloons of two equal panels are compared with a photograph: compare the panels of others one by one, with the command compare and its --flat.</source>
        <translation>Solo los globos de dos paneles iguales se comparan con una fotografía: compare los paneles de otros uno por uno, con el comando compare y su --flat.</translation>
    </message>
    <message>
        <source>Only grades of this film with a sealing layer weld: try scraps before you cut.</source>
        <translation>De esta película solo se sueldan las calidades con capa de sellado: pruebe con retales antes de cortar.</translation>
    </message>
    <message>
        <source>Only pieces that are no larger than this either way get tabs, such as 50 mm</source>
        <translation>Solo llevan puentes las piezas que no superan este tamaño en ningún sentido, por ejemplo 50 mm</translation>
    </message>
    <message>
        <source>Only the middle of the weld. A closed weld runs past its start, so that the joint is tight.</source>
        <translation>Solo el centro de la soldadura. Una soldadura cerrada pasa de su comienzo, para que la unión sea hermética.</translation>
    </message>
    <message>
        <source>Only the shape is compared, at the size that fits best</source>
        <translation>Solo se compara la forma, al tamaño que mejor encaja</translation>
    </message>
    <message>
        <source>Only {0} of film stay between two cuts near {1}; {2} wants {3}. It may tear or melt there.</source>
        <translation>Solo quedan {0} de película entre dos cortes cerca de {1}; {2} quiere {3}. Puede rasgarse o fundirse ahí.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abierto</translation>
    </message>
    <message>
        <source>Open edge: {}</source>
        <translation>Borde abierto: {}</translation>
    </message>
    <message>
        <source>Open it, do not import it. Outline, holes and notches are on cut layers, without speed and power: take them from your material library. Welds (T1) and all that is drawn (T2) are on tool layers, which LightBurn never burns.</source>
        <translation>Ábralo, no lo importe. Contorno, agujeros y muescas están en capas de corte, sin velocidad ni potencia: tómelas de su biblioteca de materiales. Las soldaduras (T1) y todo lo dibujado (T2) están en capas de herramienta, que LightBurn nunca quema.</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Abertura</translation>
    </message>
    <message>
        <source>Opposite the intake</source>
        <translation>Enfrente de la boca</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Naranja</translation>
    </message>
    <message>
        <source>Order of the seams</source>
        <translation>Orden de las costuras</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Outline edit {0} at {1} is left out. {2}</source>
        <translation>La edición {0} del contorno en {1} se omite. {2}</translation>
    </message>
    <message>
        <source>Outline edit {0} does none of {1}. {2}</source>
        <translation>La edición {0} del contorno no hace nada de {1}. {2}</translation>
    </message>
    <message>
        <source>Outline edit {0} has an 'at' that does not fit. {1}</source>
        <translation>La edición {0} del contorno tiene un 'at' que no es válido. {1}</translation>
    </message>
    <message>
        <source>Outline edit {0} has an unknown '{1}'. Use {2}.</source>
        <translation>La edición {0} del contorno tiene un '{1}' desconocido. Use {2}.</translation>
    </message>
    <message>
        <source>Outline edit {0} has no place [x, y] as its 'to', or one too many. {1}</source>
        <translation>La edición {0} del contorno no tiene un lugar [x, y] como 'to', o lo tiene de más. {1}</translation>
    </message>
    <message>
        <source>Outline edit {0}: 'mirrored' is true or false.</source>
        <translation>Edición {0} del contorno: 'mirrored' es true o false.</translation>
    </message>
    <message>
        <source>Outline {}</source>
        <translation>Contorno {}</translation>
    </message>
    <message>
        <source>Outline {}, holes: {}</source>
        <translation>Contorno {}, agujeros: {}</translation>
    </message>
    <message>
        <source>Overcut</source>
        <translation>Sobrecorte</translation>
    </message>
    <message>
        <source>PDF files, previews and labels need it; DXF, SVG and HPGL can be written.</source>
        <translation>Los archivos PDF, las vistas previas y las etiquetas lo necesitan; DXF, SVG y HPGL se pueden escribir.</translation>
    </message>
    <message>
        <source>PNG, JPEG or BMP</source>
        <translation>PNG, JPEG o BMP</translation>
    </message>
    <message>
        <source>Pa, its own range</source>
        <translation>Pa, su propio intervalo</translation>
    </message>
    <message>
        <source>Page {0} of {1}: column {2}, row {3}</source>
        <translation>Página {0} de {1}: columna {2}, fila {3}</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>Paint a balloon</source>
        <translation>Pintar un globo</translation>
    </message>
    <message>
        <source>Paint a shape first: the decoration is seen on it alone.</source>
        <translation>Pinte antes una forma: la decoración solo se ve sobre ella.</translation>
    </message>
    <message>
        <source>Paint both sides at once, mirrored (M)</source>
        <translation>Pintar ambos lados a la vez, en espejo (M)</translation>
    </message>
    <message>
        <source>Paint broad, soft strokes: what is painted becomes a balloon.</source>
        <translation>Pintar con trazos anchos y suaves: lo pintado se convierte en un globo.</translation>
    </message>
    <message>
        <source>Paint so many times around a centre ( , fewer, . more)</source>
        <translation>Pintar tantas veces alrededor de un centro ( , menos, . más)</translation>
    </message>
    <message>
        <source>Paint something first: a closed line is enough.</source>
        <translation>Pinte algo primero: basta una línea cerrada.</translation>
    </message>
    <message>
        <source>Paint what becomes the outline (D)</source>
        <translation>Pintar lo que se convierte en el contorno (D)</translation>
    </message>
    <message>
        <source>Paint what is printed on the film and leaves the outline as it is (D)</source>
        <translation>Pintar lo que se imprime en la película y deja el contorno como está (D)</translation>
    </message>
    <message>
        <source>Painted balloon</source>
        <translation>Globo pintado</translation>
    </message>
    <message>
        <source>Painted fish</source>
        <translation>Pez pintado</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel de película</translation>
    </message>
    <message>
        <source>Panel '{0}' crosses itself: divide the body otherwise there.</source>
        <translation>El panel «{0}» se cruza consigo mismo: divida ahí el cuerpo de otro modo.</translation>
    </message>
    <message>
        <source>Panel '{0}' crosses or nearly touches itself: separate the parts that meet there.</source>
        <translation>El panel «{0}» se cruza o casi se toca: separe las partes que ahí se juntan.</translation>
    </message>
    <message>
        <source>Panel '{0}' is folded over: {1} crosses or touches another edge at {2}. Separate them.</source>
        <translation>El panel «{0}» está doblado: {1} cruza o toca otro borde en {2}. Sepárelos.</translation>
    </message>
    <message>
        <source>Panel '{0}' is only {1} wide at {2}, too narrow for welds of {3} along both of its sides. Make it wider, or the welds narrower.</source>
        <translation>El panel «{0}» solo tiene {1} de ancho en {2}, demasiado estrecho para soldaduras de {3} a ambos lados. Hágalo más ancho, o las soldaduras más estrechas.</translation>
    </message>
    <message>
        <source>Panel '{0}' is seen from inside: its points run clockwise. Mirror it, or turn their order round.</source>
        <translation>El panel «{0}» se ve desde dentro: sus puntos giran en sentido horario. Refléjelo, o invierta su orden.</translation>
    </message>
    <message>
        <source>Panel '{0}' is the whole surface and has no edge: divide the body into more panels.</source>
        <translation>El panel «{0}» es toda la superficie y no tiene borde: divida el cuerpo en más paneles.</translation>
    </message>
    <message>
        <source>Panel '{0}' would cross itself when laid flat. {1}</source>
        <translation>El panel «{0}» se cruzaría consigo mismo al aplanarlo. {1}</translation>
    </message>
    <message>
        <source>Panel {0} goes round a part of the body: it is cut open there.</source>
        <translation>El panel {0} rodea una parte del cuerpo: se abre ahí con un corte.</translation>
    </message>
    <message>
        <source>Panel {0} has a triangle with a vertex that is not there. Mesh it anew.</source>
        <translation>El panel {0} tiene un triángulo con un vértice que no existe. Vuelva a mallarlo.</translation>
    </message>
    <message>
        <source>Panel {0} has a vertex without triangles. Mesh it anew.</source>
        <translation>El panel {0} tiene un vértice sin triángulos. Vuelva a mallarlo.</translation>
    </message>
    <message>
        <source>Panel {0} has an edge with more than two triangles. Mesh it anew.</source>
        <translation>El panel {0} tiene un borde con más de dos triángulos. Vuelva a mallarlo.</translation>
    </message>
    <message>
        <source>Panel {0} has no edge {1} for the opening: say another one of its outer loop.</source>
        <translation>El panel {0} no tiene un borde {1} para la abertura: indique otro de su contorno exterior.</translation>
    </message>
    <message>
        <source>Panel {0} has no room for its name: write it beside the cut when you lay it out.</source>
        <translation>El panel {0} no tiene sitio para su nombre: escríbalo junto al corte cuando lo coloque.</translation>
    </message>
    <message>
        <source>Panel {0} has no room for numbers and arrows of seams: {1}. Its notches tell them apart.</source>
        <translation>El panel {0} no tiene sitio para números y flechas de costuras: {1}. Sus muescas las distinguen.</translation>
    </message>
    <message>
        <source>Panel {0} is not cut: say another one for the opening.</source>
        <translation>El panel {0} no se corta: indique otro para la abertura.</translation>
    </message>
    <message>
        <source>Panel {0} is nowhere wider than {1}, and its welds are {2} wide: it hardly bulges. Make the balloon larger, the panel wider or the seal narrower.</source>
        <translation>El panel {0} no es en ningún sitio más ancho que {1}, y sus soldaduras tienen {2} de ancho: apenas se abomba. Haga el globo mayor, el panel más ancho o la soldadura más estrecha.</translation>
    </message>
    <message>
        <source>Panel {0} is open between its vertices {1} and {2}: the boundary is in no seam there. Seal it to another.</source>
        <translation>El panel {0} está abierto entre sus vértices {1} y {2}: el contorno no está allí en ninguna costura. Séllelo con otro.</translation>
    </message>
    <message>
        <source>Panel {0} leans by {1} between front and back. Make the side band narrower there, or the parts of the drawing wider.</source>
        <translation>El panel {0} se inclina {1} entre delante y detrás. Haga ahí la banda lateral más estrecha, o las partes del dibujo más anchas.</translation>
    </message>
    <message>
        <source>Panel {0} near {1} goes round the body and cannot be laid flat. Draw a seam across it.</source>
        <translation>El panel {0} cerca de {1} rodea el cuerpo y no se puede aplanar. Dibuje una costura a través de él.</translation>
    </message>
    <message>
        <source>Panel {0} of the JSON file has no name or no 'outer' loop. {1}</source>
        <translation>El panel {0} del archivo JSON no tiene nombre o no tiene 'outer'. {1}</translation>
    </message>
    <message>
        <source>Panel {0}: an intake of this kind leads through a seam. Say which one, or an edge of the panel such as {1}.0, or choose a nozzle.</source>
        <translation>Panel {0}: una boca de este tipo atraviesa una costura. Diga cuál, o un borde del panel como {1}.0, o elija una boquilla.</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Paneles</translation>
    </message>
    <message>
        <source>Panels and seams; a copy of them travels in the document</source>
        <translation>Paneles y costuras; una copia viaja en el documento</translation>
    </message>
    <message>
        <source>Panels are laid on the film in rows instead of closely; nothing else changes.</source>
        <translation>Los paneles se colocan en filas en vez de apretados; nada más cambia.</translation>
    </message>
    <message>
        <source>Panels laid flat: strained by {0} on average, at most {1}</source>
        <translation>Paneles aplanados: deformación de {0} de media, como mucho {1}</translation>
    </message>
    <message>
        <source>Panels with gussets, whose sizes come from a spreadsheet</source>
        <translation>Paneles con fuelles, cuyas medidas vienen de una hoja de cálculo</translation>
    </message>
    <message>
        <source>Panels: {0}, of different shapes: {1}</source>
        <translation>Paneles: {0}, de formas distintas: {1}</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Parts of the balloon may lean to one side or the other: the inflated outline is {0} to {1} from the drawing. Another width of the side band may hold them.</source>
        <translation>Partes del globo pueden inclinarse a un lado o a otro: el contorno inflado queda de {0} a {1} del dibujo. Otro ancho de la banda lateral puede sujetarlas.</translation>
    </message>
    <message>
        <source>Paste (Ctrl+V)</source>
        <translation>Pegar (Ctrl+V)</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Patrón</translation>
    </message>
    <message>
        <source>Pattern correction needs scipy: install it with pip install scipy.</source>
        <translation>La corrección del patrón necesita scipy: instálelo con pip install scipy.</translation>
    </message>
    <message>
        <source>Pattern drawn 1 : {0}</source>
        <translation>Patrón a escala 1 : {0}</translation>
    </message>
    <message>
        <source>Pattern of the balloon, all pieces</source>
        <translation>Patrón del globo, todas las piezas</translation>
    </message>
    <message>
        <source>Pattern on several pages</source>
        <translation>Patrón en varias páginas</translation>
    </message>
    <message>
        <source>Pattern written to {}</source>
        <translation>Patrón escrito en {}</translation>
    </message>
    <message>
        <source>Pattern {0} ({1} x {2} in), pages: {3}.</source>
        <translation>Patrón {0} ({1} x {2} pulgadas), páginas: {3}.</translation>
    </message>
    <message>
        <source>Pattern, cut two (one mirrored)</source>
        <translation>Patrón, cortar dos (uno reflejado)</translation>
    </message>
    <message>
        <source>Pattern, {0} panels</source>
        <translation>Patrón, {0} paneles</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Patrones</translation>
    </message>
    <message>
        <source>Patterns need shapely: install it with pip install shapely.</source>
        <translation>Los patrones necesitan shapely: instálelo con pip install shapely.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Lápiz</translation>
    </message>
    <message>
        <source>Pen drawing</source>
        <translation>Dibujo a línea</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Fotografía</translation>
    </message>
    <message>
        <source>Pick an edge to see its partner.</source>
        <translation>Elija un borde para ver su pareja.</translation>
    </message>
    <message>
        <source>Pick an edge, then its partner, here or in the 3D view. Free edges: {}</source>
        <translation>Elija un borde y luego su pareja, aquí o en la vista 3D. Bordes libres: {}</translation>
    </message>
    <message>
        <source>Pick the edge at which it is filled.</source>
        <translation>Elija el borde por el que se llena.</translation>
    </message>
    <message>
        <source>Picture (PNG)</source>
        <translation>Imagen (PNG)</translation>
    </message>
    <message>
        <source>Picture, SVG, DXF or JSON</source>
        <translation>Imagen, SVG, DXF o JSON</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Pictures are read by Qt and traced with SciPy instead, a little slower.</source>
        <translation>Las imágenes se leen con Qt y se trazan con SciPy en su lugar, algo más despacio.</translation>
    </message>
    <message>
        <source>Pictures need OpenCV or SciPy: install the package python3-opencv or python3-scipy.</source>
        <translation>Las imágenes necesitan OpenCV o SciPy: instale el paquete python3-opencv o python3-scipy.</translation>
    </message>
    <message>
        <source>Pictures need OpenCV, which is missing or does not work here. Install the package python3-opencv (or opencv-python-headless), or open the picture inside FreeCAD.</source>
        <translation>Las imágenes necesitan OpenCV, que falta o no funciona aquí. Instale el paquete python3-opencv (u opencv-python-headless) o abra la imagen dentro de FreeCAD.</translation>
    </message>
    <message>
        <source>Pictures of the work</source>
        <translation>Imágenes del trabajo</translation>
    </message>
    <message>
        <source>Pieces of the side band cannot be {0} long. Give 0 or more.</source>
        <translation>Las piezas de la banda lateral no pueden medir {0} de largo. Indique 0 o más.</translation>
    </message>
    <message>
        <source>Pieces of {0} are too short for a side band of {1}. Allow longer ones.</source>
        <translation>Piezas de {0} son demasiado cortas para una banda lateral de {1}. Permita otras más largas.</translation>
    </message>
    <message>
        <source>Pieces: {}, on {}, {} used</source>
        <translation>Piezas: {}, en {}, {} usado</translation>
    </message>
    <message>
        <source>Pipette</source>
        <translation>Cuentagotas</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Píxeles</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Place by</source>
        <translation>Situar por</translation>
    </message>
    <message>
        <source>Place on the seam</source>
        <translation>Lugar en la costura</translation>
    </message>
    <message>
        <source>Places of a seam</source>
        <translation>Puntos de una costura</translation>
    </message>
    <message>
        <source>Places on the body in mm: two for a cut, one for the chosen seam to be moved to</source>
        <translation>Lugares sobre el cuerpo en mm: dos para un corte, uno adonde mover la costura elegida</translation>
    </message>
    <message>
        <source>Plain PET does not weld to itself: take a grade with a sealing layer, or tape. The aluminium (some 50 nm) adds neither stiffness nor weight. What shops sell as Mylar balloons is mostly nylon-foil.</source>
        <translation>El PET solo no se suelda consigo mismo: tome una calidad con capa de sellado, o cinta. El aluminio (unos 50 nm) no añade rigidez ni peso. Lo que las tiendas venden como globos Mylar suele ser nylon-foil.</translation>
    </message>
    <message>
        <source>Plain paper (PDF)</source>
        <translation>Papel corriente (PDF)</translation>
    </message>
    <message>
        <source>Plain shell</source>
        <translation>Lámina simple</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Play the inflation, or stop at a frame</source>
        <translation>Reproducir el inflado o parar en un fotograma</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Representar</translation>
    </message>
    <message>
        <source>Plotter units of 0.025 mm. Pen 1 draws the control bar, pen 2 cuts the notches, pen 3 the rest. Nothing is in the file that may not be cut. For a swivel knife set its offset, 0.25 mm is common. Cuts run 1 mm past their start: set overcut_mm to 0 where the cutter does that itself.</source>
        <translation>Unidades de trazador de 0,025 mm. La pluma 1 dibuja la barra de control, la 2 corta las muescas, la 3 lo demás. En el archivo no hay nada que no se pueda cortar. Con cuchilla giratoria ajuste su desvío; 0,25 mm es lo habitual. Los cortes pasan 1 mm de su comienzo: ponga overcut_mm a 0 si la cortadora ya lo hace.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punta</translation>
    </message>
    <message>
        <source>Point {0} of the JSON file's 'profile' is not a pair of numbers. {1}</source>
        <translation>El punto {0} de 'profile' del archivo JSON no es un par de números. {1}</translation>
    </message>
    <message>
        <source>Point {0} of the JSON file's {1} is not a pair of numbers. {2}</source>
        <translation>El punto {0} de {1} del archivo JSON no es un par de números. {2}</translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation>Coeficiente de Poisson</translation>
    </message>
    <message>
        <source>Polyethylene film (LDPE), 50 µm</source>
        <translation>Película de polietileno (LDPE), 50 µm</translation>
    </message>
    <message>
        <source>Polylines at the real size with a layer and a colour for each role. CUT, CUT_INNER and NOTCH are cut, SEAL and WELD welded, all others drawn.</source>
        <translation>Polilíneas a tamaño real con una capa y un color para cada función. CUT, CUT_INNER y NOTCH se cortan, SEAL y WELD se sueldan, todo lo demás se dibuja.</translation>
    </message>
    <message>
        <source>Polylines in millimetres with a layer for each role: what every program reads. CUT, CUT_INNER and NOTCH are cut, SEAL and WELD welded, all others drawn.</source>
        <translation>Polilíneas en milímetros con una capa para cada función: lo que lee cualquier programa. CUT, CUT_INNER y NOTCH se cortan, SEAL y WELD se sueldan, todo lo demás se dibuja.</translation>
    </message>
    <message>
        <source>Pouch</source>
        <translation>Bolsa con fuelles</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Potencia</translation>
    </message>
    <message>
        <source>Predicted from the outline; not inflated yet.</source>
        <translation>Previsto a partir del contorno; aún sin inflar.</translation>
    </message>
    <message>
        <source>Press a head to sort by it.</source>
        <translation>Pulse un encabezado para ordenar por él.</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Presión</translation>
    </message>
    <message>
        <source>Pressure inside, above that outside</source>
        <translation>Presión interior, por encima de la exterior</translation>
    </message>
    <message>
        <source>Pressure rises with height</source>
        <translation>La presión crece con la altura</translation>
    </message>
    <message>
        <source>Pressure with the margin left</source>
        <translation>Presión que conserva el margen</translation>
    </message>
    <message>
        <source>Pressure: {0}</source>
        <translation>Presión: {0}</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimir</translation>
    </message>
    <message>
        <source>Print at 100 % ("actual size"). The bar below must be 100 mm long.</source>
        <translation>Imprima al 100 % («tamaño real»). La barra de abajo debe medir 100 mm.</translation>
    </message>
    <message>
        <source>Print shop (PDF with CutContour)</source>
        <translation>Imprenta (PDF con CutContour)</translation>
    </message>
    <message>
        <source>Print the pieces</source>
        <translation>Imprimir las piezas</translation>
    </message>
    <message>
        <source>Print {0} at {1} dpi, all panels</source>
        <translation>Impresión de {0} a {1} dpi, todos los paneles</translation>
    </message>
    <message>
        <source>Print {0} at {1} dpi, front and back</source>
        <translation>Impresión de {0} a {1} puntos por pulgada, frente y dorso</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Perfil</translation>
    </message>
    <message>
        <source>Pull a line; then move the pointer to bend it, and click. A right click keeps it straight.</source>
        <translation>Tire una línea; luego mueva el puntero para curvarla y haga clic. Con clic derecho queda recta.</translation>
    </message>
    <message>
        <source>Pull a rectangle to copy (Ctrl+C) or cut (Ctrl+X); without one that is all. Ctrl+V pastes.</source>
        <translation>Tire un rectángulo para copiar (Ctrl+C) o cortar (Ctrl+X); sin él vale para todo. Ctrl+V pega.</translation>
    </message>
    <message>
        <source>Pull a shape to its size, up or down to turn it; Shift keeps it upright.</source>
        <translation>Tire de una forma hasta su tamaño, hacia arriba o abajo para girarla; Mayús la mantiene derecha.</translation>
    </message>
    <message>
        <source>Pull it, its corner, or the ring that turns it. Enter paints it, Esc drops it.</source>
        <translation>Arrástrelo, o su esquina, o el anillo que lo gira. Intro lo pinta, Esc lo descarta.</translation>
    </message>
    <message>
        <source>Pull the centre of the symmetry to its place, and turn its axis by the ring</source>
        <translation>Tire del centro de la simetría hasta su lugar y gire su eje con el anillo</translation>
    </message>
    <message>
        <source>Pull the paper. The middle button, or the space bar, does it with every tool; the wheel zooms.</source>
        <translation>Mueva el papel. El botón central o la barra espaciadora lo hacen con cualquier herramienta; la rueda amplía.</translation>
    </message>
    <message>
        <source>Pull the straw out and seal straight across the neck, beside the balloon.</source>
        <translation>Saque la pajita y selle recto a través del cuello, junto al globo.</translation>
    </message>
    <message>
        <source>Push a straw in, fill, pull it out and close the neck like the seam, straight across beside the balloon.</source>
        <translation>Meta una pajita, llene, sáquela y cierre el cuello como la costura, recto a través, junto al globo.</translation>
    </message>
    <message>
        <source>Push the nozzle through the hole of the front panel from inside, put the ring over it from outside, and join flange, film and ring like the seam, along the ring's line, before the panels are joined.</source>
        <translation>Meta la boquilla desde dentro por el agujero del panel delantero, ponga el anillo encima por fuera y una brida, película y anillo como la costura, por la línea del anillo, antes de unir los paneles.</translation>
    </message>
    <message>
        <source>Put a picture on the paper, without its background</source>
        <translation>Poner una imagen en el papel, sin su fondo</translation>
    </message>
    <message>
        <source>Put outline, balloon and pattern into the document, and print the pattern</source>
        <translation>Poner contorno, globo y patrón en el documento e imprimir el patrón</translation>
    </message>
    <message>
        <source>Put the intake low</source>
        <translation>Poner la boca abajo</translation>
    </message>
    <message>
        <source>Put the same moves into the document, as objects of FreeCAD's workbench Path (CAM since 1.0), which can simulate them and write them with its post processors</source>
        <translation>Poner los mismos movimientos en el documento, como objetos del banco de trabajo Path de FreeCAD (CAM desde la 1.0), que puede simularlos y escribirlos con sus posprocesadores</translation>
    </message>
    <message>
        <source>RDWorks (Ruida laser)</source>
        <translation>RDWorks (láser Ruida)</translation>
    </message>
    <message>
        <source>Reading a mesh needs scipy: install it with pip install scipy.</source>
        <translation>Leer una malla necesita scipy: instálelo con pip install scipy.</translation>
    </message>
    <message>
        <source>Reads</source>
        <translation>Lee</translation>
    </message>
    <message>
        <source>Ready body</source>
        <translation>Cuerpo listo</translation>
    </message>
    <message>
        <source>Ready to make. Paint on, or press Make it!</source>
        <translation>Listo para hacer. Siga pintando o pulse «¡Hazlo!».</translation>
    </message>
    <message>
        <source>Real size, to cut out by hand. Print at 100 % and measure the control bar.</source>
        <translation>Tamaño real, para recortar a mano. Imprima al 100 % y mida la barra de control.</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rojo</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Y)</source>
        <translation>Rehacer (Ctrl+Y)</translation>
    </message>
    <message>
        <source>Remnant</source>
        <translation>Retal</translation>
    </message>
    <message>
        <source>Remnants</source>
        <translation>Retales</translation>
    </message>
    <message>
        <source>Remove (Del)</source>
        <translation>Quitar (Supr)</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparar</translation>
    </message>
    <message>
        <source>Repair {0} cannot be read: delete it from Repairs.</source>
        <translation>La reparación {0} no se puede leer: bórrela de «Repairs».</translation>
    </message>
    <message>
        <source>Replace the file</source>
        <translation>Reemplazar el archivo</translation>
    </message>
    <message>
        <source>Replace the files</source>
        <translation>Reemplazar los archivos</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Result that is shown as colours, with a legend</source>
        <translation>Resultado que se muestra en colores, con leyenda</translation>
    </message>
    <message>
        <source>Results cannot be written as '{0}'. Choose {1}.</source>
        <translation>Los resultados no se pueden escribir como «{0}». Elija {1}.</translation>
    </message>
    <message>
        <source>Results written to {}</source>
        <translation>Resultados escritos en {}</translation>
    </message>
    <message>
        <source>Rim</source>
        <translation>Borde</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Anillo</translation>
    </message>
    <message>
        <source>Ring that kinks where its weld creases</source>
        <translation>Anillo que se dobla donde se arruga su soldadura</translation>
    </message>
    <message>
        <source>Ring that warps</source>
        <translation>Anillo que se alabea</translation>
    </message>
    <message>
        <source>Roland with crop marks (vinyl cutter)</source>
        <translation>Roland con marcas de corte (cortador de vinilo)</translation>
    </message>
    <message>
        <source>Round pieces up to</source>
        <translation>En piezas de hasta</translation>
    </message>
    <message>
        <source>Round this hole the balloon may kink: with a weld creased to {percent} of its stiffness the outline moves by up to {length}; with one {wanted} wide, creased as much, by {less}.</source>
        <translation>Alrededor de este agujero el globo puede doblarse: con una soldadura arrugada que solo conserva el {percent} de su rigidez, el contorno se mueve hasta {length}; con una de {wanted} de ancho, igual de arrugada, {less}.</translation>
    </message>
    <message>
        <source>Round this hole the balloon will not lie flat: a closed tube wants to curve more and twists out of its plane, here by about {length}. Open the ring, or seal the hole's area without cutting it out and keep it small.</source>
        <translation>Alrededor de este agujero el globo no quedará plano: un tubo cerrado quiere curvarse más y se tuerce fuera de su plano, aquí unos {length}. Abra el anillo, o selle el área del agujero sin recortarla y manténgala pequeña.</translation>
    </message>
    <message>
        <source>Round this hole the balloon will not lie quite flat: a closed tube wants to curve more and twists out of its plane, here by about {length}.</source>
        <translation>Alrededor de este agujero el globo no quedará del todo plano: un tubo cerrado quiere curvarse más y se tuerce fuera de su plano, aquí unos {length}.</translation>
    </message>
    <message>
        <source>Round with a radius of</source>
        <translation>Redondear con un radio de</translation>
    </message>
    <message>
        <source>Row {0}: {1}</source>
        <translation>Fila {0}: {1}</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Filas</translation>
    </message>
    <message>
        <source>Rows from below: {0}</source>
        <translation>Filas desde abajo: {0}</translation>
    </message>
    <message>
        <source>Rows: {0}, of these make no sense: {1}</source>
        <translation>Filas: {0}, de ellas sin sentido: {1}</translation>
    </message>
    <message>
        <source>Rows: {0}, without a balloon: {1}</source>
        <translation>Filas: {0}, sin globo: {1}</translation>
    </message>
    <message>
        <source>S at full power</source>
        <translation>S a plena potencia</translation>
    </message>
    <message>
        <source>STL, OBJ, PLY, 3MF or STEP</source>
        <translation>STL, OBJ, PLY, 3MF o STEP</translation>
    </message>
    <message>
        <source>SVG files can be written but not read without it; pictures, DXF and JSON can be read.</source>
        <translation>Sin él los archivos SVG se pueden escribir pero no leer; imágenes, DXF y JSON sí.</translation>
    </message>
    <message>
        <source>SVG files need the Python package svgelements. Install it with 'pip install svgelements', or save the drawing as DXF.</source>
        <translation>Los archivos SVG necesitan el paquete de Python svgelements. Instálelo con «pip install svgelements» o guarde el dibujo como DXF.</translation>
    </message>
    <message>
        <source>SVG, DXF or JSON</source>
        <translation>SVG, DXF o JSON</translation>
    </message>
    <message>
        <source>Safe pressure</source>
        <translation>Presión segura</translation>
    </message>
    <message>
        <source>Safe pressure: {0}</source>
        <translation>Presión segura: {0}</translation>
    </message>
    <message>
        <source>Safe pressure: {0}, less than its {1}</source>
        <translation>Presión segura: {0}, menos que sus {1}</translation>
    </message>
    <message>
        <source>Safe to</source>
        <translation>Seguro hasta</translation>
    </message>
    <message>
        <source>Samples need scipy: install it with pip install scipy.</source>
        <translation>Las muestras necesitan scipy: instálelo con pip install scipy.</translation>
    </message>
    <message>
        <source>Samples of a {0} need scipy: install it with pip install scipy, or take {1} ones.</source>
        <translation>Las muestras de tipo {0} necesitan scipy: instálelo con pip install scipy o tome {1}.</translation>
    </message>
    <message>
        <source>Samples: {0}, of these failed: {1}, not at rest: {2}</source>
        <translation>Muestras: {0}, de ellas fallidas: {1}, sin reposo: {2}</translation>
    </message>
    <message>
        <source>Save as GIF or MP4</source>
        <translation>Guardar como GIF o MP4</translation>
    </message>
    <message>
        <source>Save files…</source>
        <translation>Guardar archivos…</translation>
    </message>
    <message>
        <source>Save results</source>
        <translation>Guardar resultados</translation>
    </message>
    <message>
        <source>Save results…</source>
        <translation>Guardar resultados…</translation>
    </message>
    <message>
        <source>Save the inflation</source>
        <translation>Guardar el inflado</translation>
    </message>
    <message>
        <source>Scale to fit</source>
        <translation>Reducir para que quepa</translation>
    </message>
    <message>
        <source>Scaled to fit: the balloon is {0} wide instead of {1}.</source>
        <translation>Reducido para que quepa: el globo mide {0} de ancho en vez de {1}.</translation>
    </message>
    <message>
        <source>Scaled to fit: the drawing is {0} wide instead of {1}.</source>
        <translation>Reducido para que quepa: el dibujo tiene {0} de ancho en vez de {1}.</translation>
    </message>
    <message>
        <source>Scaled to fit: {} wide instead of {}.</source>
        <translation>Reducido para que quepa: {} de ancho en vez de {}.</translation>
    </message>
    <message>
        <source>SciPy triangulates instead, a little slower.</source>
        <translation>En su lugar triangula SciPy, algo más despacio.</translation>
    </message>
    <message>
        <source>Seal a disc on each point where four panels or more meet.</source>
        <translation>Selle un disco sobre cada punto donde se juntan cuatro paneles o más.</translation>
    </message>
    <message>
        <source>Seal across the neck along its line, through panels and strips. The field keeps the channel open.</source>
        <translation>Selle a través del cuello por su línea, paneles y tiras juntos. El campo mantiene abierto el canal.</translation>
    </message>
    <message>
        <source>Seal the lines inside.</source>
        <translation>Selle las líneas del interior.</translation>
    </message>
    <message>
        <source>Seal the outline, {seal} wide, all but the mouth of the neck.</source>
        <translation>Selle el contorno, con {seal} de ancho, todo menos la boca del cuello.</translation>
    </message>
    <message>
        <source>Seal the outline, {seal} wide, all the way round.</source>
        <translation>Selle el contorno, con {seal} de ancho, todo alrededor.</translation>
    </message>
    <message>
        <source>Seal the seams in the order of the pictures along the dashed line, {seal} wide, from end to end.</source>
        <translation>Selle las costuras en el orden de las imágenes a lo largo de la línea discontinua, de {seal} de ancho, de extremo a extremo.</translation>
    </message>
    <message>
        <source>Seal the seams in the order of the pictures along the dashed line, {seal} wide, from end to end. Leave the mouth of the neck open.</source>
        <translation>Selle las costuras en el orden de las imágenes a lo largo de la línea discontinua, de {seal} de ancho, de extremo a extremo. Deje abierta la boca del cuello.</translation>
    </message>
    <message>
        <source>Seal width</source>
        <translation>Anchura de soldadura</translation>
    </message>
    <message>
        <source>Seal width (0: the film's)</source>
        <translation>Anchura de soldadura (0: la de la película)</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Costura</translation>
    </message>
    <message>
        <source>Seam edit {0}</source>
        <translation>Cambio de costura {0}</translation>
    </message>
    <message>
        <source>Seam length</source>
        <translation>Longitud de costura</translation>
    </message>
    <message>
        <source>Seam length: {0}</source>
        <translation>Longitud de costura: {0}</translation>
    </message>
    <message>
        <source>Seam or edge</source>
        <translation>Costura o borde</translation>
    </message>
    <message>
        <source>Seam {0} has no length: it begins and ends where {1} begins. Give two points; a whole loop is written as two seams.</source>
        <translation>La costura {0} no tiene longitud: empieza y acaba donde empieza {1}. Dé dos puntos; un contorno entero se escribe como dos costuras.</translation>
    </message>
    <message>
        <source>Seam {0} is along a panel {1}, but there are {2}.</source>
        <translation>La costura {0} recorre un panel {1}, pero hay {2}.</translation>
    </message>
    <message>
        <source>Seam {0} is along vertices that panel {1} does not have.</source>
        <translation>La costura {0} recorre vértices que el panel {1} no tiene.</translation>
    </message>
    <message>
        <source>Seam {0} is at an end that stays open: say another one for the opening.</source>
        <translation>La costura {0} está en un extremo que queda abierto: indique otra para la abertura.</translation>
    </message>
    <message>
        <source>Seam {0} is on hole {1} of panel '{2}', which has {3}. Check its sides.</source>
        <translation>La costura {0} está en el agujero {1} del panel «{2}», que tiene {3}. Revise sus lados.</translation>
    </message>
    <message>
        <source>Seam {0} is on panel {1}, but there are {2}. Check its sides.</source>
        <translation>La costura {0} está en el panel {1}, pero hay {2}. Revise sus lados.</translation>
    </message>
    <message>
        <source>Seam {0} is on point {1} of panel '{2}', whose points there are 0 to {3}. Check its sides.</source>
        <translation>La costura {0} está en el punto {1} del panel «{2}», cuyos puntos ahí son de 0 a {3}. Revise sus lados.</translation>
    </message>
    <message>
        <source>Seam {0} joins holes of panels {1} and {2}, where no intake can be: say another seam.</source>
        <translation>La costura {0} une agujeros de los paneles {1} y {2}, donde no puede haber boca: indique otra costura.</translation>
    </message>
    <message>
        <source>Seam {0} joins the outside of the film to its inside, as in a Moebius strip. Turn one of its sides round.</source>
        <translation>La costura {0} une el exterior de la película con su interior, como en una cinta de Möbius. Dé la vuelta a uno de sus lados.</translation>
    </message>
    <message>
        <source>Seam {0} joins {1} vertices to {2}. Divide both sides into equally many parts.</source>
        <translation>La costura {0} une {1} vértices con {2}. Divida ambos lados en igual número de partes.</translation>
    </message>
    <message>
        <source>Seam {0} leaves the boundary of panel {1}. Give its vertices in a row along it.</source>
        <translation>La costura {0} se sale del contorno del panel {1}. Dé sus vértices seguidos a lo largo de él.</translation>
    </message>
    <message>
        <source>Seam {0} of panels {1} is {2} long, and the intake takes {3} with its welds: make it narrower, or say another edge for the opening.</source>
        <translation>La costura {0} de los paneles {1} mide {2}, y la boca ocupa {3} con sus soldaduras: hágala más estrecha, o indique otro borde para la abertura.</translation>
    </message>
    <message>
        <source>Seam {0} of the JSON file has no two sides 'a' and 'b'. {1}</source>
        <translation>La costura {0} del archivo JSON no tiene dos lados 'a' y 'b'. {1}</translation>
    </message>
    <message>
        <source>Seam {0} of the list does none of {1}. {2}</source>
        <translation>La costura {0} de la lista no hace nada de esto: {1}. {2}</translation>
    </message>
    <message>
        <source>Seam {0} of the list has a place that is not [x, y, z]. {1}</source>
        <translation>La costura {0} de la lista tiene un lugar que no es [x, y, z]. {1}</translation>
    </message>
    <message>
        <source>Seam {0} of the list has an unknown '{1}'. Use {2}.</source>
        <translation>La costura {0} de la lista tiene un '{1}' desconocido. Use {2}.</translation>
    </message>
    <message>
        <source>Seam {0} of the list: 'side' is '{1}' or '{2}', 'mirrored' is true or false.</source>
        <translation>Costura {0} de la lista: 'side' es '{1}' o '{2}', 'mirrored' es true o false.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, last, with the opening.</source>
        <translation>Costura {0}: {1} con {2}, al final, con la abertura.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, last.</source>
        <translation>Costura {0}: {1} con {2}, al final.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, lying flat.</source>
        <translation>Costura {0}: {1} con {2}, plana.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, one edge turned round the other.</source>
        <translation>Costura {0}: {1} con {2}, un borde vuelto sobre el otro.</translation>
    </message>
    <message>
        <source>Seam {}: {}</source>
        <translation>Costura {}: {}</translation>
    </message>
    <message>
        <source>Seam {}: {}; {}</source>
        <translation>Costura {}: {}; {}</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Costuras</translation>
    </message>
    <message>
        <source>Seams and centres apart</source>
        <translation>Distancia entre costuras y centros</translation>
    </message>
    <message>
        <source>Seams and middles of gores: {0} apart at most</source>
        <translation>Costuras y centros de los gajos: como mucho a {0}</translation>
    </message>
    <message>
        <source>Seams that do not lie flat: {0}. Seal them bit by bit.</source>
        <translation>Costuras que no quedan planas: {0}. Séllelas poco a poco.</translation>
    </message>
    <message>
        <source>Seams that do not lie flat: {0}. Their allowance is cut into tabs that turn.</source>
        <translation>Costuras que no quedan planas: {0}. Su margen está cortado en pestañas que se vuelven.</translation>
    </message>
    <message>
        <source>Seams {0} and {1} hold the same piece of the boundary of panel {2}. Seal each piece once.</source>
        <translation>Las costuras {0} y {1} toman el mismo trozo del contorno del panel {2}. Selle cada trozo una vez.</translation>
    </message>
    <message>
        <source>Seams: {0}, where an edge must turn: {1}</source>
        <translation>Costuras: {0}, en las que un borde debe volverse: {1}</translation>
    </message>
    <message>
        <source>Second panel, mirrored</source>
        <translation>Segundo panel, reflejado</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Selección</translation>
    </message>
    <message>
        <source>Select a sketch of half the outline, or choose where the profile comes from.</source>
        <translation>Elija un croquis de medio contorno, o de dónde viene el perfil.</translation>
    </message>
    <message>
        <source>Select a sketch, a wire or a face in the tree or the 3D view.</source>
        <translation>Seleccione un croquis, un alambre o una cara en el árbol o en la vista 3D.</translation>
    </message>
    <message>
        <source>Select a solid or a mesh, or choose a file.</source>
        <translation>Elija un sólido o una malla, o un archivo.</translation>
    </message>
    <message>
        <source>Select all (Ctrl+A)</source>
        <translation>Seleccionar todo (Ctrl+A)</translation>
    </message>
    <message>
        <source>Select another</source>
        <translation>Elegir otro</translation>
    </message>
    <message>
        <source>Select sketches or flat faces, or take a ready body or a file.</source>
        <translation>Elija croquis o caras planas, o tome un cuerpo listo o un archivo.</translation>
    </message>
    <message>
        <source>Select sketches, wires or flat faces first.</source>
        <translation>Elija primero croquis, alambres o caras planas.</translation>
    </message>
    <message>
        <source>Self-sealing film valve</source>
        <translation>Válvula de película autosellante</translation>
    </message>
    <message>
        <source>Set X0 Y0 at the lower left corner of the film, and Z0 where the tool touches it; nothing homes. A laser wants laser mode, $32=1.</source>
        <translation>Ponga X0 Y0 en la esquina inferior izquierda de la película y Z0 donde la herramienta la toca; el archivo no busca el origen. Un láser necesita el modo láser, $32=1.</translation>
    </message>
    <message>
        <source>Set X0 Y0 at the lower left corner of the film, and Z0 where the tool touches it; nothing homes. For a swivel knife set its offset in a machine file of your own.</source>
        <translation>Ponga X0 Y0 en la esquina inferior izquierda de la película y Z0 donde la herramienta la toca; el archivo no busca el origen. Con cuchilla giratoria ajuste su desvío en un archivo de máquina propio.</translation>
    </message>
    <message>
        <source>Set the opening</source>
        <translation>Poner la abertura</translation>
    </message>
    <message>
        <source>Set up machines of your own</source>
        <translation>Configurar máquinas propias</translation>
    </message>
    <message>
        <source>Shadows on the background were taken off.</source>
        <translation>Se quitaron las sombras del fondo.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Shape that stays flat</source>
        <translation>Forma que queda plana</translation>
    </message>
    <message>
        <source>Share of the feed near corners and in narrow bends</source>
        <translation>Parte del avance cerca de las esquinas y en curvas cerradas</translation>
    </message>
    <message>
        <source>Share of the laser's full power; empty: not known yet</source>
        <translation>Parte de la potencia máxima del láser; vacío: aún no se sabe</translation>
    </message>
    <message>
        <source>Sharp or round (S)</source>
        <translation>Agudo o redondo (S)</translation>
    </message>
    <message>
        <source>Sheet length</source>
        <translation>Longitud de lámina</translation>
    </message>
    <message>
        <source>Sheet {} of {}</source>
        <translation>Lámina {} de {}</translation>
    </message>
    <message>
        <source>Show all (0)</source>
        <translation>Mostrar todo (0)</translation>
    </message>
    <message>
        <source>Show all pieces (0)</source>
        <translation>Mostrar todas las piezas (0)</translation>
    </message>
    <message>
        <source>Show the drawing and the silhouette over each other</source>
        <translation>Mostrar dibujo y silueta superpuestos</translation>
    </message>
    <message>
        <source>Show the whole paper (0)</source>
        <translation>Mostrar todo el papel (0)</translation>
    </message>
    <message>
        <source>Shown on the pieces</source>
        <translation>Se muestra en las piezas</translation>
    </message>
    <message>
        <source>Shown sheet</source>
        <translation>Lámina mostrada</translation>
    </message>
    <message>
        <source>Shown side</source>
        <translation>Cara mostrada</translation>
    </message>
    <message>
        <source>Side '{0}' of seam {1} is not the name of a panel and two points. {2}</source>
        <translation>El lado '{0}' de la costura {1} no es el nombre de un panel y dos puntos. {2}</translation>
    </message>
    <message>
        <source>Side '{0}' of seam {1} is on a panel '{2}' that is not there. {3}</source>
        <translation>El lado '{0}' de la costura {1} está en un panel «{2}» que no existe. {3}</translation>
    </message>
    <message>
        <source>Side band</source>
        <translation>Banda lateral</translation>
    </message>
    <message>
        <source>Side {0} of seam {1} runs the wrong way at {2}, which would seal the outside of the film to its inside, as in a Moebius strip: it goes {3} its loop. Swap the two points of {4}.</source>
        <translation>El lado {0} de la costura {1} va al revés en {2}, lo que soldaría el exterior de la película con su interior, como en una cinta de Möbius: va {3} su contorno. Intercambie los dos puntos de {4}.</translation>
    </message>
    <message>
        <source>Silhouette Cameo 5 Alpha from Inkscape</source>
        <translation>Silhouette Cameo 5 Alpha desde Inkscape</translation>
    </message>
    <message>
        <source>Silhouette Studio (vinyl cutter)</source>
        <translation>Silhouette Studio (cortador de vinilo)</translation>
    </message>
    <message>
        <source>Silhouette error, largest</source>
        <translation>Error de la silueta, máximo</translation>
    </message>
    <message>
        <source>Silhouette error, mean</source>
        <translation>Error de la silueta, medio</translation>
    </message>
    <message>
        <source>Silhouette from Inkscape</source>
        <translation>Silhouette desde Inkscape</translation>
    </message>
    <message>
        <source>Silhouette off the drawing</source>
        <translation>Desvío de la silueta del dibujo</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulación</translation>
    </message>
    <message>
        <source>Simulations use NumPy. "What works here" in the menu fetches the native solver later.</source>
        <translation>Las simulaciones usan NumPy. «Qué funciona aquí», en el menú, descarga más tarde el solucionador nativo.</translation>
    </message>
    <message>
        <source>Six gores from half an outline in a sketch: change their number</source>
        <translation>Seis gajos a partir de medio contorno en un croquis: cambie su número</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Size from</source>
        <translation>Tamaño según</translation>
    </message>
    <message>
        <source>Size unknown</source>
        <translation>Tamaño desconocido</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>Suavidad</translation>
    </message>
    <message>
        <source>So far it is a line. Close it, or paint an area, and it becomes a balloon.</source>
        <translation>De momento es una línea. Ciérrela o pinte una superficie y será un globo.</translation>
    </message>
    <message>
        <source>Soft PVC film, 0.2 mm</source>
        <translation>Película de PVC blando, 0,2 mm</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solucionador</translation>
    </message>
    <message>
        <source>Solver: {0}.</source>
        <translation>Solucionador: {0}.</translation>
    </message>
    <message>
        <source>Solver: {0}. {1}</source>
        <translation>Solucionador: {0}. {1}</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Separación</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Husillo</translation>
    </message>
    <message>
        <source>Split over beds</source>
        <translation>Repartir en varias camas</translation>
    </message>
    <message>
        <source>Split over beds of {0}, the pattern leaves no waste film for two crosses {1} apart by which it is laid on anew: choose a larger bed, or lay the pieces out on sheets.</source>
        <translation>Repartido en varias camas de {0}, el patrón no deja película sobrante para dos cruces separadas {1} con las que recolocarla: elija una cama mayor o coloque las piezas en láminas.</translation>
    </message>
    <message>
        <source>Spot in 16 panels</source>
        <translation>Spot en 16 paneles</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>Sello</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Estrella</translation>
    </message>
    <message>
        <source>Start values for welding: {0} ({1}).</source>
        <translation>Valores iniciales para soldar: {0} ({1}).</translation>
    </message>
    <message>
        <source>Start values, not tried on your film and tool: {start_values} ({start_sources}).</source>
        <translation>Valores iniciales, sin probar con su película y su herramienta: {start_values} ({start_sources}).</translation>
    </message>
    <message>
        <source>Stated is: {0} ({1}).</source>
        <translation>Se indica: {0} ({1}).</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pasos</translation>
    </message>
    <message>
        <source>Stiffer across the web than along it (up to 4.5 against 2.5 GPa): cut both panels in the same direction. Only grades with a sealing layer weld; the gas barrier is poor.</source>
        <translation>Más rígido a través de la banda que a lo largo (hasta 4,5 frente a 2,5 GPa): corte ambos paneles en la misma dirección. Solo se sueldan las calidades con capa de sellado; la barrera al gas es mala.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>Parar (Esc)</translation>
    </message>
    <message>
        <source>Stop and keep the last result</source>
        <translation>Parar y conservar el último resultado</translation>
    </message>
    <message>
        <source>Stopped. Your painting is still here.</source>
        <translation>Detenido. Su pintura sigue ahí.</translation>
    </message>
    <message>
        <source>Stopping ...</source>
        <translation>Deteniendo ...</translation>
    </message>
    <message>
        <source>Straight from the front, from far away, on a plain background of another colour</source>
        <translation>Justo de frente, desde lejos, sobre un fondo liso de otro color</translation>
    </message>
    <message>
        <source>Straw neck</source>
        <translation>Cuello para pajita</translation>
    </message>
    <message>
        <source>Stretch of the film: {0}</source>
        <translation>Estiramiento de la película: {0}</translation>
    </message>
    <message>
        <source>Strips</source>
        <translation>Tiras</translation>
    </message>
    <message>
        <source>Strips welded together</source>
        <translation>Tiras soldadas entre sí</translation>
    </message>
    <message>
        <source>Studies on Dask need {0}: install it with pip install {1}, or leave --dask and --scheduler out ({2}).</source>
        <translation>Los estudios en Dask necesitan {0}: instálelo con pip install {1} u omita --dask y --scheduler ({2}).</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Such as Tip for PE</source>
        <translation>Por ejemplo, Punta para PE</translation>
    </message>
    <message>
        <source>Summa with OPOS (vinyl cutter)</source>
        <translation>Summa con OPOS (cortador de vinilo)</translation>
    </message>
    <message>
        <source>Summa with OPOS XY (vinyl cutter)</source>
        <translation>Summa con OPOS XY (cortador de vinilo)</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simetría</translation>
    </message>
    <message>
        <source>TPU-coated nylon fabric (70 den), 170 g/m²</source>
        <translation>Tejido de nailon recubierto de TPU (70 den), 170 g/m²</translation>
    </message>
    <message>
        <source>Tab to tie it to</source>
        <translation>Lengüeta para atar</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Puentes</translation>
    </message>
    <message>
        <source>Tabs are left by a machine that cuts: give --machine too, and one that does.</source>
        <translation>Los puentes los deja una máquina que corta: indique también --machine, y una que lo haga.</translation>
    </message>
    <message>
        <source>Tacked to one panel</source>
        <translation>Fijadas a un panel</translation>
    </message>
    <message>
        <source>Take a colour from the painting, or the picture under it</source>
        <translation>Tomar un color de la pintura, o de la imagen que está debajo</translation>
    </message>
    <message>
        <source>Take a tool to change the seams, or choose one and press Delete to merge.</source>
        <translation>Elija una herramienta para cambiar las costuras, o elija una costura y pulse Supr para unir.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Take everything off the paper</source>
        <translation>Quitar todo del papel</translation>
    </message>
    <message>
        <source>Take paint off</source>
        <translation>Quitar pintura</translation>
    </message>
    <message>
        <source>Take seam apart</source>
        <translation>Deshacer costura</translation>
    </message>
    <message>
        <source>Take the last change of a seam back (Ctrl+Z in the 3D view)</source>
        <translation>Deshacer el último cambio de una costura (Ctrl+Z en la vista 3D)</translation>
    </message>
    <message>
        <source>Take the numbers of one of FreeCAD's material cards</source>
        <translation>Tomar los números de una ficha de material de FreeCAD</translation>
    </message>
    <message>
        <source>Take the picture away</source>
        <translation>Quitar la imagen</translation>
    </message>
    <message>
        <source>Take this row</source>
        <translation>Tomar esta fila</translation>
    </message>
    <message>
        <source>Take what is selected</source>
        <translation>Tomar lo seleccionado</translation>
    </message>
    <message>
        <source>Take {0} gores.</source>
        <translation>Tome {0} gajos.</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Cinta</translation>
    </message>
    <message>
        <source>Tape along the dashed line, {seal} wide, all the way round.</source>
        <translation>Pegue cinta a lo largo de la línea discontinua, con {seal} de ancho, todo alrededor.</translation>
    </message>
    <message>
        <source>Tape along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>Pegue cinta a lo largo de la línea discontinua, con {seal} de ancho; deje abierta la boca del cuello.</translation>
    </message>
    <message>
        <source>Taped seam</source>
        <translation>Costura con cinta</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cuerpo objetivo</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatura</translation>
    </message>
    <message>
        <source>Temperatures need scipy: install it with pip install scipy.</source>
        <translation>Las temperaturas necesitan scipy: instálelo con pip install scipy.</translation>
    </message>
    <message>
        <source>Tension field</source>
        <translation>Campo de tensión</translation>
    </message>
    <message>
        <source>Test card</source>
        <translation>Tarjeta de prueba</translation>
    </message>
    <message>
        <source>Test card written to {}</source>
        <translation>Tarjeta de prueba escrita en {}</translation>
    </message>
    <message>
        <source>Test cards</source>
        <translation>Tarjetas de prueba</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>That of the front</source>
        <translation>La del frente</translation>
    </message>
    <message>
        <source>That of the outline</source>
        <translation>La del contorno</translation>
    </message>
    <message>
        <source>That of the page</source>
        <translation>El de la página</translation>
    </message>
    <message>
        <source>That wide</source>
        <translation>Esta anchura</translation>
    </message>
    <message>
        <source>That would take {0} pages: choose larger paper or a smaller balloon.</source>
        <translation>Serían {0} páginas: elija papel más grande o un globo más pequeño.</translation>
    </message>
    <message>
        <source>The "as_made" of the film {0} cannot be read: delete it from the file.</source>
        <translation>El «as_made» de la película {0} no se puede leer: bórrelo del archivo.</translation>
    </message>
    <message>
        <source>The 'at' of seam {0} of the list is no list of places. {1}</source>
        <translation>El 'at' de la costura {0} de la lista no es una lista de lugares. {1}</translation>
    </message>
    <message>
        <source>The 'cut' of panel '{0}' is neither true nor false. Write one of them.</source>
        <translation>El 'cut' del panel «{0}» no es true ni false. Escriba uno de ellos.</translation>
    </message>
    <message>
        <source>The 'ease' of the JSON file is no part of a length. Give a number from 0 to 1.</source>
        <translation>El 'ease' del archivo JSON no es parte de una longitud. Dé un número de 0 a 1.</translation>
    </message>
    <message>
        <source>The 'holes' of panel '{0}' are not a list of loops. {1}</source>
        <translation>Los 'holes' del panel «{0}» no son una lista de contornos. {1}</translation>
    </message>
    <message>
        <source>The 'natural_shape' of the JSON file is no length. Give the length of its gores.</source>
        <translation>La 'natural_shape' del archivo JSON no es una longitud. Dé la longitud de sus gajos.</translation>
    </message>
    <message>
        <source>The 'opening' of the JSON file has no panel and point. {0}</source>
        <translation>La 'opening' del archivo JSON no tiene panel ni punto. {0}</translation>
    </message>
    <message>
        <source>The 'panels' of seam {0} of the list are no names. {1}</source>
        <translation>Los 'panels' de la costura {0} de la lista no son nombres. {1}</translation>
    </message>
    <message>
        <source>The 'parts' of the JSON file are not a list of shapes. {0}</source>
        <translation>'parts' del archivo JSON no es una lista de formas. {0}</translation>
    </message>
    <message>
        <source>The 'profile' of the JSON file needs at least two points. {0}</source>
        <translation>El 'profile' del archivo JSON necesita al menos dos puntos. {0}</translation>
    </message>
    <message>
        <source>The '{0}' of the JSON file are not a list of {1}. {2}</source>
        <translation>'{0}' del archivo JSON no es una lista de {1}. {2}</translation>
    </message>
    <message>
        <source>The '{0}' of the body '{1}' is out of range. Choose {2}.</source>
        <translation>El '{0}' del cuerpo «{1}» está fuera de rango. Elija {2}.</translation>
    </message>
    <message>
        <source>The 3MF file has more than {0} bodies. Leave one of them in it.</source>
        <translation>El archivo 3MF tiene más de {0} cuerpos. Deje uno de ellos.</translation>
    </message>
    <message>
        <source>The 3MF file has no bodies. Save the body as a mesh of triangles.</source>
        <translation>El archivo 3MF no tiene cuerpos. Guarde el cuerpo como malla de triángulos.</translation>
    </message>
    <message>
        <source>The 3MF file is damaged ({}). Save it once more.</source>
        <translation>El archivo 3MF está dañado ({}). Guárdelo de nuevo.</translation>
    </message>
    <message>
        <source>The 3MF file is too large. Simplify the mesh in the program it comes from.</source>
        <translation>El archivo 3MF es demasiado grande. Simplifique la malla en el programa del que viene.</translation>
    </message>
    <message>
        <source>The DXF file has errors; what could be read was taken from it.</source>
        <translation>El archivo DXF tiene errores; se tomó de él lo que se pudo leer.</translation>
    </message>
    <message>
        <source>The DXF file {0}; millimetres are assumed.</source>
        <translation>El archivo DXF {0}; se suponen milímetros.</translation>
    </message>
    <message>
        <source>The G-code turns the tool by {0}. FreeCAD takes that axis for one that turns the work: its 3D view shows the path turned.</source>
        <translation>El código G gira la herramienta con {0}. FreeCAD toma ese eje por uno que gira la pieza de trabajo: su vista 3D muestra la trayectoria girada.</translation>
    </message>
    <message>
        <source>The JSON file cannot be read ({0}). {1}</source>
        <translation>El archivo JSON no se puede leer ({0}). {1}</translation>
    </message>
    <message>
        <source>The JSON file does not name its unit; millimetres are assumed.</source>
        <translation>El archivo JSON no indica su unidad; se suponen milímetros.</translation>
    </message>
    <message>
        <source>The JSON file has no 'outer' loop. {0}</source>
        <translation>El archivo JSON no tiene el lazo 'outer'. {0}</translation>
    </message>
    <message>
        <source>The JSON file has no list of 'panels'. {0}</source>
        <translation>El archivo JSON no tiene una lista 'panels'. {0}</translation>
    </message>
    <message>
        <source>The JSON file has no list of 'seams'. {0}</source>
        <translation>El archivo JSON no tiene una lista 'seams'. {0}</translation>
    </message>
    <message>
        <source>The JSON file has the unknown unit {0}. Use one of {1}.</source>
        <translation>El archivo JSON tiene la unidad desconocida {0}. Use una de {1}.</translation>
    </message>
    <message>
        <source>The JSON file's {0} needs at least {1}. {2}</source>
        <translation>{0} del archivo JSON necesita al menos {1}. {2}</translation>
    </message>
    <message>
        <source>The OBJ file has a face that is no list of points. Save it once more.</source>
        <translation>El archivo OBJ tiene una cara que no es una lista de puntos. Guárdelo de nuevo.</translation>
    </message>
    <message>
        <source>The OBJ file has no faces. Save the body as a mesh of triangles.</source>
        <translation>El archivo OBJ no tiene caras. Guarde el cuerpo como malla de triángulos.</translation>
    </message>
    <message>
        <source>The PLY file has no faces. Save the body as a mesh of triangles.</source>
        <translation>El archivo PLY no tiene caras. Guarde el cuerpo como malla de triángulos.</translation>
    </message>
    <message>
        <source>The PLY file is damaged: {} Save it once more.</source>
        <translation>El archivo PLY está dañado: {} Guárdelo de nuevo.</translation>
    </message>
    <message>
        <source>The Poisson's ratio {0} is not between 0 and 0.5: give one such as 0.38.</source>
        <translation>El coeficiente de Poisson {0} no está entre 0 y 0,5: indique por ejemplo 0.38.</translation>
    </message>
    <message>
        <source>The Python package {0} is missing. {1} To get it: pip install {2}</source>
        <translation>Falta el paquete de Python {0}. {1} Para obtenerlo: pip install {2}</translation>
    </message>
    <message>
        <source>The STL file is damaged, as it ends too early, or no STL file at all. Save it once more.</source>
        <translation>El archivo STL está dañado, porque acaba demasiado pronto, o no es un archivo STL. Guárdelo de nuevo.</translation>
    </message>
    <message>
        <source>The STL file is damaged: it has no triangles, or half of one. Save it once more.</source>
        <translation>El archivo STL está dañado: no tiene triángulos, o le falta parte de uno. Guárdelo de nuevo.</translation>
    </message>
    <message>
        <source>The SVG file cannot be read ({0}). Save it as plain SVG once more.</source>
        <translation>El archivo SVG no se puede leer ({0}). Guárdelo de nuevo como SVG simple.</translation>
    </message>
    <message>
        <source>The SVG file defines entities, which are not read. Save it as plain SVG.</source>
        <translation>El archivo SVG define entidades, que no se leen. Guárdelo como SVG simple.</translation>
    </message>
    <message>
        <source>The SVG file has a '{0}' of endless length. Save it as plain SVG once more.</source>
        <translation>El archivo SVG tiene un «{0}» de longitud infinita. Guárdelo de nuevo como SVG simple.</translation>
    </message>
    <message>
        <source>The SVG file has too many attributes. Save it as plain SVG once more.</source>
        <translation>El archivo SVG tiene demasiados atributos. Guárdelo de nuevo como SVG simple.</translation>
    </message>
    <message>
        <source>The SVG file has too many styles. Save it as plain SVG once more.</source>
        <translation>El archivo SVG tiene demasiados estilos. Guárdelo de nuevo como SVG simple.</translation>
    </message>
    <message>
        <source>The SVG file is damaged ({0}). Save it once more.</source>
        <translation>El archivo SVG está dañado ({0}). Guárdelo de nuevo.</translation>
    </message>
    <message>
        <source>The Young's modulus across the grain {0} is too large for one along it of {1}: turn the grain by 90 degrees and exchange the two.</source>
        <translation>El módulo de Young transversal {0} es demasiado grande para el longitudinal de {1}: gire la fibra 90 grados e intercambie los dos.</translation>
    </message>
    <message>
        <source>The accuracy decides the number of panels: give one of them.</source>
        <translation>La precisión decide el número de paneles: indique solo una de las dos cosas.</translation>
    </message>
    <message>
        <source>The accuracy must be above 0 and below 1: 0.003 is within 0.3 % of the diagonal.</source>
        <translation>La precisión debe estar por encima de 0 y por debajo de 1: 0.003 es dentro del 0.3 % de la diagonal.</translation>
    </message>
    <message>
        <source>The accuracy must be above 0 and below 1: 0.01 is within 1 % of the profile.</source>
        <translation>La precisión debe estar por encima de 0 y por debajo de 1: 0.01 es dentro del 1 % del perfil.</translation>
    </message>
    <message>
        <source>The altitude {0} m is out of range: give one up to 11000 m.</source>
        <translation>La altitud {0} m está fuera de rango: indique hasta 11000 m.</translation>
    </message>
    <message>
        <source>The axis that turns the wheel or knife along the path, 0 along X, counter-clockwise from above; none for one that swivels or is round</source>
        <translation>El eje que gira la rueda o la cuchilla según la trayectoria, 0 a lo largo de X, en sentido antihorario desde arriba; ninguno si pivota por sí sola o es redonda</translation>
    </message>
    <message>
        <source>The bag has no opening through which it is filled. Name the edge at which it stays open, such as edge 1 of panel '{0}', or make it without an intake.</source>
        <translation>La bolsa no tiene abertura por la que se llene. Nombre el borde donde queda abierta, como el borde 1 del panel «{0}», o hágala sin boca.</translation>
    </message>
    <message>
        <source>The bag has {0} panels, more than {1}. Make it of fewer, larger ones.</source>
        <translation>La bolsa tiene {0} paneles, más de {1}. Hágala de menos paneles y mayores.</translation>
    </message>
    <message>
        <source>The balloon</source>
        <translation>El globo</translation>
    </message>
    <message>
        <source>The balloon has no opening: say at which edge it is filled, or choose no intake.</source>
        <translation>El globo no tiene abertura: diga por qué borde se llena, o elija ninguna boca.</translation>
    </message>
    <message>
        <source>The balloon has nothing that is called '{0}': {1}.</source>
        <translation>El globo no tiene nada que se llame «{0}»: {1}.</translation>
    </message>
    <message>
        <source>The balloon has parts too thin to fit the film with: use a wider shape.</source>
        <translation>El globo tiene partes demasiado finas para ajustar con ellas la película: use una forma más ancha.</translation>
    </message>
    <message>
        <source>The balloon is not near rest. Inflate it anew.</source>
        <translation>El globo no está cerca del reposo. Ínflelo de nuevo.</translation>
    </message>
    <message>
        <source>The balloon is nowhere {0} wide behind its intake: choose another intake angle or a narrower intake, else air enters slowly.</source>
        <translation>El globo no tiene en ninguna parte {0} de ancho tras su boca: elija otra dirección o una boca más estrecha; si no, el aire entra despacio.</translation>
    </message>
    <message>
        <source>The balloon must be thicker than 0, not {0}. Give its thickness.</source>
        <translation>El globo debe ser más grueso que 0, no {0}. Indique su espesor.</translation>
    </message>
    <message>
        <source>The balloon of {0} gores is {1} of its diagonal away from the profile on average, and {2} was asked for: its seams stand out by up to {3} over the middle of the gores. {4}</source>
        <translation>El globo de {0} gajos queda de media a {1} de su diagonal del perfil, y se pedía {2}: sus costuras sobresalen hasta {3} del centro de los gajos. {4}</translation>
    </message>
    <message>
        <source>The balloon stays {0} from the body on average, {1} of its diagonal: flat panels bulge between their seams. Take more than {2} panels.</source>
        <translation>El globo queda a {0} del cuerpo de media, {1} de su diagonal: los paneles planos se abomban entre sus costuras. Tome más de {2} paneles.</translation>
    </message>
    <message>
        <source>The balloon whose weld creases did not come to rest; what is told of it is its last good state.</source>
        <translation>El globo cuya soldadura se arruga no llegó al reposo; lo que se dice de él vale para su último buen estado.</translation>
    </message>
    <message>
        <source>The bar of {0} does not fit between marks that are {1} apart: make the balloon larger, or print several beside each other.</source>
        <translation>La barra de {0} no cabe entre marcas separadas {1}: haga el globo mayor o imprima varios uno al lado de otro.</translation>
    </message>
    <message>
        <source>The bending floor must be between 0 and 1, not {0}. Usual is {1}.</source>
        <translation>El límite inferior de flexión debe estar entre 0 y 1, no {0}. Lo habitual es {1}.</translation>
    </message>
    <message>
        <source>The bleed must be from 0 to {0}, not {1}.</source>
        <translation>El sangrado debe ser de 0 a {0}, no {1}.</translation>
    </message>
    <message>
        <source>The body '{0}' has no '{1}'. It has {2}.</source>
        <translation>El cuerpo «{0}» no tiene '{1}'. Tiene {2}.</translation>
    </message>
    <message>
        <source>The body has no plane of symmetry.</source>
        <translation>El cuerpo no tiene ningún plano de simetría.</translation>
    </message>
    <message>
        <source>The body has no seam. Draw seams, or take 2 panels or more.</source>
        <translation>El cuerpo no tiene costuras. Dibuje costuras, o tome 2 paneles o más.</translation>
    </message>
    <message>
        <source>The body has no seam. Draw seams, or take 2 panels or more.{0}</source>
        <translation>El cuerpo no tiene costuras. Dibuje costuras, o tome 2 paneles o más.{0}</translation>
    </message>
    <message>
        <source>The body has nothing near {0}. Give a place on its surface.</source>
        <translation>El cuerpo no tiene nada cerca de {0}. Indique un lugar de su superficie.</translation>
    </message>
    <message>
        <source>The body is thinner than {0} over {1} of its surface: film bulges there. Make such parts of two panels of their own, or thicker.</source>
        <translation>El cuerpo es más delgado que {0} en {1} de su superficie: la película se abomba allí. Haga esas partes con dos paneles propios, o más gruesas.</translation>
    </message>
    <message>
        <source>The body is {0} long. Give a width or a height, so that it is between {1} and {2}.</source>
        <translation>El cuerpo mide {0} de largo. Indique una anchura o una altura, para que quede entre {1} y {2}.</translation>
    </message>
    <message>
        <source>The body of the mesh is flat: it encloses {0} % of its size. Give a closed body, or a drawing for two equal panels.</source>
        <translation>El cuerpo de la malla es plano: encierra el {0} % de su tamaño. Dé un cuerpo cerrado, o un dibujo para dos paneles iguales.</translation>
    </message>
    <message>
        <source>The body of the profile is {0} high and {1} wide: no balloon is so flat. Draw its profile higher, or make it of two panels.</source>
        <translation>El cuerpo del perfil mide {0} de alto y {1} de ancho: ningún globo es tan plano. Dibuje su perfil más alto, o hágalo de dos paneles.</translation>
    </message>
    <message>
        <source>The camera finds the dots round a print, on the layer Register; the fifth tells how the sheet lies. The layer Register is not cut.</source>
        <translation>La cámara encuentra los puntos alrededor de una impresión, en la capa Register; el quinto dice cómo está puesta la lámina. La capa Register no se corta.</translation>
    </message>
    <message>
        <source>The caps are too large for the ball. Choose a smaller diameter for them.</source>
        <translation>Los casquetes son demasiado grandes para la pelota. Elija un diámetro menor para ellos.</translation>
    </message>
    <message>
        <source>The card has no field {0}: choose one of {1}.</source>
        <translation>La tarjeta no tiene ningún campo {0}: elija uno de {1}.</translation>
    </message>
    <message>
        <source>The cluster cannot be made ({0}): check the file that --cluster names.</source>
        <translation>No se puede crear el clúster ({0}): revise el archivo que indica --cluster.</translation>
    </message>
    <message>
        <source>The colour would run out: close the line around this place first.</source>
        <translation>El color se saldría: cierre primero la línea alrededor de este lugar.</translation>
    </message>
    <message>
        <source>The connection to {0} ended before the whole native solver had come. Try again. {1}</source>
        <translation>La conexión con {0} terminó antes de que llegara el solucionador nativo entero. Inténtelo de nuevo. {1}</translation>
    </message>
    <message>
        <source>The copied picture</source>
        <translation>La imagen copiada</translation>
    </message>
    <message>
        <source>The cutter finds the four discs round a print itself. VersaWorks prints discs of its own: give it the PDF for print and cut instead. The layer REGISTRATION is not cut.</source>
        <translation>La cortadora encuentra sola los cuatro discos alrededor de una impresión. VersaWorks imprime discos propios: dele en su lugar el PDF para imprimir y cortar. La capa REGISTRATION no se corta.</translation>
    </message>
    <message>
        <source>The cutter finds the squares at both sides of a print itself, on the layer Regmark, which is not cut. Set their size of 3 mm and their distances there, where its program does not read them. Feed the sheet with its lower edge first.</source>
        <translation>La cortadora encuentra sola los cuadrados a ambos lados de una impresión, en la capa Regmark, que no se corta. Ponga allí su tamaño de 3 mm y sus distancias, si su programa no los lee. Meta la lámina con el borde inferior por delante.</translation>
    </message>
    <message>
        <source>The drawing cannot be reached everywhere: the silhouette is up to {} off it.</source>
        <translation>El dibujo no se puede alcanzar en todas partes: la silueta se desvía hasta {}.</translation>
    </message>
    <message>
        <source>The drawing has a curve through more than {0} points. Save it as a polyline.</source>
        <translation>El dibujo tiene una curva por más de {0} puntos. Guárdela como polilínea.</translation>
    </message>
    <message>
        <source>The drawing has blocks or copies that show themselves. Remove those from it.</source>
        <translation>El dibujo tiene bloques o copias que se muestran a sí mismos. Quítelos.</translation>
    </message>
    <message>
        <source>The drawing has more than {0} elements, with those of its blocks and copies. Leave only the outline and its holes in it.</source>
        <translation>El dibujo tiene más de {0} elementos, con los de sus bloques y copias. Deje solo el contorno y sus agujeros.</translation>
    </message>
    <message>
        <source>The drawing has more than {0} groups or blocks inside each other. Take them apart in the program it comes from.</source>
        <translation>El dibujo tiene más de {0} grupos o bloques unos dentro de otros. Sepárelos en el programa del que procede.</translation>
    </message>
    <message>
        <source>The drawing has more than {0} points. Simplify it in the program it comes from, or leave only the outline and its holes in it.</source>
        <translation>El dibujo tiene más de {0} puntos. Simplifíquelo en el programa del que procede o deje solo el contorno y sus agujeros.</translation>
    </message>
    <message>
        <source>The drawing has no closed line. Draw one, and turn texts and groups into paths.</source>
        <translation>El dibujo no tiene ninguna línea cerrada. Dibuje una y convierta textos y grupos en trazos.</translation>
    </message>
    <message>
        <source>The drawing has no line. {0}</source>
        <translation>El dibujo no tiene ninguna línea. {0}</translation>
    </message>
    <message>
        <source>The drawing has points more than {0} km from its origin. Move it there, and give it a size between 1 mm and 100 m.</source>
        <translation>El dibujo tiene puntos a más de {0} km de su origen. Muévalo allí y dele un tamaño de 1 mm a 100 m.</translation>
    </message>
    <message>
        <source>The drawing has too much text in its styles and transforms. Save it as plain SVG once more.</source>
        <translation>El dibujo tiene demasiado texto en sus estilos y transformaciones. Guárdelo de nuevo como SVG simple.</translation>
    </message>
    <message>
        <source>The drawing has {0} lines beside the axis, not one. {1}</source>
        <translation>El dibujo tiene {0} líneas junto al eje, no una. {1}</translation>
    </message>
    <message>
        <source>The drawing has {0} shape and no number {1}: choose another Part, or delete this balloon.</source>
        <translation>El dibujo tiene {0} forma y ningún número {1}: elija otra «Part» o borre este globo.</translation>
    </message>
    <message>
        <source>The drawing has {0} shapes and no number {1}: choose another Part, or delete this balloon.</source>
        <translation>El dibujo tiene {0} formas y ningún número {1}: elija otra «Part» o borre este globo.</translation>
    </message>
    <message>
        <source>The drawing is open: a line starts at {0} and ends {1} away at {2}. Close it.</source>
        <translation>El dibujo está abierto: una línea empieza en {0} y termina a {1}, en {2}. Ciérrela.</translation>
    </message>
    <message>
        <source>The drawing takes more than {0} s to read. Simplify it in the program it comes from, or leave only the outline and its holes in it.</source>
        <translation>El dibujo tarda más de {0} s en leerse. Simplifíquelo en el programa del que procede o deje solo el contorno y sus agujeros.</translation>
    </message>
    <message>
        <source>The drawing was made symmetric: its halves were {0} apart, the left one was kept.</source>
        <translation>El dibujo se hizo simétrico: sus mitades diferían {0}, se conservó la izquierda.</translation>
    </message>
    <message>
        <source>The drawing would be smaller than {0}: choose a larger lift.</source>
        <translation>El dibujo sería menor que {0}: elija una sustentación mayor.</translation>
    </message>
    <message>
        <source>The drawing; a copy of it travels in the document</source>
        <translation>El dibujo; una copia viaja en el documento</translation>
    </message>
    <message>
        <source>The edges of the chosen seam are free again</source>
        <translation>Los bordes de la costura elegida vuelven a estar libres</translation>
    </message>
    <message>
        <source>The end of a seam cannot be moved alone. Take hold of the seam between its ends.</source>
        <translation>El extremo de una costura no se puede mover solo. Tome la costura entre sus extremos.</translation>
    </message>
    <message>
        <source>The error of {0} is of the whole contour: leave "along" out.</source>
        <translation>El error de {0} es de todo el contorno: omita «along».</translation>
    </message>
    <message>
        <source>The error of {0} is per {1}: write "{2}" or "{3}".</source>
        <translation>El error de {0} es por {1}: escriba «{2}» o «{3}».</translation>
    </message>
    <message>
        <source>The faces of {0} cannot be told from each other in a mesh. Repair the solid, or give a mesh of it.</source>
        <translation>Las caras de {0} no se pueden distinguir entre sí en una malla. Repare el sólido, o dé una malla de él.</translation>
    </message>
    <message>
        <source>The field {0} of this card makes no machine: {1}</source>
        <translation>El campo {0} de esta tarjeta no da una máquina: {1}</translation>
    </message>
    <message>
        <source>The file does not name its unit: the largest size in it, {0}, is taken as metres. Give a width to have another one.</source>
        <translation>El archivo no indica su unidad: su mayor medida, {0}, se toma en metros. Indique una anchura para tener otra.</translation>
    </message>
    <message>
        <source>The file has no solid that can be read. Save it once more as STEP.</source>
        <translation>El archivo no tiene ningún sólido que se pueda leer. Guárdelo de nuevo como STEP.</translation>
    </message>
    <message>
        <source>The file is XML but no SVG drawing. Choose a drawing.</source>
        <translation>El archivo es XML pero no un dibujo SVG. Elija un dibujo.</translation>
    </message>
    <message>
        <source>The file is damaged or not a DXF file. Save it once more.</source>
        <translation>El archivo está dañado o no es un archivo DXF. Guárdelo de nuevo.</translation>
    </message>
    <message>
        <source>The file of gases {0} is of no use: {1}. Install it anew.</source>
        <translation>El archivo de gases {0} no sirve: {1}. Instálelo de nuevo.</translation>
    </message>
    <message>
        <source>The file of rules {0} is of no use: {1}. Install it anew.</source>
        <translation>El archivo de reglas {0} no sirve: {1}. Instálelo de nuevo.</translation>
    </message>
    <message>
        <source>The file of the pattern</source>
        <translation>Los archivos de los patrones</translation>
    </message>
    <message>
        <source>The file of what is left of another layout: pieces are laid inside it first</source>
        <translation>El archivo de lo que queda de otra colocación: las piezas se colocan primero dentro de él</translation>
    </message>
    <message>
        <source>The file test-card.json that was written with the card</source>
        <translation>El archivo test-card.json que se escribió con la tarjeta</translation>
    </message>
    <message>
        <source>The file {0} is of no use: {1}. Install it anew.</source>
        <translation>El archivo {0} no sirve: {1}. Instálelo de nuevo.</translation>
    </message>
    <message>
        <source>The files that it, or its program, opens</source>
        <translation>Los archivos que abre ella, o su programa</translation>
    </message>
    <message>
        <source>The film '{0}' has no mass. Give its areal density.</source>
        <translation>La película «{0}» no tiene masa. Indique su densidad superficial.</translation>
    </message>
    <message>
        <source>The film came to rest</source>
        <translation>La película llegó al reposo</translation>
    </message>
    <message>
        <source>The film comes as near as {0} to the body, and a margin of {1} was asked for. Take more panels, or a larger margin.</source>
        <translation>La película se acerca hasta {0} al cuerpo y se pidió un margen de {1}. Tome más paneles o un margen mayor.</translation>
    </message>
    <message>
        <source>The film did not come to rest: its numbers are estimates.</source>
        <translation>La película no llegó al reposo: sus números son estimaciones.</translation>
    </message>
    <message>
        <source>The film file {0} calls itself "{1}": give both the same name.</source>
        <translation>El archivo de película {0} se llama a sí mismo «{1}»: dé a ambos el mismo nombre.</translation>
    </message>
    <message>
        <source>The film file {0} is of no use: {1}</source>
        <translation>El archivo de película {0} no sirve: {1}</translation>
    </message>
    <message>
        <source>The film file {0} lacks {1}: add it.</source>
        <translation>Al archivo de película {0} le falta {1}: añádalo.</translation>
    </message>
    <message>
        <source>The film folds up and nothing of it is seen from above: make the shape thicker.</source>
        <translation>La película se pliega y desde arriba no se ve nada de ella: haga la forma más gruesa.</translation>
    </message>
    <message>
        <source>The film lies from {0} to {1} outside of the body</source>
        <translation>La película queda de {0} a {1} por fuera del cuerpo</translation>
    </message>
    <message>
        <source>The film needs a width of more than two spacings, and no spacing below 0.</source>
        <translation>La película debe ser más ancha que dos separaciones, y ninguna separación menor que 0.</translation>
    </message>
    <message>
        <source>The film of shop-bought foil balloons: 15 µm oriented nylon 6 with an aluminium coat, 15 µm polyethylene inside. Weld PE to PE. Nylon takes up moisture and is then softer.</source>
        <translation>La película de los globos de tienda: 15 µm de nailon 6 orientado con una capa de aluminio, 15 µm de polietileno por dentro. Suelde PE con PE. El nailon absorbe humedad y entonces es más blando.</translation>
    </message>
    <message>
        <source>The film passes through itself near {0}, which the simulation does not feel: the balloon will look otherwise there. Move those parts away from each other.</source>
        <translation>La película pasa a través de sí misma cerca de {0}, lo que la simulación no nota: ahí el globo será distinto. Aleje esas partes una de otra.</translation>
    </message>
    <message>
        <source>The film stays up to {0} away from the profile, even half way between the seams and the middle of the gores: it cannot take this shape. Round the profile where it is flat, hollow or sharp.</source>
        <translation>La película queda hasta a {0} del perfil, incluso a medio camino entre las costuras y el centro de los gajos: no puede tomar esta forma. Redondee el perfil donde es plano, hueco o agudo.</translation>
    </message>
    <message>
        <source>The first {0} of {1} rows, without a balloon: {2}</source>
        <translation>Las primeras {0} de {1} filas, sin globo: {2}</translation>
    </message>
    <message>
        <source>The first {0} rows; the others are in table.csv.</source>
        <translation>Las primeras {0} filas; las demás están en table.csv.</translation>
    </message>
    <message>
        <source>The folder '{0}' has vanished: bring it back or choose another one, and start the study again.</source>
        <translation>La carpeta «{0}» ha desaparecido: recupérela o elija otra e inicie el estudio de nuevo.</translation>
    </message>
    <message>
        <source>The free edition opens DXF, not SVG. Choose "as is" for the size in the import preferences. Silhouette adds the knife's offset and overcut. Nothing is in the file that may not be cut. Studio draws registration marks itself, print them from there; or set page A4, inset 10.01 mm, length 8.38 mm and thickness 0.99 mm there (0.394, 0.33 and 0.039 in) and lay the file's marks on them, not to be cut: a print has the same. Nothing is cut outside them.</source>
        <translation>La edición gratuita abre DXF, no SVG. Elija «as is» para el tamaño en las preferencias de importación. Silhouette añade el desvío y el sobrecorte de la cuchilla. En el archivo no hay nada que no se pueda cortar. Studio dibuja él mismo las marcas de registro, imprímalas desde allí; o ponga allí página A4, margen 10,01 mm, longitud 8,38 mm y grosor 0,99 mm (0,394, 0,33 y 0,039 pulgadas) y ponga sobre ellas las marcas del archivo, sin cortarlas: una impresión tiene las mismas. Fuera de ellas no se corta nada.</translation>
    </message>
    <message>
        <source>The goal has {0} combinations to choose from, of which each is tried: list 1 to {1}.</source>
        <translation>El objetivo tiene {0} combinaciones para elegir, y cada una se prueba: enumere de 1 a {1}.</translation>
    </message>
    <message>
        <source>The goal is no JSON object: write {0}.</source>
        <translation>El objetivo no es un objeto JSON: escriba {0}.</translation>
    </message>
    <message>
        <source>The grain's angle {0} is no number: give degrees from the x axis.</source>
        <translation>El ángulo de la fibra {0} no es un número: indique grados desde el eje x.</translation>
    </message>
    <message>
        <source>The gussets are deeper than the pouch is high. Choose a smaller depth.</source>
        <translation>Los fuelles son más profundos que la altura de la bolsa. Elija una profundidad menor.</translation>
    </message>
    <message>
        <source>The hand beside the shape is as large as a grown-up's</source>
        <translation>La mano junto a la forma es tan grande como la de un adulto</translation>
    </message>
    <message>
        <source>The hole at {0} is too small for a {1} seal, and its weld reaches {2} into the balloon: make the hole at least {3} wide, or the seal narrower.</source>
        <translation>El agujero en {0} es demasiado pequeño para una soldadura de {1}, que entra {2} en el globo: hágalo de al menos {3} de ancho o estreche la soldadura.</translation>
    </message>
    <message>
        <source>The hole at {0} is welded but not cut out: for that, make it wider than two seals with their allowances, {1}.</source>
        <translation>El agujero en {0} se suelda pero no se recorta: para ello hágalo más ancho que dos soldaduras con sus márgenes, {1}.</translation>
    </message>
    <message>
        <source>The hole at {0} lies in another hole; remove one of them.</source>
        <translation>El agujero en {0} está dentro de otro; quite uno.</translation>
    </message>
    <message>
        <source>The hole at {0} lies outside the outline; move it inside.</source>
        <translation>El agujero en {0} está fuera del contorno; muévalo dentro.</translation>
    </message>
    <message>
        <source>The holes of a filled shape stay, the lines of a pen drawing are filled inside</source>
        <translation>Los agujeros de una forma rellena quedan, las líneas de un dibujo a línea se rellenan por dentro</translation>
    </message>
    <message>
        <source>The inflated outline stays {0} from the drawing on average: film cannot follow this shape everywhere. Round off notches and widen thin parts.</source>
        <translation>El contorno inflado queda de media a {0} del dibujo: la película no puede seguir esta forma en todas partes. Redondee entallas y ensanche partes finas.</translation>
    </message>
    <message>
        <source>The inflated outline stays {0} from the drawing on average: the balloon folds across a hole or a spot.</source>
        <translation>El contorno inflado queda de media a {0} del dibujo: el globo se pliega a través de un agujero o de un punto de soldadura.</translation>
    </message>
    <message>
        <source>The intake cannot lead into a hole of panel {0}: say another edge for the opening.</source>
        <translation>La boca no puede llevar a un agujero del panel {0}: indique otro borde para la abertura.</translation>
    </message>
    <message>
        <source>The intake file {0} calls itself "{1}": give both the same name.</source>
        <translation>El archivo de boca {0} se llama a sí mismo «{1}»: dé a ambos el mismo nombre.</translation>
    </message>
    <message>
        <source>The intake file {0} is of no use: {1}</source>
        <translation>El archivo de boca {0} no sirve: {1}</translation>
    </message>
    <message>
        <source>The intake file {0} lacks {1}: add it.</source>
        <translation>Al archivo de boca {0} le falta {1}: añádalo.</translation>
    </message>
    <message>
        <source>The intake is at the farthest point, on a part that becomes {measured} as thick as the balloon: there it is tied, hangs and is held. A low place carries it better.</source>
        <translation>La boca está en el punto más lejano, en una parte que queda con {measured} del grosor del globo: ahí se ata, cuelga y se sujeta. Un lugar bajo lo lleva mejor.</translation>
    </message>
    <message>
        <source>The intake opens into a part with {percent} of the film; the rest fills through something narrower than the intake. Move it to the largest part.</source>
        <translation>La boca da a una parte con {percent} de la película; el resto se llena por algo más estrecho que ella. Muévala a la parte mayor.</translation>
    </message>
    <message>
        <source>The intake was left out of the comparison.</source>
        <translation>La boca se dejó fuera de la comparación.</translation>
    </message>
    <message>
        <source>The intake would run into another part of the balloon: choose another angle or length for it.</source>
        <translation>La boca chocaría con otra parte del globo: elija otro ángulo u otra longitud.</translation>
    </message>
    <message>
        <source>The intake's angle must be a number.</source>
        <translation>El ángulo de la boca debe ser un número.</translation>
    </message>
    <message>
        <source>The intake's direction is of two equal panels: of many, say a seam and how far along it.</source>
        <translation>La dirección de la boca es de dos paneles iguales: con muchos, indique una costura y a qué distancia a lo largo.</translation>
    </message>
    <message>
        <source>The intake's length must be above 0, up to 100 m: give it about 30 mm.</source>
        <translation>La longitud de la boca debe ser mayor que 0, hasta 100 m: dele unos 30 mm.</translation>
    </message>
    <message>
        <source>The intake's place along the seam must be a length.</source>
        <translation>El lugar de la boca a lo largo de la costura debe ser una longitud.</translation>
    </message>
    <message>
        <source>The intake's place cannot be "{0}": choose {1}.</source>
        <translation>El lugar de la boca no puede ser «{0}»: elija {1}.</translation>
    </message>
    <message>
        <source>The intake's width must be between 0.01 mm and 10 m: give it about 10 mm.</source>
        <translation>La anchura de la boca debe estar entre 0,01 mm y 10 m: dele unos 10 mm.</translation>
    </message>
    <message>
        <source>The intakes of two chambers run into each other: leave a gap in the weld between them, or choose another place for the first.</source>
        <translation>Las bocas de dos cámaras chocan: deje un hueco en la soldadura entre ellas o ponga la primera en otro lugar.</translation>
    </message>
    <message>
        <source>The label "{0}" is {1} long, and the film is only {2} wide: take a shorter text or lower letters.</source>
        <translation>La etiqueta «{0}» mide {1} y la película solo {2} de ancho: tome un texto más corto o letras más bajas.</translation>
    </message>
    <message>
        <source>The last {length} of this tip stay flat. A radius of {wanted} makes it rounder.</source>
        <translation>El extremo de esta punta queda plano a lo largo de {length}. Un radio de {wanted} lo hace más redondo.</translation>
    </message>
    <message>
        <source>The layer MARK of the machine file {0}.json takes notches only. Rename it NOTCH, and where your machine can draw, add the layers FOLD and PEN.</source>
        <translation>La capa MARK del archivo de máquina {0}.json solo recibe muescas. Cámbiele el nombre a NOTCH y, si su máquina puede dibujar, añada las capas FOLD y PEN.</translation>
    </message>
    <message>
        <source>The layout failed: give the pieces more room.</source>
        <translation>La colocación falló: dé más sitio a las piezas.</translation>
    </message>
    <message>
        <source>The layout of {0} is older than its patterns: recompute it.</source>
        <translation>La colocación de {0} es más antigua que sus patrones: recalcúlela.</translation>
    </message>
    <message>
        <source>The layout on film</source>
        <translation>La colocación en la película</translation>
    </message>
    <message>
        <source>The layout was stopped; nothing was changed.</source>
        <translation>La colocación se detuvo; nada cambió.</translation>
    </message>
    <message>
        <source>The line at {0} divides no panel.</source>
        <translation>La línea en {0} no divide ningún panel.</translation>
    </message>
    <message>
        <source>The line at {0} misses the body.</source>
        <translation>La línea en {0} no toca el cuerpo.</translation>
    </message>
    <message>
        <source>The lines make up for a kerf of {0} already: leave LightBurn's kerf offset at 0.</source>
        <translation>Las líneas ya compensan un ancho de corte de {0}: deje en 0 la compensación de corte (kerf offset) de LightBurn.</translation>
    </message>
    <message>
        <source>The lines of the drawing do not close around anything: the outline follows the lines.</source>
        <translation>Las líneas del dibujo no encierran nada: el contorno sigue las líneas.</translation>
    </message>
    <message>
        <source>The machine file {0} calls itself "{1}": give both the same name.</source>
        <translation>El archivo de máquina {0} se llama a sí mismo «{1}»: dé a ambos el mismo nombre.</translation>
    </message>
    <message>
        <source>The machine file {0} is of no use: {1}</source>
        <translation>El archivo de máquina {0} no sirve: {1}</translation>
    </message>
    <message>
        <source>The machine file {0} lacks {1}: add it.</source>
        <translation>Al archivo de máquina {0} le falta {1}: añádalo.</translation>
    </message>
    <message>
        <source>The machine that finds the print again by its registration marks, printed round it</source>
        <translation>La máquina que vuelve a encontrar la impresión por sus marcas de registro, impresas a su alrededor</translation>
    </message>
    <message>
        <source>The marks round the print span {0}, and {1} takes at most {2}: make the balloon smaller, or print and cut it on another machine.</source>
        <translation>Las marcas alrededor de la impresión abarcan {0}, y {1} admite {2} como mucho: reduzca el globo, o imprímalo y córtelo en otra máquina.</translation>
    </message>
    <message>
        <source>The mesh has a triangle with a point that is not there. Save it once more.</source>
        <translation>La malla tiene un triángulo con un punto que no existe. Guárdela de nuevo.</translation>
    </message>
    <message>
        <source>The mesh has a vertex without triangles. Mesh the outline anew.</source>
        <translation>La malla tiene un nodo sin triángulos. Malle el contorno de nuevo.</translation>
    </message>
    <message>
        <source>The mesh has no triangle. Save the body as a mesh of triangles.</source>
        <translation>La malla no tiene ningún triángulo. Guarde el cuerpo como malla de triángulos.</translation>
    </message>
    <message>
        <source>The mesh has too many triangles, more than {0}. Simplify it in the program that it comes from.</source>
        <translation>La malla tiene demasiados triángulos, más de {0}. Simplifíquela en el programa del que viene.</translation>
    </message>
    <message>
        <source>The mesh is flat. Give a closed body, or a drawing for two equal panels.</source>
        <translation>La malla es plana. Dé un cuerpo cerrado, o un dibujo para dos paneles iguales.</translation>
    </message>
    <message>
        <source>The mesh is not closed: a hole is {0} % of its size long round. Close it in the program that the mesh comes from.</source>
        <translation>La malla no está cerrada: el contorno de un agujero mide el {0} % de su tamaño. Ciérrelo en el programa del que viene la malla.</translation>
    </message>
    <message>
        <source>The mesh size is {0}: give one above 0.</source>
        <translation>El tamaño de malla es {0}: indique uno mayor que 0.</translation>
    </message>
    <message>
        <source>The mesh was made simpler. Its triangles were: {0}.</source>
        <translation>La malla se ha simplificado. Triángulos que tenía: {0}.</translation>
    </message>
    <message>
        <source>The moving picture was stopped.</source>
        <translation>Se detuvo la animación.</translation>
    </message>
    <message>
        <source>The native solver cannot be saved. {0}</source>
        <translation>El solucionador nativo no se puede guardar. {0}</translation>
    </message>
    <message>
        <source>The native solver could not be fetched from {0} ({1}). Try again when the network is there. {2}</source>
        <translation>El solucionador nativo no se pudo descargar de {0} ({1}). Inténtelo de nuevo cuando haya red. {2}</translation>
    </message>
    <message>
        <source>The native solver is here already.</source>
        <translation>El solucionador nativo ya está aquí.</translation>
    </message>
    <message>
        <source>The native solver is in use now.</source>
        <translation>Ahora se usa el solucionador nativo.</translation>
    </message>
    <message>
        <source>The native solver is not available: {0} Use the NumPy solver.</source>
        <translation>El solucionador nativo no está disponible: {0} Use el de NumPy.</translation>
    </message>
    <message>
        <source>The native solver is not installed. Everything works without it, but simulations take 20 to 30 times longer. Fetch it now?</source>
        <translation>El solucionador nativo no está instalado. Todo funciona sin él, pero las simulaciones tardan de 20 a 30 veces más. ¿Descargarlo ahora?</translation>
    </message>
    <message>
        <source>The native solver was fetched, but does not run here: {0}</source>
        <translation>El solucionador nativo se descargó, pero no funciona aquí: {0}</translation>
    </message>
    <message>
        <source>The native solver was not fetched: stopped.</source>
        <translation>El solucionador nativo no se descargó: se detuvo.</translation>
    </message>
    <message>
        <source>The native solver, which is faster, is not available: {0}</source>
        <translation>El solucionador nativo, más rápido, no está disponible: {0}</translation>
    </message>
    <message>
        <source>The nozzle's flange must be wider than its bore.</source>
        <translation>La brida de la boquilla debe ser más ancha que su calibre.</translation>
    </message>
    <message>
        <source>The number that the controller takes for full power: $30 of GRBL</source>
        <translation>El número que el controlador toma como plena potencia: $30 en GRBL</translation>
    </message>
    <message>
        <source>The opening is at point {0} of panel '{1}', whose points are 0 to {2}. Choose one of them.</source>
        <translation>La abertura está en el punto {0} del panel «{1}», cuyos puntos son de 0 a {2}. Elija uno de ellos.</translation>
    </message>
    <message>
        <source>The opening is on a panel '{0}' that is not there. {1}</source>
        <translation>La abertura está en un panel «{0}» que no existe. {1}</translation>
    </message>
    <message>
        <source>The opening is on panel {0}, but there are {1}. Choose one of them.</source>
        <translation>La abertura está en el panel {0}, pero hay {1}. Elija uno de ellos.</translation>
    </message>
    <message>
        <source>The options cannot be used ({0}). See --help.</source>
        <translation>Las opciones no sirven ({0}). Vea --help.</translation>
    </message>
    <message>
        <source>The outline cannot be mirrored about its axis: draw it symmetric, or leave that.</source>
        <translation>El contorno no se puede reflejar en su eje: dibújelo simétrico o déjelo.</translation>
    </message>
    <message>
        <source>The outline comes to its axis more than once. {0}</source>
        <translation>El contorno llega a su eje más de una vez. {0}</translation>
    </message>
    <message>
        <source>The outline crosses or nearly touches itself near {0}: separate the parts that meet there.</source>
        <translation>El contorno se cruza o casi se toca cerca de {0}: separe ahí las partes.</translation>
    </message>
    <message>
        <source>The outline crosses or touches itself and cannot be meshed: separate the parts that meet.</source>
        <translation>El contorno se cruza o se toca y no se puede mallar: separe las partes que se tocan.</translation>
    </message>
    <message>
        <source>The outline crosses or touches itself and cannot be mirrored; part the lines.</source>
        <translation>El contorno se cruza o se toca y no se puede reflejar; separe las líneas.</translation>
    </message>
    <message>
        <source>The outline does not pass there any more: delete the edit.</source>
        <translation>El contorno ya no pasa por ahí: borre la edición.</translation>
    </message>
    <message>
        <source>The outline encloses no area; draw a closed shape with at least three corners.</source>
        <translation>El contorno no encierra área; dibuje una forma cerrada con al menos tres esquinas.</translation>
    </message>
    <message>
        <source>The outline has a coordinate that is not a number; correct it in the drawing.</source>
        <translation>El contorno tiene una coordenada que no es un número; corríjala en el dibujo.</translation>
    </message>
    <message>
        <source>The outline has no straight upright side on its left, so its axis is missing. {0}</source>
        <translation>El contorno no tiene un lado recto y vertical a su izquierda, así que falta su eje. {0}</translation>
    </message>
    <message>
        <source>The outline runs another way there: delete the edit.</source>
        <translation>El contorno va ahí de otra manera: borre la edición.</translation>
    </message>
    <message>
        <source>The outline's {0} of {1} cannot be made; bring it to a size between 1 mm and 100 m.</source>
        <translation>La {0} del contorno, {1}, no es posible; dele un tamaño entre 1 mm y 100 m.</translation>
    </message>
    <message>
        <source>The page will be in English, as no font here has the letters of your language: install IPAexGothic or Noto Sans CJK JP, and open this panel again.</source>
        <translation>La página estará en inglés, pues ningún tipo de letra tiene aquí los caracteres de su idioma: instale IPAexGothic o Noto Sans CJK JP y vuelva a abrir este panel.</translation>
    </message>
    <message>
        <source>The painting cannot be written to '{}': is the disk full?</source>
        <translation>La pintura no se puede escribir en «{}»: ¿está lleno el disco?</translation>
    </message>
    <message>
        <source>The panels are sealed to {0} bodies. Inflate each by itself.</source>
        <translation>Los paneles forman {0} cuerpos. Infle cada uno por separado.</translation>
    </message>
    <message>
        <source>The panels are sealed to {0} bodies: panel '{1}' does not hang together with panel '{2}'. Make a bag of each body.</source>
        <translation>Los paneles están soldados en {0} cuerpos: el panel «{1}» no está unido al panel «{2}». Haga una bolsa de cada cuerpo.</translation>
    </message>
    <message>
        <source>The panels have no names. {0}</source>
        <translation>Los paneles no tienen nombres. {0}</translation>
    </message>
    <message>
        <source>The panels have other points than those that were meshed. Mesh the bag anew.</source>
        <translation>Los paneles tienen otros puntos que los de la malla. Malle la bolsa de nuevo.</translation>
    </message>
    <message>
        <source>The panels have {0} points, more than {1}. Simplify them in the program that they come from.</source>
        <translation>Los paneles tienen {0} puntos, más de {1}. Simplifíquelos en el programa del que vienen.</translation>
    </message>
    <message>
        <source>The part round {0} has no rim for an intake: leave a gap in the welds round it.</source>
        <translation>La parte alrededor de {0} no tiene borde para una boca: deje un hueco en las soldaduras que la rodean.</translation>
    </message>
    <message>
        <source>The pattern becomes too thin for its mesh. Widen the thin parts, or use a finer mesh.</source>
        <translation>El patrón se vuelve demasiado fino para su malla. Ensanche las partes finas o use una malla más fina.</translation>
    </message>
    <message>
        <source>The pattern crosses itself near {0}: simplify the drawing there.</source>
        <translation>El patrón se cruza cerca de {0}: simplifique ahí el dibujo.</translation>
    </message>
    <message>
        <source>The pattern has no lines for {0}, which takes {1}: choose another machine.</source>
        <translation>El patrón no tiene líneas para {0}, que toma {1}: elija otra máquina.</translation>
    </message>
    <message>
        <source>The pattern is being fitted to the painting ...</source>
        <translation>El patrón se está ajustando a la pintura ...</translation>
    </message>
    <message>
        <source>The pattern measures {0}, the bed of {1} is {2}</source>
        <translation>El patrón mide {0}, la cama de {1} {2}</translation>
    </message>
    <message>
        <source>The photograph shows the back: it was mirrored.</source>
        <translation>La fotografía muestra el dorso: se reflejó.</translation>
    </message>
    <message>
        <source>The photograph shows too many shapes: take one of the balloon alone, on a plain background.</source>
        <translation>La fotografía muestra demasiadas formas: tome una del globo solo, sobre un fondo liso.</translation>
    </message>
    <message>
        <source>The picture has a single colour. Choose one that shows a shape on a background.</source>
        <translation>La imagen tiene un solo color. Elija una que muestre una forma sobre un fondo.</translation>
    </message>
    <message>
        <source>The picture has no plain background around the shape. Use one with a background of one colour or a transparent one.</source>
        <translation>La imagen no tiene un fondo liso alrededor de la forma. Use una con fondo de un color o transparente.</translation>
    </message>
    <message>
        <source>The picture is empty: all of it is transparent. Choose a picture that shows a shape.</source>
        <translation>La imagen está vacía: es toda transparente. Elija una que muestre una forma.</translation>
    </message>
    <message>
        <source>The picture is too small to see a shape. Use {0} pixels or more across.</source>
        <translation>La imagen es demasiado pequeña para ver una forma. Use al menos {0} píxeles de ancho.</translation>
    </message>
    <message>
        <source>The picture is traced as it is without a choice of yours</source>
        <translation>La imagen se traza como sin elección suya</translation>
    </message>
    <message>
        <source>The picture of a body of gores goes all round: leave out --artwork-back.</source>
        <translation>La imagen de un cuerpo de gajos da toda la vuelta: quite --artwork-back.</translation>
    </message>
    <message>
        <source>The picture was read as a pen drawing: the inside of its lines is filled.</source>
        <translation>La imagen se leyó como dibujo a línea: el interior de sus líneas está relleno.</translation>
    </message>
    <message>
        <source>The picture, and all figures as JSON</source>
        <translation>La imagen, y todas las cifras como JSON</translation>
    </message>
    <message>
        <source>The pieces of the intake "{0}" are cut from {1}: they have a file of their own, with all of them for each balloon.</source>
        <translation>Las piezas de la boca «{0}» se cortan de {1}: tienen un archivo propio, con todas ellas para cada globo.</translation>
    </message>
    <message>
        <source>The pieces of the intake "{0}" are of {1}, which does not weld to {2}: choose another intake, or a film that it welds to: {3}.</source>
        <translation>Las piezas de la boca «{0}» son de {1}, que no se suelda con {2}: elija otra boca o una película con la que se suelde: {3}.</translation>
    </message>
    <message>
        <source>The place {0} is not on panels {1}, between which the seam lies.</source>
        <translation>El lugar {0} no está en los paneles {1}, entre los que va la costura.</translation>
    </message>
    <message>
        <source>The plane through {0} divides no panel.</source>
        <translation>El plano por {0} no divide ningún panel.</translation>
    </message>
    <message>
        <source>The plane through {0} does not meet the body.</source>
        <translation>El plano por {0} no toca el cuerpo.</translation>
    </message>
    <message>
        <source>The plotter finds the marks of a print itself. Set mark type 1 and a size of 10 mm there. The layer REGISTRATION is not cut. The knife's offset belongs into the plotter.</source>
        <translation>El trazador encuentra solo las marcas de una impresión. Ponga allí el tipo de marca 1 y un tamaño de 10 mm. La capa REGISTRATION no se corta. El desvío de la cuchilla se pone en el trazador.</translation>
    </message>
    <message>
        <source>The plotter finds the marks of a print itself. Set shape 1 and a size of 10 mm there. FineCut takes marks only that it made itself: let it make them in the place of these. The layer REGISTRATION is not cut.</source>
        <translation>El trazador encuentra solo las marcas de una impresión. Ponga allí la forma 1 y un tamaño de 10 mm. FineCut solo acepta marcas que hizo él mismo: haga que las ponga en el lugar de estas. La capa REGISTRATION no se corta.</translation>
    </message>
    <message>
        <source>The pressure at the lower end must be 0 or more.</source>
        <translation>La presión en el extremo inferior debe ser 0 o más.</translation>
    </message>
    <message>
        <source>The pressure must be positive and at most {0}, not {1}. A party balloon has about 2 kPa.</source>
        <translation>La presión debe ser positiva y como mucho {0}, no {1}. Un globo de fiesta tiene unos 2 kPa.</translation>
    </message>
    <message>
        <source>The pressure must grow upwards: give a gradient of 0 or more.</source>
        <translation>La presión debe crecer hacia arriba: indique un gradiente de 0 o más.</translation>
    </message>
    <message>
        <source>The preview picture needs matplotlib: install it with pip install matplotlib.</source>
        <translation>La imagen de vista previa necesita matplotlib: instálelo con pip install matplotlib.</translation>
    </message>
    <message>
        <source>The print has {0}, and {1} looks for others: print once more with its marks ({2}).</source>
        <translation>La impresión tiene {0}, y {1} busca otras: imprima otra vez con sus marcas ({2}).</translation>
    </message>
    <message>
        <source>The print measures {0}, and between the marks of {1} there are {2} on paper of {3}: make the balloon smaller, or give larger paper as page_mm of the marks in a file of your machine.</source>
        <translation>La impresión mide {0}, y entre las marcas de {1} hay {2} en papel de {3}: reduzca el globo, o indique un papel mayor como page_mm de las marcas en un archivo de su máquina.</translation>
    </message>
    <message>
        <source>The print measures {0}, and {1} takes at most {2}: make the balloon smaller, or print and cut it on another machine.</source>
        <translation>La impresión mide {0}, y {1} admite {2} como mucho: reduzca el globo, o imprímalo y córtelo en otra máquina.</translation>
    </message>
    <message>
        <source>The print on film</source>
        <translation>La impresión en la película</translation>
    </message>
    <message>
        <source>The print reaches into the marks of {0}, or comes nearer than {1}: make the balloon smaller, or give larger paper as page_mm of the marks in a file of your machine.</source>
        <translation>La impresión entra en las marcas de {0}, o se acerca a menos de {1}: reduzca el globo, o indique un papel mayor como page_mm de las marcas en un archivo de su máquina.</translation>
    </message>
    <message>
        <source>The profile crosses or touches itself at {0}. Draw a simple line.</source>
        <translation>El perfil se cruza o se toca en {0}. Dibuje una línea simple.</translation>
    </message>
    <message>
        <source>The profile goes to the other side of its axis at the height {0}: the radius is {1}. Draw one half only.</source>
        <translation>El perfil pasa al otro lado de su eje a la altura {0}: el radio es {1}. Dibuje solo una mitad.</translation>
    </message>
    <message>
        <source>The profile has more than {0} points. Simplify it.</source>
        <translation>El perfil tiene más de {0} puntos. Simplifíquelo.</translation>
    </message>
    <message>
        <source>The profile is a closed line that does not run along its axis. Draw one half of the section, from the lower to the upper end.</source>
        <translation>El perfil es una línea cerrada que no sigue su eje. Dibuje una mitad de la sección, del extremo inferior al superior.</translation>
    </message>
    <message>
        <source>The profile is too slender for a disc of {0} at its {1} end. Let the gores meet in a point there.</source>
        <translation>El perfil es demasiado delgado para un disco de {0} en su extremo ({1}). Deje que ahí los gajos se junten en una punta.</translation>
    </message>
    <message>
        <source>The profile is {0} large. Give it a size between {1} and {2}, and check its unit.</source>
        <translation>El perfil mide {0}. Dele un tamaño entre {1} y {2}, y revise su unidad.</translation>
    </message>
    <message>
        <source>The profile lies on its axis. Draw the half outline at a distance from it.</source>
        <translation>El perfil está sobre su eje. Dibuje el medio contorno a cierta distancia de él.</translation>
    </message>
    <message>
        <source>The profile needs at least two points, each a pair of numbers: radius and height.</source>
        <translation>El perfil necesita al menos dos puntos, cada uno un par de números: radio y altura.</translation>
    </message>
    <message>
        <source>The profile touches its axis at the height {0}, which parts the balloon in two. Keep it away from the axis there.</source>
        <translation>El perfil toca su eje a la altura {0}, lo que parte el globo en dos. Apártelo ahí del eje.</translation>
    </message>
    <message>
        <source>The radius of the corner relief must be 0 or above.</source>
        <translation>El radio del alivio de esquinas debe ser 0 o mayor.</translation>
    </message>
    <message>
        <source>The remnant is of {0} film, and no piece here is cut from that.</source>
        <translation>El retal es de película de {0}, y aquí ninguna pieza se corta de ella.</translation>
    </message>
    <message>
        <source>The remnant {0} is of no use: {1}</source>
        <translation>El retal {0} no sirve: {1}</translation>
    </message>
    <message>
        <source>The remnant {0} lacks {1}: add it.</source>
        <translation>Al retal {0} le falta {1}: añádalo.</translation>
    </message>
    <message>
        <source>The repair at {0} no longer fits, {1}: take it back or draw that part anew.</source>
        <translation>La reparación en {0} ya no encaja, {1}: deshágala o dibuje esa parte de nuevo.</translation>
    </message>
    <message>
        <source>The rest of the job</source>
        <translation>Los demás archivos</translation>
    </message>
    <message>
        <source>The rim is the width of the weld and of the film beside it: give 0 to 1 m.</source>
        <translation>El borde es la anchura de la soldadura y de la película junto a ella: indique de 0 a 1 m.</translation>
    </message>
    <message>
        <source>The row has more cells than there are columns: leave out what is too much.</source>
        <translation>La fila tiene más celdas que columnas hay: quite lo que sobra.</translation>
    </message>
    <message>
        <source>The row has no input: give it the name of a drawing.</source>
        <translation>La fila no tiene entrada: indique el nombre de un dibujo.</translation>
    </message>
    <message>
        <source>The same in all rows</source>
        <translation>Igual en todas las filas</translation>
    </message>
    <message>
        <source>The same length as it is, such as 300 mm</source>
        <translation>La misma longitud tal como es, por ejemplo 300 mm</translation>
    </message>
    <message>
        <source>The scale '{0}' cannot be used: {1}.</source>
        <translation>La escala «{0}» no sirve: {1}.</translation>
    </message>
    <message>
        <source>The scale of {0} over {1} pixels has no length: mark two points that are far apart, and give the distance between them.</source>
        <translation>La escala de {0} en {1} píxeles no tiene longitud: marque dos puntos muy separados e indique la distancia entre ellos.</translation>
    </message>
    <message>
        <source>The scheduler of Dask went away: start it and the study again; nothing is lost.</source>
        <translation>El planificador de Dask desapareció: inícielo de nuevo, y también el estudio; no se pierde nada.</translation>
    </message>
    <message>
        <source>The seal width must be between 0.01 mm and 1 m, the allowance between 0 and 1 m.</source>
        <translation>La anchura de soldadura debe estar entre 0,01 mm y 1 m, el margen entre 0 y 1 m.</translation>
    </message>
    <message>
        <source>The seam near {0} divides no panel.</source>
        <translation>La costura cerca de {0} no divide ningún panel.</translation>
    </message>
    <message>
        <source>The seam near {0} is one of {1}, not of {2}.</source>
        <translation>La costura cerca de {0} es de {1}, no de {2}.</translation>
    </message>
    <message>
        <source>The seam near {0} would divide panels {1}, not {2}.</source>
        <translation>La costura cerca de {0} dividiría los paneles {1}, no {2}.</translation>
    </message>
    <message>
        <source>The seams of {0} gores stand out by up to {1} over their middles. More gores make the body rounder.</source>
        <translation>Las costuras de {0} gajos sobresalen hasta {1} de sus centros. Más gajos hacen el cuerpo más redondo.</translation>
    </message>
    <message>
        <source>The search for a goal asks for a few balloons at a time, of this machine: leave out --scheduler and --dask.</source>
        <translation>La búsqueda de un objetivo pide pocos globos cada vez, a esta máquina: omita --scheduler y --dask.</translation>
    </message>
    <message>
        <source>The search for a goal finds its balloons one after the other: leave out --shard, --script, --dry-run and --collect; what is there already is not made again.</source>
        <translation>La búsqueda de un objetivo halla sus globos uno tras otro: omita --shard, --script, --dry-run y --collect; lo que ya está no se hace de nuevo.</translation>
    </message>
    <message>
        <source>The search for a goal needs scipy: install it with pip install scipy.</source>
        <translation>La búsqueda de un objetivo necesita scipy: instálelo con pip install scipy.</translation>
    </message>
    <message>
        <source>The search was stopped; what was made stays.</source>
        <translation>La búsqueda se detuvo; lo ya hecho queda.</translation>
    </message>
    <message>
        <source>The search with optuna needs its package: install it with pip install optuna, or leave out "search".</source>
        <translation>La búsqueda con optuna necesita su paquete: instálelo con pip install optuna u omita "search".</translation>
    </message>
    <message>
        <source>The seed is a whole number from 0 up, not {0}.</source>
        <translation>La semilla es un número entero desde 0, no {0}.</translation>
    </message>
    <message>
        <source>The selected sketches, wires and flat faces become the panels</source>
        <translation>Los croquis, alambres y caras planas seleccionados pasan a ser los paneles</translation>
    </message>
    <message>
        <source>The settings lack "{0}": write {"{1}": {2}} into their file.</source>
        <translation>A los ajustes les falta «{0}»: escriba {"{1}": {2}} en su archivo.</translation>
    </message>
    <message>
        <source>The shape has the colour of a shadow: shadows on the background count as part of it.</source>
        <translation>La forma tiene el color de una sombra: las sombras del fondo cuentan como parte de ella.</translation>
    </message>
    <message>
        <source>The shape in the photograph measures {0}, {1} were expected: check the scale, or whether it is the right photograph.</source>
        <translation>La forma de la fotografía mide {0}, se esperaban {1}: revise la escala, o si es la fotografía correcta.</translation>
    </message>
    <message>
        <source>The shape in the picture is too frayed to trace. Use a clearer picture.</source>
        <translation>La forma de la imagen está demasiado deshilachada para calcarla. Use una imagen más clara.</translation>
    </message>
    <message>
        <source>The shape is only {0} thick near {1}, too thin for a mesh of {2}: make it thicker there, or use a mesh size of at most {3}.</source>
        <translation>La forma solo tiene {0} de grueso cerca de {1}, demasiado fina para una malla de {2}: engrósela ahí o use como mucho {3}.</translation>
    </message>
    <message>
        <source>The shape touches the {0} border of the photograph: take one that shows all of it on a plain background.</source>
        <translation>La forma toca el borde de la fotografía ({0}): tome una que la muestre entera sobre un fondo liso.</translation>
    </message>
    <message>
        <source>The shape touches the {0} border of the picture; if it was cut off there, leave more margin.</source>
        <translation>La forma toca el borde de la imagen ({0}); si se cortó ahí, deje más margen.</translation>
    </message>
    <message>
        <source>The side band has no width: give its width, or the thickness of the balloon.</source>
        <translation>La banda lateral no tiene ancho: indique su ancho, o el espesor del globo.</translation>
    </message>
    <message>
        <source>The side band is too wide for this drawing, whose parts are about {0} wide: give it at most {1}.</source>
        <translation>La banda lateral es demasiado ancha para este dibujo, cuyas partes tienen unos {0} de ancho: dele como mucho {1}.</translation>
    </message>
    <message>
        <source>The side band must be wider than 0, not {0}. Give it 20 mm or so.</source>
        <translation>La banda lateral debe ser más ancha que 0, no {0}. Dele unos 20 mm.</translation>
    </message>
    <message>
        <source>The side band of {0} leaves nothing of the front, whose widest part is {1} wide: give it at most {2}.</source>
        <translation>La banda lateral de {0} no deja nada del frente, cuya parte más ancha tiene {1}: dele como mucho {2}.</translation>
    </message>
    <message>
        <source>The sides of seam {0} are not equally long: {1}, {2}. Make them equally long, or allow them ease.</source>
        <translation>Los lados de la costura {0} no son igual de largos: {1}, {2}. Iguálelos, o permítales holgura.</translation>
    </message>
    <message>
        <source>The sides of seam {0} are {1} and {2} long. Make them equally long.</source>
        <translation>Los lados de la costura {0} miden {1} y {2}. Iguale sus longitudes.</translation>
    </message>
    <message>
        <source>The simulation cannot take its first step. Check the outline for degenerate parts.</source>
        <translation>La simulación no puede dar su primer paso. Compruebe si el contorno tiene partes degeneradas.</translation>
    </message>
    <message>
        <source>The simulation did not come to rest; the shape shown is its last good state. Try a coarser mesh.</source>
        <translation>La simulación no llegó al reposo; se muestra su último buen estado. Pruebe una malla más gruesa.</translation>
    </message>
    <message>
        <source>The simulation failed: {0}. Check the outline for degenerate parts.</source>
        <translation>La simulación falló: {0}. Compruebe si el contorno tiene partes degeneradas.</translation>
    </message>
    <message>
        <source>The simulation has no finite start. Check the outline for degenerate parts.</source>
        <translation>La simulación no tiene un comienzo finito. Compruebe si el contorno tiene partes degeneradas.</translation>
    </message>
    <message>
        <source>The simulation was stopped.</source>
        <translation>La simulación se detuvo.</translation>
    </message>
    <message>
        <source>The size comes from {0}: make it smaller there, or of more and narrower panels.</source>
        <translation>El tamaño viene de {0}: hágalo menor ahí, o de más paneles y más estrechos.</translation>
    </message>
    <message>
        <source>The size comes from {0}: make it smaller there.</source>
        <translation>El tamaño viene de {0}: redúzcalo allí.</translation>
    </message>
    <message>
        <source>The size follows from a volume or a lift: choose a smaller one.</source>
        <translation>Un volumen o una sustentación decide el tamaño: elija un valor menor.</translation>
    </message>
    <message>
        <source>The size of {0} is set by an expression: change the value that it uses.</source>
        <translation>El tamaño de {0} sigue una expresión: cambie aquello a lo que se refiere.</translation>
    </message>
    <message>
        <source>The slant of a cone is longer than its radius. Choose a longer slant.</source>
        <translation>La generatriz de un cono es más larga que su radio. Elija una más larga.</translation>
    </message>
    <message>
        <source>The smallest radius is {0}, near {1}; {2} follows {3}. It will come out rounder there.</source>
        <translation>El radio menor es {0}, cerca de {1}; {2} sigue {3}. Ahí saldrá más redondo.</translation>
    </message>
    <message>
        <source>The solver '{0}' needs the Python package scipy. Install it or use the native solver.</source>
        <translation>El solucionador «{0}» necesita el paquete de Python scipy. Instálelo o use el nativo.</translation>
    </message>
    <message>
        <source>The speed of welding must be above 0, and the time for each seam not below it.</source>
        <translation>La velocidad de soldadura debe ser mayor que 0, y el tiempo por costura no menor que 0.</translation>
    </message>
    <message>
        <source>The spread of {0} cannot be {1}: write it with its unit, such as "{2}".</source>
        <translation>La dispersión de {0} no puede ser {1}: escríbala con su unidad, como «{2}».</translation>
    </message>
    <message>
        <source>The spread of {0} has "{1}", which is none of {2}.</source>
        <translation>La dispersión de {0} tiene «{1}», que no es ninguno de {2}.</translation>
    </message>
    <message>
        <source>The spread of {0} is {1}: give one above 0, or leave it out.</source>
        <translation>La dispersión de {0} es {1}: indique una mayor que 0 u omítala.</translation>
    </message>
    <message>
        <source>The spread of {0} is {1}: write one {2}.</source>
        <translation>La dispersión de {0} es {1}: escriba una {2}.</translation>
    </message>
    <message>
        <source>The step of {0} has another unit than its ends: write the same one.</source>
        <translation>El paso de {0} tiene otra unidad que sus extremos: escriba la misma.</translation>
    </message>
    <message>
        <source>The strips of valves are not here: lay them out on a sheet of their own, with "Valve film".</source>
        <translation>Las tiras de las válvulas no están aquí: colóquelas en una lámina aparte, con «Película de válvula».</translation>
    </message>
    <message>
        <source>The study cannot go on ({0}).</source>
        <translation>El estudio no puede continuar ({0}).</translation>
    </message>
    <message>
        <source>The study has no inputs: give it a column 'input' with the names of drawings.</source>
        <translation>El estudio no tiene entradas: dele una columna «input» con los nombres de dibujos.</translation>
    </message>
    <message>
        <source>The study has no rows.</source>
        <translation>El estudio no tiene filas.</translation>
    </message>
    <message>
        <source>The study has the column {0} twice.</source>
        <translation>El estudio tiene dos veces la columna {0}.</translation>
    </message>
    <message>
        <source>The study has {0} rows, more than {1}: take fewer values, or give --most {2} if that is meant.</source>
        <translation>El estudio tiene {0} filas, más de {1}: tome menos valores o indique --most {2} si es lo que quiere.</translation>
    </message>
    <message>
        <source>The study has {0} rows, more than {1}: take fewer values.</source>
        <translation>El estudio tiene {0} filas, más de {1}: tome menos valores.</translation>
    </message>
    <message>
        <source>The study is no JSON object: begin it with {"vary": ...}.</source>
        <translation>El estudio no es un objeto JSON: empiécelo con {"vary": ...}.</translation>
    </message>
    <message>
        <source>The study was stopped.</source>
        <translation>El estudio se detuvo.</translation>
    </message>
    <message>
        <source>The summary cannot be shown ({0}); {1}.</source>
        <translation>El resumen no se puede mostrar ({0}); {1}.</translation>
    </message>
    <message>
        <source>The surface cannot be laid flat: some of its triangles have no area, or a panel hangs together in a point only. Repair the body, or take another number of panels.</source>
        <translation>La superficie no se puede aplanar: algunos de sus triángulos no tienen área, o un panel solo se une en un punto. Repare el cuerpo o tome otro número de paneles.</translation>
    </message>
    <message>
        <source>The surface crosses itself, at ({0}) of the mesh. Film cannot follow it there. Triangles that cross others: {1}.</source>
        <translation>La superficie se cruza consigo misma, en ({0}) de la malla. La película no puede seguirla ahí. Triángulos que cruzan otros: {1}.</translation>
    </message>
    <message>
        <source>The surface of the mesh has no outside, as a Moebius strip. Give the mesh of a solid.</source>
        <translation>La superficie de la malla no tiene lado exterior, como una cinta de Moebius. Dé la malla de un sólido.</translation>
    </message>
    <message>
        <source>The temperature of the {0}, {1} degrees Celsius, is out of range: give one such as 20C.</source>
        <translation>La temperatura ({0}) de {1} grados Celsius está fuera de rango: indique por ejemplo 20C.</translation>
    </message>
    <message>
        <source>The test card measures {0}, the bed of {1} is {2}: try fewer values, or say with --bed how large it is.</source>
        <translation>La tarjeta de prueba mide {0}, la mesa de {1} {2}: pruebe menos valores, o diga con --bed su tamaño.</translation>
    </message>
    <message>
        <source>The thickness of the balloon decides the width of its side band: give one of them.</source>
        <translation>El espesor del globo decide el ancho de su banda lateral: indique uno de los dos.</translation>
    </message>
    <message>
        <source>The tie tab at {0} degrees would run into another part: choose another angle.</source>
        <translation>La lengüeta a {0} grados chocaría con otra parte: elija otro ángulo.</translation>
    </message>
    <message>
        <source>The valve reaches {0} into the balloon, past the weld at {1}: put the intake where the balloon is longer, or take another one.</source>
        <translation>La válvula entra {0} en el globo, más allá de la soldadura en {1}: ponga la boca donde el globo sea más largo o tome otra.</translation>
    </message>
    <message>
        <source>The vertices along both sides of seam {0} are up to {1} apart. Put them at equal lengths along it.</source>
        <translation>Los vértices de ambos lados de la costura {0} distan hasta {1}. Colóquelos a longitudes iguales.</translation>
    </message>
    <message>
        <source>The volume must be positive, not {0}.</source>
        <translation>El volumen debe ser positivo, no {0}.</translation>
    </message>
    <message>
        <source>The way from the intake into the balloon narrows to {0}, and the intake is {1} wide: put it where the balloon is wider, else air enters slowly.</source>
        <translation>El paso de la boca al globo se estrecha a {0}, y la boca mide {1}: póngala donde el globo sea más ancho; si no, el aire entra despacio.</translation>
    </message>
    <message>
        <source>The weld draws the seam inward by {0}</source>
        <translation>La soldadura lleva la costura hacia dentro {0}</translation>
    </message>
    <message>
        <source>The width and the height must be more than 0.</source>
        <translation>La anchura y la altura deben ser más de 0.</translation>
    </message>
    <message>
        <source>The width of the passages must be 0 or above.</source>
        <translation>La anchura de los pasos debe ser 0 o mayor.</translation>
    </message>
    <message>
        <source>The worker on {0}</source>
        <translation>El worker en {0}</translation>
    </message>
    <message>
        <source>The worker on {0} cannot work: {1}</source>
        <translation>El worker en {0} no puede trabajar: {1}</translation>
    </message>
    <message>
        <source>The {0} "{1}" of the material card {2} cannot be read: correct the card.</source>
        <translation>El {0} «{1}» de la ficha de material {2} no se puede leer: corrija la ficha.</translation>
    </message>
    <message>
        <source>The {0} bears {1} here with a margin of {2}, and the pressure is {3}. Inflate it to less, or take a stronger film.</source>
        <translation>{0}: aguanta aquí {1} con un margen de {2}, y la presión es {3}. Ínflelo menos, o tome una película más fuerte.</translation>
    </message>
    <message>
        <source>The {0} crosses or touches itself at {1}; part the lines there.</source>
        <translation>Cruce o contacto ({0}) en {1}; separe ahí las líneas.</translation>
    </message>
    <message>
        <source>The {0} encloses no area; draw a closed shape with at least three corners.</source>
        <translation>No se encierra área ({0}); dibuje una forma cerrada con al menos tres esquinas.</translation>
    </message>
    <message>
        <source>The {0} end of the profile is '{1}'. Use one of {2}.</source>
        <translation>El extremo ({0}) del perfil es «{1}». Use uno de {2}.</translation>
    </message>
    <message>
        <source>The {0} end of the profile is {1} away from the axis, so no gores can meet there in a point. Close it with a disc, or leave it open.</source>
        <translation>El extremo ({0}) del perfil está a {1} del eje, así que ahí los gajos no pueden juntarse en una punta. Ciérrelo con un disco, o déjelo abierto.</translation>
    </message>
    <message>
        <source>The {0} file has a point that is no three numbers. Save it once more.</source>
        <translation>El archivo {0} tiene un punto que no son tres números. Guárdelo de nuevo.</translation>
    </message>
    <message>
        <source>The {0} is {1} mm: give one above 0, for example 300 mm.</source>
        <translation>La medida ({0}) es {1} mm: indique una mayor que 0, por ejemplo 300 mm.</translation>
    </message>
    <message>
        <source>The {0} is {1} off its goal: change the goal by as much.</source>
        <translation>El objetivo ({0}) se desvió un {1}: corríjalo en la misma medida.</translation>
    </message>
    <message>
        <source>The {0} is {1}, not between {2} and {3} {4}: give one such as {5}.</source>
        <translation>El valor ({0}) es {1}, no está entre {2} y {3} {4}: indique por ejemplo {5}.</translation>
    </message>
    <message>
        <source>The {0} line crosses itself near {1}: simplify the drawing there.</source>
        <translation>La línea {0} se cruza cerca de {1}: simplifique ahí el dibujo.</translation>
    </message>
    <message>
        <source>The {0} line runs back along itself near {1}: simplify the drawing there.</source>
        <translation>La línea {0} vuelve sobre sí misma cerca de {1}: simplifique ahí el dibujo.</translation>
    </message>
    <message>
        <source>The {0} line that begins at {1} is open: programs fill, offset and cut closed lines only. Close it.</source>
        <translation>La línea {0} que empieza en {1} está abierta: los programas solo rellenan, desplazan y cortan líneas cerradas. Ciérrela.</translation>
    </message>
    <message>
        <source>The {0} must be between 0 and {1}.</source>
        <translation>{0} debe estar entre 0 y {1}.</translation>
    </message>
    <message>
        <source>The {0} of a {1} must be from {2} to {3}.</source>
        <translation>El valor ({0}) de la herramienta ({1}) debe ser de {2} a {3}.</translation>
    </message>
    <message>
        <source>The {0} strays by {1} % in sample {2}, which leaves nothing of it: give a smaller spread.</source>
        <translation>En la muestra {2} el desvío es del {1} % y no deja nada ({0}): indique una dispersión menor.</translation>
    </message>
    <message>
        <source>Their depth</source>
        <translation>Su profundidad</translation>
    </message>
    <message>
        <source>There are no panels: choose sketches or flat faces.</source>
        <translation>No hay paneles: elija croquis o caras planas.</translation>
    </message>
    <message>
        <source>There are seams in the planes of symmetry already.</source>
        <translation>Ya hay costuras en los planos de simetría.</translation>
    </message>
    <message>
        <source>There can be 0 to {0} notches, not {1}, with a depth above 0.</source>
        <translation>Puede haber de 0 a {0} muescas, no {1}, con profundidad mayor que 0.</translation>
    </message>
    <message>
        <source>There can be 1 to {0} copies, not {1}.</source>
        <translation>Puede haber de 1 a {0} copias, no {1}.</translation>
    </message>
    <message>
        <source>There is a machine {0} already: give this one another name.</source>
        <translation>Ya existe una máquina {0}: dé a esta otro nombre.</translation>
    </message>
    <message>
        <source>There is advice about two equal panels only: of many, the warnings tell.</source>
        <translation>Solo hay consejos sobre dos paneles iguales: de muchos hablan las advertencias.</translation>
    </message>
    <message>
        <source>There is no "{0}" to repair in {1}: see its advice.</source>
        <translation>No hay «{0}» que reparar en {1}: vea sus consejos.</translation>
    </message>
    <message>
        <source>There is no column '{0}': {1}.</source>
        <translation>No hay columna «{0}»: {1}.</translation>
    </message>
    <message>
        <source>There is no file '{0}'. Check the name and the folder.</source>
        <translation>No existe el archivo «{0}». Compruebe el nombre y la carpeta.</translation>
    </message>
    <message>
        <source>There is no file {0}, and no such ready body: check the name and the folder.</source>
        <translation>No hay archivo {0}, ni un cuerpo listo así: revise el nombre y la carpeta.</translation>
    </message>
    <message>
        <source>There is no file {0}: check the name and the folder.</source>
        <translation>No existe el archivo {0}: compruebe el nombre y la carpeta.</translation>
    </message>
    <message>
        <source>There is no file {}: check the name and the folder.</source>
        <translation>No existe el archivo {}: compruebe el nombre y la carpeta.</translation>
    </message>
    <message>
        <source>There is no film "{0}": choose one of {1}.</source>
        <translation>No hay película «{0}»: elija una de {1}.</translation>
    </message>
    <message>
        <source>There is no gas "{0}": choose one of {1}.</source>
        <translation>No hay gas «{0}»: elija uno de {1}.</translation>
    </message>
    <message>
        <source>There is no hole any more: delete the edit.</source>
        <translation>Ya no hay ningún agujero: borre la edición.</translation>
    </message>
    <message>
        <source>There is no hole at {0}: give a place on its edge.</source>
        <translation>No hay ningún agujero en {0}: indique un lugar de su borde.</translation>
    </message>
    <message>
        <source>There is no intake "{0}": choose one of {1}.</source>
        <translation>No hay boca «{0}»: elija una de {1}.</translation>
    </message>
    <message>
        <source>There is no joining "{0}": choose one of {1}.</source>
        <translation>No hay unión «{0}»: elija una de {1}.</translation>
    </message>
    <message>
        <source>There is no language "{0}": choose one of {1}.</source>
        <translation>No hay idioma «{0}»: elija uno de {1}.</translation>
    </message>
    <message>
        <source>There is no look "{0}": choose one of {1}.</source>
        <translation>No hay aspecto «{0}»: elija uno de {1}.</translation>
    </message>
    <message>
        <source>There is no machine "{0}": choose one of {1}, or give a .json file.</source>
        <translation>No hay máquina «{0}»: elija una de {1} o indique un archivo .json.</translation>
    </message>
    <message>
        <source>There is no native solver for {0}. {1}</source>
        <translation>No hay solucionador nativo para {0}. {1}</translation>
    </message>
    <message>
        <source>There is no native solver to be fetched for this version yet. {0}</source>
        <translation>Todavía no hay solucionador nativo que descargar para esta versión. {0}</translation>
    </message>
    <message>
        <source>There is no node near {0}: add one there.</source>
        <translation>No hay ningún nodo cerca de {0}: añada uno ahí.</translation>
    </message>
    <message>
        <source>There is no outline at {0} degrees from the centre: choose another intake angle.</source>
        <translation>No hay contorno a {0} grados del centro: elija otro ángulo para la boca.</translation>
    </message>
    <message>
        <source>There is no panel. Give at least one.</source>
        <translation>No hay ningún panel. Dé al menos uno.</translation>
    </message>
    <message>
        <source>There is no paper "{0}" for the assembly sheet: choose A4 or Letter.</source>
        <translation>No hay papel «{0}» para la hoja de montaje: elija A4 o Letter.</translation>
    </message>
    <message>
        <source>There is no paper "{0}": choose A4, A3 or Letter.</source>
        <translation>No hay papel «{0}»: elija A4, A3 o Letter.</translation>
    </message>
    <message>
        <source>There is no picture to paste: copy one first.</source>
        <translation>No hay ninguna imagen que pegar: copie antes una.</translation>
    </message>
    <message>
        <source>There is no picture to print: choose one, as the balloon has none of its own.</source>
        <translation>No hay imagen que imprimir: elija una, ya que el globo no tiene ninguna propia.</translation>
    </message>
    <message>
        <source>There is no picture to print: choose one, as the outline has none of its own.</source>
        <translation>No hay imagen que imprimir: elija una, pues el contorno no tiene.</translation>
    </message>
    <message>
        <source>There is no ready body '{0}'. Choose one of {1}.</source>
        <translation>No hay un cuerpo listo «{0}». Elija uno de {1}.</translation>
    </message>
    <message>
        <source>There is no result '{0}': take {1}.</source>
        <translation>No hay resultado «{0}»: tome {1}.</translation>
    </message>
    <message>
        <source>There is no room for a flange of {0} in its middle: choose another panel or a smaller one.</source>
        <translation>En su centro no hay sitio para una brida de {0}: elija otro panel o una más pequeña.</translation>
    </message>
    <message>
        <source>There is no room for a flange of {0} there: choose another place or a smaller one.</source>
        <translation>No hay sitio para una brida de {0} ahí: elija otro lugar o una más pequeña.</translation>
    </message>
    <message>
        <source>There is no seam between panels {0}.</source>
        <translation>No hay ninguna costura entre los paneles {0}.</translation>
    </message>
    <message>
        <source>There is no seam near {0}.</source>
        <translation>No hay ninguna costura cerca de {0}.</translation>
    </message>
    <message>
        <source>There is no seam {0} for the opening: the seams are 1 to {1}.</source>
        <translation>No hay costura {0} para la abertura: las costuras son de 1 a {1}.</translation>
    </message>
    <message>
        <source>There is no share {0} of {1}: write one from 1/{2} on.</source>
        <translation>No hay parte {0} de {1}: escriba una a partir de 1/{2}.</translation>
    </message>
    <message>
        <source>There is no sheet {0}: give a number from 1 to {1}.</source>
        <translation>No hay lámina {0}: indique un número de 1 a {1}.</translation>
    </message>
    <message>
        <source>There is no solver named '{0}'. Use 'native', 'numpy' or 'newmark'.</source>
        <translation>No hay ningún solucionador llamado «{0}». Use 'native', 'numpy' o 'newmark'.</translation>
    </message>
    <message>
        <source>There is no symmetry "{0}": choose one of {1}.</source>
        <translation>No hay simetría «{0}»: elija una de {1}.</translation>
    </message>
    <message>
        <source>There is nothing to copy: paint something, or select it.</source>
        <translation>No hay nada que copiar: pinte algo o selecciónelo.</translation>
    </message>
    <message>
        <source>There is too little memory for this: take a coarser mesh, or close other programs.</source>
        <translation>Hay muy poca memoria para esto: tome una malla más gruesa o cierre otros programas.</translation>
    </message>
    <message>
        <source>There is too little memory for this: take a coarser mesh, or close other programs. Details are in '{0}'.</source>
        <translation>Hay muy poca memoria para esto: tome una malla más gruesa o cierre otros programas. Los detalles están en «{0}».</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>Thickness of the balloon</source>
        <translation>Grosor del globo</translation>
    </message>
    <message>
        <source>Thickness of the pen ([ thinner, ] thicker)</source>
        <translation>Grosor del trazo ([ más fino, ] más grueso)</translation>
    </message>
    <message>
        <source>This Python has no working ctypes module, which SciPy and the native solver need: patterns can be changed and written, but no balloon can be inflated anew. Take another build of FreeCAD or of Python.</source>
        <translation>Este Python no tiene un módulo ctypes que funcione, y SciPy y el solucionador nativo lo necesitan: los patrones se pueden cambiar y escribir, pero no se puede inflar ningún globo de nuevo. Use otra compilación de FreeCAD o de Python.</translation>
    </message>
    <message>
        <source>This arm is too thin to fill: drawn {width} wide, it becomes {measured} thick. Make it {wanted} wide.</source>
        <translation>Este brazo es demasiado fino para llenarse: dibujado con {width} de ancho, queda con {measured} de grueso. Hágalo de {wanted} de ancho.</translation>
    </message>
    <message>
        <source>This arm is too thin to fill: {}. Make it {}?</source>
        <translation>Este brazo es demasiado fino para llenarse: {}. ¿Hacerlo de {}?</translation>
    </message>
    <message>
        <source>This arm stays much thinner than the rest: drawn {width} wide, it becomes {measured} thick. For a rounder one make it {wanted} wide.</source>
        <translation>Este brazo queda mucho más fino que el resto: dibujado con {width} de ancho, queda con {measured} de grueso. Para que sea más redondo, hágalo de {wanted} de ancho.</translation>
    </message>
    <message>
        <source>This balloon has not been worked out yet: start the study again.</source>
        <translation>Este globo aún no se ha calculado: inicie el estudio de nuevo.</translation>
    </message>
    <message>
        <source>This balloon holds less than {0} at any pressure that suits its film: {1} at {2}. Change the size of the balloon or the volume.</source>
        <translation>Este globo contiene menos de {0} a cualquier presión que admita su película: {1} a {2}. Cambie el tamaño del globo o el volumen.</translation>
    </message>
    <message>
        <source>This balloon holds more than {0} at any pressure that suits its film: {1} at {2}. Change the size of the balloon or the volume.</source>
        <translation>Este globo contiene más de {0} a cualquier presión que admita su película: {1} a {2}. Cambie el tamaño del globo o el volumen.</translation>
    </message>
    <message>
        <source>This cannot be shown ({0}).</source>
        <translation>Esto no se puede mostrar ({0}).</translation>
    </message>
    <message>
        <source>This gas is not lighter than the air around, so the balloon never floats: choose another gas or a higher temperature of the gas.</source>
        <translation>Este gas no es más ligero que el aire de alrededor, así que el globo nunca flota: elija otro gas o una temperatura del gas mayor.</translation>
    </message>
    <message>
        <source>This gives no whole number: {}</source>
        <translation>Esto no da un número entero: {}</translation>
    </message>
    <message>
        <source>This is a fault of the program, not yours, and its details cannot be written anywhere. Please report it: {0}, {1}.</source>
        <translation>Es un fallo del programa, no suyo, y sus detalles no se pueden escribir en ningún sitio. Comuníquelo, por favor: {0}, {1}.</translation>
    </message>
    <message>
        <source>This is a fault of the program, not yours. Its details are in '{0}': please report it with this file.</source>
        <translation>Es un fallo del programa, no suyo. Sus detalles están en «{0}»: comuníquelo, por favor, con este archivo.</translation>
    </message>
    <message>
        <source>This is shape {0} of the {1} in the drawing.</source>
        <translation>Esta es la forma {0} de las {1} del dibujo.</translation>
    </message>
    <message>
        <source>This neck chokes the air: inside it is as wide as a tube of {measured} of film, the intake is {intake}. {behind} of the balloon fill through it. Make it {wanted} wide.</source>
        <translation>Este cuello estrangula el aire: por dentro equivale a un tubo de {measured} de película, la boca mide {intake}. {behind} del globo se llena por él. Hágalo de {wanted} de ancho.</translation>
    </message>
    <message>
        <source>This neck is too thin to let the air through: {}. Make it {}?</source>
        <translation>Este cuello es demasiado fino para que pase el aire: {}. ¿Hacerlo de {}?</translation>
    </message>
    <message>
        <source>This neck slows the filling: inside it is as wide as a tube of {measured} of film, the intake is {intake}. {behind} of the balloon fill through it. For quicker filling make it {wanted} wide.</source>
        <translation>Este cuello hace más lento el llenado: por dentro equivale a un tubo de {measured} de película, la boca mide {intake}. {behind} del globo se llena por él. Para llenar más deprisa, hágalo de {wanted} de ancho.</translation>
    </message>
    <message>
        <source>This notch pulls the film {measured} as tight as elsewhere, so that it wrinkles there. A radius of {wanted} eases that.</source>
        <translation>Esta entalla tensa la película {measured} más que en otras partes, y ahí se arruga. Un radio de {wanted} lo alivia.</translation>
    </message>
    <message>
        <source>This notch pulls the film {measured} as tight as elsewhere; it wrinkles there and is where it would tear. Round it with a radius of {wanted}.</source>
        <translation>Esta entalla tensa la película {measured} más que en otras partes; ahí se arruga y se rasgaría. Redondéela con un radio de {wanted}.</translation>
    </message>
    <message>
        <source>This row is not worked out: choose Work out.</source>
        <translation>Esta fila no está calculada: elija Calcular.</translation>
    </message>
    <message>
        <source>This shape does not tell a stretch of the film from a weld that draws the seam inward: it is either a stretch of {0}, or a weld that draws it inward by {1}.</source>
        <translation>Esta forma no distingue un estiramiento de la película de una soldadura que lleva la costura hacia dentro: es o bien un estiramiento de {0}, o bien una soldadura que la lleva hacia dentro {1}.</translation>
    </message>
    <message>
        <source>This shape stays flat: it holds {percent} of the air that a round balloon of as much film would. Fewer and wider parts make it rounder.</source>
        <translation>Esta forma queda plana: contiene {percent} del aire que tendría un globo redondo con igual película. Partes menos numerosas y más anchas la redondean.</translation>
    </message>
    <message>
        <source>This shape stays rather flat: it holds {percent} of the air that a round balloon of as much film would. Fewer and wider parts make it rounder.</source>
        <translation>Esta forma queda bastante plana: contiene {percent} del aire que tendría un globo redondo con igual película. Partes menos numerosas y más anchas la redondean.</translation>
    </message>
    <message>
        <source>This tip stays flat over {length}: it is too pointed. Round it with a radius of {wanted}.</source>
        <translation>Esta punta queda plana a lo largo de {length}: es demasiado aguda. Redondéela con un radio de {wanted}.</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Umbral</translation>
    </message>
    <message>
        <source>Tie a ribbon round the neck, and to it a weight heavier than the {lift} that {gas} lifts. No metallic ribbon on foil, never let it fly.</source>
        <translation>Ate una cinta al cuello, y a ella un peso mayor que los {lift} que levanta el gas ({gas}). Nada de cinta metálica en película metalizada, no lo suelte nunca.</translation>
    </message>
    <message>
        <source>Tie a ribbon round the neck, to hang it up or to hold it: it does not float.</source>
        <translation>Ate una cinta al cuello, para colgarlo o sujetarlo: no flota.</translation>
    </message>
    <message>
        <source>Tip that stays flat</source>
        <translation>Punta que queda plana</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>To cut, your settings of {cut_machine}: {cut}.</source>
        <translation>Para cortar, sus ajustes de {cut_machine}: {cut}.</translation>
    </message>
    <message>
        <source>To let the gas out, cut the seal across the neck off.</source>
        <translation>Para sacar el gas, corte la soldadura a través del cuello.</translation>
    </message>
    <message>
        <source>To let the gas out, push a straw in through the neck until it hisses, and press gently. Keep the balloon flat, not folded: it can be filled again.</source>
        <translation>Para sacar el gas, meta una pajita por el cuello hasta que silbe y apriete suavemente. Guarde el globo plano, sin doblar: se puede volver a llenar.</translation>
    </message>
    <message>
        <source>To this value, with its unit</source>
        <translation>Hasta este valor, con su unidad</translation>
    </message>
    <message>
        <source>To weld, your settings of {weld_machine}: {weld}.</source>
        <translation>Para soldar, sus ajustes de {weld_machine}: {weld}.</translation>
    </message>
    <message>
        <source>Tolerances are worked out for two equal panels of one shape: </source>
        <translation>Las tolerancias se calculan para dos paneles iguales de una sola forma: </translation>
    </message>
    <message>
        <source>Tolerances are worked out for two equal panels, of which one is simulated: leave out --two-panels, and take a drawing.</source>
        <translation>Las tolerancias se calculan para dos paneles iguales, de los que se simula uno: omita --two-panels y tome un dibujo.</translation>
    </message>
    <message>
        <source>Too many samples could not be made to say which pressure 95 of 100 balloons bear.</source>
        <translation>No se pudieron hacer demasiadas muestras para decir qué presión soportan 95 de 100 globos.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>Tool paths</source>
        <translation>Trayectorias de herramienta</translation>
    </message>
    <message>
        <source>Tool paths are not split over beds: write the G-code, or choose a larger bed.</source>
        <translation>Las trayectorias de herramienta no se reparten en varias camas: escriba el código G o elija una cama mayor.</translation>
    </message>
    <message>
        <source>Tool paths, no file</source>
        <translation>Trayectorias de herramienta, sin archivo</translation>
    </message>
    <message>
        <source>Tracing paper, 92 g/m²</source>
        <translation>Papel vegetal, 92 g/m²</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparente</translation>
    </message>
    <message>
        <source>Triangle {0} of panel {1} has no area. Mesh the panel anew.</source>
        <translation>El triángulo {0} del panel {1} no tiene área. Vuelva a mallar el panel.</translation>
    </message>
    <message>
        <source>Triangle {0} of panel {1} runs clockwise. Mesh the panel anew.</source>
        <translation>El triángulo {0} del panel {1} gira en sentido horario. Vuelva a mallar el panel.</translation>
    </message>
    <message>
        <source>Triangles of the mesh that lay on others were left out: {0}.</source>
        <translation>Triángulos de la malla que estaban sobre otros y se omitieron: {0}.</translation>
    </message>
    <message>
        <source>Triangles of the mesh that stood on its surface, or were walls inside it, were left out: {0}.</source>
        <translation>Triángulos de la malla que sobresalían de su superficie, o eran paredes en su interior, y se omitieron: {0}.</translation>
    </message>
    <message>
        <source>Triangles of the mesh that were the wrong way round were turned: {0}.</source>
        <translation>Triángulos de la malla que estaban al revés y se giraron: {0}.</translation>
    </message>
    <message>
        <source>Triangles of the mesh whose points are no numbers were left out: {0}.</source>
        <translation>Triángulos de la malla cuyos puntos no son números y se omitieron: {0}.</translation>
    </message>
    <message>
        <source>Triangles that crossed others were cut out, and closed: {0}.</source>
        <translation>Triángulos que cruzaban otros; se recortaron y se cerró el hueco: {0}.</translation>
    </message>
    <message>
        <source>True length</source>
        <translation>Longitud real</translation>
    </message>
    <message>
        <source>Try temperature and time on two scraps: the weld must stretch or tear before it opens.</source>
        <translation>Pruebe temperatura y tiempo en dos retales: la soldadura debe estirarse o rasgarse antes de abrirse.</translation>
    </message>
    <message>
        <source>Turn piece</source>
        <translation>Girar pieza</translation>
    </message>
    <message>
        <source>Turning axis</source>
        <translation>Eje de giro</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Se vuelve</translation>
    </message>
    <message>
        <source>Turns a minute; empty: not known yet</source>
        <translation>Vueltas por minuto; vacío: aún no se sabe</translation>
    </message>
    <message>
        <source>Twelve panels that follow a solid: change its sizes in the spreadsheet</source>
        <translation>Doce paneles que siguen un sólido: cambie sus medidas en la hoja de cálculo</translation>
    </message>
    <message>
        <source>Two circles: change their diameters in the sketch</source>
        <translation>Dos círculos: cambie sus diámetros en el croquis</translation>
    </message>
    <message>
        <source>Two equal panels have one seam: what is said of the seam or edge of the opening has no effect. Say the direction of the intake, or its place along the seam.</source>
        <translation>Dos paneles iguales tienen una sola costura: lo dicho de la costura o del borde de la abertura no tiene efecto. Indique la dirección de la boca, o su lugar a lo largo de la costura.</translation>
    </message>
    <message>
        <source>Two equal panels lie flat and have no lower end. Give lift to a standing body.</source>
        <translation>Dos paneles iguales yacen planos y no tienen extremo inferior. Dé sustentación a un cuerpo de pie.</translation>
    </message>
    <message>
        <source>Two panels</source>
        <translation>Dos paneles</translation>
    </message>
    <message>
        <source>Two panels of the JSON file are called '{0}'. Give each a name of its own.</source>
        <translation>Dos paneles del archivo JSON se llaman «{0}». Dé a cada uno su nombre.</translation>
    </message>
    <message>
        <source>Two panels with a grain aslant are no mirror images. Turn the grain along x or y.</source>
        <translation>Dos paneles con la fibra inclinada no son imágenes especulares. Gire la fibra según x o y.</translation>
    </message>
    <message>
        <source>Two shapes meet at {0}; part them, or join them into one.</source>
        <translation>Dos formas se tocan en {0}; sepárelas o únalas en una.</translation>
    </message>
    <message>
        <source>Type = for an expression</source>
        <translation>Escriba = para una expresión</translation>
    </message>
    <message>
        <source>Type two places for a cut, such as 10 0 50; 10 20 50, or choose a seam and type one.</source>
        <translation>Escriba dos lugares para un corte, como 10 0 50; 10 20 50, o elija una costura y escriba uno.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Deshacer (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Uniform errors along a seam need scipy: pip install scipy.</source>
        <translation>Los errores uniformes a lo largo de una costura necesitan scipy: pip install scipy.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Unit of the numbers in its files</source>
        <translation>Unidad de los números en sus archivos</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Desconocido</translation>
    </message>
    <message>
        <source>Upload the SVG as a cut image and compare the control bar: some versions read the size at 72 dpi. Nothing is in the file that may not be cut. It adds the knife's offset and overcut itself. Design Space prints marks of its own (Print Then Cut), round at most 9.25 x 6.75 in: a print has none, and is refused where it is larger. Where yours takes more, raise most_mm in a copy.</source>
        <translation>Suba el SVG como imagen de corte y compare la barra de control: algunas versiones leen el tamaño a 72 ppp. En el archivo no hay nada que no se pueda cortar. Añade él mismo el desvío y el sobrecorte de la cuchilla. Design Space imprime marcas propias (Print Then Cut), alrededor de 9,25 x 6,75 pulgadas como mucho: una impresión no lleva ninguna, y se rechaza si es mayor. Si el suyo admite más, aumente most_mm en una copia.</translation>
    </message>
    <message>
        <source>Upper end</source>
        <translation>Extremo superior</translation>
    </message>
    <message>
        <source>Use it as --machine {0}; in FreeCAD it is among the machines.</source>
        <translation>Úsela como --machine {0}; en FreeCAD está entre las máquinas.</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Usado</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Valve film</source>
        <translation>Película de válvula</translation>
    </message>
    <message>
        <source>Valve, on one panel</source>
        <translation>Válvula, sobre un panel</translation>
    </message>
    <message>
        <source>Vary</source>
        <translation>Variar</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violeta</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volume of the body: {0}, the balloon has {1} of it</source>
        <translation>Volumen del cuerpo: {0}; el globo tiene {1} de él</translation>
    </message>
    <message>
        <source>Warm air</source>
        <translation>Aire caliente</translation>
    </message>
    <message>
        <source>Water column</source>
        <translation>Columna de agua</translation>
    </message>
    <message>
        <source>Weakest place</source>
        <translation>Lugar más débil</translation>
    </message>
    <message>
        <source>Weakest place: {0} at {1}</source>
        <translation>Lugar más débil: {0} en {1}</translation>
    </message>
    <message>
        <source>Weakest place: {0} at {1}, estimated: the film did not come to rest</source>
        <translation>Lugar más débil: {0} en {1}, estimado: la película no llegó al reposo</translation>
    </message>
    <message>
        <source>Web page that turns the balloon (HTML)</source>
        <translation>Página web que gira el globo (HTML)</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Weight of film, welds and valve</source>
        <translation>Peso de película, soldaduras y válvula</translation>
    </message>
    <message>
        <source>Weld</source>
        <translation>Soldadura</translation>
    </message>
    <message>
        <source>Weld TPU to TPU with an iron or hot air, 10 mm wide. Warp and weft are stiff, the bias is soft: the model takes one modulus for all directions. Stiffer after the first inflations.</source>
        <translation>Suelde TPU con TPU con plancha o aire caliente, 10 mm de ancho. Urdimbre y trama son rígidas, el bies es blando: el modelo toma un módulo para todas las direcciones. Más rígido tras los primeros inflados.</translation>
    </message>
    <message>
        <source>Weld across the neck along its line, through panels and strips: the field keeps the channel open. Pull the slip out and blow through the valve.</source>
        <translation>Suelde a través del cuello por su línea, paneles y tiras juntos: el campo mantiene abierto el canal. Saque el trozo de papel y sople por la válvula.</translation>
    </message>
    <message>
        <source>Weld along the dashed line, {seal} wide, all the way round.</source>
        <translation>Suelde a lo largo de la línea discontinua, con {seal} de ancho, todo alrededor.</translation>
    </message>
    <message>
        <source>Weld along the dashed line, {seal} wide. Leave the mouth of the neck open.</source>
        <translation>Suelde a lo largo de la línea discontinua, con {seal} de ancho. Deje abierta la boca del cuello.</translation>
    </message>
    <message>
        <source>Weld and cut</source>
        <translation>Soldadura y corte</translation>
    </message>
    <message>
        <source>Weld overrun</source>
        <translation>Solape de soldadura</translation>
    </message>
    <message>
        <source>Weld rigidity</source>
        <translation>Rigidez de la soldadura</translation>
    </message>
    <message>
        <source>Weld the lines inside the balloon.</source>
        <translation>Suelde las líneas del interior del globo.</translation>
    </message>
    <message>
        <source>Weld the two strips together along their lines; over the marked field, heat-resistant ink or a slip of baking paper keeps the channel open. Tack them to one panel, their end at the mouth; then weld round the balloon and across the neck. Fill with a 6 mm tube: the pressure closes the strips.</source>
        <translation>Suelde las dos tiras entre sí por sus líneas; sobre el campo marcado, tinta resistente al calor o un trozo de papel de hornear mantiene abierto el canal. Fíjelas a un panel, con el extremo en la boca; luego suelde alrededor del globo y a través del cuello. Llene con un tubo de 6 mm: la presión cierra las tiras.</translation>
    </message>
    <message>
        <source>Weld with high frequency along the dashed line, {seal} wide, all the way round.</source>
        <translation>Suelde por alta frecuencia a lo largo de la línea discontinua, con {seal} de ancho, todo alrededor.</translation>
    </message>
    <message>
        <source>Weld with high frequency along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>Suelde por alta frecuencia a lo largo de la línea discontinua, con {seal} de ancho; deje abierta la boca del cuello.</translation>
    </message>
    <message>
        <source>Weld: {}</source>
        <translation>Soldadura: {}</translation>
    </message>
    <message>
        <source>Welded across, last</source>
        <translation>Soldada a través, al final</translation>
    </message>
    <message>
        <source>Welding</source>
        <translation>Soldadura</translation>
    </message>
    <message>
        <source>Welding: {0}</source>
        <translation>Soldadura: {0}</translation>
    </message>
    <message>
        <source>Welds easily with an impulse sealer or an iron. Yields at about 9 MPa, half its tensile strength, and creeps: keep the pressure low.</source>
        <translation>Se suelda fácilmente con selladora de impulso o plancha. Cede a unos 9 MPa, la mitad de su resistencia, y fluye: mantenga baja la presión.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>What is behind the balloon</source>
        <translation>Lo que hay detrás del globo</translation>
    </message>
    <message>
        <source>What is cut is a line in the spot colour CutContour, which prints over the picture and leaves no gap in it. With artwork both are in artwork-print-and-cut-pdf.pdf. The shop's program adds marks of its own.</source>
        <translation>Lo que se corta es una línea en la tinta plana CutContour, que se imprime sobre la imagen y no deja hueco en ella. Con ilustración, ambas están en artwork-print-and-cut-pdf.pdf. El programa de la imprenta añade marcas propias.</translation>
    </message>
    <message>
        <source>What is left of other film is of one film: choose patterns of one film for it.</source>
        <translation>Los retales son de una sola película: elija para ellos patrones de una sola película.</translation>
    </message>
    <message>
        <source>What it can work on, such as 600 x 400 mm, or 600 mm for a roll; empty where there is no limit</source>
        <translation>Lo que puede trabajar, por ejemplo 600 x 400 mm, o 600 mm para un rollo; vacío si no hay límite</translation>
    </message>
    <message>
        <source>What it holds</source>
        <translation>Lo que lleva montado</translation>
    </message>
    <message>
        <source>What it takes to make it</source>
        <translation>Lo que hace falta para hacerlo</translation>
    </message>
    <message>
        <source>What most shops ask for: R12, closed polylines, nothing on the sheet that is not cut. R12 knows no unit, so the file's name tells it.</source>
        <translation>Lo que piden casi todos los talleres: R12, polilíneas cerradas, nada en la lámina que no se corte. R12 no conoce unidades, por eso las dice el nombre del archivo.</translation>
    </message>
    <message>
        <source>What shows the balloon</source>
        <translation>Lo que muestra el globo</translation>
    </message>
    <message>
        <source>What the chosen gas carries besides</source>
        <translation>Lo que el gas elegido lleva además</translation>
    </message>
    <message>
        <source>What this film costs, without what is left over</source>
        <translation>Lo que cuesta esta película, sin los recortes</translation>
    </message>
    <message>
        <source>What this gas costs</source>
        <translation>Lo que cuesta este gas</translation>
    </message>
    <message>
        <source>What this machine can work on, such as 600 x 400 mm, or 600 mm for a roll; empty where there is no limit. It is kept for this machine</source>
        <translation>Lo que esta máquina puede trabajar, por ejemplo 600 x 400 mm, o 600 mm para un rollo; vacío si no hay límite. Se guarda para esta máquina</translation>
    </message>
    <message>
        <source>What works here</source>
        <translation>Qué funciona aquí</translation>
    </message>
    <message>
        <source>What you want to read when you choose this machine, such as film and separating layer</source>
        <translation>Lo que quiere leer al elegir esta máquina, por ejemplo película y capa separadora</translation>
    </message>
    <message>
        <source>What {0} sent is not the native solver of this release: its SHA-256 is another one. It was not kept. {1}</source>
        <translation>Lo que envió {0} no es el solucionador nativo de esta versión: su SHA-256 es otro. No se guardó. {1}</translation>
    </message>
    <message>
        <source>When all shards are done, --collect writes the table.</source>
        <translation>Cuando todas las partes estén hechas, --collect escribe la tabla.</translation>
    </message>
    <message>
        <source>Where an edge is cut into tabs, turn it round the other one tab by tab while you seal.</source>
        <translation>Donde un borde está cortado en pestañas, vuélvalo sobre el otro pestaña a pestaña mientras sella.</translation>
    </message>
    <message>
        <source>Where the film wrinkles</source>
        <translation>Dónde se arruga la película</translation>
    </message>
    <message>
        <source>Whether the {0} of the intake's pieces welds to {1} is not known: try it on a scrap first.</source>
        <translation>No se sabe si {0} de las piezas de la boca se suelda con {1}: pruébelo antes en un retal.</translation>
    </message>
    <message>
        <source>While this is pressed, the edge that you pick is where it is filled</source>
        <translation>Mientras esté pulsado, el borde que elija es por donde se llena</translation>
    </message>
    <message>
        <source>While this is pressed, the ring in the 3D view moves the intake</source>
        <translation>Mientras esté pulsado, el anillo de la vista 3D mueve la boca</translation>
    </message>
    <message>
        <source>While this is pressed, what you select becomes the source</source>
        <translation>Mientras esté pulsado, lo que seleccione será la fuente</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanco</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Width hidden in wrinkles</source>
        <translation>Anchura oculta en arrugas</translation>
    </message>
    <message>
        <source>Width of film that the beam or cutter takes away: cuts are moved outward by half of it</source>
        <translation>Anchura de película que quita el haz o la fresa: los cortes se mueven hacia fuera la mitad</translation>
    </message>
    <message>
        <source>Width of the balloon when it is inflated</source>
        <translation>Anchura del globo una vez inflado</translation>
    </message>
    <message>
        <source>Will it float?</source>
        <translation>¿Flotará?</translation>
    </message>
    <message>
        <source>Will it float? {0}</source>
        <translation>¿Flotará? {0}</translation>
    </message>
    <message>
        <source>With --scale {0} the size tells nothing of the film: give the photograph's scale to fit it.</source>
        <translation>Con --scale {0} el tamaño no dice nada de la película: indique la escala de la fotografía para ajustarla.</translation>
    </message>
    <message>
        <source>With a side band the balloon of this drawing becomes {0} to {1} thick, not {2}. Choose a thickness between, or draw its parts wider or narrower.</source>
        <translation>Con una banda lateral el globo de este dibujo tendrá de {0} a {1} de espesor, no {2}. Elija un espesor entre ellos, o dibuje sus partes más anchas o más estrechas.</translation>
    </message>
    <message>
        <source>With so few samples, {0}, nobody can say which pressure 95 of 100 balloons bear: take {1} or more.</source>
        <translation>{0} muestras son muy pocas para decir qué presión soportan 95 de 100 globos: tome {1} o más.</translation>
    </message>
    <message>
        <source>With the fonts of this computer {0} cannot be drawn, letter by letter from left to right: leave that out of the label, or install a font that has it and start again.</source>
        <translation>Con los tipos de letra de este ordenador no se puede dibujar {0}, letra a letra de izquierda a derecha: quítelo de la etiqueta o instale un tipo de letra que lo tenga y vuelva a empezar.</translation>
    </message>
    <message>
        <source>With {0} panels some would cross themselves when laid flat: the body has {1}.</source>
        <translation>Con {0} paneles, algunos se cruzarían consigo mismos al aplanarlos: el cuerpo tiene {1}.</translation>
    </message>
    <message>
        <source>With {0} to {1} panels some would cross themselves when laid flat: give more panels.</source>
        <translation>Con {0} a {1} paneles, algunos se cruzarían consigo mismos al aplanarlos: indique más paneles.</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Dentro de</translation>
    </message>
    <message>
        <source>Without this seam panel {0} goes round the body and cannot be laid flat.</source>
        <translation>Sin esta costura, el panel {0} rodea el cuerpo y no se puede aplanar.</translation>
    </message>
    <message>
        <source>Work out</source>
        <translation>Calcular</translation>
    </message>
    <message>
        <source>Work out how near balloons of 6 to 60 panels come to the body</source>
        <translation>Calcular cuánto se acercan al cuerpo globos de 6 a 60 paneles</translation>
    </message>
    <message>
        <source>Wrinkles</source>
        <translation>Arrugas</translation>
    </message>
    <message>
        <source>Write all results for ParaView (.vtu) or NumPy (.npz), or the shape alone (.stl)</source>
        <translation>Escribir todos los resultados para ParaView (.vtu) o NumPy (.npz), o solo la forma (.stl)</translation>
    </message>
    <message>
        <source>Write anyway</source>
        <translation>Escribir de todos modos</translation>
    </message>
    <message>
        <source>Write files…</source>
        <translation>Escribir archivos…</translation>
    </message>
    <message>
        <source>Write several files, each as large as the bed. Crosses in waste film tell how the film is laid on anew for the next one</source>
        <translation>Escribir varios archivos, cada uno tan grande como la cama. Unas cruces en la película sobrante dicen cómo recolocarla para el siguiente</translation>
    </message>
    <message>
        <source>Write the file although it is larger than the bed</source>
        <translation>Escribir el archivo aunque sea más grande que la cama</translation>
    </message>
    <message>
        <source>Write the pieces as they lie, and the artwork if it is shown, to a PDF in real size</source>
        <translation>Escribir las piezas como están, y la ilustración si se muestra, en un PDF a tamaño real</translation>
    </message>
    <message>
        <source>Write these frames as a moving picture, with the artwork, on white</source>
        <translation>Escribir estos fotogramas como animación, con la impresión, sobre blanco</translation>
    </message>
    <message>
        <source>Write what is left of the film to a file, for another layout</source>
        <translation>Escribir lo que queda de la película en un archivo, para otra colocación</translation>
    </message>
    <message>
        <source>Write {"a": ["top", 0, 1], "b": ["side", 3, 2]}.</source>
        <translation>Escriba {"a": ["top", 0, 1], "b": ["side", 3, 2]}.</translation>
    </message>
    <message>
        <source>Write {"do": "add", "at": [[0.3, 0.5]]}.</source>
        <translation>Escriba {"do": "add", "at": [[0.3, 0.5]]}.</translation>
    </message>
    <message>
        <source>Write {"do": "cut", "at": [[0, 0, 50], [100, 0, 20]]}.</source>
        <translation>Escriba {"do": "cut", "at": [[0, 0, 50], [100, 0, 20]]}.</translation>
    </message>
    <message>
        <source>Write {"name": "top", "outer": [[0, 0], [300, 0], [150, 200]]}.</source>
        <translation>Escriba {"name": "top", "outer": [[0, 0], [300, 0], [150, 200]]}.</translation>
    </message>
    <message>
        <source>Write {"panel": "side", "at": 2}.</source>
        <translation>Escriba {"panel": "side", "at": 2}.</translation>
    </message>
    <message>
        <source>Write {"unit": "mm", "outer": [[0, 0], [300, 0], [150, 200]]}.</source>
        <translation>Escriba {"unit": "mm", "outer": [[0, 0], [300, 0], [150, 200]]}.</translation>
    </message>
    <message>
        <source>Write {"unit": "mm", "profile": [[0, 0], [150, 200], [0, 400]]}.</source>
        <translation>Escriba {"unit": "mm", "profile": [[0, 0], [150, 200], [0, 400]]}.</translation>
    </message>
    <message>
        <source>Writing DXF needs ezdxf: install it with pip install ezdxf, or use the SVG file.</source>
        <translation>Escribir DXF necesita ezdxf: instálelo con pip install ezdxf o use el archivo SVG.</translation>
    </message>
    <message>
        <source>Writing PDF needs matplotlib: install it with pip install matplotlib, or use the SVG file.</source>
        <translation>Escribir PDF necesita matplotlib: instálelo con pip install matplotlib, o use el archivo SVG.</translation>
    </message>
    <message>
        <source>Writing the test card</source>
        <translation>Escribiendo la tarjeta de prueba</translation>
    </message>
    <message>
        <source>Writing {0}</source>
        <translation>Escribiendo {0}</translation>
    </message>
    <message>
        <source>Written to {}</source>
        <translation>Escrito en {}</translation>
    </message>
    <message>
        <source>Written to {}, in real size on {}: print it at 100 %.</source>
        <translation>Escrito en {}, a tamaño real en {}: imprímalo al 100 %.</translation>
    </message>
    <message>
        <source>Wrote {0}</source>
        <translation>Escrito: {0}</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Amarillo</translation>
    </message>
    <message>
        <source>You paint on: {}</source>
        <translation>Pinta en: {}</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>Módulo de Young</translation>
    </message>
    <message>
        <source>Young's modulus across the grain</source>
        <translation>Módulo de Young transversal a la fibra</translation>
    </message>
    <message>
        <source>Young's modulus of the film</source>
        <translation>Módulo de Young de la película</translation>
    </message>
    <message>
        <source>Zünd Cut Center (flat bed)</source>
        <translation>Zünd Cut Center (mesa plana)</translation>
    </message>
    <message>
        <source>["200mm", "300mm"], {"linspace": ["1kPa", "3kPa", 5]} with how many, {"range": [6, 12, 2]} with the step, {"between": ["1kPa", "3kPa"]} for samples, or {"glob": "drawings/*.png"}</source>
        <translation>["200mm", "300mm"], {"linspace": ["1kPa", "3kPa", 5]} con la cantidad, {"range": [6, 12, 2]} con el paso, {"between": ["1kPa", "3kPa"]} para muestras, o {"glob": "drawings/*.png"}</translation>
    </message>
    <message>
        <source>a LightBurn project has layers up to {0}: change the pen.</source>
        <translation>un proyecto de LightBurn tiene capas hasta la {0}: cambie la pluma.</translation>
    </message>
    <message>
        <source>a body consists of itself, or of one that is not there</source>
        <translation>un cuerpo consta de sí mismo, o de uno que no existe</translation>
    </message>
    <message>
        <source>a body hangs together</source>
        <translation>un cuerpo es de una sola pieza</translation>
    </message>
    <message>
        <source>a comma, quote or bracket is missing or too much in line {0}</source>
        <translation>en la línea {0} falta o sobra una coma, una comilla o un paréntesis</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>una coordenada no es un número</translation>
    </message>
    <message>
        <source>a density</source>
        <translation>una densidad</translation>
    </message>
    <message>
        <source>a face is no list of points.</source>
        <translation>una cara no es una lista de puntos.</translation>
    </message>
    <message>
        <source>a force</source>
        <translation>una fuerza</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>una longitud</translation>
    </message>
    <message>
        <source>a loop is no list of at least three points [x, y].</source>
        <translation>un contorno no es una lista de al menos tres puntos [x, y].</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>una masa</translation>
    </message>
    <message>
        <source>a number without a unit</source>
        <translation>un número sin unidad</translation>
    </message>
    <message>
        <source>a point is no three numbers.</source>
        <translation>un punto no son tres números.</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>una presión</translation>
    </message>
    <message>
        <source>a sleeve has an end</source>
        <translation>una manga tiene un extremo</translation>
    </message>
    <message>
        <source>a temperature</source>
        <translation>una temperatura</translation>
    </message>
    <message>
        <source>a transform is not a number</source>
        <translation>una transformación no es un número</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>un volumen</translation>
    </message>
    <message>
        <source>a {0} file has a unit of its own: give "unit": "mm".</source>
        <translation>un archivo {0} tiene su propia unidad: indique "unit": "mm".</translation>
    </message>
    <message>
        <source>about {}</source>
        <translation>unos {}</translation>
    </message>
    <message>
        <source>about {} x {}, {} thick, {}</source>
        <translation>unos {} x {}, {} de grueso, {}</translation>
    </message>
    <message>
        <source>air</source>
        <translation>aire</translation>
    </message>
    <message>
        <source>all files were written before to {0}</source>
        <translation>todos los archivos se escribieron antes en {0}</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>un ángulo</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>un área</translation>
    </message>
    <message>
        <source>another run has been writing there for a minute</source>
        <translation>otra ejecución lleva un minuto escribiendo ahí</translation>
    </message>
    <message>
        <source>another unit</source>
        <translation>otra unidad</translation>
    </message>
    <message>
        <source>any accuracy</source>
        <translation>cualquier precisión</translation>
    </message>
    <message>
        <source>apart {} in the mean, 95 % below {}, at most {}</source>
        <translation>distancia media {}, 95 % por debajo de {}, como mucho {}</translation>
    </message>
    <message>
        <source>areal density</source>
        <translation>densidad superficial</translation>
    </message>
    <message>
        <source>artwork.pdf was left out. {0}</source>
        <translation>Se omitió artwork.pdf. {0}</translation>
    </message>
    <message>
        <source>as made is larger</source>
        <translation>lo hecho es mayor</translation>
    </message>
    <message>
        <source>as made is smaller</source>
        <translation>lo hecho es menor</translation>
    </message>
    <message>
        <source>at most </source>
        <translation>como mucho </translation>
    </message>
    <message>
        <source>at most {0}</source>
        <translation>como mucho {0}</translation>
    </message>
    <message>
        <source>at most {} ({})</source>
        <translation>como mucho {} ({})</translation>
    </message>
    <message>
        <source>at most {} {}</source>
        <translation>como mucho {} {}</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
    <message>
        <source>back</source>
        <translation>dorso</translation>
    </message>
    <message>
        <source>baking paper</source>
        <translation>papel de hornear</translation>
    </message>
    <message>
        <source>balloon {0} of {1}</source>
        <translation>globo {0} de {1}</translation>
    </message>
    <message>
        <source>balloon {0} of {1} at most</source>
        <translation>globo {0} de {1} como máximo</translation>
    </message>
    <message>
        <source>balloon {0} of {1}, {2}</source>
        <translation>globo {0} de {1}, {2}</translation>
    </message>
    <message>
        <source>balloons</source>
        <translation>globos</translation>
    </message>
    <message>
        <source>bar or iron {0}</source>
        <translation>barra o plancha: {0}</translation>
    </message>
    <message>
        <source>bed_mm is {0}: give [width, height], [width, null] for a roll, or null where there is no limit.</source>
        <translation>bed_mm es {0}: indique [anchura, altura], [anchura, null] para un rollo, o null si no hay límite.</translation>
    </message>
    <message>
        <source>both lie on borders of one piece</source>
        <translation>ambos están en bordes de una misma pieza</translation>
    </message>
    <message>
        <source>choose Drawn as filled shape</source>
        <translation>elija Forma rellena en «Dibujado como»</translation>
    </message>
    <message>
        <source>colour index {0} and pen {1} of {2} must be from 1 to 255.</source>
        <translation>el índice de color {0} y la pluma {1} de {2} deben ser de 1 a 255.</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>conectando</translation>
    </message>
    <message>
        <source>crosses for the eye</source>
        <translation>cruces a ojo</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>corte</translation>
    </message>
    <message>
        <source>cut inside</source>
        <translation>corte interior</translation>
    </message>
    <message>
        <source>cutting error</source>
        <translation>error de corte</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>profundidad</translation>
    </message>
    <message>
        <source>designing a balloon</source>
        <translation>diseñar un globo</translation>
    </message>
    <message>
        <source>does not name its unit</source>
        <translation>no indica su unidad</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>dibujo</translation>
    </message>
    <message>
        <source>drawn mark</source>
        <translation>marca dibujada</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>espera</translation>
    </message>
    <message>
        <source>edge {0} of {1}panel '{2}'</source>
        <translation>borde {0} del {1}panel «{2}»</translation>
    </message>
    <message>
        <source>edges {0} to {1}</source>
        <translation>bordes {0} a {1}</translation>
    </message>
    <message>
        <source>empty: </source>
        <translation>vacío: </translation>
    </message>
    <message>
        <source>feed</source>
        <translation>avance</translation>
    </message>
    <message>
        <source>feed in corners</source>
        <translation>avance en las esquinas</translation>
    </message>
    <message>
        <source>fetch the native solver from the network, where the workbench came without it</source>
        <translation>descargar de la red el solucionador nativo, si el banco de trabajo vino sin él</translation>
    </message>
    <message>
        <source>fetching</source>
        <translation>descargando</translation>
    </message>
    <message>
        <source>few panels</source>
        <translation>pocos paneles</translation>
    </message>
    <message>
        <source>film</source>
        <translation>película</translation>
    </message>
    <message>
        <source>film and valve weigh {0}</source>
        <translation>película y válvula pesan {0}</translation>
    </message>
    <message>
        <source>fitted to {0}</source>
        <translation>ajustado a {0}</translation>
    </message>
    <message>
        <source>fold</source>
        <translation>pliegue</translation>
    </message>
    <message>
        <source>front</source>
        <translation>frente</translation>
    </message>
    <message>
        <source>gas</source>
        <translation>gas</translation>
    </message>
    <message>
        <source>given by the user</source>
        <translation>indicado por el usuario</translation>
    </message>
    <message>
        <source>glued seam</source>
        <translation>costura pegada</translation>
    </message>
    <message>
        <source>glued seam inside</source>
        <translation>costura pegada interior</translation>
    </message>
    <message>
        <source>grain at {}°</source>
        <translation>fibra a {}°</translation>
    </message>
    <message>
        <source>height</source>
        <translation>altura</translation>
    </message>
    <message>
        <source>helium</source>
        <translation>helio</translation>
    </message>
    <message>
        <source>hide {} of the film's width</source>
        <translation>ocultan {} del ancho de la película</translation>
    </message>
    <message>
        <source>hint</source>
        <translation>sugerencia</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>agujero</translation>
    </message>
    <message>
        <source>hole {0} of panel '{1}'</source>
        <translation>agujero {0} del panel «{1}»</translation>
    </message>
    <message>
        <source>hot tip</source>
        <translation>punta caliente</translation>
    </message>
    <message>
        <source>hot tip at {0}</source>
        <translation>punta caliente: {0}</translation>
    </message>
    <message>
        <source>hot wheel</source>
        <translation>rueda caliente</translation>
    </message>
    <message>
        <source>hydrogen</source>
        <translation>hidrógeno</translation>
    </message>
    <message>
        <source>if the weld creases: {0}</source>
        <translation>si la soldadura se arruga: {0}</translation>
    </message>
    <message>
        <source>in both sides of seam {0}</source>
        <translation>en ambos lados de la costura {0}</translation>
    </message>
    <message>
        <source>in seams {0} and {1}</source>
        <translation>en las costuras {0} y {1}</translation>
    </message>
    <message>
        <source>in the mean {}</source>
        <translation>de media {}</translation>
    </message>
    <message>
        <source>in the mean {} ({})</source>
        <translation>de media {} ({})</translation>
    </message>
    <message>
        <source>in the mean {}, 95 % below {}, at most {}</source>
        <translation>de media {}, 95 % por debajo de {}, como mucho {}</translation>
    </message>
    <message>
        <source>in {}</source>
        <translation>en {}</translation>
    </message>
    <message>
        <source>inflated</source>
        <translation>inflado</translation>
    </message>
    <message>
        <source>inflated {0}, {1}</source>
        <translation>inflado {0}, {1}</translation>
    </message>
    <message>
        <source>inflating</source>
        <translation>inflando</translation>
    </message>
    <message>
        <source>inflating in time</source>
        <translation>inflando en el tiempo</translation>
    </message>
    <message>
        <source>intake piece {0}</source>
        <translation>pieza de la boca {0}</translation>
    </message>
    <message>
        <source>it ends too early.</source>
        <translation>acaba demasiado pronto.</translation>
    </message>
    <message>
        <source>it has {0} shapes: give 1 to {1}.</source>
        <translation>tiene {0} formas: indique de 1 a {1}.</translation>
    </message>
    <message>
        <source>it is nested too deeply</source>
        <translation>está anidado con demasiada profundidad</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>no es un archivo</translation>
    </message>
    <message>
        <source>it is thinner than any film. Make it wider.</source>
        <translation>es más delgado que cualquier película. Hágalo más ancho.</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>es demasiado grande</translation>
    </message>
    <message>
        <source>it would grow together with another part</source>
        <translation>se uniría con otra parte</translation>
    </message>
    <message>
        <source>its header cannot be understood.</source>
        <translation>su cabecera no se entiende.</translation>
    </message>
    <message>
        <source>its header has no end.</source>
        <translation>su cabecera no tiene fin.</translation>
    </message>
    <message>
        <source>its lines cross or touch: give the edge of one piece of film, and its holes.</source>
        <translation>sus líneas se cruzan o se tocan: indique el borde de una pieza de película, y sus agujeros.</translation>
    </message>
    <message>
        <source>its points have lists.</source>
        <translation>sus puntos tienen listas.</translation>
    </message>
    <message>
        <source>its points have no x, y and z.</source>
        <translation>sus puntos no tienen x, y y z.</translation>
    </message>
    <message>
        <source>knife</source>
        <translation>cuchilla</translation>
    </message>
    <message>
        <source>known of two equal panels alone</source>
        <translation>conocido solo de dos paneles iguales</translation>
    </message>
    <message>
        <source>laser</source>
        <translation>láser</translation>
    </message>
    <message>
        <source>layer {0} of the LightBurn project has two speeds or powers: give its roles one.</source>
        <translation>la capa {0} del proyecto de LightBurn tiene dos velocidades o potencias: dé a sus funciones una sola.</translation>
    </message>
    <message>
        <source>laying out</source>
        <translation>colocando</translation>
    </message>
    <message>
        <source>laying out, {0} so far</source>
        <translation>colocando, {0} hasta ahora</translation>
    </message>
    <message>
        <source>lead-in</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierdo</translation>
    </message>
    <message>
        <source>length</source>
        <translation>longitud</translation>
    </message>
    <message>
        <source>less than</source>
        <translation>menos de</translation>
    </message>
    <message>
        <source>less than its {} with a margin of {} ({})</source>
        <translation>menos que sus {} con margen {} ({})</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>sustentación</translation>
    </message>
    <message>
        <source>lift of the tool</source>
        <translation>elevación de la herramienta</translation>
    </message>
    <message>
        <source>line_mm of marks is {0}, and size_mm {1}: a line is at most half as wide as its mark.</source>
        <translation>line_mm de las marcas es {0}, y size_mm {1}: una línea tiene como mucho la mitad del ancho de su marca.</translation>
    </message>
    <message>
        <source>loose: {}</source>
        <translation>flojo: {}</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>making a balloon of a study</source>
        <translation>al hacer un globo de un estudio</translation>
    </message>
    <message>
        <source>making the document</source>
        <translation>crear el documento</translation>
    </message>
    <message>
        <source>marks is {0}: give {"style": ...}, or leave it out for crosses.</source>
        <translation>marks es {0}: indique {"style": ...}, u omítalo para tener cruces.</translation>
    </message>
    <message>
        <source>marks of size_mm {0} and inset_mm {1} do not fit on a page_mm of {2}: give a larger page or smaller marks.</source>
        <translation>las marcas con size_mm {0} e inset_mm {1} no caben en un page_mm de {2}: indique una página mayor o marcas menores.</translation>
    </message>
    <message>
        <source>marks of style {0} have no "{1}": only {2}.</source>
        <translation>las marcas de estilo {0} no tienen "{1}": solo {2}.</translation>
    </message>
    <message>
        <source>marks of style {0} lack {1}: add it.</source>
        <translation>a las marcas de estilo {0} les falta {1}: añádalo.</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>masa</translation>
    </message>
    <message>
        <source>may be cut</source>
        <translation>se puede cortar</translation>
    </message>
    <message>
        <source>min_power_percent of {0} is more than max_power_percent: exchange the two.</source>
        <translation>min_power_percent de {0} es mayor que max_power_percent: intercambie los dos.</translation>
    </message>
    <message>
        <source>mirrored: its other side is up, with its print and sealing side</source>
        <translation>reflejada: queda arriba su otro lado, con su impresión y su cara de sellado</translation>
    </message>
    <message>
        <source>more than</source>
        <translation>más de</translation>
    </message>
    <message>
        <source>moved at {0}</source>
        <translation>movida a {0}</translation>
    </message>
    <message>
        <source>name a property of the balloon</source>
        <translation>indique una propiedad del globo</translation>
    </message>
    <message>
        <source>names the unit {0}, which is not a usual one</source>
        <translation>indica la unidad {0}, que no es habitual</translation>
    </message>
    <message>
        <source>near {0} two of its edges are closer than {1}, and their welds run into each other: make the balloon larger or the seal narrower.</source>
        <translation>cerca de {0} dos de sus bordes están a menos de {1}, y sus soldaduras se juntan: haga el globo mayor o la soldadura más estrecha.</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>no drawing to compare with</source>
        <translation>no hay dibujo con que comparar</translation>
    </message>
    <message>
        <source>no file was written</source>
        <translation>no se escribió ningún archivo</translation>
    </message>
    <message>
        <source>no layer is written: name at least CUT.</source>
        <translation>no se escribe ninguna capa: nombre al menos CUT.</translation>
    </message>
    <message>
        <source>nobody knows "{0}" of a tool: it may be one of {1}.</source>
        <translation>nadie conoce «{0}» de una herramienta: puede ser {1}.</translation>
    </message>
    <message>
        <source>nobody knows "{0}": it may be one of {1}.</source>
        <translation>nadie conoce «{0}»: puede ser {1}.</translation>
    </message>
    <message>
        <source>nobody knows the start value "{0}": it may be one of {1}.</source>
        <translation>nadie conoce el valor inicial "{0}": puede ser {1}.</translation>
    </message>
    <message>
        <source>not converged: </source>
        <translation>no convergido: </translation>
    </message>
    <message>
        <source>notch</source>
        <translation>muesca</translation>
    </message>
    <message>
        <source>nothing is left that is large enough to be used again</source>
        <translation>no queda nada bastante grande para volver a usarse</translation>
    </message>
    <message>
        <source>number for full power</source>
        <translation>número para la potencia máxima</translation>
    </message>
    <message>
        <source>one of its values is of another kind than it must be</source>
        <translation>uno de sus valores no es del tipo que debe ser</translation>
    </message>
    <message>
        <source>only a PDF has spot colours: give "format": "pdf", or leave them out.</source>
        <translation>solo un PDF tiene tintas planas: indique "format": "pdf", u omítalas.</translation>
    </message>
    <message>
        <source>opacity</source>
        <translation>opacidad</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>contorno</translation>
    </message>
    <message>
        <source>outward of marks is {0}: write true or false.</source>
        <translation>outward de las marcas es {0}: escriba true o false.</translation>
    </message>
    <message>
        <source>over</source>
        <translation>en función de</translation>
    </message>
    <message>
        <source>pass {0}: {1}</source>
        <translation>pasada {0}: {1}</translation>
    </message>
    <message>
        <source>passes of {0} is {1}: give a whole number.</source>
        <translation>passes de {0} es {1}: indique un número entero.</translation>
    </message>
    <message>
        <source>pieces {0}, on a remnant of {1}, {2} used</source>
        <translation>piezas {0}, en un retal de {1}, {2} aprovechado</translation>
    </message>
    <message>
        <source>pieces {0}, on {1}, {2} used</source>
        <translation>piezas {0}, en {1}, {2} aprovechado</translation>
    </message>
    <message>
        <source>place "{0}" is neither {1} nor {2}.</source>
        <translation>place «{0}» no es ni {1} ni {2}.</translation>
    </message>
    <message>
        <source>power</source>
        <translation>potencia</translation>
    </message>
    <message>
        <source>pressed for {0}</source>
        <translation>presión durante {0}</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>presión</translation>
    </message>
    <message>
        <source>pressure at filling</source>
        <translation>presión al llenar</translation>
    </message>
    <message>
        <source>printing</source>
        <translation>imprimiendo</translation>
    </message>
    <message>
        <source>reading the photograph</source>
        <translation>leyendo la fotografía</translation>
    </message>
    <message>
        <source>reading the solid</source>
        <translation>leer el sólido</translation>
    </message>
    <message>
        <source>remnants {0}, {1}</source>
        <translation>retales {0}, {1}</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecho</translation>
    </message>
    <message>
        <source>safe to {}, margin {}</source>
        <translation>seguro hasta {}, margen {}</translation>
    </message>
    <message>
        <source>safe to: is being worked out</source>
        <translation>seguro hasta: se está calculando</translation>
    </message>
    <message>
        <source>seal width</source>
        <translation>anchura de soldadura</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>costura</translation>
    </message>
    <message>
        <source>seam inside</source>
        <translation>costura interior</translation>
    </message>
    <message>
        <source>serious</source>
        <translation>grave</translation>
    </message>
    <message>
        <source>size {0}, {1}</source>
        <translation>tamaño {0}, {1}</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>speed of the spindle</source>
        <translation>velocidad del husillo</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>husillo</translation>
    </message>
    <message>
        <source>square_mm of marks is larger than size_mm, {0}: make it smaller.</source>
        <translation>square_mm de las marcas es mayor que size_mm, {0}: redúzcalo.</translation>
    </message>
    <message>
        <source>stale: </source>
        <translation>obsoleto: </translation>
    </message>
    <message>
        <source>stale: belongs to earlier values</source>
        <translation>obsoleto: pertenece a valores anteriores</translation>
    </message>
    <message>
        <source>start_values are of films that are welded by heat: give "joining": "heat" too.</source>
        <translation>start_values son de películas que se sueldan con calor: indique también "joining": "heat".</translation>
    </message>
    <message>
        <source>start_values are {0}: give the values with their sources, or leave them out.</source>
        <translation>start_values son {0}: indique los valores con sus fuentes, u omítalos.</translation>
    </message>
    <message>
        <source>stopped; {0}.</source>
        <translation>detenido; {0}.</translation>
    </message>
    <message>
        <source>strain {}</source>
        <translation>deformación: {}</translation>
    </message>
    <message>
        <source>strength</source>
        <translation>resistencia</translation>
    </message>
    <message>
        <source>strength of film and weld</source>
        <translation>resistencia de película y soldadura</translation>
    </message>
    <message>
        <source>strength of the film not known</source>
        <translation>resistencia de la película desconocida</translation>
    </message>
    <message>
        <source>such as {"normal": "{0}"}</source>
        <translation>como {"normal": "{0}"}</translation>
    </message>
    <message>
        <source>taped seam</source>
        <translation>costura con cinta</translation>
    </message>
    <message>
        <source>taped seam inside</source>
        <translation>costura con cinta interior</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>temperatura</translation>
    </message>
    <message>
        <source>temperature after filling</source>
        <translation>temperatura después de llenar</translation>
    </message>
    <message>
        <source>test-card.json</source>
        <translation>test-card.json</translation>
    </message>
    <message>
        <source>the answer is not HTTP</source>
        <translation>la respuesta no es HTTP</translation>
    </message>
    <message>
        <source>the balloons that were made stay, and the same command goes on</source>
        <translation>los globos ya hechos quedan y la misma orden continúa</translation>
    </message>
    <message>
        <source>the colour "{0}" is not written like #ff0000.</source>
        <translation>el color «{0}» no está escrito como #ff0000.</translation>
    </message>
    <message>
        <source>the columns are the options of the command line</source>
        <translation>las columnas son las opciones de la línea de órdenes</translation>
    </message>
    <message>
        <source>the connection ended too soon</source>
        <translation>la conexión terminó demasiado pronto</translation>
    </message>
    <message>
        <source>the connection timed out</source>
        <translation>no hubo respuesta a tiempo</translation>
    </message>
    <message>
        <source>the file name "{0}" may have letters, digits, spaces, _, - and . only.</source>
        <translation>el nombre de archivo «{0}» solo puede tener letras, dígitos, espacios, _, - y .</translation>
    </message>
    <message>
        <source>the film weighs {0}</source>
        <translation>la película pesa {0}</translation>
    </message>
    <message>
        <source>the last line of each piece is its CUT.</source>
        <translation>la última línea de cada pieza es su CUT.</translation>
    </message>
    <message>
        <source>the layer name "{0}" may have 1 to 31 of A-Z, a-z, 0-9, _, - and $ only.</source>
        <translation>el nombre de capa "{0}" solo puede tener de 1 a 31 de A-Z, a-z, 0-9, _, - y $.</translation>
    </message>
    <message>
        <source>the layer {0} lacks {1}: give speed and power together, or neither.</source>
        <translation>a la capa {0} le falta {1}: indique velocidad y potencia juntas, o ninguna.</translation>
    </message>
    <message>
        <source>the marks of {0}</source>
        <translation>las marcas de {0}</translation>
    </message>
    <message>
        <source>the name "{0}" of the stock goes into file names: take letters a to z.</source>
        <translation>el nombre «{0}» del material va en los nombres de archivo: use letras de la a a la z.</translation>
    </message>
    <message>
        <source>the nearest are {0}</source>
        <translation>las más parecidas son {0}</translation>
    </message>
    <message>
        <source>the sealing side {0} is no polymer: give one such as "PE", or "none".</source>
        <translation>la cara de sellado {0} no es un polímero: indique uno como "PE", o "none".</translation>
    </message>
    <message>
        <source>the separating layer "{0}" is none of {1}: take one.</source>
        <translation>la capa separadora "{0}" no es ninguna de {1}: tome una.</translation>
    </message>
    <message>
        <source>the spot colour "{0}" may have letters, digits, _ and - only.</source>
        <translation>la tinta plana "{0}" solo puede tener letras, cifras, _ y -.</translation>
    </message>
    <message>
        <source>the style of marks</source>
        <translation>el estilo de las marcas</translation>
    </message>
    <message>
        <source>the tool "{0}" is none of {1}.</source>
        <translation>la herramienta «{0}» no es ninguna de {1}.</translation>
    </message>
    <message>
        <source>the weld rigidity lacks its source: write where it is from, or "assumed".</source>
        <translation>falta la fuente de la rigidez de la soldadura: escriba de dónde procede, o «assumed».</translation>
    </message>
    <message>
        <source>there is no model in it</source>
        <translation>no hay ningún modelo en él</translation>
    </message>
    <message>
        <source>there is no such corner</source>
        <translation>no existe tal esquina</translation>
    </message>
    <message>
        <source>there is no such part</source>
        <translation>no existe tal parte</translation>
    </message>
    <message>
        <source>there is no unit "{0}": write "mm".</source>
        <translation>no hay unidad "{0}": escriba "mm".</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>espesor</translation>
    </message>
    <message>
        <source>thickness of the film</source>
        <translation>espesor de la película</translation>
    </message>
    <message>
        <source>thin PE film, 30 to 50 µm</source>
        <translation>película fina de PE, 30 a 50 µm</translation>
    </message>
    <message>
        <source>through a layer of {0}</source>
        <translation>a través de una capa de {0}</translation>
    </message>
    <message>
        <source>tight: {}</source>
        <translation>tenso: {}</translation>
    </message>
    <message>
        <source>times that of flat film</source>
        <translation>veces el de la película plana</translation>
    </message>
    <message>
        <source>trial of the pattern: {0}</source>
        <translation>prueba del patrón: {0}</translation>
    </message>
    <message>
        <source>trial {0}, {1}</source>
        <translation>prueba {0}, {1}</translation>
    </message>
    <message>
        <source>true to shape</source>
        <translation>fiel a la forma</translation>
    </message>
    <message>
        <source>turned by {}°</source>
        <translation>girada {}°</translation>
    </message>
    <message>
        <source>unknown: this film has no strength</source>
        <translation>desconocida: esta película no tiene resistencia</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>al día</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>superior</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volumen</translation>
    </message>
    <message>
        <source>warm air</source>
        <translation>aire caliente</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>advertencia</translation>
    </message>
    <message>
        <source>weld</source>
        <translation>soldadura</translation>
    </message>
    <message>
        <source>weld inside</source>
        <translation>soldadura interior</translation>
    </message>
    <message>
        <source>welding error</source>
        <translation>error de soldadura</translation>
    </message>
    <message>
        <source>what came out</source>
        <translation>lo que resultó</translation>
    </message>
    <message>
        <source>width</source>
        <translation>anchura</translation>
    </message>
    <message>
        <source>width_mm must be above 0, and taper from 0.2 to 1.</source>
        <translation>width_mm debe ser mayor que 0, y taper de 0,2 a 1.</translation>
    </message>
    <message>
        <source>without a word</source>
        <translation>sin una palabra</translation>
    </message>
    <message>
        <source>wrinkled: {}</source>
        <translation>arrugado: {}</translation>
    </message>
    <message>
        <source>writing files</source>
        <translation>escribiendo archivos</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>{0} "{1}" is none of {2}.</source>
        <translation>{0} «{1}» no es ninguno de {2}.</translation>
    </message>
    <message>
        <source>{0} ({1}, margin {2})</source>
        <translation>{0} ({1}, margen {2})</translation>
    </message>
    <message>
        <source>{0} It is left out.</source>
        <translation>{0} Se omite.</translation>
    </message>
    <message>
        <source>{0} and {1} lines meet near {2}: move the hole inward or make the allowance narrower.</source>
        <translation>Las líneas {0} y {1} se tocan cerca de {2}: mueva el agujero hacia dentro o reduzca el margen.</translation>
    </message>
    <message>
        <source>{0} at least {1}</source>
        <translation>{0} de al menos {1}</translation>
    </message>
    <message>
        <source>{0} at most {1}</source>
        <translation>{0} de como mucho {1}</translation>
    </message>
    <message>
        <source>{0} balloons cannot be laid out: give 1 or more.</source>
        <translation>{0} globos no se pueden colocar: indique 1 o más.</translation>
    </message>
    <message>
        <source>{0} begins in {1} and ends in {2}: write both in one unit.</source>
        <translation>{0} empieza en {1} y acaba en {2}: escriba ambos en una sola unidad.</translation>
    </message>
    <message>
        <source>{0} belongs to no balloon: choose an outline, a balloon or a pattern.</source>
        <translation>{0} no pertenece a ningún globo: elija un contorno, un globo o un patrón.</translation>
    </message>
    <message>
        <source>{0} cannot be "{1}": {2}</source>
        <translation>{0} no puede ser «{1}»: {2}</translation>
    </message>
    <message>
        <source>{0} cannot be deleted: {1}. See who may write there.</source>
        <translation>{0} no se puede eliminar: {1}. Mire quién puede escribir ahí.</translation>
    </message>
    <message>
        <source>{0} cannot be loaded ({1}).</source>
        <translation>{0} no se puede cargar ({1}).</translation>
    </message>
    <message>
        <source>{0} cannot be read ({1}): write {2}.</source>
        <translation>{0} no se puede leer ({1}): escriba {2}.</translation>
    </message>
    <message>
        <source>{0} cannot be varied: choose a number, a word or a choice.</source>
        <translation>{0} no se puede variar: elija un número, una palabra o una opción.</translation>
    </message>
    <message>
        <source>{0} cannot make crosses in the film to lay it on anew (layer REGISTRATION): choose another machine, or make the balloon smaller.</source>
        <translation>{0} no puede hacer cruces en la película para recolocarla (capa REGISTRATION): elija otra máquina o reduzca el globo.</translation>
    </message>
    <message>
        <source>{0} cannot work: {1}</source>
        <translation>{0} no puede trabajar: {1}</translation>
    </message>
    <message>
        <source>{0} changed since. Choose Inflate now in its context menu, or switch Live on.</source>
        <translation>Ha cambiado: {0}. Elija «Inflar ahora» en su menú contextual o active En vivo.</translation>
    </message>
    <message>
        <source>{0} does not have the native solver (answer {1}). Try again later. {2}</source>
        <translation>{0} no tiene el solucionador nativo (respuesta {1}). Inténtelo más tarde. {2}</translation>
    </message>
    <message>
        <source>{0} does not see the folder '{1}': choose one that all machines share.</source>
        <translation>{0} no ve la carpeta «{1}»: elija una que compartan todas las máquinas.</translation>
    </message>
    <message>
        <source>{0} dots per inch cannot be printed well: give {1} to {2}.</source>
        <translation>{0} puntos por pulgada no se imprimen bien: indique de {1} a {2}.</translation>
    </message>
    <message>
        <source>{0} follows itself: choose something that is not made of it.</source>
        <translation>{0} se sigue a sí mismo: elija algo que no esté hecho de él.</translation>
    </message>
    <message>
        <source>{0} follows {1}: edit that.</source>
        <translation>{0} sigue {1}: edite este último.</translation>
    </message>
    <message>
        <source>{0} gap between the lines closed, the widest {1} of the drawing's width.</source>
        <translation>{0} hueco cerrado entre las líneas, el mayor del {1} de la anchura del dibujo.</translation>
    </message>
    <message>
        <source>{0} gaps between the lines closed, the widest {1} of the drawing's width.</source>
        <translation>{0} huecos cerrados entre las líneas, el mayor del {1} de la anchura del dibujo.</translation>
    </message>
    <message>
        <source>{0} goes up to {1}, and {2} bears {3}: give less.</source>
        <translation>{0}: llega hasta {1}, y {2} soporta {3}: indique menos.</translation>
    </message>
    <message>
        <source>{0} has a point that is no number or farther away than {1}. Check its coordinates and the unit.</source>
        <translation>{0} tiene un punto que no es un número o está más lejos que {1}. Revise sus coordenadas y la unidad.</translation>
    </message>
    <message>
        <source>{0} has a speed and a power, which only layers below {1} of a LightBurn project have: remove them.</source>
        <translation>{0} tiene velocidad y potencia, que en un proyecto de LightBurn solo tienen las capas por debajo de {1}: quítelas.</translation>
    </message>
    <message>
        <source>{0} has an error: repair it.</source>
        <translation>{0} tiene un error: repárelo.</translation>
    </message>
    <message>
        <source>{0} has fewer than three points. Give all of its corners.</source>
        <translation>{0} tiene menos de tres puntos. Dé todas sus esquinas.</translation>
    </message>
    <message>
        <source>{0} has interface {1}, but {2} is needed.</source>
        <translation>{0} tiene la interfaz {1}, pero hace falta {2}.</translation>
    </message>
    <message>
        <source>{0} has no "{1}": it has {2}.</source>
        <translation>{0} no tiene «{1}»: tiene {2}.</translation>
    </message>
    <message>
        <source>{0} has no area: all of its points lie on a line. Check its coordinates.</source>
        <translation>{0} no tiene superficie: todos sus puntos están en una línea. Revise sus coordenadas.</translation>
    </message>
    <message>
        <source>{0} has no balloon: choose the one that is to be varied.</source>
        <translation>{0} no tiene globo: elija el que se va a variar.</translation>
    </message>
    <message>
        <source>{0} has no drawing yet: choose a picture.</source>
        <translation>{0} aún no tiene dibujo: elija una imagen.</translation>
    </message>
    <message>
        <source>{0} has no outline to edit: choose a balloon from a picture.</source>
        <translation>{0} no tiene un contorno que editar: elija un globo hecho de una imagen.</translation>
    </message>
    <message>
        <source>{0} has no pattern: choose a balloon.</source>
        <translation>{0} no tiene patrón: elija un globo.</translation>
    </message>
    <message>
        <source>{0} has no piece {1}: its pieces are {2}.</source>
        <translation>{0} no tiene ninguna pieza {1}: sus piezas son {2}.</translation>
    </message>
    <message>
        <source>{0} has no result yet: recompute it.</source>
        <translation>{0} aún no tiene resultado: recalcúlelo.</translation>
    </message>
    <message>
        <source>{0} has no room between its ends: write the smaller one first.</source>
        <translation>{0} no tiene espacio entre sus extremos: escriba primero el menor.</translation>
    </message>
    <message>
        <source>{0} has no rows: write the values of each balloon below the headings.</source>
        <translation>{0} no tiene filas: escriba los valores de cada globo bajo los encabezados.</translation>
    </message>
    <message>
        <source>{0} has no shape. Choose a solid or a mesh.</source>
        <translation>{0} no tiene forma. Elija un sólido o una malla.</translation>
    </message>
    <message>
        <source>{0} has no shape: select a sketch, a wire or a face.</source>
        <translation>{0} no tiene forma: seleccione un croquis, un alambre o una cara.</translation>
    </message>
    <message>
        <source>{0} has no table: choose a spreadsheet of the document.</source>
        <translation>{0} no tiene tabla: elija una hoja de cálculo del documento.</translation>
    </message>
    <message>
        <source>{0} has no values: write {1}.</source>
        <translation>{0} no tiene valores: escriba {1}.</translation>
    </message>
    <message>
        <source>{0} has not been built.</source>
        <translation>{0} no se ha compilado.</translation>
    </message>
    <message>
        <source>{0} has several faces: select one of them.</source>
        <translation>{0} tiene varias caras: seleccione una.</translation>
    </message>
    <message>
        <source>{0} has several faces: select those that are panels.</source>
        <translation>{0} tiene varias caras: seleccione las que son paneles.</translation>
    </message>
    <message>
        <source>{0} has two columns for {1}: leave one out.</source>
        <translation>{0} tiene dos columnas para {1}: quite una.</translation>
    </message>
    <message>
        <source>{0} has version {1}, not {2}: install the same one everywhere.</source>
        <translation>{0} tiene la versión {1}, no {2}: instale la misma en todas partes.</translation>
    </message>
    <message>
        <source>{0} has {1} bodies: choose one of them.</source>
        <translation>{0} tiene {1} cuerpos: elija uno de ellos.</translation>
    </message>
    <message>
        <source>{0} has {1} construction lines: leave one of them, which is the axis.</source>
        <translation>{0} tiene {1} líneas de construcción: deje una de ellas, que es el eje.</translation>
    </message>
    <message>
        <source>{0} has {1} pieces now: delete it.</source>
        <translation>{0} tiene ahora {1} piezas: bórrelo.</translation>
    </message>
    <message>
        <source>{0} hole with a thin line round it was filled, as a pen's: choose Drawn as filled shape to keep it.</source>
        <translation>Se rellenó {0} agujero rodeado por una línea fina, como de pluma: elija Forma rellena en «Dibujado como» para conservarlo.</translation>
    </message>
    <message>
        <source>{0} holes with a thin line round them were filled, as a pen's: choose Drawn as filled shape to keep them.</source>
        <translation>Se rellenaron {0} agujeros rodeados por una línea fina, como de pluma: elija Forma rellena en «Dibujado como» para conservarlos.</translation>
    </message>
    <message>
        <source>{0} is a file</source>
        <translation>{0} es un archivo</translation>
    </message>
    <message>
        <source>{0} is a folder</source>
        <translation>{0} es una carpeta</translation>
    </message>
    <message>
        <source>{0} is an edge of a hole: choose one of an outer loop as the opening.</source>
        <translation>{0} es un borde de un agujero: elija como abertura uno de un contorno exterior.</translation>
    </message>
    <message>
        <source>{0} is at an end of its range: a wider one may hold a better balloon.</source>
        <translation>{0} está en un extremo de su rango: uno más amplio puede contener un globo mejor.</translation>
    </message>
    <message>
        <source>{0} is curved both ways: it is cut into {1} strips.</source>
        <translation>{0} está curvada en dos sentidos: se corta en {1} tiras.</translation>
    </message>
    <message>
        <source>{0} is damaged or incomplete ({1}). Install the workbench anew.</source>
        <translation>{0} está dañado o incompleto ({1}). Instale de nuevo el banco de trabajo.</translation>
    </message>
    <message>
        <source>{0} is damaged or incomplete. Install the workbench anew.</source>
        <translation>{0} está dañado o incompleto. Instale de nuevo el banco de trabajo.</translation>
    </message>
    <message>
        <source>{0} is damaged: install the workbench anew, or go on without the native solver.</source>
        <translation>{0} está dañado: instale de nuevo el banco de trabajo o siga sin el solucionador nativo.</translation>
    </message>
    <message>
        <source>{0} is damaged: remove it and start the study again.</source>
        <translation>{0} está dañado: elimínelo e inicie el estudio de nuevo.</translation>
    </message>
    <message>
        <source>{0} is empty: draw a closed line in it.</source>
        <translation>{0} está vacío: dibuje en él una línea cerrada.</translation>
    </message>
    <message>
        <source>{0} is empty: draw a line in it.</source>
        <translation>{0} está vacío: dibuje una línea en él.</translation>
    </message>
    <message>
        <source>{0} is empty: draw half an outline in it, beside the vertical axis.</source>
        <translation>{0} está vacío: dibuje en él medio contorno, junto al eje vertical.</translation>
    </message>
    <message>
        <source>{0} is hollow: choose a solid without a space inside.</source>
        <translation>{0} es hueco: elija un sólido sin espacio dentro.</translation>
    </message>
    <message>
        <source>{0} is in no seam. Seal it to another edge.</source>
        <translation>{0} no está en ninguna costura. Séllelo con otro borde.</translation>
    </message>
    <message>
        <source>{0} is in no seam: join it to another edge.</source>
        <translation>{0} no está en ninguna costura: únalo a otro borde.</translation>
    </message>
    <message>
        <source>{0} is in the document {1}: copy it into {2} first.</source>
        <translation>{0} está en el documento {1}: cópielo primero en {2}.</translation>
    </message>
    <message>
        <source>{0} is in two seams: take one of them away.</source>
        <translation>{0} está en dos costuras: quite una de ellas.</translation>
    </message>
    <message>
        <source>{0} is left out. {1}</source>
        <translation>Se omite {0}. {1}</translation>
    </message>
    <message>
        <source>{0} is neither DXF nor SVG: let the name end in .dxf or .svg.</source>
        <translation>{0} no es DXF ni SVG: haga que el nombre acabe en .dxf o .svg.</translation>
    </message>
    <message>
        <source>{0} is neither VTU, NPZ nor STL: let the name end in .vtu, .npz or .stl.</source>
        <translation>{0} no es VTU, NPZ ni STL: haga que el nombre acabe en .vtu, .npz o .stl.</translation>
    </message>
    <message>
        <source>{0} is no body: give a solid, a mesh or the path of a file.</source>
        <translation>{0} no es un cuerpo: dé un sólido, una malla o la ruta de un archivo.</translation>
    </message>
    <message>
        <source>{0} is no file for the web: let the name end in .glb, .html, .png, .gif or .mp4.</source>
        <translation>{0} no es un archivo para la web: termine el nombre en .glb, .html, .png, .gif o .mp4.</translation>
    </message>
    <message>
        <source>{0} is no number</source>
        <translation>{0} no es un número</translation>
    </message>
    <message>
        <source>{0} is no number: list its values.</source>
        <translation>{0} no es un número: enumere sus valores.</translation>
    </message>
    <message>
        <source>{0} is no number: write its values into the table.</source>
        <translation>{0} no es un número: escriba sus valores en la tabla.</translation>
    </message>
    <message>
        <source>{0} is none of the names that are known</source>
        <translation>{0} no es ninguno de los nombres conocidos</translation>
    </message>
    <message>
        <source>{0} is not a coordinate</source>
        <translation>{0} no es una coordenada</translation>
    </message>
    <message>
        <source>{0} is not closed: film can only be filled where it is. Choose a solid.</source>
        <translation>{0} no está cerrado: la película solo se puede llenar si lo está. Elija un sólido.</translation>
    </message>
    <message>
        <source>{0} is not flat: a balloon is cut from flat film, so draw it in one plane.</source>
        <translation>{0} no es plano: un globo se corta de película plana, así que dibújelo en un plano.</translation>
    </message>
    <message>
        <source>{0} is not flat: draw half the outline in a sketch.</source>
        <translation>{0} no es plano: dibuje el medio contorno en un croquis.</translation>
    </message>
    <message>
        <source>{0} is not joined by heat: {1} is not made for it.</source>
        <translation>{0} no se une con calor: {1} no está hecho para ello.</translation>
    </message>
    <message>
        <source>{0} is not printed on {1}: choose an artwork of this pattern.</source>
        <translation>{0} no se imprime en {1}: tome una ilustración de este patrón.</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1}</source>
        <translation>{0} no está al día. {1}</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1} Repair that and recompute.</source>
        <translation>{0} no está al día. {1} Repárelo y recalcule.</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1} Repair that, recompute and export again.</source>
        <translation>{0} no está al día. {1} Repárelo, recalcule y exporte de nuevo.</translation>
    </message>
    <message>
        <source>{0} is not worked out yet: recompute the document.</source>
        <translation>{0} aún no está calculado: recalcule el documento.</translation>
    </message>
    <message>
        <source>{0} is open: close its line.</source>
        <translation>{0} está abierto: cierre su línea.</translation>
    </message>
    <message>
        <source>{0} is too large a number, or none</source>
        <translation>{0} es un número demasiado grande, o no es un número</translation>
    </message>
    <message>
        <source>{0} is {1} long, {2} is {3}: make them equally long.</source>
        <translation>{0} mide {1}, {2} {3}: hágalos igual de largos.</translation>
    </message>
    <message>
        <source>{0} is {1} long. Scale it, so that it is between {2} and {3}.</source>
        <translation>{0} mide {1} de largo. Escálelo para que esté entre {2} y {3}.</translation>
    </message>
    <message>
        <source>{0} is {1}. Seal each edge once: side a goes along its loop from its first point to its second, b against it.</source>
        <translation>{0} está {1}. Selle cada borde una vez: el lado a sigue su contorno del primer punto al segundo, b lo recorre al revés.</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number from {2} to {3}.</source>
        <translation>{0} es {1}: indique un número de {2} a {3}.</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number, or [least, most].</source>
        <translation>{0} es {1}: indique un número, o [mínimo, máximo].</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number.</source>
        <translation>{0} es {1}: indique un número.</translation>
    </message>
    <message>
        <source>{0} is {1}: give numbers from {2} to {3}, the smaller one first.</source>
        <translation>{0} es {1}: indique números de {2} a {3}, el menor primero.</translation>
    </message>
    <message>
        <source>{0} is {1}: give {2}, or leave it out.</source>
        <translation>{0} es {1}: indique {2} u omítalo.</translation>
    </message>
    <message>
        <source>{0} is {1}: write it as {"value": ..., "source": "who says so"}.</source>
        <translation>{0} es {1}: escríbalo como {"value": ..., "source": "quién lo dice"}.</translation>
    </message>
    <message>
        <source>{0} is {1}: write true or false.</source>
        <translation>{0} es {1}: escriba true o false.</translation>
    </message>
    <message>
        <source>{0} lacks its source: write who states it. What nobody states is left out.</source>
        <translation>{0} no tiene fuente: escriba quién lo indica. Lo que nadie indica se omite.</translation>
    </message>
    <message>
        <source>{0} left out ({1}).</source>
        <translation>{0} omitidas ({1}).</translation>
    </message>
    <message>
        <source>{0} lies on both sides of its axis: draw half the outline, on one side.</source>
        <translation>{0} está a ambos lados de su eje: dibuje el medio contorno a un solo lado.</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: no, at no size.</source>
        <translation>{0} levanta {1}, {2}: no, con ningún tamaño.</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: no. From {3} width on it would.</source>
        <translation>{0} levanta {1}, {2}: no. Desde {3} de anchura sí.</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: yes, and it carries {3}.</source>
        <translation>{0} levanta {1}, {2}: sí, y aún levanta {3}.</translation>
    </message>
    <message>
        <source>{0} mm on paper = {1} of film</source>
        <translation>{0} mm en papel = {1} de película</translation>
    </message>
    <message>
        <source>{0} mm with an error of {1} mm</source>
        <translation>{0} mm con un error de {1} mm</translation>
    </message>
    <message>
        <source>{0} must never be cut with a laser: choose a machine with a knife.</source>
        <translation>{0} no se debe cortar nunca con láser: elija una máquina con cuchilla.</translation>
    </message>
    <message>
        <source>{0} needs a unit: write {1} instead of {2}.</source>
        <translation>{0} necesita una unidad: escriba {1} en vez de {2}.</translation>
    </message>
    <message>
        <source>{0} never gets from '{1}' to '{2}' by '{3}'.</source>
        <translation>{0} nunca llega de «{1}» a «{2}» con «{3}».</translation>
    </message>
    <message>
        <source>{0} notches are closer than {1}: take fewer.</source>
        <translation>{0} muescas quedan a menos de {1}: tome menos.</translation>
    </message>
    <message>
        <source>{0} of a roll {1} wide</source>
        <translation>{0} de un rollo de {1} de ancho</translation>
    </message>
    <message>
        <source>{0} of its size</source>
        <translation>un {0} de su tamaño</translation>
    </message>
    <message>
        <source>{0} of marks is {1}: give [width, height], or leave it out.</source>
        <translation>{0} de las marcas es {1}: indique [anchura, altura], u omítalo.</translation>
    </message>
    <message>
        <source>{0} of marks is {1}: give a number from {2} to {3}.</source>
        <translation>{0} de las marcas es {1}: indique un número de {2} a {3}.</translation>
    </message>
    <message>
        <source>{0} of {1} cannot be {2}: take another value.</source>
        <translation>{0} de {1} no puede ser {2}: tome otro valor.</translation>
    </message>
    <message>
        <source>{0} of {1} follows the expression '{2}': vary what that is made of.</source>
        <translation>{0} de {1} sigue la expresión «{2}»: varíe aquello de lo que se compone.</translation>
    </message>
    <message>
        <source>{0} of {1} is {2}, but its expression '{3}' gives {4}: change the expression.</source>
        <translation>{0} de {1} es {2}, pero su expresión «{3}» da {4}: cambie la expresión.</translation>
    </message>
    <message>
        <source>{0} open line was left out.</source>
        <translation>Se omitió {0} línea abierta.</translation>
    </message>
    <message>
        <source>{0} open lines were left out.</source>
        <translation>Se omitieron {0} líneas abiertas.</translation>
    </message>
    <message>
        <source>{0} over {1}</source>
        <translation>{0} en función de {1}</translation>
    </message>
    <message>
        <source>{0} panels meet at one point, which no weld closes: seal the cap from the sheet over it, or tape it.</source>
        <translation>{0} paneles se juntan en un punto que ninguna soldadura cierra: selle encima el casquete de la lámina, o péguelo con cinta.</translation>
    </message>
    <message>
        <source>{0} reads no G-code: choose a machine that does.</source>
        <translation>{0} no lee código G: elija una máquina que lo haga.</translation>
    </message>
    <message>
        <source>{0} reads {1}, which has no pages: choose paper.</source>
        <translation>{0} lee {1}, que no tiene páginas: elija papel.</translation>
    </message>
    <message>
        <source>{0} runs between two ends: say how to take samples in "{1}".</source>
        <translation>{0} va entre dos extremos: diga en «{1}» cómo tomar muestras.</translation>
    </message>
    <message>
        <source>{0} seams cannot be sealed lying flat, least of all seam {1} of panels {2}: one edge turns by {3} in all to follow the other. Seal them bit by bit, or round the corners.</source>
        <translation>{0} costuras no se pueden sellar planas, la que menos la costura {1} de los paneles {2}: un borde gira {3} en total para seguir al otro. Séllelas poco a poco, o redondee las esquinas.</translation>
    </message>
    <message>
        <source>{0} small speck was dropped.</source>
        <translation>Se omitió {0} mota pequeña.</translation>
    </message>
    <message>
        <source>{0} small specks were dropped.</source>
        <translation>Se omitieron {0} motas pequeñas.</translation>
    </message>
    <message>
        <source>{0} takes from 1 to {1} equal parts, not '{2}'.</source>
        <translation>{0} toma de 1 a {1} partes iguales, no «{2}».</translation>
    </message>
    <message>
        <source>{0} thin line is</source>
        <translation>{0} línea fina</translation>
    </message>
    <message>
        <source>{0} thin lines are</source>
        <translation>{0} líneas finas</translation>
    </message>
    <message>
        <source>{0} times</source>
        <translation>{0} veces</translation>
    </message>
    <message>
        <source>{0} tiny hole was filled.</source>
        <translation>Se rellenó {0} agujero diminuto.</translation>
    </message>
    <message>
        <source>{0} tiny holes were filled.</source>
        <translation>Se rellenaron {0} agujeros diminutos.</translation>
    </message>
    <message>
        <source>{0} turns a minute</source>
        <translation>{0} vueltas por minuto</translation>
    </message>
    <message>
        <source>{0} was left out. {1}</source>
        <translation>{0} (omitido). {1}</translation>
    </message>
    <message>
        <source>{0} weld outside the shapes left out.</source>
        <translation>Se omitió {0} soldadura fuera de las formas.</translation>
    </message>
    <message>
        <source>{0} welds outside the shapes left out.</source>
        <translation>Se omitieron {0} soldaduras fuera de las formas.</translation>
    </message>
    <message>
        <source>{0} wide, {1} long</source>
        <translation>{0} de ancho, {1} de largo</translation>
    </message>
    <message>
        <source>{0} with an error of {1}</source>
        <translation>{0} con un error de {1}</translation>
    </message>
    <message>
        <source>{0} with valve {1}</source>
        <translation>{0} con válvula de {1}</translation>
    </message>
    <message>
        <source>{0}, inflated: {1}</source>
        <translation>{0}, inflado: {1}</translation>
    </message>
    <message>
        <source>{0}: '{1}' is no number, write one such as 20.</source>
        <translation>{0}: '{1}' no es un número, escriba uno como 20.</translation>
    </message>
    <message>
        <source>{0}: it is split over several files. Cut them in their order, and lay the film on anew each time so that its crosses are where the next file has them.</source>
        <translation>{0}: está repartido en varios archivos. Córtelos en su orden, y recoloque cada vez la película de modo que sus cruces queden donde las tiene el archivo siguiente.</translation>
    </message>
    <message>
        <source>{0}: its file lacks {1}: add it.</source>
        <translation>{0}: a su archivo le falta {1}: añádalo.</translation>
    </message>
    <message>
        <source>{0}: lay its pieces out on sheets of that size, make the balloon smaller, or write the file anyway.</source>
        <translation>{0}: coloque sus piezas en láminas de ese tamaño, reduzca el globo o haga escribir el archivo de todos modos.</translation>
    </message>
    <message>
        <source>{0}: make the balloon smaller, choose another machine or paper, or write the file anyway.</source>
        <translation>{0}: reduzca el globo, elija otra máquina u otro papel, o haga escribir el archivo de todos modos.</translation>
    </message>
    <message>
        <source>{0}: the file is written anyway.</source>
        <translation>{0}: se escribe de todos modos.</translation>
    </message>
    <message>
        <source>{0}: what changes it most</source>
        <translation>{0}: lo que más influye</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}: {1}</translation>
    </message>
    <message>
        <source>{0}: {1} mm is out of range, give {2} to {3} mm.</source>
        <translation>{0}: {1} mm está fuera del intervalo, indique de {2} a {3} mm.</translation>
    </message>
    <message>
        <source>{0}; wider than the usual roll</source>
        <translation>{0}; más ancha que el rollo habitual</translation>
    </message>
    <message>
        <source>{0}take a drawing, without a side band or gores.</source>
        <translation>{0}tome un dibujo, sin banda lateral ni gajos.</translation>
    </message>
    <message>
        <source>{0}this drawing has {1} shapes, study one at a time.</source>
        <translation>{0}este dibujo tiene {1} formas, estúdielas una por una.</translation>
    </message>
    <message>
        <source>{0}what is shown is the last good state. Lower the pressure or change the mesh size.</source>
        <translation>{0}se muestra el último buen estado. Baje la presión o cambie el tamaño de malla.</translation>
    </message>
    <message>
        <source>{0}{1} has no length. Take one of its points out.</source>
        <translation>{0}{1} no tiene longitud. Quite uno de sus puntos.</translation>
    </message>
    <message>
        <source>{} (unusable)</source>
        <translation>{} (inservible)</translation>
    </message>
    <message>
        <source>{} ({})</source>
        <translation>{} ({})</translation>
    </message>
    <message>
        <source>{} MB from {}; the file is checked before it is used, and nothing is sent.</source>
        <translation>{} MB de {}; el archivo se comprueba antes de usarlo y no se envía nada.</translation>
    </message>
    <message>
        <source>{} at ({})</source>
        <translation>{} en ({})</translation>
    </message>
    <message>
        <source>{} gores are enough for {} of the profile's diagonal</source>
        <translation>{} gajos bastan para {} de la diagonal del perfil</translation>
    </message>
    <message>
        <source>{} gores, as many as {} of the profile's diagonal need</source>
        <translation>{} gajos, tantos como necesita {} de la diagonal del perfil</translation>
    </message>
    <message>
        <source>{} in the mean, at most {}</source>
        <translation>{} de media, como mucho {}</translation>
    </message>
    <message>
        <source>{} inside</source>
        <translation>{} por dentro</translation>
    </message>
    <message>
        <source>{} is among the films</source>
        <translation>{} está entre las películas</translation>
    </message>
    <message>
        <source>{} is among the machines of Export pattern</source>
        <translation>{} está entre las máquinas de «Exportar patrón»</translation>
    </message>
    <message>
        <source>{} is in the tree</source>
        <translation>{} está en el árbol</translation>
    </message>
    <message>
        <source>{} is there already: give another name.</source>
        <translation>{} ya existe: indique otro nombre.</translation>
    </message>
    <message>
        <source>{} is there already: tick "Replace the file", or give another name.</source>
        <translation>{} ya existe: marque «Reemplazar el archivo» o indique otro nombre.</translation>
    </message>
    <message>
        <source>{} is there already: tick "Replace the files", or choose another folder.</source>
        <translation>{} ya existe: marque «Reemplazar los archivos» o elija otra carpeta.</translation>
    </message>
    <message>
        <source>{} ms, {}, frame {} of {}</source>
        <translation>{} ms, {}, fotograma {} de {}</translation>
    </message>
    <message>
        <source>{} of it wrinkles, {} is loose</source>
        <translation>{} se arruga, {} está flojo</translation>
    </message>
    <message>
        <source>{} of the profile's diagonal take {} gores</source>
        <translation>{} de la diagonal del perfil necesitan {} gajos</translation>
    </message>
    <message>
        <source>{} of them cannot be made:</source>
        <translation>De ellas, {} sin globo:</translation>
    </message>
    <message>
        <source>{} of {}</source>
        <translation>{} de {}</translation>
    </message>
    <message>
        <source>{} of {} rows are worked out.</source>
        <translation>{} de {} filas están calculadas.</translation>
    </message>
    <message>
        <source>{} outside</source>
        <translation>{} por fuera</translation>
    </message>
    <message>
        <source>{} panels, {} of seams, {} inside</source>
        <translation>{} paneles, {} de costuras, {} dentro</translation>
    </message>
    <message>
        <source>{} panels, {} seams of {}</source>
        <translation>{} paneles, {} costuras, {} en total</translation>
    </message>
    <message>
        <source>{} panels: about {} off, {} of seams, {} h of welding</source>
        <translation>{} paneles: desvío de unos {}, {} de costuras, {} h de soldadura</translation>
    </message>
    <message>
        <source>{} px</source>
        <translation>{} px</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>de {} a {}</translation>
    </message>
    <message>
        <source>{} x {}, {} thick, {}</source>
        <translation>{} x {}, {} de grueso, {}</translation>
    </message>
    <message>
        <source>{}, at most {}</source>
        <translation>{}, como mucho {}</translation>
    </message>
    <message>
        <source>{}, carries {} with {}</source>
        <translation>{}, levanta {} con {}</translation>
    </message>
    <message>
        <source>{}, floats from {} width on with {}</source>
        <translation>{}, flota desde {} de anchura con {}</translation>
    </message>
    <message>
        <source>{}, never floats with {}</source>
        <translation>{}, nunca flota con {}</translation>
    </message>
    <message>
        <source>{}, row {}</source>
        <translation>{}, fila {}</translation>
    </message>
    <message>
        <source>{}, seam {}</source>
        <translation>{}, costura {}</translation>
    </message>
    <message>
        <source>{}: film {}, seam and neck {}</source>
        <translation>{}: película {}, costura y cuello {}</translation>
    </message>
    <message>
        <source>{}: film {}, seam and neck {}, valve {}</source>
        <translation>{}: película {}, costura y cuello {}, válvula {}</translation>
    </message>
    <message>
        <source>{}: they differ by {}</source>
        <translation>{}: se diferencian en {}</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>{}: {}, flat</source>
        <translation>{}: {}, plano</translation>
    </message>
    <message>
        <source>{}: {}, nodes</source>
        <translation>{}: {}, nodos</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Advice</name>
    <message>
        <source>Advice</source>
        <translation>Consejos</translation>
    </message>
    <message>
        <source>Show which parts of a shape will inflate badly, and repair them</source>
        <translation>Muestra qué partes de una forma se inflarán mal y las repara</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Animate</name>
    <message>
        <source>Animate inflation</source>
        <translation>Animar el inflado</translation>
    </message>
    <message>
        <source>Play how the balloon inflates, from the flat film to rest, with a slider</source>
        <translation>Reproduce cómo se infla el globo, de la película plana al reposo, con un control deslizante</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Artwork</name>
    <message>
        <source>Artwork</source>
        <translation>Ilustración</translation>
    </message>
    <message>
        <source>Print a picture on the film so that it reads right on the inflated balloon</source>
        <translation>Imprimir una imagen en la película para que se vea bien en el globo inflado</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_AssemblySheet</name>
    <message>
        <source>Assembly sheet</source>
        <translation>Hoja de montaje</translation>
    </message>
    <message>
        <source>Tell what the balloon takes and whether it floats, and write one page on how to make it</source>
        <translation>Dice qué necesita el globo y si flota, y escribe una página sobre cómo hacerlo</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ColourMap</name>
    <message>
        <source>Colour map</source>
        <translation>Mapa de colores</translation>
    </message>
    <message>
        <source>Show tension, wrinkles, thickness and other results as colours on the balloon</source>
        <translation>Muestra tensión, arrugas, grosor y otros resultados como colores sobre el globo</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Compare</name>
    <message>
        <source>Compare with a photograph</source>
        <translation>Comparar con una fotografía</translation>
    </message>
    <message>
        <source>Lay a photograph of the finished balloon over the simulated one, and see how near it came</source>
        <translation>Poner una fotografía del globo acabado sobre el simulado y ver cuánto se le acercó</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_EditOutline</name>
    <message>
        <source>Edit outline</source>
        <translation>Editar contorno</translation>
    </message>
    <message>
        <source>Move, add and remove nodes of the outline over its picture, and set how the picture is read</source>
        <translation>Mover, añadir y quitar nodos del contorno sobre su imagen, y ajustar cómo se lee la imagen</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Equipment</name>
    <message>
        <source>Show the solver in use, and which packages are missing and what that costs</source>
        <translation>Muestra el solucionador en uso, qué paquetes faltan y qué supone</translation>
    </message>
    <message>
        <source>What works here</source>
        <translation>Qué funciona aquí</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Examples</name>
    <message>
        <source>Examples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>Open a finished balloon, to look at it and to change it</source>
        <translation>Abre un globo terminado, para verlo y cambiarlo</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ExportForWeb</name>
    <message>
        <source>Export for the web</source>
        <translation>Exportar para la web</translation>
    </message>
    <message>
        <source>Write the balloon with its artwork as a web page that turns it, as a 3D model or as a picture</source>
        <translation>Escribir el globo con su impresión: página web que lo gira, modelo 3D o imagen</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ExportPattern</name>
    <message>
        <source>Export pattern</source>
        <translation>Exportar patrón</translation>
    </message>
    <message>
        <source>Write the flat pattern of a balloon for a cutter, a plotter, a heat sealer or a printer</source>
        <translation>Escribe el patrón plano de un globo para una cortadora, un trazador, una selladora o una impresora</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromBody</name>
    <message>
        <source>Find the panels of a balloon that fills the selected solid or mesh</source>
        <translation>Buscar los paneles de un globo que llene el sólido o la malla seleccionados</translation>
    </message>
    <message>
        <source>New balloon from body</source>
        <translation>Nuevo globo desde un cuerpo</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromPanels</name>
    <message>
        <source>New bag of panels</source>
        <translation>Nueva bolsa de paneles</translation>
    </message>
    <message>
        <source>Seal flat panels along their edges: selected sketches and faces, a ready body or a file</source>
        <translation>Sellar paneles planos a lo largo de sus bordes: croquis y caras seleccionados, un cuerpo listo o un archivo</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromPicture</name>
    <message>
        <source>New balloon from picture</source>
        <translation>Nuevo globo desde imagen</translation>
    </message>
    <message>
        <source>Trace a picture, SVG, DXF or JSON file and design the balloon that looks like it</source>
        <translation>Calca una imagen, archivo SVG, DXF o JSON y diseña el globo que se le parece</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromProfile</name>
    <message>
        <source>Design the gores of a ball, an airship or another round body from half its outline</source>
        <translation>Diseñar los gajos de una pelota, un dirigible u otro cuerpo redondo a partir de medio contorno</translation>
    </message>
    <message>
        <source>New body of gores</source>
        <translation>Nuevo cuerpo de gajos</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromSketch</name>
    <message>
        <source>Design the balloon that looks like the selected sketch, wire or face and follows it</source>
        <translation>Diseña el globo que se parece al croquis, alambre o cara elegidos y los sigue</translation>
    </message>
    <message>
        <source>New balloon from sketch</source>
        <translation>Nuevo globo desde croquis</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Machines</name>
    <message>
        <source>My machines</source>
        <translation>Mis máquinas</translation>
    </message>
    <message>
        <source>Set up cutters, lasers, sealers and printers of your own: bed, file format, kerf, knife and tool</source>
        <translation>Configurar cortadoras, láseres, selladoras e impresoras propias: cama, formato de archivo, ancho de corte, cuchilla y herramienta</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Nest</name>
    <message>
        <source>Lay out on film</source>
        <translation>Colocar en la película</translation>
    </message>
    <message>
        <source>Lay the panels of one or several balloons closely on a roll or on sheets of film</source>
        <translation>Colocar apretados los paneles de uno o varios globos en un rollo o en láminas</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Paint</name>
    <message>
        <source>Draw with pen and brush, and watch the balloon and its pattern grow beside it</source>
        <translation>Dibujar con lápiz y pincel y ver crecer al lado el globo y su patrón</translation>
    </message>
    <message>
        <source>Paint a balloon</source>
        <translation>Pintar un globo</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_PatternView</name>
    <message>
        <source>Pattern view</source>
        <translation>Vista del patrón</translation>
    </message>
    <message>
        <source>Show all panels flat in a tab of their own: pick an edge to see its partner, and measure</source>
        <translation>Mostrar todos los paneles planos en su pestaña: elegir un borde muestra su pareja; y medir</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Study</name>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Work out many variants of a balloon from a spreadsheet, and compare them</source>
        <translation>Calcular muchas variantes de un globo desde una hoja de cálculo y compararlas</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_TestCard</name>
    <message>
        <source>Find feed, power, temperature or depth of a tool for a film: weld or cut a card of fields</source>
        <translation>Hallar avance, potencia, temperatura o profundidad de una herramienta para una película: soldar o cortar una tarjeta de campos</translation>
    </message>
    <message>
        <source>Test card</source>
        <translation>Tarjeta de prueba</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Film &amp;Balloon</source>
        <translation>Glo&amp;bo de película</translation>
    </message>
    <message>
        <source>Film Balloon</source>
        <translation>Globo de película</translation>
    </message>
</context>
</TS>

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>A line of text where the film is widest, as outlines</source>
        <translation>Une ligne de texte là où le film est le plus large, en contours</translation>
    </message>
    <message>
        <source>A ready body, made to measure</source>
        <translation>Un corps prêt, sur mesure</translation>
    </message>
    <message>
        <source>A size of the ready body</source>
        <translation>Une dimension du corps prêt</translation>
    </message>
    <message>
        <source>A tab with a hole to tie the balloon to, outside the weld</source>
        <translation>Une languette percée pour attacher le ballon, hors de la soudure</translation>
    </message>
    <message>
        <source>Add what the balloon is filled through</source>
        <translation>Ajoute ce par quoi le ballon est gonflé</translation>
    </message>
    <message>
        <source>Air that it holds, as a share of what a round balloon of as much film would</source>
        <translation>Air qu'il contient, en part de ce que contiendrait un ballon rond d'autant de film</translation>
    </message>
    <message>
        <source>Another picture for the back; empty takes that of the front</source>
        <translation>Une autre image pour le dos ; vide prend celle du devant</translation>
    </message>
    <message>
        <source>Area of film inside the welds, all panels</source>
        <translation>Surface de film à l'intérieur des soudures, tous les panneaux</translation>
    </message>
    <message>
        <source>Area of the piece of film</source>
        <translation>Surface de la pièce de film</translation>
    </message>
    <message>
        <source>Around the balloon, in degrees Celsius</source>
        <translation>Autour du ballon, en degrés Celsius</translation>
    </message>
    <message>
        <source>Automatic evens out a nearly symmetric picture, Forced any drawing: its left half is mirrored</source>
        <translation>« Automatique » régularise une image presque symétrique, « Forcée » tout dessin : sa moitié gauche est reflétée</translation>
    </message>
    <message>
        <source>Corner relief: corners of the cuts are rounded so; the weld is not</source>
        <translation>Dégagement d'angle : les angles des coupes sont arrondis ainsi, la soudure ne l'est pas</translation>
    </message>
    <message>
        <source>Corners of all loops</source>
        <translation>Sommets de toutes les boucles</translation>
    </message>
    <message>
        <source>Corners of all welds</source>
        <translation>Sommets de toutes les soudures</translation>
    </message>
    <message>
        <source>Corners of the pattern's seam</source>
        <translation>Sommets de la soudure du patron</translation>
    </message>
    <message>
        <source>Corners of the triangles on the flat film; z is not 0 where a face does not unroll</source>
        <translation>Sommets des triangles sur le film à plat ; z n'est pas 0 là où une face n'est pas développable</translation>
    </message>
    <message>
        <source>Corners of the welds inside</source>
        <translation>Sommets des soudures intérieures</translation>
    </message>
    <message>
        <source>Correct the pattern until the balloon looks like the drawing, or not</source>
        <translation>Corriger ou non le patron jusqu'à ce que le ballon ressemble au dessin</translation>
    </message>
    <message>
        <source>Corrections of the pattern</source>
        <translation>Corrections du patron</translation>
    </message>
    <message>
        <source>Diameter of a body from a file; 0 follows from the height, or the file</source>
        <translation>Diamètre d'un corps venant d'un fichier ; 0 découle de la hauteur, ou du fichier</translation>
    </message>
    <message>
        <source>Direction of the grain, from the x axis of the drawing</source>
        <translation>Sens du film, depuis l'axe x du dessin</translation>
    </message>
    <message>
        <source>Direction of the neck, counter-clockwise from the x axis</source>
        <translation>Direction du col, dans le sens antihoraire depuis l'axe x</translation>
    </message>
    <message>
        <source>Direction of the tab from the middle of the pattern</source>
        <translation>Direction de la languette depuis le milieu du patron</translation>
    </message>
    <message>
        <source>Display mode when no map is shown</source>
        <translation>Mode d'affichage quand aucune carte n'est montrée</translation>
    </message>
    <message>
        <source>Distance that 95 % of the silhouette keep to</source>
        <translation>Écart que 95 % de la silhouette respectent</translation>
    </message>
    <message>
        <source>Distance that 95 % of the silhouette keep to if the weld creases</source>
        <translation>Écart que 95 % de la silhouette respectent si la soudure se froisse</translation>
    </message>
    <message>
        <source>Dots per inch of the files</source>
        <translation>Points par pouce des fichiers</translation>
    </message>
    <message>
        <source>Edge at which the bag is filled, such as Sketch.Edge3; of a file or ready body: the panel and the number of a point, such as side.2, or the number of a seam; empty: as the file or body says</source>
        <translation>Bord par lequel le sac est rempli, comme Sketch.Edge3 ; pour un fichier ou un corps prêt : le panneau et le numéro d'un point, comme side.2, ou le numéro d'une couture ; vide : comme le fichier ou le corps l'indique</translation>
    </message>
    <message>
        <source>Edges that are joined, such as Sketch.Edge1=Sketch001.Edge3; edges that faces share need no word</source>
        <translation>Bords assemblés, comme Sketch.Edge1=Sketch001.Edge3 ; les bords communs à des faces n'ont pas besoin d'être nommés</translation>
    </message>
    <message>
        <source>Edges that stand for pieces of curves</source>
        <translation>Arêtes qui remplacent des morceaux de courbes</translation>
    </message>
    <message>
        <source>Film left between pieces, and at the edges</source>
        <translation>Film laissé entre les pièces et aux bords</translation>
    </message>
    <message>
        <source>Film left outside the weld</source>
        <translation>Film laissé à l'extérieur de la soudure</translation>
    </message>
    <message>
        <source>Film of both panels with weld and intake, in grams</source>
        <translation>Film des deux panneaux avec soudure et embout, en grammes</translation>
    </message>
    <message>
        <source>Film that wrinkles where it is compressed, or a shell that does not, for comparison</source>
        <translation>Film qui se plisse où il est comprimé, ou coque qui ne le fait pas, pour comparer</translation>
    </message>
    <message>
        <source>Film, model and solver of the result</source>
        <translation>Film, modèle et solveur du résultat</translation>
    </message>
    <message>
        <source>Find the place of the intake</source>
        <translation>Chercher la place de l'embout</translation>
    </message>
    <message>
        <source>Fit inside width and height instead of stretching to both</source>
        <translation>Inscrire dans la largeur et la hauteur au lieu d'étirer aux deux</translation>
    </message>
    <message>
        <source>Flat panels and their seams as JSON, in metres</source>
        <translation>Panneaux plats et leurs coutures en JSON, en mètres</translation>
    </message>
    <message>
        <source>Folder that keeps finished balloons; empty: FreeCAD's cache folder</source>
        <translation>Dossier qui garde les ballons finis ; vide : le dossier de cache de FreeCAD</translation>
    </message>
    <message>
        <source>Follow every change at once; switch it off for heavy models and inflate when you ask for it</source>
        <translation>Suivre aussitôt chaque changement ; à désactiver pour les modèles lourds, puis gonfler à la demande</translation>
    </message>
    <message>
        <source>FreeCAD's material card that the values were taken from</source>
        <translation>Fiche de matériau de FreeCAD d'où viennent les valeurs</translation>
    </message>
    <message>
        <source>Gores that the accuracy needs, foretold from the profile</source>
        <translation>Fuseaux nécessaires à la précision, prévus d'après le profil</translation>
    </message>
    <message>
        <source>Height above the sea</source>
        <translation>Altitude au-dessus de la mer</translation>
    </message>
    <message>
        <source>Height of a body from a file, along z; 0 follows</source>
        <translation>Hauteur d'un corps venant d'un fichier, selon z ; 0 en découle</translation>
    </message>
    <message>
        <source>Height of a body from a file; 0 follows</source>
        <translation>Hauteur d'un corps venant d'un fichier ; 0 en découle</translation>
    </message>
    <message>
        <source>Height of all that is cut</source>
        <translation>Hauteur de tout ce qui est coupé</translation>
    </message>
    <message>
        <source>Height of its capital letters</source>
        <translation>Hauteur des capitales</translation>
    </message>
    <message>
        <source>Height of the drawing; 0 follows from the width</source>
        <translation>Hauteur du dessin ; 0 se déduit de la largeur</translation>
    </message>
    <message>
        <source>Height of the inflated balloon</source>
        <translation>Hauteur du ballon gonflé</translation>
    </message>
    <message>
        <source>Height of the outline</source>
        <translation>Hauteur du contour</translation>
    </message>
    <message>
        <source>Height of the piece of film</source>
        <translation>Hauteur de la pièce de film</translation>
    </message>
    <message>
        <source>Height of the print with its marks</source>
        <translation>Hauteur de l'impression avec ses repères</translation>
    </message>
    <message>
        <source>Height of the profile</source>
        <translation>Hauteur du profil</translation>
    </message>
    <message>
        <source>How a picture is read: holes of a filled shape stay, lines of a pen drawing are filled inside</source>
        <translation>Comment une image est lue : les trous d'une forme pleine restent, les lignes d'un dessin au trait sont remplies à l'intérieur</translation>
    </message>
    <message>
        <source>How far along that seam, from 0 to 1 of its length; 0 takes its middle, or that of the edge</source>
        <translation>À quelle distance le long de cette couture, de 0 à 1 de sa longueur ; 0 prend son milieu, ou celui du bord</translation>
    </message>
    <message>
        <source>How far from the background what is drawn must be, of the greatest difference; 0 finds it</source>
        <translation>De combien ce qui est dessiné doit se distinguer du fond, en part du plus grand écart ; 0 le trouve</translation>
    </message>
    <message>
        <source>How far the balloon may be from its profile or body on average, in parts of the diagonal</source>
        <translation>De combien le ballon peut s'écarter en moyenne de son profil ou de son corps, en part de la diagonale</translation>
    </message>
    <message>
        <source>How far the print goes past the cut</source>
        <translation>De combien l'impression dépasse la coupe</translation>
    </message>
    <message>
        <source>How far the seams of a body of gores are farther out than the gores' centres</source>
        <translation>De combien les coutures d'un corps de fuseaux dépassent le milieu des fuseaux</translation>
    </message>
    <message>
        <source>How its lower and its upper end are closed</source>
        <translation>Comment ses extrémités basse et haute sont fermées</translation>
    </message>
    <message>
        <source>How large each was then [mm]</source>
        <translation>Taille de chacune alors [mm]</translation>
    </message>
    <message>
        <source>How long the ripples are that are smoothed away, in pixels; 0 keeps all</source>
        <translation>Longueur des ondulations qui sont lissées, en pixels ; 0 les garde toutes</translation>
    </message>
    <message>
        <source>How many balloons are cut from the sheet</source>
        <translation>Nombre de ballons découpés dans la feuille</translation>
    </message>
    <message>
        <source>How many balloons are worked out at a time; 0: one for each processor</source>
        <translation>Nombre de ballons calculés à la fois ; 0 : un par processeur</translation>
    </message>
    <message>
        <source>How many balloons of each pattern</source>
        <translation>Nombre de ballons de chaque patron</translation>
    </message>
    <message>
        <source>How many gores; 0 takes as many as the accuracy needs</source>
        <translation>Nombre de fuseaux ; 0 en prend autant que la précision en demande</translation>
    </message>
    <message>
        <source>How much longer one side of a seam may be, as a part of its length</source>
        <translation>De combien un côté d'une couture peut être plus long, en part de sa longueur</translation>
    </message>
    <message>
        <source>How the balloon is filled and closed</source>
        <translation>Comment le ballon est gonflé et fermé</translation>
    </message>
    <message>
        <source>How the grain of pieces lies, where their film has one</source>
        <translation>Comment le sens du film des pièces est placé, quand leur film en a un</translation>
    </message>
    <message>
        <source>How the intake is made and used</source>
        <translation>Comment l'embout est fait et utilisé</translation>
    </message>
    <message>
        <source>How the lower end is closed</source>
        <translation>Comment l'extrémité basse est fermée</translation>
    </message>
    <message>
        <source>How the outline was edited by hand: nodes moved, added and removed, one JSON text each</source>
        <translation>Comment le contour a été modifié à la main : nœuds déplacés, ajoutés et supprimés, un texte JSON chacun</translation>
    </message>
    <message>
        <source>How the seams were changed: panels merged, seams cut and moved, one JSON text each</source>
        <translation>Comment les coutures ont été changées : panneaux fusionnés, coutures coupées et déplacées, un texte JSON chacune</translation>
    </message>
    <message>
        <source>How the upper end is closed</source>
        <translation>Comment l'extrémité haute est fermée</translation>
    </message>
    <message>
        <source>How two panels of this film are joined</source>
        <translation>Comment deux panneaux de ce film sont assemblés</translation>
    </message>
    <message>
        <source>Inner width of the neck, or bore of the nozzle</source>
        <translation>Largeur intérieure du col, ou alésage de la buse</translation>
    </message>
    <message>
        <source>Into how many panels the body is divided; 0 takes the faces of a solid, 16 panels of a mesh; 1 takes only the seams that are drawn</source>
        <translation>En combien de panneaux le corps est divisé ; 0 prend les faces d'un solide, 16 panneaux pour un maillage ; 1 ne prend que les coutures dessinées</translation>
    </message>
    <message>
        <source>It carries itself</source>
        <translation>Il se porte lui-même</translation>
    </message>
    <message>
        <source>Its place, seen from its sketch</source>
        <translation>Sa position, vue depuis son esquisse</translation>
    </message>
    <message>
        <source>JSON file of panels and seams; a copy travels in the document</source>
        <translation>Fichier JSON de panneaux et de coutures ; une copie voyage dans le document</translation>
    </message>
    <message>
        <source>Label of the values the mesh belongs to</source>
        <translation>Repère des valeurs auxquelles appartient le maillage</translation>
    </message>
    <message>
        <source>Label of what was laid out</source>
        <translation>Repère de ce qui a été disposé</translation>
    </message>
    <message>
        <source>Label that the workbench has given it</source>
        <translation>Nom que l'atelier lui a donné</translation>
    </message>
    <message>
        <source>Larger dimension before repairs, in mm</source>
        <translation>Plus grande dimension avant réparations, en mm</translation>
    </message>
    <message>
        <source>Largest diameter of the profile</source>
        <translation>Plus grand diamètre du profil</translation>
    </message>
    <message>
        <source>Largest distance between drawing and silhouette</source>
        <translation>Plus grand écart entre dessin et silhouette</translation>
    </message>
    <message>
        <source>Largest distance between drawing and silhouette if the weld creases</source>
        <translation>Plus grand écart entre dessin et silhouette si la soudure se froisse</translation>
    </message>
    <message>
        <source>Largest membrane tension in N/m</source>
        <translation>Plus grande tension de membrane en N/m</translation>
    </message>
    <message>
        <source>Largest strain of the film</source>
        <translation>Plus grande déformation du film</translation>
    </message>
    <message>
        <source>Lay panels first onto what is left of another layout, as its file says; the rest on the film</source>
        <translation>Poser d'abord les panneaux sur ce qui reste d'une autre disposition, comme le dit son fichier ; le reste sur le film</translation>
    </message>
    <message>
        <source>Least bending stiffness, in units of the usual least one</source>
        <translation>Rigidité de flexion minimale, en unités de la minimale habituelle</translation>
    </message>
    <message>
        <source>Left open in welds that would cut off a part, so wide; 0 gives each part an intake of its own</source>
        <translation>Largeur laissée ouverte dans les soudures qui isoleraient une partie ; 0 donne à chaque partie son propre embout</translation>
    </message>
    <message>
        <source>Length of a notch; at most the allowance</source>
        <translation>Longueur d'une encoche ; au plus la marge</translation>
    </message>
    <message>
        <source>Length of a sheet; 0 is a roll</source>
        <translation>Longueur d'une feuille ; 0 est un rouleau</translation>
    </message>
    <message>
        <source>Length of all seams on the body</source>
        <translation>Longueur de toutes les coutures sur le corps</translation>
    </message>
    <message>
        <source>Length of all welds on it</source>
        <translation>Longueur de toutes les soudures</translation>
    </message>
    <message>
        <source>Length of its welds</source>
        <translation>Longueur de ses soudures</translation>
    </message>
    <message>
        <source>Length of the natural shape's gores, from its lower to its upper end</source>
        <translation>Longueur des fuseaux de la forme naturelle, de l'extrémité basse à la haute</translation>
    </message>
    <message>
        <source>Length of the neck from the seam outward, or diameter of the flange; 0 takes the usual one</source>
        <translation>Longueur du col depuis la soudure, ou diamètre de la collerette ; 0 prend la valeur habituelle</translation>
    </message>
    <message>
        <source>Length of the profile from end to end</source>
        <translation>Longueur du profil d'un bout à l'autre</translation>
    </message>
    <message>
        <source>Length of the roll that is used</source>
        <translation>Longueur de rouleau utilisée</translation>
    </message>
    <message>
        <source>Length of the weld</source>
        <translation>Longueur de la soudure</translation>
    </message>
    <message>
        <source>Lengths of both sides of each seam in mm</source>
        <translation>Longueurs des deux côtés de chaque couture en mm</translation>
    </message>
    <message>
        <source>Lines and arcs within 0.02 mm in place of many short lines</source>
        <translation>Droites et arcs à 0,02 mm près au lieu de nombreux petits segments</translation>
    </message>
    <message>
        <source>Longest piece of the side band; 0 is the width of the film</source>
        <translation>Plus longue pièce de la bande latérale ; 0 est la largeur du film</translation>
    </message>
    <message>
        <source>Mean distance between drawing and silhouette</source>
        <translation>Écart moyen entre dessin et silhouette</translation>
    </message>
    <message>
        <source>Mean distance between drawing and silhouette if the weld creases</source>
        <translation>Écart moyen entre dessin et silhouette si la soudure se froisse</translation>
    </message>
    <message>
        <source>Names of the panels</source>
        <translation>Noms des panneaux</translation>
    </message>
    <message>
        <source>Names of the panels and other pieces</source>
        <translation>Noms des panneaux et des autres pièces</translation>
    </message>
    <message>
        <source>Names of the pieces that have been arranged</source>
        <translation>Noms des pièces qui ont été disposées</translation>
    </message>
    <message>
        <source>Notches to lay both films on each other by, evenly along the cut; of many panels, groups of them on each seam, 0 as many as its length needs</source>
        <translation>Encoches pour poser les deux films l'un sur l'autre, réparties le long de la coupe ; avec plusieurs panneaux, des groupes d'encoches sur chaque couture, 0 autant que sa longueur en demande</translation>
    </message>
    <message>
        <source>Number of balloons in the table</source>
        <translation>Nombre de ballons dans le tableau</translation>
    </message>
    <message>
        <source>Number of balloons that are worked out</source>
        <translation>Nombre de ballons calculés</translation>
    </message>
    <message>
        <source>Number of balloons that cannot be made</source>
        <translation>Nombre de ballons impossibles à faire</translation>
    </message>
    <message>
        <source>Number of corners of each loop</source>
        <translation>Nombre de sommets de chaque boucle</translation>
    </message>
    <message>
        <source>Number of corners of each seam</source>
        <translation>Nombre de sommets de chaque couture</translation>
    </message>
    <message>
        <source>Number of corners of each weld</source>
        <translation>Nombre de sommets de chaque soudure</translation>
    </message>
    <message>
        <source>Number of flat panels that it is made of; 0: two equal ones</source>
        <translation>Nombre de panneaux plats dont il est fait ; 0 : deux panneaux égaux</translation>
    </message>
    <message>
        <source>Number of holes</source>
        <translation>Nombre de trous</translation>
    </message>
    <message>
        <source>Number of panels</source>
        <translation>Nombre de panneaux</translation>
    </message>
    <message>
        <source>Number of pieces on what is shown</source>
        <translation>Nombre de pièces sur ce qui est montré</translation>
    </message>
    <message>
        <source>Number of seams between them</source>
        <translation>Nombre de coutures entre eux</translation>
    </message>
    <message>
        <source>Number of seams, then the number of vertices of each seam and weld</source>
        <translation>Nombre de coutures, puis nombre de nœuds de chaque couture et soudure</translation>
    </message>
    <message>
        <source>Number of sheets</source>
        <translation>Nombre de feuilles</translation>
    </message>
    <message>
        <source>Number of the sheet that is shown and exported</source>
        <translation>Numéro de la feuille montrée et exportée</translation>
    </message>
    <message>
        <source>Of many panels, for each seam: both panels, number of vertices, then those of either side</source>
        <translation>Avec plusieurs panneaux, pour chaque couture : les deux panneaux, le nombre de nœuds, puis ceux de chaque côté</translation>
    </message>
    <message>
        <source>Of many panels, for each: number of vertices, of triangles and of loops</source>
        <translation>Avec plusieurs panneaux, pour chacun : nombre de nœuds, de triangles et de boucles</translation>
    </message>
    <message>
        <source>Of many panels, how much longer one side of a seam may be</source>
        <translation>Avec plusieurs panneaux, de combien un côté d'une couture peut être plus long</translation>
    </message>
    <message>
        <source>Of warm air, in degrees Celsius</source>
        <translation>De l'air chaud, en degrés Celsius</translation>
    </message>
    <message>
        <source>On which remnant each sheet is, -1 for none</source>
        <translation>Sur quelle chute est chaque feuille, -1 pour aucune</translation>
    </message>
    <message>
        <source>Only one side of this film can be joined so</source>
        <translation>Une seule face de ce film peut être assemblée ainsi</translation>
    </message>
    <message>
        <source>Panel of each triangle</source>
        <translation>Panneau de chaque triangle</translation>
    </message>
    <message>
        <source>Panels and seams as JSON, in metres</source>
        <translation>Panneaux et coutures en JSON, en mètres</translation>
    </message>
    <message>
        <source>Panels that are cut, each with what is equal to it</source>
        <translation>Panneaux découpés, chacun avec ceux qui lui sont égaux</translation>
    </message>
    <message>
        <source>Part of the film that the pieces take, in per cent</source>
        <translation>Part du film que prennent les pièces, en pour cent</translation>
    </message>
    <message>
        <source>Part of the film's area that hangs loose</source>
        <translation>Part de la surface du film qui est détendue</translation>
    </message>
    <message>
        <source>Part of the film's area that is wrinkled</source>
        <translation>Part de la surface du film qui est plissée</translation>
    </message>
    <message>
        <source>Picture, SVG, DXF or JSON file; a copy travels in the document</source>
        <translation>Image, fichier SVG, DXF ou JSON ; une copie reste dans le document</translation>
    </message>
    <message>
        <source>Place of the intake: counter-clockwise along the outer seam from its rightmost point</source>
        <translation>Place de l'embout : le long de la couture extérieure, sens antihoraire depuis son point le plus à droite</translation>
    </message>
    <message>
        <source>Places of the outline that move if the weld creases, the worst first</source>
        <translation>Endroits du contour qui se déplacent si la soudure se froisse, le pire d'abord</translation>
    </message>
    <message>
        <source>Points of the body's triangles</source>
        <translation>Points des triangles du corps</translation>
    </message>
    <message>
        <source>Points of the profile: radius, 0, height</source>
        <translation>Points du profil : rayon, 0, hauteur</translation>
    </message>
    <message>
        <source>Poisson's ratio of the film</source>
        <translation>Coefficient de Poisson du film</translation>
    </message>
    <message>
        <source>Polymer of the side that is welded, such as PE; none where it does not weld, empty: not known</source>
        <translation>Polymère de la face soudable, par exemple PE ; none quand elle ne se soude pas ; vide : inconnu</translation>
    </message>
    <message>
        <source>Pressure in the inflated balloon</source>
        <translation>Pression dans le ballon gonflé</translation>
    </message>
    <message>
        <source>Pressure inside, above that outside</source>
        <translation>Pression intérieure, au-dessus de l'extérieure</translation>
    </message>
    <message>
        <source>Put the tab opposite the intake</source>
        <translation>Placer la languette à l'opposé de l'embout</translation>
    </message>
    <message>
        <source>Remarks made during the design</source>
        <translation>Remarques faites pendant la conception</translation>
    </message>
    <message>
        <source>Remarks made while the body was read</source>
        <translation>Remarques faites à la lecture du corps</translation>
    </message>
    <message>
        <source>Remarks made while the outline was found</source>
        <translation>Remarques faites pendant la recherche du contour</translation>
    </message>
    <message>
        <source>Remarks made while the panels were read</source>
        <translation>Remarques faites à la lecture des panneaux</translation>
    </message>
    <message>
        <source>Remarks made while the pattern was drawn</source>
        <translation>Remarques faites pendant le tracé du patron</translation>
    </message>
    <message>
        <source>Remarks made while the profile was read</source>
        <translation>Remarques faites à la lecture du profil</translation>
    </message>
    <message>
        <source>Remarks on the layout</source>
        <translation>Remarques sur la disposition</translation>
    </message>
    <message>
        <source>Repairs that were made in the drawing, one each; delete an entry to take it back</source>
        <translation>Réparations faites dans le dessin, une par entrée ; effacer une entrée l'annule</translation>
    </message>
    <message>
        <source>Result that is shown as colours, with a legend</source>
        <translation>Résultat montré en couleurs, avec une légende</translation>
    </message>
    <message>
        <source>STL, OBJ, PLY, 3MF, STEP, IGES or BREP file of a closed body; a copy travels in the document</source>
        <translation>Fichier STL, OBJ, PLY, 3MF, STEP, IGES ou BREP d'un corps fermé ; une copie voyage dans le document</translation>
    </message>
    <message>
        <source>SVG, DXF or JSON file of half the outline; a copy travels in the document</source>
        <translation>Fichier SVG, DXF ou JSON d'un demi-contour ; une copie voyage dans le document</translation>
    </message>
    <message>
        <source>Seams by the number on both edges, with their lengths</source>
        <translation>Coutures selon le numéro sur les deux bords, avec leurs longueurs</translation>
    </message>
    <message>
        <source>Show the drawing and the silhouette over each other</source>
        <translation>Montrer le dessin et la silhouette superposés</translation>
    </message>
    <message>
        <source>Simulate both panels instead of one and its mirror image</source>
        <translation>Simuler les deux panneaux au lieu d'un seul et de son image miroir</translation>
    </message>
    <message>
        <source>Size of the body along x, y and z</source>
        <translation>Taille du corps selon x, y et z</translation>
    </message>
    <message>
        <source>Size of the triangles; 0 is automatic</source>
        <translation>Taille des triangles ; 0 est automatique</translation>
    </message>
    <message>
        <source>Sketch or wire of half the outline, which the body follows</source>
        <translation>Esquisse ou fil d'un demi-contour, que le corps suit</translation>
    </message>
    <message>
        <source>Sketch, wire or face that the outline follows instead of a file</source>
        <translation>Esquisse, fil ou face que le contour suit au lieu d'un fichier</translation>
    </message>
    <message>
        <source>Sketches are projected onto the side that is nearer to them only</source>
        <translation>Les esquisses ne sont projetées que sur le côté le plus proche d'elles</translation>
    </message>
    <message>
        <source>Sketches whose lines are seams: they are projected onto the body along the normal of their plane</source>
        <translation>Esquisses dont les lignes sont des coutures : elles sont projetées sur le corps selon la normale de leur plan</translation>
    </message>
    <message>
        <source>Sketches, wires and flat faces that are the panels, each seen from outside</source>
        <translation>Esquisses, fils et faces planes qui sont les panneaux, chacun vu de l'extérieur</translation>
    </message>
    <message>
        <source>Smaller holes, of the area of their shape, are filled</source>
        <translation>Les trous plus petits, en part de l'aire de leur forme, sont remplis</translation>
    </message>
    <message>
        <source>Smooth stretches as single splines in place of arcs</source>
        <translation>Parties lisses en une seule spline au lieu d'arcs</translation>
    </message>
    <message>
        <source>So far outside of the body, or inside, the film lies at least</source>
        <translation>Distance minimale du film au corps, à l'extérieur ou à l'intérieur</translation>
    </message>
    <message>
        <source>Solid or mesh that the balloon is to fill, which it follows</source>
        <translation>Solide ou maillage que le ballon doit remplir, et qu'il suit</translation>
    </message>
    <message>
        <source>Solver that was used</source>
        <translation>Solveur utilisé</translation>
    </message>
    <message>
        <source>Solver: compiled, NumPy, or the best of them; Newmark follows the inflation in time, slowly</source>
        <translation>Solveur : compilé, NumPy, ou le meilleur des deux ; Newmark suit le gonflage dans le temps, lentement</translation>
    </message>
    <message>
        <source>Steps of the solver in the last inflation</source>
        <translation>Pas du solveur au dernier gonflage</translation>
    </message>
    <message>
        <source>Stiffness of a weld in its plane, in parts of what both films have there when they stay flat</source>
        <translation>Rigidité d'une soudure dans son plan, en proportion de celle qu'y ont les deux films quand ils restent plats</translation>
    </message>
    <message>
        <source>Tension over the section at which the film tears; 0: not known</source>
        <translation>Contrainte dans la section à laquelle le film se déchire ; 0 : inconnue</translation>
    </message>
    <message>
        <source>The balloon of a row that was shown last</source>
        <translation>Le dernier ballon d'une ligne qui a été montré</translation>
    </message>
    <message>
        <source>The balloon shown has come to rest</source>
        <translation>Le ballon montré est arrivé au repos</translation>
    </message>
    <message>
        <source>The balloon that is cut from this pattern</source>
        <translation>Le ballon découpé dans ce patron</translation>
    </message>
    <message>
        <source>The balloon that is varied</source>
        <translation>Le ballon que l'on fait varier</translation>
    </message>
    <message>
        <source>The film resists bending</source>
        <translation>Le film résiste à la flexion</translation>
    </message>
    <message>
        <source>The machine that finds the print again by its registration marks; empty has crosses for the eye</source>
        <translation>La machine qui retrouve l'impression par ses repères ; vide donne des croix pour l'œil</translation>
    </message>
    <message>
        <source>The outline whose drawing this one shares; empty: its own</source>
        <translation>Le contour dont celui-ci partage le dessin ; vide : le sien</translation>
    </message>
    <message>
        <source>The pattern that is printed</source>
        <translation>Le patron imprimé</translation>
    </message>
    <message>
        <source>The pattern that it is a piece of</source>
        <translation>Le patron dont c'est une pièce</translation>
    </message>
    <message>
        <source>The patterns that are laid out</source>
        <translation>Les patrons disposés</translation>
    </message>
    <message>
        <source>The pressure is that at the lower end and rises with the height, as the gas is lighter than air</source>
        <translation>La pression est celle de l'extrémité basse et croît avec la hauteur, car le gaz est plus léger que l'air</translation>
    </message>
    <message>
        <source>The seams in the order of the work</source>
        <translation>Les coutures dans l'ordre du travail</translation>
    </message>
    <message>
        <source>The second panel beside the first, mirrored; else cut twice</source>
        <translation>Le second panneau à côté du premier, en miroir ; sinon couper deux fois</translation>
    </message>
    <message>
        <source>The side that is shown and exported for a cutter</source>
        <translation>La face montrée et exportée pour une découpeuse</translation>
    </message>
    <message>
        <source>The silhouette is within the tolerance of the drawing</source>
        <translation>La silhouette est dans la tolérance du dessin</translation>
    </message>
    <message>
        <source>The spreadsheet: headings in its first row, a balloon in each below</source>
        <translation>La feuille de calcul : en-têtes dans la première ligne, un ballon dans chacune des suivantes</translation>
    </message>
    <message>
        <source>The whole report as JSON</source>
        <translation>Le rapport entier en JSON</translation>
    </message>
    <message>
        <source>The workbench has given it a place</source>
        <translation>Il a une place ; un nouvel objet en reçoit une</translation>
    </message>
    <message>
        <source>Thickness of the balloon, from which the side band follows; 0 takes the band's own width</source>
        <translation>Épaisseur du ballon, dont découle la bande latérale ; 0 prend la largeur propre de la bande</translation>
    </message>
    <message>
        <source>Thickness of the film</source>
        <translation>Épaisseur du film</translation>
    </message>
    <message>
        <source>Thickness of the inflated balloon</source>
        <translation>Épaisseur du ballon gonflé</translation>
    </message>
    <message>
        <source>Three places on each of these, flat</source>
        <translation>Trois endroits sur chacune d'elles, à plat</translation>
    </message>
    <message>
        <source>Three points of each triangle</source>
        <translation>Trois points de chaque triangle</translation>
    </message>
    <message>
        <source>Two points of each edge at which a panel is cut open</source>
        <translation>Deux points de chaque bord où un panneau est ouvert par une coupe</translation>
    </message>
    <message>
        <source>Up to date, or what is wrong</source>
        <translation>À jour, ou ce qui ne va pas</translation>
    </message>
    <message>
        <source>Version of this object's properties</source>
        <translation>Version des propriétés de cet objet</translation>
    </message>
    <message>
        <source>Vertices along all seams, then along all welds inside</source>
        <translation>Nœuds le long des coutures, puis des soudures intérieures</translation>
    </message>
    <message>
        <source>Vertices of each triangle</source>
        <translation>Nœuds de chaque triangle</translation>
    </message>
    <message>
        <source>Vertices of the flat panel</source>
        <translation>Nœuds du panneau à plat</translation>
    </message>
    <message>
        <source>Vertices of the inflated upper film</source>
        <translation>Nœuds du film supérieur gonflé</translation>
    </message>
    <message>
        <source>Vertices of the lower film where both were simulated</source>
        <translation>Nœuds du film inférieur quand les deux ont été simulés</translation>
    </message>
    <message>
        <source>Volume of the balloon, from which the pressure follows</source>
        <translation>Volume du ballon, d'où se déduit la pression</translation>
    </message>
    <message>
        <source>Volume of the body</source>
        <translation>Volume du corps</translation>
    </message>
    <message>
        <source>Volume of the inflated balloon</source>
        <translation>Volume du ballon gonflé</translation>
    </message>
    <message>
        <source>Volume that decides the size</source>
        <translation>Volume qui décide de la taille</translation>
    </message>
    <message>
        <source>Weight of the film in kg per square metre</source>
        <translation>Masse du film en kg par mètre carré</translation>
    </message>
    <message>
        <source>Weld that resists bending in its plane, or film that crumples there freely, the worst for a ring</source>
        <translation>Soudure qui résiste à la flexion dans son plan, ou film qui s'y froisse librement, le pire pour un anneau</translation>
    </message>
    <message>
        <source>What decides the size: the outline as it is, a volume to hold or a load to carry</source>
        <translation>Ce qui décide de la taille : le contour tel quel, un volume à contenir ou une charge à porter</translation>
    </message>
    <message>
        <source>What does not fit yet, a sentence each</source>
        <translation>Ce qui ne va pas encore, une phrase par point</translation>
    </message>
    <message>
        <source>What each edge of the shape is called</source>
        <translation>Comment s'appelle chaque bord de la forme</translation>
    </message>
    <message>
        <source>What fills it when it shall float</source>
        <translation>Ce qui le remplit quand il doit flotter</translation>
    </message>
    <message>
        <source>What is given: the pressure, or the volume that it shall reach</source>
        <translation>Ce qui est donné : la pression, ou le volume à atteindre</translation>
    </message>
    <message>
        <source>What is printed; empty takes the picture or painting of the outline</source>
        <translation>Ce qui est imprimé ; vide prend l'image ou la peinture du contour</translation>
    </message>
    <message>
        <source>What is thinner, of the size of the drawing, is a line whose inside is filled; 0 keeps all holes</source>
        <translation>Ce qui est plus mince, en part de la taille du dessin, est une ligne dont l'intérieur est rempli ; 0 garde tous les trous</translation>
    </message>
    <message>
        <source>What it carries with its gas, in grams; below 0 it sinks</source>
        <translation>Ce qu'il porte avec son gaz, en grammes ; sous 0 il descend</translation>
    </message>
    <message>
        <source>What it is called on the pattern</source>
        <translation>Comment elle s'appelle sur le patron</translation>
    </message>
    <message>
        <source>What it is to be: an outline, a body of gores or a bag</source>
        <translation>Ce que ce doit être : un contour, un corps de fuseaux ou un sac</translation>
    </message>
    <message>
        <source>What it shall carry besides itself, in grams; 0 makes it float just so</source>
        <translation>Ce qu'il doit porter en plus de lui-même, en grammes ; 0 le fait juste flotter</translation>
    </message>
    <message>
        <source>What tells where the intake is</source>
        <translation>Ce qui indique la place de l'embout</translation>
    </message>
    <message>
        <source>What the balloon is made of; Custom lets you give your own values</source>
        <translation>De quoi le ballon est fait ; « Personnalisé » permet vos propres valeurs</translation>
    </message>
    <message>
        <source>What the body was read from</source>
        <translation>D'où le corps a été lu</translation>
    </message>
    <message>
        <source>What the design of many panels has figures, as JSON</source>
        <translation>Chiffres de la conception à plusieurs panneaux, en JSON</translation>
    </message>
    <message>
        <source>What the outline was read from</source>
        <translation>D'où le contour a été lu</translation>
    </message>
    <message>
        <source>What the panels were read from</source>
        <translation>D'où les panneaux ont été lus</translation>
    </message>
    <message>
        <source>What the profile was read from</source>
        <translation>D'où le profil a été lu</translation>
    </message>
    <message>
        <source>What to do along each wire of the shape</source>
        <translation>Que faire le long de chaque fil de la forme</translation>
    </message>
    <message>
        <source>What would make the balloon better</source>
        <translation>Ce qui rendrait le ballon meilleur</translation>
    </message>
    <message>
        <source>Where a balloon of many panels is filled: the number of a seam, or a panel and the point at which an edge begins, such as top.2; a panel alone has a nozzle in its middle</source>
        <translation>Par où un ballon de plusieurs panneaux est rempli : le numéro d'une couture, ou un panneau et le point où un bord commence, comme top.2 ; un panneau seul a une buse en son milieu</translation>
    </message>
    <message>
        <source>Where all pieces lie, as JSON</source>
        <translation>Où sont toutes les pièces, en JSON</translation>
    </message>
    <message>
        <source>Where it is found: farthest from the centre, or low, where a tied balloon hangs straight</source>
        <translation>Où elle est cherchée : au plus loin du centre, ou en bas, où un ballon attaché pend droit</translation>
    </message>
    <message>
        <source>Where the middle of each lies, turned and mirrored</source>
        <translation>Où est le milieu de chacune, tournée et en miroir</translation>
    </message>
    <message>
        <source>Where the profile comes from without a sketch: a file, or the shape of a balloon without weight</source>
        <translation>D'où vient le profil sans esquisse : d'un fichier, ou de la forme d'un ballon sans poids</translation>
    </message>
    <message>
        <source>Where the workbench put it</source>
        <translation>Où il a été placé, sauf par l'utilisateur</translation>
    </message>
    <message>
        <source>Whether a laser may cut this film</source>
        <translation>Si un laser peut couper ce film</translation>
    </message>
    <message>
        <source>Whether the balloon follows the body, encloses or lines it</source>
        <translation>Si le ballon suit le corps, l'entoure ou le double à l'intérieur</translation>
    </message>
    <message>
        <source>Which edges are joined</source>
        <translation>Quels bords sont assemblés</translation>
    </message>
    <message>
        <source>Which film is laid out: pieces of a valve are on one of their own</source>
        <translation>Quel film est disposé : les pièces d'une valve sont sur un film à part</translation>
    </message>
    <message>
        <source>Which of them each wire belongs to; 0: a copy</source>
        <translation>À quelle pièce appartient chaque fil ; 0 : une copie</translation>
    </message>
    <message>
        <source>Which piece of the pattern it is, from 1</source>
        <translation>Quelle pièce du patron c'est, à partir de 1</translation>
    </message>
    <message>
        <source>Which shape of the drawing it is; 1 is the largest</source>
        <translation>Quelle forme du dessin c'est ; 1 est la plus grande</translation>
    </message>
    <message>
        <source>Width from which it carries itself; 0 when never</source>
        <translation>Largeur à partir de laquelle il se porte ; 0 : jamais</translation>
    </message>
    <message>
        <source>Width of a body from a file, along x; 0 follows from the height, or the file</source>
        <translation>Largeur d'un corps venant d'un fichier, selon x ; 0 découle de la hauteur, ou du fichier</translation>
    </message>
    <message>
        <source>Width of a side band between front and back; 0 is two panels</source>
        <translation>Largeur d'une bande latérale entre l'avant et l'arrière ; 0 donne deux panneaux</translation>
    </message>
    <message>
        <source>Width of all that is cut</source>
        <translation>Largeur de tout ce qui est coupé</translation>
    </message>
    <message>
        <source>Width of the drawing; 0 follows from the height</source>
        <translation>Largeur du dessin ; 0 se déduit de la hauteur</translation>
    </message>
    <message>
        <source>Width of the inflated balloon</source>
        <translation>Largeur du ballon gonflé</translation>
    </message>
    <message>
        <source>Width of the outline</source>
        <translation>Largeur du contour</translation>
    </message>
    <message>
        <source>Width of the piece of film</source>
        <translation>Largeur de la pièce de film</translation>
    </message>
    <message>
        <source>Width of the print with its marks</source>
        <translation>Largeur de l'impression avec ses repères</translation>
    </message>
    <message>
        <source>Width of the roll or sheet</source>
        <translation>Largeur du rouleau ou de la feuille</translation>
    </message>
    <message>
        <source>Width of the weld that this film needs</source>
        <translation>Largeur de soudure qu'il faut à ce film</translation>
    </message>
    <message>
        <source>Width of the weld; 0 takes the film's</source>
        <translation>Largeur de la soudure ; 0 prend celle du film</translation>
    </message>
    <message>
        <source>Young's modulus across the grain; 0 means no grain</source>
        <translation>Module d'Young en travers du film ; 0 : sans sens privilégié</translation>
    </message>
    <message>
        <source>Young's modulus of the film</source>
        <translation>Module d'Young du film</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench</name>
    <message>
        <source> It may have lacked memory: take a coarser mesh.</source>
        <translation> La mémoire a peut-être manqué : prenez un maillage plus grossier.</translation>
    </message>
    <message>
        <source> is not ready: </source>
        <translation> n'est pas prêt : </translation>
    </message>
    <message>
        <source>"hosts" is no list: write {0}.</source>
        <translation>« hosts » n'est pas une liste : écrivez {0}.</translation>
    </message>
    <message>
        <source>"{0}" cannot be read: write {"kind": "latin-hypercube", "rows": 100, "seed": 1}.</source>
        <translation>« {0} » est illisible : écrivez {"kind": "latin-hypercube", "rows": 100, "seed": 1}.</translation>
    </message>
    <message>
        <source>"{0}" has one result and its value: write {"lift": "20 g"}.</source>
        <translation>« {0} » a un résultat et sa valeur : écrivez {"lift": "20 g"}.</translation>
    </message>
    <message>
        <source>"{0}" is an edge of {1} panels: name the face too, as in {2}.</source>
        <translation>« {0} » est un bord de {1} panneaux : nommez aussi la face, comme dans {2}.</translation>
    </message>
    <message>
        <source>"{0}" is no choice for a pattern larger than the bed: choose {1}.</source>
        <translation>« {0} » n'est pas possible avec un patron trop grand : choisissez {1}.</translation>
    </message>
    <message>
        <source>"{0}" is no colour: give one such as "#cc294d".</source>
        <translation>« {0} » n'est pas une couleur : donnez par exemple « #cc294d ».</translation>
    </message>
    <message>
        <source>"{0}" is no edge of a panel: write it as in {1}.0, or give the number of a seam, 1 to {2}. There are the panels {3}{4}.</source>
        <translation>« {0} » n'est pas un bord d'un panneau : écrivez-le comme dans {1}.0, ou donnez le numéro d'une couture, de 1 à {2}. Il y a les panneaux {3}{4}.</translation>
    </message>
    <message>
        <source>"{0}" is no sum of L, W, S, A and millimetres, such as "0.5 W + 2".</source>
        <translation>« {0} » n'est pas une somme de L, W, S, A et de millimètres, comme « 0.5 W + 2 ».</translation>
    </message>
    <message>
        <source>"{0}" may not use {1}.</source>
        <translation>« {0} » ne peut pas utiliser {1}.</translation>
    </message>
    <message>
        <source>"{0}" of "{1}" is no whole number: write one.</source>
        <translation>« {0} » de « {1} » n'est pas un nombre entier : écrivez-en un.</translation>
    </message>
    <message>
        <source>"{0}" of the study is no JSON object: write {"width": ...}.</source>
        <translation>« {0} » de l'étude n'est pas un objet JSON : écrivez {"width": ...}.</translation>
    </message>
    <message>
        <source>"{0}" of the study is no list of JSON objects: write [{"input": ...}, ...].</source>
        <translation>« {0} » de l'étude n'est pas une liste d'objets JSON : écrivez [{"input": ...}, ...].</translation>
    </message>
    <message>
        <source>"{0}" says what may be chosen: write {"width": ["100mm", "400mm"]}.</source>
        <translation>« {0} » dit ce qui peut être choisi : écrivez {"width": ["100mm", "400mm"]}.</translation>
    </message>
    <message>
        <source>'{0}' cannot be kept: write {1} or {2}.</source>
        <translation>« {0} » ne peut pas être conservé : écrivez {1} ou {2}.</translation>
    </message>
    <message>
        <source>'{0}' cannot be read ({1}). Check the name and its access.</source>
        <translation>« {0} » ne peut pas être lu ({1}). Vérifiez le nom et les droits d'accès.</translation>
    </message>
    <message>
        <source>'{0}' cannot be read ({1}): name a JSON file of settings.</source>
        <translation>« {0} » est illisible ({1}) : indiquez un fichier JSON de réglages.</translation>
    </message>
    <message>
        <source>'{0}' cannot be the name of a machine: take up to 40 letters, digits, spaces and - only.</source>
        <translation>« {0} » ne peut pas être le nom d'une machine : prenez jusqu'à 40 lettres, chiffres, espaces et - seulement.</translation>
    </message>
    <message>
        <source>'{0}' has a column twice.</source>
        <translation>« {0} » a deux fois la même colonne.</translation>
    </message>
    <message>
        <source>'{0}' has another unit than {1}: write it like {2}.</source>
        <translation>« {0} » a une autre unité que {1} : écrivez comme {2}.</translation>
    </message>
    <message>
        <source>'{0}' has its own panels: leave out what you give of gores or of a side band.</source>
        <translation>« {0} » a ses propres panneaux : retirez ce qui concerne les fuseaux ou une bande latérale.</translation>
    </message>
    <message>
        <source>'{0}' has its panels as they are to be cut: use inflate instead of design.</source>
        <translation>« {0} » a ses panneaux tels qu'ils seront coupés : utilisez inflate au lieu de design.</translation>
    </message>
    <message>
        <source>'{0}' has no closed line: give the pattern as it was cut.</source>
        <translation>« {0} » n'a pas de ligne fermée : donnez le patron tel qu'il a été coupé.</translation>
    </message>
    <message>
        <source>'{0}' has no panels of its own: give gores, or the width of a side band.</source>
        <translation>« {0} » n'a pas de panneaux propres : donnez des fuseaux, ou la largeur d'une bande latérale.</translation>
    </message>
    <message>
        <source>'{0}' has no profile: give half the outline of the body as an SVG, a DXF or JSON.</source>
        <translation>« {0} » n'a pas de profil : donnez un demi-contour du corps en SVG, DXF ou JSON.</translation>
    </message>
    <message>
        <source>'{0}' has the size of its panels: leave out the width and the height.</source>
        <translation>« {0} » a la taille de ses panneaux : retirez la largeur et la hauteur.</translation>
    </message>
    <message>
        <source>'{0}' has {1} x {2} pixels, more than {3} million. Make it smaller; 2000 pixels across are plenty.</source>
        <translation>« {0} » a {1} x {2} pixels, plus de {3} millions. Réduisez-la ; 2000 pixels de large suffisent largement.</translation>
    </message>
    <message>
        <source>'{0}' is a body: leave out what you give of gores or of a side band.</source>
        <translation>« {0} » est un corps : retirez ce qui concerne les fuseaux ou une bande latérale.</translation>
    </message>
    <message>
        <source>'{0}' is a pipe or a device: save what comes from it, and name that file.</source>
        <translation>« {0} » est un tube ou un périphérique : enregistrez ce qui en vient, et donnez ce fichier.</translation>
    </message>
    <message>
        <source>'{0}' is a profile, which has no side band: give a drawing for that.</source>
        <translation>« {0} » est un profil, qui n'a pas de bande latérale : donnez un dessin pour cela.</translation>
    </message>
    <message>
        <source>'{0}' is colder than anything; write a temperature as 20C, 68F or 293K.</source>
        <translation>« {0} » est plus froid que tout ; écrivez une température comme 20C, 68F ou 293K.</translation>
    </message>
    <message>
        <source>'{0}' is damaged or not a picture ({1}). Save it as PNG, JPEG or BMP once more.</source>
        <translation>« {0} » est abîmé ou n'est pas une image ({1}). Enregistrez-le à nouveau en PNG, JPEG ou BMP.</translation>
    </message>
    <message>
        <source>'{0}' is damaged or not a picture. Save it as PNG, JPEG or BMP once more.</source>
        <translation>« {0} » est abîmé ou n'est pas une image. Enregistrez-le à nouveau en PNG, JPEG ou BMP.</translation>
    </message>
    <message>
        <source>'{0}' is damaged. Save it as PNG, JPEG or BMP once more.</source>
        <translation>« {0} » est abîmé. Enregistrez-le à nouveau en PNG, JPEG ou BMP.</translation>
    </message>
    <message>
        <source>'{0}' is empty. Choose another file.</source>
        <translation>« {0} » est vide. Choisissez un autre fichier.</translation>
    </message>
    <message>
        <source>'{0}' is larger than {1} MB. Make it simpler.</source>
        <translation>« {0} » dépasse {1} Mo. Simplifiez le contenu.</translation>
    </message>
    <message>
        <source>'{0}' is larger than {1} MB. Save it as JPEG or PNG.</source>
        <translation>« {0} » dépasse {1} Mo. Enregistrez-le en JPEG ou PNG.</translation>
    </message>
    <message>
        <source>'{0}' is neither SVG, DXF nor JSON. Save the drawing as one of these.</source>
        <translation>« {0} » n'est ni SVG, ni DXF, ni JSON. Enregistrez le dessin dans un de ces formats.</translation>
    </message>
    <message>
        <source>'{0}' is neither yes nor no: write one of them for {1}.</source>
        <translation>« {0} » n'est ni yes ni no : écrivez l'un des deux pour {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no JSON ({1}{2}).</source>
        <translation>« {0} » n'est pas du JSON ({1}{2}).</translation>
    </message>
    <message>
        <source>'{0}' is no JSON object: write {"queue": ...}.</source>
        <translation>« {0} » n'est pas un objet JSON : écrivez {"queue": ...}.</translation>
    </message>
    <message>
        <source>'{0}' is no closed body: leave out --panels, or give an STL, OBJ, PLY, 3MF or STEP.</source>
        <translation>« {0} » n'est pas un corps fermé : retirez --panels, ou donnez un STL, OBJ, PLY, 3MF ou STEP.</translation>
    </message>
    <message>
        <source>'{0}' is no cluster: write one of {1}.</source>
        <translation>« {0} » n'est pas un cluster : écrivez l'un de {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no command of a study: write {1} or {2}.</source>
        <translation>« {0} » n'est pas une commande d'étude : écrivez {1} ou {2}.</translation>
    </message>
    <message>
        <source>'{0}' is no difference of temperatures: write 5K, 5C or 9F.</source>
        <translation>« {0} » n'est pas un écart de température : écrivez 5K, 5C ou 9F.</translation>
    </message>
    <message>
        <source>'{0}' is no file: name one.</source>
        <translation>« {0} » n'est pas un fichier : indiquez-en un.</translation>
    </message>
    <message>
        <source>'{0}' is no number for {1}.</source>
        <translation>« {0} » n'est pas un nombre pour {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no single value for {1}.</source>
        <translation>« {0} » n'est pas une valeur unique pour {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no size: write 500mm for a width, 500mmx700mm for width and height.</source>
        <translation>« {0} » n'est pas une taille : écrivez 500mm pour une largeur, 500mmx700mm pour largeur et hauteur.</translation>
    </message>
    <message>
        <source>'{0}' is no table ({1}): save it as CSV.</source>
        <translation>« {0} » n'est pas un tableau ({1}) : enregistrez-le en CSV.</translation>
    </message>
    <message>
        <source>'{0}' is no test card: name the test-card.json that was made with it.</source>
        <translation>« {0} » n'est pas une carte d'essai : nommez le test-card.json fait avec elle.</translation>
    </message>
    <message>
        <source>'{0}' is no text in UTF-8: save it as one.</source>
        <translation>« {0} » n'est pas un texte en UTF-8 : enregistrez-le ainsi.</translation>
    </message>
    <message>
        <source>'{0}' is no text in UTF-8: save the table as CSV in UTF-8.</source>
        <translation>« {0} » n'est pas un texte en UTF-8 : enregistrez le tableau en CSV, en UTF-8.</translation>
    </message>
    <message>
        <source>'{0}' is no value for an option of sbatch: write one line.</source>
        <translation>« {0} » n'est pas une valeur pour une option de sbatch : écrivez une seule ligne.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}.</source>
        <translation>« {0} » n'est pas une valeur pour {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number and its unit.</source>
        <translation>« {0} » n'est pas une valeur pour {1} : écrivez un nombre et son unité.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number in its unit.</source>
        <translation>« {0} » n'est pas une valeur pour {1} : écrivez un nombre dans son unité.</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number without a unit.</source>
        <translation>« {0} » n'est pas une valeur pour {1} : écrivez un nombre sans unité.</translation>
    </message>
    <message>
        <source>'{0}' is no way to search: write {1} or {2}.</source>
        <translation>« {0} » n'est pas une façon de chercher : écrivez {1} ou {2}.</translation>
    </message>
    <message>
        <source>'{0}' is no way to take samples: write {1} or {2}.</source>
        <translation>« {0} » n'est pas une façon de tirer des échantillons : écrivez {1} ou {2}.</translation>
    </message>
    <message>
        <source>'{0}' is no whole number: write one for {1}.</source>
        <translation>« {0} » n'est pas un nombre entier : écrivez-en un pour {1}.</translation>
    </message>
    <message>
        <source>'{0}' is no {1}: write {2}.</source>
        <translation>« {0} » n'est pas un choix de {1} : écrivez l'un de ceux-ci : {2}.</translation>
    </message>
    <message>
        <source>'{0}' is none of {1} for {2}.</source>
        <translation>« {0} » n'est aucun de {1} pour {2}.</translation>
    </message>
    <message>
        <source>'{0}' is not a drawing that can be read. Use PNG, JPEG, BMP, SVG, DXF or JSON.</source>
        <translation>« {0} » n'est pas un dessin lisible. Utilisez PNG, JPEG, BMP, SVG, DXF ou JSON.</translation>
    </message>
    <message>
        <source>'{0}' is not a file name: leave out the folder.</source>
        <translation>« {0} » n'est pas un nom de fichier : omettez le dossier.</translation>
    </message>
    <message>
        <source>'{0}' is not a picture that can be read. Save it as PNG, JPEG or BMP.</source>
        <translation>« {0} » n'est pas une image lisible. Enregistrez-la en PNG, JPEG ou BMP.</translation>
    </message>
    <message>
        <source>'{0}' is not a temperature; write it as 20C, 68F or 293K.</source>
        <translation>« {0} » n'est pas une température ; écrivez-la comme 20C, 68F ou 293K.</translation>
    </message>
    <message>
        <source>'{0}' is not a {1}; write it like {2}.</source>
        <translation>« {0} » ne convient pas ({1}) ; écrivez par exemple {2}.</translation>
    </message>
    <message>
        <source>'{0}' is read by FreeCAD, which is not there: install it for the Python that runs this, or give an STL of the solid.</source>
        <translation>« {0} » est lu par FreeCAD, qui n'est pas là : installez-le pour le Python qui exécute ceci, ou donnez un STL du solide.</translation>
    </message>
    <message>
        <source>'{}' has {} x {} pixels, more than {} million. Make it smaller; 2000 across are plenty.</source>
        <translation>« {} » a {} x {} pixels, plus de {} millions. Réduisez-la ; 2000 pixels de large suffisent largement.</translation>
    </message>
    <message>
        <source>'{}' is not a picture. Save it as PNG, JPEG or BMP once more.</source>
        <translation>« {} » n'est pas une image. Enregistrez-la à nouveau en PNG, JPEG ou BMP.</translation>
    </message>
    <message>
        <source>'{}' was painted with a newer release: update Film Balloon.</source>
        <translation>« {} » a été peint avec une version plus récente : mettez Film Balloon à jour.</translation>
    </message>
    <message>
        <source>, about {0}</source>
        <translation>, environ {0}</translation>
    </message>
    <message>
        <source>, estimated: the film did not come to rest</source>
        <translation>, estimé : le film n'est pas arrivé au repos</translation>
    </message>
    <message>
        <source>, one edge must turn</source>
        <translation>, un bord doit se retourner</translation>
    </message>
    <message>
        <source>, {0} of them mirrored</source>
        <translation>, dont {0} en miroir</translation>
    </message>
    <message>
        <source>--jobs and --timeout are numbers above 0.</source>
        <translation>--jobs et --timeout sont des nombres supérieurs à 0.</translation>
    </message>
    <message>
        <source>--oversize scale makes the balloon smaller until it fits, --oversize split writes several files between which the film is moved, --oversize write writes the file anyway, --bed tells how large the bed is.</source>
        <translation>--oversize scale réduit le ballon jusqu'à ce qu'il tienne, --oversize split écrit plusieurs fichiers entre lesquels on déplace le film, --oversize write écrit le fichier quand même, --bed dit quelle est la taille du plateau.</translation>
    </message>
    <message>
        <source>--rim is the width of the weld and of the film beside it: give 0 to 1 m.</source>
        <translation>--rim est la largeur de la soudure et du film à côté : donnez de 0 à 1 m.</translation>
    </message>
    <message>
        <source>--tabs-below is about tabs: give their width too, such as --tabs 0.4mm.</source>
        <translation>--tabs-below concerne les attaches : donnez aussi leur largeur, par exemple --tabs 0.4mm.</translation>
    </message>
    <message>
        <source>--target-volume and --target-lift decide the size: leave out --width and --height.</source>
        <translation>--target-volume et --target-lift décident de la taille : omettez --width et --height.</translation>
    </message>
    <message>
        <source>1 to {0} pieces can be laid out, not {1}.</source>
        <translation>On peut disposer de 1 à {0} pièces, pas {1}.</translation>
    </message>
    <message>
        <source>3D model (GLB)</source>
        <translation>Modèle 3D (GLB)</translation>
    </message>
    <message>
        <source>95 % below {} ({})</source>
        <translation>95 % sous {} ({})</translation>
    </message>
    <message>
        <source>95 % of it below</source>
        <translation>95 % en dessous de</translation>
    </message>
    <message>
        <source>A GIF needs Pillow: install it with pip install pillow.</source>
        <translation>Un GIF demande Pillow : installez-le par pip install pillow.</translation>
    </message>
    <message>
        <source>A balloon has no "{0}": it has {1}.</source>
        <translation>Un ballon n'a pas de « {0} » : il a {1}.</translation>
    </message>
    <message>
        <source>A balloon with a side band has no welds inside: its front and back are apart. Leave them out, or make it of two panels.</source>
        <translation>Un ballon à bande latérale n'a pas de soudures à l'intérieur : son avant et son arrière sont écartés. Retirez-les, ou faites-le de deux panneaux.</translation>
    </message>
    <message>
        <source>A bar is stated to weld {0} at {1}, this tool has {2}: peel a test card before you rely on it.</source>
        <translation>Selon sa source, une barre soude {0} à {1}, cet outil est à {2} : pelez une carte d'essai avant de vous y fier.</translation>
    </message>
    <message>
        <source>A bed is that of a machine: give --machine too.</source>
        <translation>Un plateau est celui d'une machine : donnez aussi --machine.</translation>
    </message>
    <message>
        <source>A bed is {0} mm to {1} mm wide and high: write 600mmx400mm, 600mm for a roll, or {2}.</source>
        <translation>Un plateau fait de {0} mm à {1} mm de large et de haut : écrivez 600mmx400mm, 600mm pour un rouleau, ou {2}.</translation>
    </message>
    <message>
        <source>A bed of {0} is too small to lay so much film on anew: give a larger one, or make the balloon smaller.</source>
        <translation>Un plateau de {0} est trop petit pour reposer autant de film : donnez-en un plus grand, ou réduisez le ballon.</translation>
    </message>
    <message>
        <source>A body cannot be made of {0} gores. Take {1} to {2}.</source>
        <translation>Un corps ne peut pas être fait de {0} fuseaux. Prenez-en de {1} à {2}.</translation>
    </message>
    <message>
        <source>A body has 2 panels or more: these are the last ones.</source>
        <translation>Un corps a au moins 2 panneaux : ce sont les derniers.</translation>
    </message>
    <message>
        <source>A body is divided into 2 to {0} panels: say how many.</source>
        <translation>Un corps se divise en 2 à {0} panneaux : dites combien.</translation>
    </message>
    <message>
        <source>A body of gores has no side band: leave out what you give of the one or of the other.</source>
        <translation>Un corps de fuseaux n'a pas de bande latérale : retirez ce qui concerne l'un ou l'autre.</translation>
    </message>
    <message>
        <source>A closed body; a copy of it travels in the document</source>
        <translation>Un corps fermé ; une copie voyage dans le document</translation>
    </message>
    <message>
        <source>A colour</source>
        <translation>Une couleur</translation>
    </message>
    <message>
        <source>A corner relief of {0} would cut into the weld: choose a smaller radius or a wider allowance.</source>
        <translation>Un dégagement d'angle de {0} entamerait la soudure : choisissez un rayon plus petit ou une marge plus large.</translation>
    </message>
    <message>
        <source>A cow from a mesh, by Keenan Crane: change the number of panels</source>
        <translation>Une vache d'après un maillage, de Keenan Crane : changez le nombre de panneaux</translation>
    </message>
    <message>
        <source>A drawing with welds inside is not made symmetric: draw it so, and turn this off.</source>
        <translation>Un dessin à soudures intérieures n'est pas rendu symétrique : dessinez-le ainsi et désactivez ceci.</translation>
    </message>
    <message>
        <source>A file of this name is there already</source>
        <translation>Un fichier de ce nom existe déjà</translation>
    </message>
    <message>
        <source>A film of this name is there already: else it gets the mean of all</source>
        <translation>Un film de ce nom existe déjà : sinon il reçoit la moyenne de toutes les photos</translation>
    </message>
    <message>
        <source>A film of your own beside the balloon's, with what was found; it changes no pattern</source>
        <translation>Un film à vous à côté de celui du ballon, avec ce qui a été trouvé ; aucun patron ne change</translation>
    </message>
    <message>
        <source>A fitted film is kept beside the numbers of a known one: choose the balloon's film in its panel.</source>
        <translation>Un film ajusté est gardé à côté des nombres d'un film connu : choisissez le film du ballon dans son panneau.</translation>
    </message>
    <message>
        <source>A fitted film is written beside the numbers of a known one: give it by --material.</source>
        <translation>Un film ajusté s'écrit à côté des nombres d'un film connu : donnez celui-ci par --material.</translation>
    </message>
    <message>
        <source>A flat panel has no pressure and no rim: leave out --fit, --rim and --uncorrected.</source>
        <translation>Un panneau à plat n'a ni pression ni bord : omettez --fit, --rim et --uncorrected.</translation>
    </message>
    <message>
        <source>A goal has no '{0}': it has one of {1}, and {2}, {3} and {4}.</source>
        <translation>Un but n'a pas de « {0} » : il a l'un de {1}, ainsi que {2}, {3} et {4}.</translation>
    </message>
    <message>
        <source>A goal has one of {0}: write {1}.</source>
        <translation>Un but a l'un de {0} : écrivez {1}.</translation>
    </message>
    <message>
        <source>A hole meets the outline or another hole at {0}; keep some film between them.</source>
        <translation>Un trou rencontre le contour ou un autre trou en {0} ; gardez un peu de film entre eux.</translation>
    </message>
    <message>
        <source>A hole would open or close: draw that part anew.</source>
        <translation>Un trou s'ouvrirait ou se fermerait : redessinez cette partie.</translation>
    </message>
    <message>
        <source>A hot tip is stated to weld {0} at {1}, this tool has {2}: peel a test card before you rely on it.</source>
        <translation>Selon sa source, une pointe chaude soude {0} à {1}, cet outil est à {2} : pelez une carte d'essai avant de vous y fier.</translation>
    </message>
    <message>
        <source>A known length, in pixels of the picture</source>
        <translation>Une longueur connue, en pixels de l'image</translation>
    </message>
    <message>
        <source>A label has up to {0} letters, between 0.1 mm and 10 m high: change it.</source>
        <translation>Une inscription a au plus {0} lettres, hautes de 0,1 mm à 10 m : changez-la.</translation>
    </message>
    <message>
        <source>A layout is as large as its film: give the film the size of the bed there.</source>
        <translation>Une disposition est aussi grande que son film : donnez-y au film la taille du plateau.</translation>
    </message>
    <message>
        <source>A lift of {0} cannot be made: give one such as 5g.</source>
        <translation>Une portance de {0} est impossible : donnez par exemple 5g.</translation>
    </message>
    <message>
        <source>A lift of {0} is out of reach: {1} large, this balloon would carry {2}. Choose a lighter film or gas, a smaller lift, or a rounder shape.</source>
        <translation>Une portance de {0} est hors d'atteinte : grand de {1}, ce ballon porterait {2}. Choisissez un film ou un gaz plus léger, moins de portance ou une forme plus ronde.</translation>
    </message>
    <message>
        <source>A lift of {0} is out of reach: {1} large, this balloon would lack {2}. Choose a lighter film or gas, a smaller lift, or a rounder shape.</source>
        <translation>Une portance de {0} est hors d'atteinte : grand de {1}, il manquerait {2} à ce ballon. Choisissez un film ou un gaz plus léger, moins de portance ou une forme plus ronde.</translation>
    </message>
    <message>
        <source>A line that is projected needs a direction. Give one.</source>
        <translation>Une ligne projetée demande une direction. Donnez-en une.</translation>
    </message>
    <message>
        <source>A line that is projected needs two points or more. Draw them.</source>
        <translation>Une ligne projetée demande au moins deux points. Dessinez-les.</translation>
    </message>
    <message>
        <source>A mesh of {0} is too coarse for a shape of {1}: use at most {2}.</source>
        <translation>Un maillage de {0} est trop grossier pour une forme de {1} : prenez au plus {2}.</translation>
    </message>
    <message>
        <source>A mesh of {0} would need more than a million vertices for a shape of {1}: use at least {2}.</source>
        <translation>Un maillage de {0} demanderait plus d'un million de nœuds pour une forme de {1} : prenez au moins {2}.</translation>
    </message>
    <message>
        <source>A mesh of {0} would need more than a million vertices for these panels: use at least {1}.</source>
        <translation>Un maillage de {0} demanderait plus d'un million de nœuds pour ces panneaux : prenez au moins {1}.</translation>
    </message>
    <message>
        <source>A new Sketcher sketch of lines and arcs, to go on with in FreeCAD</source>
        <translation>Une nouvelle esquisse de lignes et d'arcs, pour continuer dans FreeCAD</translation>
    </message>
    <message>
        <source>A node that moves needs a place to move to; nothing else does.</source>
        <translation>Un nœud qui se déplace demande un endroit où aller ; rien d'autre n'en a.</translation>
    </message>
    <message>
        <source>A number of an intake is empty.</source>
        <translation>Un nombre d'un embout est vide.</translation>
    </message>
    <message>
        <source>A package for this cluster is missing: {0}</source>
        <translation>Il manque un paquet pour ce cluster : {0}</translation>
    </message>
    <message>
        <source>A passage of {0} is left open in the weld at {1}, so that air reaches both sides.</source>
        <translation>Un passage de {0} reste ouvert dans la soudure en {1}, pour que l'air atteigne les deux côtés.</translation>
    </message>
    <message>
        <source>A photograph</source>
        <translation>Une photo</translation>
    </message>
    <message>
        <source>A photograph on a page needs Pillow: install it with pip install pillow.</source>
        <translation>Une photo sur une page demande Pillow : installez-le avec pip install pillow.</translation>
    </message>
    <message>
        <source>A picture cannot be drawn as "{0}": choose {1}.</source>
        <translation>Une image ne peut pas être dessinée comme « {0} » : choisissez {1}.</translation>
    </message>
    <message>
        <source>A picture has no size of its own. Give the width or the height of the balloon.</source>
        <translation>Une image n'a pas de taille propre. Donnez la largeur ou la hauteur du ballon.</translation>
    </message>
    <message>
        <source>A picture that covers what is behind the balloon, such as a photograph of a room</source>
        <translation>Une image qui couvre ce qui est derrière le ballon, comme la photo d'une pièce</translation>
    </message>
    <message>
        <source>A piece does not fit on the sheet: take a larger one.</source>
        <translation>Une pièce ne tient pas sur la feuille : prenez-en une plus grande.</translation>
    </message>
    <message>
        <source>A piece of {0} x {1} does not fit on film of {2}{3}: take film at least {4} wide, or let the grain lie in another direction.</source>
        <translation>Une pièce de {0} x {1} ne tient pas sur un film de {2}{3} : prenez un film d'au moins {4} de large, ou changez le sens du film.</translation>
    </message>
    <message>
        <source>A pillow box cannot be deeper than wide. Choose a smaller depth.</source>
        <translation>Une boîte coussin ne peut pas être plus profonde que large. Choisissez une profondeur plus petite.</translation>
    </message>
    <message>
        <source>A plane needs its normal. Give one.</source>
        <translation>Un plan demande sa normale. Donnez-en une.</translation>
    </message>
    <message>
        <source>A print is not cut in parts: choose a machine with a larger bed than {0}, or make the balloon smaller.</source>
        <translation>Une impression ne se coupe pas en parties : choisissez une machine dont le plateau dépasse {0}, ou réduisez le ballon.</translation>
    </message>
    <message>
        <source>A process beside this one does not start: {0}</source>
        <translation>Un processus à côté de celui-ci ne démarre pas : {0}</translation>
    </message>
    <message>
        <source>A process beside this one is of version {0}, not of {1}: install one of them anew.</source>
        <translation>Un processus à côté de celui-ci est de la version {0}, et non {1} : réinstallez l'un des deux.</translation>
    </message>
    <message>
        <source>A remnant is left of a layout: give --nest too, such as --nest 500mm.</source>
        <translation>Une chute reste d'une disposition : donnez aussi --nest, par exemple --nest 500mm.</translation>
    </message>
    <message>
        <source>A script needs to know how many shards it has: give --shards a number.</source>
        <translation>Un script doit savoir combien de parts il a : donnez un nombre à --shards.</translation>
    </message>
    <message>
        <source>A seam cannot be moved so far: it would meet another one.</source>
        <translation>Une couture ne peut pas être déplacée si loin : elle en rencontrerait une autre.</translation>
    </message>
    <message>
        <source>A seam cannot be moved so far: one of its panels would be lost.</source>
        <translation>Une couture ne peut pas être déplacée si loin : l'un de ses panneaux disparaîtrait.</translation>
    </message>
    <message>
        <source>A seam closes an edge of a triangle to a point. Check which runs it joins.</source>
        <translation>Une soudure ferme l'arête d'un triangle en un point. Vérifiez quels bords elle joint.</translation>
    </message>
    <message>
        <source>A seam near {0} has one place only. Draw it through two.</source>
        <translation>Une couture près de {0} n'a qu'un endroit. Dessinez-la par deux.</translation>
    </message>
    <message>
        <source>A seam near {0} would pass the same place twice. Draw it in two parts.</source>
        <translation>Une couture près de {0} passerait deux fois au même endroit. Dessinez-la en deux parties.</translation>
    </message>
    <message>
        <source>A separating layer of PTFE gives off poisonous fumes above {0}, and baking paper chars above {1}: weld slower at a lower temperature, and air the room.</source>
        <translation>Une couche de PTFE dégage des fumées toxiques au-dessus de {0}, et le papier cuisson charbonne au-dessus de {1} : soudez plus lentement à une température plus basse, et aérez la pièce.</translation>
    </message>
    <message>
        <source>A setting is tried with up to twelve values, each once.</source>
        <translation>Un réglage est essayé avec douze valeurs au plus, chacune une fois.</translation>
    </message>
    <message>
        <source>A sketch with dimensions: change a cell of the spreadsheet, and all follows</source>
        <translation>Une esquisse cotée : changez une cellule du tableur, et tout suit</translation>
    </message>
    <message>
        <source>A spread of {0} % leaves nothing of the {1}: give {2} at most {3} %.</source>
        <translation>Une dispersion de {0} % ne laisse rien ({1}) : donnez à {2} au plus {3} %.</translation>
    </message>
    <message>
        <source>A strict reader that wants plain polylines. Layers are told apart by colour: cut red, blue and orange, set the output of all others to no.</source>
        <translation>Un lecteur strict qui veut des polylignes simples. Les calques se distinguent par la couleur : coupez le rouge, le bleu et l'orange, mettez la sortie de tous les autres sur non.</translation>
    </message>
    <message>
        <source>A study has no '{0}': it has {1} and {2}.</source>
        <translation>Une étude n'a pas de « {0} » : elle a {1} et {2}.</translation>
    </message>
    <message>
        <source>A study of tolerances is about one balloon: give {0} a single value.</source>
        <translation>Une étude de tolérances porte sur un seul ballon : donnez à {0} une valeur unique.</translation>
    </message>
    <message>
        <source>A study of tolerances says what strays, such as {"cut": {"normal": "0.2mm"}}.</source>
        <translation>Une étude de tolérances dit ce qui varie, par exemple {"cut": {"normal": "0.2mm"}}.</translation>
    </message>
    <message>
        <source>A study of tolerances takes 1 to {0} samples, not {1}: {2} tell a lot.</source>
        <translation>Une étude de tolérances prend 1 à {0} échantillons, pas {1} : {2} en disent déjà long.</translation>
    </message>
    <message>
        <source>A tab must be {0} to {1} wide, not {2}; 0 makes none.</source>
        <translation>Une attache doit avoir de {0} à {1} de large, pas {2} ; 0 n'en fait aucune.</translation>
    </message>
    <message>
        <source>A test card is for a machine, in a folder: give --machine and --out.</source>
        <translation>Une carte d'essai est pour une machine, dans un dossier : donnez --machine et --out.</translation>
    </message>
    <message>
        <source>A test card tries one or two settings: give several values of them, such as 200,300,400.</source>
        <translation>Une carte d'essai essaie un ou deux réglages : donnez-en plusieurs valeurs, par exemple 200,300,400.</translation>
    </message>
    <message>
        <source>A tool has no "{0}": choose one of {1}.</source>
        <translation>Un outil n'a pas de « {0} » : choisissez parmi {1}.</translation>
    </message>
    <message>
        <source>A tool is that of a machine that reads G-code: give --machine gcode-grbl or another.</source>
        <translation>Un outil est celui d'une machine qui lit le G-code : donnez --machine gcode-grbl ou une autre.</translation>
    </message>
    <message>
        <source>A tool that an axis turns does not swivel behind it: set knife_offset_mm to 0, or leave turning_axis out.</source>
        <translation>Un outil qu'un axe tourne ne pivote pas derrière lui : mettez knife_offset_mm à 0, ou omettez turning_axis.</translation>
    </message>
    <message>
        <source>A volume of {0} cannot be made: give one such as 10l.</source>
        <translation>Un volume de {0} est impossible : donnez par exemple 10l.</translation>
    </message>
    <message>
        <source>A volume or a lift decides the size, so the balloon cannot be scaled to fit: leave out --oversize scale, or what you give of --target-volume, --target-lift and --gas-volume.</source>
        <translation>Un volume ou une portance décide de la taille, le ballon ne peut donc pas être réduit au plateau : omettez --oversize scale, ou ce que vous donnez de --target-volume, --target-lift et --gas-volume.</translation>
    </message>
    <message>
        <source>A volume to inflate to and a goal for the size exclude each other: leave one out.</source>
        <translation>Un volume de gonflage et un but de taille s'excluent : omettez l'un des deux.</translation>
    </message>
    <message>
        <source>A web page came instead of the native solver, as some networks send before one has signed in. Open {0} in a browser, then try again. {1}</source>
        <translation>Une page web est arrivée au lieu du solveur natif, comme certains réseaux en envoient avant la connexion. Ouvrez {0} dans un navigateur, puis réessayez. {1}</translation>
    </message>
    <message>
        <source>A weld has no length; draw a line, or a circle for a spot.</source>
        <translation>Une soudure n'a pas de longueur ; tracez une ligne, ou un cercle pour un point.</translation>
    </message>
    <message>
        <source>A weld leaves the film at {0}; keep it inside.</source>
        <translation>Une soudure quitte le film en {0} ; gardez-la à l'intérieur.</translation>
    </message>
    <message>
        <source>A weld meets the outline, itself or another weld at {0}; keep some film between them.</source>
        <translation>Une soudure rencontre le contour, elle-même ou une autre en {0} ; gardez un peu de film entre elles.</translation>
    </message>
    <message>
        <source>A weld runs too near to another one or to the outline at {0} for this mesh: move it away, or use a smaller mesh size.</source>
        <translation>Une soudure passe trop près d'une autre ou du contour en {0} pour ce maillage : écartez-la, ou prenez une taille de maille plus petite.</translation>
    </message>
    <message>
        <source>A weld that crumples can be simulated of one panel and its mirror image alone: choose the elastic weld, or one panel and its mirror image.</source>
        <translation>Une soudure qui se froisse ne peut être simulée qu'avec un seul panneau et son image miroir : choisissez la soudure élastique, ou un seul panneau et son image miroir.</translation>
    </message>
    <message>
        <source>A worker does not have this program ({0}): install it everywhere.</source>
        <translation>Un worker n'a pas ce programme ({0}) : installez-le partout.</translation>
    </message>
    <message>
        <source>A worker of Dask failed ({0}: {1}).</source>
        <translation>Un worker de Dask a échoué ({0} : {1}).</translation>
    </message>
    <message>
        <source>A {0} of {1} cannot be made; choose one between 1 mm and 100 m.</source>
        <translation>Une {0} de {1} est impossible ; choisissez-en une entre 1 mm et 100 m.</translation>
    </message>
    <message>
        <source>About {} thick</source>
        <translation>Environ {} d'épaisseur</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>En travers</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Conseils</translation>
    </message>
    <message>
        <source>Advice ({0}), at {1}: {2}</source>
        <translation>Conseil ({0}), en {1} : {2}</translation>
    </message>
    <message>
        <source>Advice on many panels is measured on the balloon: inflate it first.</source>
        <translation>Les conseils sur plusieurs panneaux sont mesurés sur le ballon : gonflez-le d'abord.</translation>
    </message>
    <message>
        <source>Air intake</source>
        <translation>Embout de gonflage</translation>
    </message>
    <message>
        <source>Airship</source>
        <translation>Dirigeable</translation>
    </message>
    <message>
        <source>All packages are installed.</source>
        <translation>Tous les paquets sont installés.</translation>
    </message>
    <message>
        <source>All panels are on the sheet once: none is drawn a second time, mirrored.</source>
        <translation>Tous les panneaux sont une fois sur la feuille : aucun n'est dessiné une seconde fois en miroir.</translation>
    </message>
    <message>
        <source>All points of the mesh are in one place. Save the body as a mesh of triangles.</source>
        <translation>Tous les points du maillage sont au même endroit. Enregistrez le corps en maillage de triangles.</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>En long</translation>
    </message>
    <message>
        <source>Along the seam</source>
        <translation>Le long de la couture</translation>
    </message>
    <message>
        <source>Also on the other side</source>
        <translation>De l'autre côté aussi</translation>
    </message>
    <message>
        <source>Aluminised BOPP foil, 30 µm</source>
        <translation>Film BOPP aluminisé, 30 µm</translation>
    </message>
    <message>
        <source>Aluminised PET ("Mylar"), 25 µm</source>
        <translation>PET aluminisé (« Mylar »), 25 µm</translation>
    </message>
    <message>
        <source>Aluminised nylon/PE foil (party balloon), 30 µm</source>
        <translation>Film nylon/PE aluminisé (ballon de fête), 30 µm</translation>
    </message>
    <message>
        <source>An accuracy is for a balloon that follows its body: give the number of panels of one that encloses or lines it.</source>
        <translation>Une précision vaut pour un ballon qui suit son corps : pour celui qui l'entoure ou le double à l'intérieur, donnez le nombre de panneaux.</translation>
    </message>
    <message>
        <source>An animation needs at least two frames, not {0}.</source>
        <translation>Une animation demande au moins deux images, pas {0}.</translation>
    </message>
    <message>
        <source>An intake of {0} does not reach past the cut: give it at least {1}.</source>
        <translation>Un embout de {0} ne dépasse pas la coupe : donnez-lui au moins {1}.</translation>
    </message>
    <message>
        <source>An outline cannot be edited by "{0}": choose one of {1}.</source>
        <translation>Un contour ne se modifie pas par « {0} » : choisissez parmi {1}.</translation>
    </message>
    <message>
        <source>An outline keeps three nodes: move them instead.</source>
        <translation>Un contour garde trois nœuds : déplacez-les plutôt.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Animate inflation</source>
        <translation>Animer le gonflage</translation>
    </message>
    <message>
        <source>Another study is running in '{0}': wait for it, or choose another folder.</source>
        <translation>Une autre étude tourne dans « {0} » : attendez-la, ou choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Quelconque</translation>
    </message>
    <message>
        <source>Any colour</source>
        <translation>Autre couleur</translation>
    </message>
    <message>
        <source>Any colour (K)</source>
        <translation>Autre couleur (K)</translation>
    </message>
    <message>
        <source>Any program (DXF)</source>
        <translation>Tout programme (DXF)</translation>
    </message>
    <message>
        <source>Any program (SVG)</source>
        <translation>Tout programme (SVG)</translation>
    </message>
    <message>
        <source>Any size</source>
        <translation>Toute taille</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Arcs in a sketch, as they hang over a party table</source>
        <translation>Des arcs dans une esquisse, comme au-dessus d'une table de fête</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Arm too thin to fill</source>
        <translation>Bras trop mince pour se remplir</translation>
    </message>
    <message>
        <source>Artwork</source>
        <translation>Illustration</translation>
    </message>
    <message>
        <source>As Summa with OPOS, and the bar between the lower squares shows the cutter whether the print is bent. Feed the sheet with the bar first. The layer Regmark is not cut.</source>
        <translation>Comme Summa avec OPOS, et la barre entre les carrés du bas montre au plotter si l'impression est courbée. Engagez la feuille la barre en avant. Le calque Regmark n'est pas coupé.</translation>
    </message>
    <message>
        <source>As at first</source>
        <translation>Comme au début</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Tel que fabriqué</translation>
    </message>
    <message>
        <source>As made over what was expected</source>
        <translation>Le réalisé par-dessus l'attendu</translation>
    </message>
    <message>
        <source>As made: {0}, expected: {1}</source>
        <translation>Réalisé : {0}, attendu : {1}</translation>
    </message>
    <message>
        <source>Assembly sheet</source>
        <translation>Fiche de montage</translation>
    </message>
    <message>
        <source>Assembly sheet written to {}</source>
        <translation>Fiche de montage écrite dans {}</translation>
    </message>
    <message>
        <source>At least 95 of 100 balloons bear {0} with their margin, by {1} samples and with a confidence of 95 %.</source>
        <translation>Au moins 95 ballons sur 100 supportent {0} avec leur marge, d'après {1} échantillons et avec une confiance de 95 %.</translation>
    </message>
    <message>
        <source>At work the {0} is {1} above the film, and lifted {2} only: give it more depth, or a higher lift_mm.</source>
        <translation>Au travail, l'outil ({0}) est à {1} au-dessus du film, et levé à {2} seulement : donnez-lui plus de profondeur, ou un lift_mm plus grand.</translation>
    </message>
    <message>
        <source>At worst the film lies {0} on the wrong side of the body, and a margin of {1} was asked for. Take more panels, or a larger margin.</source>
        <translation>Au pire, le film se trouve à {0} du mauvais côté du corps, alors qu'une marge de {1} est demandée. Prendre plus de panneaux ou une marge plus grande.</translation>
    </message>
    <message>
        <source>At {0} dots per inch the sheet would have {1} x {2} pixels: give a lower resolution.</source>
        <translation>À {0} points par pouce, la feuille aurait {1} x {2} pixels : donnez une résolution plus faible.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Dos</translation>
    </message>
    <message>
        <source>Bag</source>
        <translation>Sac</translation>
    </message>
    <message>
        <source>Bag of panels</source>
        <translation>Sac de panneaux</translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation>Ballon</translation>
    </message>
    <message>
        <source>Balloon as a GLB file, for 3D programs</source>
        <translation>Ballon en fichier GLB, pour les logiciels 3D</translation>
    </message>
    <message>
        <source>Balloon film</source>
        <translation>Film du ballon</translation>
    </message>
    <message>
        <source>Balloon of row {0}</source>
        <translation>Ballon de la ligne {0}</translation>
    </message>
    <message>
        <source>Balloon pattern</source>
        <translation>Patron du ballon</translation>
    </message>
    <message>
        <source>Balloon: {0}, {1}, solver {2}</source>
        <translation>Ballon : {0}, {1}, solveur {2}</translation>
    </message>
    <message>
        <source>Balloons</source>
        <translation>Ballons</translation>
    </message>
    <message>
        <source>Balloons of each</source>
        <translation>Ballons de chacun</translation>
    </message>
    <message>
        <source>Balloons: {0}, of these are there: {1}</source>
        <translation>Ballons : {0}, dont déjà là : {1}</translation>
    </message>
    <message>
        <source>Balloons: {0}, worked out now: {1}, of these failed: {2}</source>
        <translation>Ballons : {0}, calculés cette fois : {1}, dont échoués : {2}</translation>
    </message>
    <message>
        <source>Bar of 100 mm to measure</source>
        <translation>Barre de 100 mm à mesurer</translation>
    </message>
    <message>
        <source>Bed</source>
        <translation>Plateau</translation>
    </message>
    <message>
        <source>Before it is written</source>
        <translation>Avant d'écrire</translation>
    </message>
    <message>
        <source>Bending stiffness</source>
        <translation>Rigidité de flexion</translation>
    </message>
    <message>
        <source>Beside the document</source>
        <translation>À côté du document</translation>
    </message>
    <message>
        <source>Beside the pattern, to see whether the size was kept</source>
        <translation>À côté du patron, pour voir si la taille a été gardée</translation>
    </message>
    <message>
        <source>Best field</source>
        <translation>Meilleur champ</translation>
    </message>
    <message>
        <source>Best of {0} balloons: {1}, with {2}.</source>
        <translation>Meilleur de {0} ballons : {1}, avec {2}.</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Noir</translation>
    </message>
    <message>
        <source>Bleed</source>
        <translation>Fond perdu</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Bleu</translation>
    </message>
    <message>
        <source>Blue 0, green {}, red {}</source>
        <translation>Bleu 0, vert {}, rouge {}</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Both halves of the body are made alike: they differ by {0} at most.</source>
        <translation>Les deux moitiés du corps sont faites égales : elles diffèrent de {0} au plus.</translation>
    </message>
    <message>
        <source>Both panels</source>
        <translation>Les deux panneaux</translation>
    </message>
    <message>
        <source>Both panels are on the sheet: only the front one gets the hole of the nozzle. Cut it once.</source>
        <translation>Les deux panneaux sont sur la feuille : seul celui de devant reçoit le trou de la buse. Coupez-le une fois.</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Les deux côtés</translation>
    </message>
    <message>
        <source>Both sides of a seam must be equally long</source>
        <translation>Les deux côtés d'une couture doivent être de même longueur</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>Bouteille</translation>
    </message>
    <message>
        <source>Bring the 3D view of the document to the front first.</source>
        <translation>Mettez d'abord la vue 3D du document au premier plan.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>By at least</source>
        <translation>D'au moins</translation>
    </message>
    <message>
        <source>Cannot read '{0}' ({1}): name the file of a test card.</source>
        <translation>Impossible de lire « {0} » ({1}) : nommez le fichier d'une carte d'essai.</translation>
    </message>
    <message>
        <source>Cannot write to '{0}' ({1}): choose another folder for the study.</source>
        <translation>Impossible d'écrire dans « {0} » ({1}) : choisissez un autre dossier pour l'étude.</translation>
    </message>
    <message>
        <source>Cannot write to {0}: {1}. Choose another folder, or make room there.</source>
        <translation>Impossible d'écrire dans {0} : {1}. Choisissez un autre dossier, ou libérez de la place.</translation>
    </message>
    <message>
        <source>Cannot write {0}: {1}. Make room there and start the study again; no balloon is lost.</source>
        <translation>Impossible d'écrire {0} : {1}. Faites-y de la place et relancez l'étude ; aucun ballon n'est perdu.</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Check the size: the 100 mm bar on the cut file or print must measure 100 mm.</source>
        <translation>Vérifiez la taille : la barre de 100 mm du fichier de coupe ou de l'impression doit mesurer 100 mm.</translation>
    </message>
    <message>
        <source>Check, {0}: {1}</source>
        <translation>Vérification, {0} : {1}</translation>
    </message>
    <message>
        <source>Check: {0}</source>
        <translation>Vérification : {0}</translation>
    </message>
    <message>
        <source>Checked: ready to make.</source>
        <translation>Vérifié : prêt à fabriquer.</translation>
    </message>
    <message>
        <source>Checking the pattern</source>
        <translation>Vérification du patron</translation>
    </message>
    <message>
        <source>Choose a body</source>
        <translation>Choisir un corps</translation>
    </message>
    <message>
        <source>Choose a colour</source>
        <translation>Choisir une couleur</translation>
    </message>
    <message>
        <source>Choose a drawing</source>
        <translation>Choisir un dessin</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Choisir un fichier</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Choisir un dossier</translation>
    </message>
    <message>
        <source>Choose a material card</source>
        <translation>Choisir une fiche de matériau</translation>
    </message>
    <message>
        <source>Choose a photograph first: a PNG, JPEG or BMP file.</source>
        <translation>Choisissez d'abord une photo : un fichier PNG, JPEG ou BMP.</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>Choisir une image</translation>
    </message>
    <message>
        <source>Choose a picture or a sketch.</source>
        <translation>Choisissez une image ou une esquisse.</translation>
    </message>
    <message>
        <source>Choose a remnant</source>
        <translation>Choisir une chute</translation>
    </message>
    <message>
        <source>Choose a row first.</source>
        <translation>Choisissez d'abord une ligne.</translation>
    </message>
    <message>
        <source>Choose a sketch or a file with half the outline.</source>
        <translation>Choisissez une esquisse ou un fichier avec un demi-contour.</translation>
    </message>
    <message>
        <source>Choose a solid, a mesh or a file with one.</source>
        <translation>Choisissez un solide, un maillage ou un fichier qui en contient un.</translation>
    </message>
    <message>
        <source>Choose a test card</source>
        <translation>Choisir une carte d'essai</translation>
    </message>
    <message>
        <source>Choose sketches, a file or a ready body.</source>
        <translation>Choisissez des esquisses, un fichier ou un corps prêt.</translation>
    </message>
    <message>
        <source>Choose the balloon that it belongs to.</source>
        <translation>Choisissez le ballon auquel il appartient.</translation>
    </message>
    <message>
        <source>Choose the outline to inflate.</source>
        <translation>Choisissez le contour à gonfler.</translation>
    </message>
    <message>
        <source>Choose the pattern to print on.</source>
        <translation>Choisissez le patron sur lequel imprimer.</translation>
    </message>
    <message>
        <source>Choose the patterns to lay out.</source>
        <translation>Choisissez les patrons à disposer.</translation>
    </message>
    <message>
        <source>Choose the photograph that is behind the balloon.</source>
        <translation>Choisissez la photo qui est derrière le ballon.</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>Click a seam: its panels become one. Esc: done.</source>
        <translation>Cliquez sur une couture : ses panneaux n'en font plus qu'un. Échap : terminé.</translation>
    </message>
    <message>
        <source>Click a seam: the panels beside it become one</source>
        <translation>Cliquez sur une couture : les panneaux de part et d'autre n'en font plus qu'un</translation>
    </message>
    <message>
        <source>Click an edge to see what it is sealed to, drag a piece to move it.</source>
        <translation>Cliquez sur un bord pour voir à quoi il est soudé, tirez une pièce pour la déplacer.</translation>
    </message>
    <message>
        <source>Click an edge to see what it is sealed to.</source>
        <translation>Cliquez sur un bord pour voir à quoi il est soudé.</translation>
    </message>
    <message>
        <source>Click and type; pull it, its corner, or the ring that turns it. Enter paints it, Esc drops it.</source>
        <translation>Cliquez et tapez ; tirez-le, son coin, ou l'anneau qui le tourne. Entrée le peint, Échap l'abandonne.</translation>
    </message>
    <message>
        <source>Click both ends of a length that you know; a third click moves the nearer mark.</source>
        <translation>Cliquez les deux bouts d'une longueur que vous connaissez ; un troisième clic déplace la marque la plus proche.</translation>
    </message>
    <message>
        <source>Click both ends of a ruler in the picture, or of another known length</source>
        <translation>Cliquer les deux bouts d'une règle dans l'image, ou d'une autre longueur connue</translation>
    </message>
    <message>
        <source>Click on the paper, then type</source>
        <translation>Cliquez sur la feuille, puis tapez</translation>
    </message>
    <message>
        <source>Click the line for a new node; drag nodes; Delete removes them; S: sharp or round.</source>
        <translation>Cliquez sur la ligne pour un nouveau nœud ; tirez les nœuds ; Suppr les enlève ; S : pointu ou rond.</translation>
    </message>
    <message>
        <source>Click to see it larger</source>
        <translation>Cliquer pour la voir en plus grand</translation>
    </message>
    <message>
        <source>Click two places: a seam runs between them</source>
        <translation>Cliquez sur deux endroits : une couture va de l'un à l'autre</translation>
    </message>
    <message>
        <source>Click two points to measure between them.</source>
        <translation>Cliquez sur deux points pour mesurer entre eux.</translation>
    </message>
    <message>
        <source>Click where the new seam begins. Esc: done.</source>
        <translation>Cliquez là où commence la nouvelle couture. Échap : terminé.</translation>
    </message>
    <message>
        <source>Click where the seam ends. Esc: another start.</source>
        <translation>Cliquez là où finit la couture. Échap : autre départ.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close the open task panel first.</source>
        <translation>Fermez d'abord le panneau de tâches ouvert.</translation>
    </message>
    <message>
        <source>Cloud</source>
        <translation>Nuage</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>Carte de couleurs</translation>
    </message>
    <message>
        <source>Colour {}</source>
        <translation>Couleur {}</translation>
    </message>
    <message>
        <source>Columns from the left: {0}</source>
        <translation>Colonnes depuis la gauche : {0}</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Compare with a photograph</source>
        <translation>Comparer à une photo</translation>
    </message>
    <message>
        <source>Comparing with the photograph</source>
        <translation>Comparaison à la photo</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>Comparaison…</translation>
    </message>
    <message>
        <source>Coordinates really are inches, and the header says so.</source>
        <translation>Les coordonnées sont vraiment en pouces, et l'en-tête le dit.</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Copies</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation>Copier (Ctrl+C)</translation>
    </message>
    <message>
        <source>Corner relief</source>
        <translation>Dégagement d'angle</translation>
    </message>
    <message>
        <source>Cricut Design Space</source>
        <translation>Cricut Design Space</translation>
    </message>
    <message>
        <source>Crosses, by eye</source>
        <translation>Croix, à l'œil</translation>
    </message>
    <message>
        <source>Crumpled</source>
        <translation>Froissée</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personnalisé</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Cut (Ctrl+X)</source>
        <translation>Couper (Ctrl+X)</translation>
    </message>
    <message>
        <source>Cut all panels from {film}, as they are drawn: so they are seen from outside, with the sealing side below.</source>
        <translation>Coupez tous les panneaux dans {film}, comme ils sont dessinés : on les voit ainsi de l'extérieur, face soudable dessous.</translation>
    </message>
    <message>
        <source>Cut all panels from {film}. As they are drawn they are seen from outside.</source>
        <translation>Coupez tous les panneaux dans {film}. Comme ils sont dessinés, on les voit de l'extérieur.</translation>
    </message>
    <message>
        <source>Cut each page along its left and lower crosses, lay it on the crosses of its neighbours, tape.</source>
        <translation>Coupez chaque page le long de ses croix de gauche et du bas, posez-la sur les croix de ses voisines, collez.</translation>
    </message>
    <message>
        <source>Cut out the hole of the nozzle, in the front panel only.</source>
        <translation>Découpez le trou de la buse, dans le panneau de devant seulement.</translation>
    </message>
    <message>
        <source>Cut out the holes inside.</source>
        <translation>Découpez les trous intérieurs.</translation>
    </message>
    <message>
        <source>Cut two panels from {film}, the second one mirrored, so that the sealing sides face each other.</source>
        <translation>Coupez deux panneaux ({film}), le second en miroir, pour que les faces soudables se regardent.</translation>
    </message>
    <message>
        <source>Cut two panels from {film}, the second one mirrored.</source>
        <translation>Coupez deux panneaux ({film}), le second en miroir.</translation>
    </message>
    <message>
        <source>Cuts without room for two tabs of {0} on a straight: {1}, the first near {2}. What they go round comes free.</source>
        <translation>Coupes sans place pour deux attaches de {0} sur une droite : {1}, la première près de {2}. Ce qu'elles entourent se détache.</translation>
    </message>
    <message>
        <source>Cutting shop (DXF R12)</source>
        <translation>Atelier de découpe (DXF R12)</translation>
    </message>
    <message>
        <source>Cutting shop in inches (DXF R2000)</source>
        <translation>Atelier de découpe en pouces (DXF R2000)</translation>
    </message>
    <message>
        <source>DXF files can be neither read nor written without it; SVG files can.</source>
        <translation>Sans lui, les fichiers DXF ne peuvent être ni lus ni écrits ; les SVG, si.</translation>
    </message>
    <message>
        <source>DXF files need the Python package ezdxf. Install it with 'pip install ezdxf', or save the drawing as SVG.</source>
        <translation>Les fichiers DXF demandent le paquet Python ezdxf. Installez-le par « pip install ezdxf », ou enregistrez le dessin en SVG.</translation>
    </message>
    <message>
        <source>Decoration</source>
        <translation>Décor</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete {}? Its file goes for good.</source>
        <translation>Supprimer {} ? Son fichier disparaît pour de bon.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Diameter {}, height {}, gores {} long</source>
        <translation>Diamètre {}, hauteur {}, fuseaux longs de {}</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Disque</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Distance from profile, drawing or body</source>
        <translation>Écart au profil, au dessin ou au corps</translation>
    </message>
    <message>
        <source>Distance {}, across {}, up {}</source>
        <translation>Distance {}, horizontale {}, verticale {}</translation>
    </message>
    <message>
        <source>Dividing a body needs scipy: install it with pip install scipy.</source>
        <translation>Diviser un corps demande scipy : installez-le par pip install scipy.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Done (Esc)</source>
        <translation>Terminé (Échap)</translation>
    </message>
    <message>
        <source>Dots per inch</source>
        <translation>Points par pouce</translation>
    </message>
    <message>
        <source>Double-click a row to see its balloon</source>
        <translation>Double-cliquez sur une ligne pour voir son ballon</translation>
    </message>
    <message>
        <source>Drag a seam to where it shall run. Esc: done.</source>
        <translation>Tirez une couture là où elle doit passer. Échap : terminé.</translation>
    </message>
    <message>
        <source>Drag a seam: it runs through the place</source>
        <translation>Tirez une couture : elle passe par l'endroit</translation>
    </message>
    <message>
        <source>Drag in the view</source>
        <translation>Glisser dans la vue</translation>
    </message>
    <message>
        <source>Drag to turn, turn the wheel to zoom; keys: arrows, plus, minus, Home.</source>
        <translation>Glissez pour tourner, la molette zoome ; touches : flèches, plus, moins, Origine.</translation>
    </message>
    <message>
        <source>Draw a closed line, or paint an area: it becomes a balloon.</source>
        <translation>Tracez une ligne fermée, ou peignez une surface : elle devient un ballon.</translation>
    </message>
    <message>
        <source>Draw half of the outline, and its axis as a straight upright line on its left.</source>
        <translation>Dessinez la moitié du contour, et son axe comme une droite verticale à sa gauche.</translation>
    </message>
    <message>
        <source>Draw lines. A closed line becomes a balloon.</source>
        <translation>Tracer des lignes. Une ligne fermée devient un ballon.</translation>
    </message>
    <message>
        <source>Drawing and silhouette</source>
        <translation>Dessin et silhouette</translation>
    </message>
    <message>
        <source>Drawing over silhouette</source>
        <translation>Dessin sur la silhouette</translation>
    </message>
    <message>
        <source>Drawing seams needs scipy: install it with pip install scipy.</source>
        <translation>Dessiner des coutures demande scipy : installez-le par pip install scipy.</translation>
    </message>
    <message>
        <source>Drawing {0}</source>
        <translation>Dessin de {0}</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Dessins</translation>
    </message>
    <message>
        <source>Drawn as</source>
        <translation>Dessiné comme</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Goutte</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Temporisation</translation>
    </message>
    <message>
        <source>E across the grain</source>
        <translation>Module d'Young en travers</translation>
    </message>
    <message>
        <source>Each row of the table once with each of these values</source>
        <translation>Chaque ligne du tableau une fois avec chacune de ces valeurs</translation>
    </message>
    <message>
        <source>Each stroke colour becomes an operation of its own: cut red, blue and orange, set all others to ignore. DXF is not read.</source>
        <translation>Chaque couleur de trait devient une opération : coupez le rouge, le bleu et l'orange, faites ignorer toutes les autres. Le DXF n'est pas lu.</translation>
    </message>
    <message>
        <source>Edges of the mesh at which more than two triangles meet: {0}, one of them at ({1}) of the mesh. Repair it in the program that it comes from, so that it is the surface of a solid.</source>
        <translation>Arêtes du maillage où se rejoignent plus de deux triangles : {0}, dont une en ({1}) du maillage. Réparez-le dans le programme d'où il vient, pour qu'il soit la surface d'un solide.</translation>
    </message>
    <message>
        <source>Edges of the panels</source>
        <translation>Bords des panneaux</translation>
    </message>
    <message>
        <source>Edit artwork</source>
        <translation>Modifier l'illustration</translation>
    </message>
    <message>
        <source>Edit balloon</source>
        <translation>Modifier le ballon</translation>
    </message>
    <message>
        <source>Edit film</source>
        <translation>Modifier la feuille de film</translation>
    </message>
    <message>
        <source>Edit outline</source>
        <translation>Modifier le contour</translation>
    </message>
    <message>
        <source>Edit outline ...</source>
        <translation>Modifier le contour ...</translation>
    </message>
    <message>
        <source>Edit study</source>
        <translation>Modifier l'étude</translation>
    </message>
    <message>
        <source>Eight panels for a solid with fillets: change its section or their number</source>
        <translation>Huit panneaux pour un solide à congés : changez sa section ou leur nombre</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>Élastique</translation>
    </message>
    <message>
        <source>Elastic materials</source>
        <translation>Matériaux élastiques</translation>
    </message>
    <message>
        <source>Encloses it</source>
        <translation>L'entoure</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Gomme</translation>
    </message>
    <message>
        <source>Errors as large as these leave no panel: give smaller ones.</source>
        <translation>Des erreurs aussi grandes ne laissent aucun panneau : donnez-en de plus petites.</translation>
    </message>
    <message>
        <source>Errors of {0} stay alike over a length above 0, such as 50mm.</source>
        <translation>Les erreurs de {0} restent semblables sur une longueur supérieure à 0, par exemple 50mm.</translation>
    </message>
    <message>
        <source>Errors that stay alike over {0} alone are too fine for a seam of {1}: give at least {2} as 'along'.</source>
        <translation>Des erreurs qui ne restent semblables que sur {0} sont trop fines pour une couture de {1} : donnez au moins {2} à « along ».</translation>
    </message>
    <message>
        <source>Every layer becomes a colour of the cut list; layers that share a colour would be merged. Set the import unit to millimetres. Cut red, blue and orange only and switch the output of all others off; the LightBurn project has them on tool layers already.</source>
        <translation>Chaque calque devient une couleur de la liste de coupe ; des calques de même couleur seraient fusionnés. Réglez l'unité d'import sur le millimètre. Coupez seulement le rouge, le bleu et l'orange et désactivez la sortie de tous les autres ; le projet LightBurn les a déjà sur des calques d'outil.</translation>
    </message>
    <message>
        <source>Expected thickness</source>
        <translation>Épaisseur attendue</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportation</translation>
    </message>
    <message>
        <source>Export begins with it</source>
        <translation>L'export commence par elle</translation>
    </message>
    <message>
        <source>Export for the web</source>
        <translation>Exporter pour le web</translation>
    </message>
    <message>
        <source>Export pattern</source>
        <translation>Exporter le patron</translation>
    </message>
    <message>
        <source>Export pattern begins with this machine; it is a preference</source>
        <translation>« Exporter le patron » commence par cette machine ; c'est une préférence</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Expression</translation>
    </message>
    <message>
        <source>Face{0} of {1} is curved so much that it would take {2} strips of film. Give a number of panels, or leave such details out of the solid.</source>
        <translation>Face{0} de {1} est si courbe qu'il y faudrait {2} bandes de film. Donnez un nombre de panneaux, ou retirez de tels détails du solide.</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échoués</translation>
    </message>
    <message>
        <source>Farthest off near {0}</source>
        <translation>Écart maximal près de {0}</translation>
    </message>
    <message>
        <source>Farthest point</source>
        <translation>Point le plus éloigné</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Feed in corners</source>
        <translation>Avance dans les coins</translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation>Télécharger</translation>
    </message>
    <message>
        <source>Fetch the native solver ...</source>
        <translation>Télécharger le solveur natif ...</translation>
    </message>
    <message>
        <source>Fetches the native solver of this version, checks its SHA-256 and puts it in its place.</source>
        <translation>Télécharge le solveur natif de cette version, vérifie son SHA-256 et le met à sa place.</translation>
    </message>
    <message>
        <source>Fetching the native solver</source>
        <translation>Téléchargement du solveur natif</translation>
    </message>
    <message>
        <source>Fetching {0} ({1} MB) into {2}; only the file with SHA-256 {3} is kept.</source>
        <translation>Téléchargement de {0} ({1} MB) dans {2} ; seul le fichier de SHA-256 {3} est gardé.</translation>
    </message>
    <message>
        <source>Few panels or true to shape</source>
        <translation>Peu de panneaux ou forme fidèle</translation>
    </message>
    <message>
        <source>Few panels or true to shape?</source>
        <translation>Peu de panneaux ou forme fidèle ?</translation>
    </message>
    <message>
        <source>Fields: {}, on {} of film</source>
        <translation>Champs : {}, sur {} de film</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Files written to {}</source>
        <translation>Fichiers écrits dans {}</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplir</translation>
    </message>
    <message>
        <source>Fill a closed line, or give an area another colour</source>
        <translation>Remplir une ligne fermée, ou changer la couleur d'une surface</translation>
    </message>
    <message>
        <source>Fill at the nozzle, to at most {column} of water.</source>
        <translation>Gonflez par la buse, à {column} d'eau au plus.</translation>
    </message>
    <message>
        <source>Fill through a straw in the neck, to at most {column} of water.</source>
        <translation>Gonflez par une paille dans le col, à {column} d'eau au plus.</translation>
    </message>
    <message>
        <source>Fill through a tube of 6 mm, its end cut aslant, pushed 25 mm past the seal across the neck, to at most {column} of water. Pull it out: the strips close by themselves.</source>
        <translation>Gonflez par un tube de 6 mm, au bout coupé en biais, poussé 25 mm au-delà de la soudure en travers du col, à {column} d'eau au plus. Retirez-le : les bandes se ferment d'elles-mêmes.</translation>
    </message>
    <message>
        <source>Fill through a tube of 6 mm, its end cut aslant, pushed 25 mm past the weld across the neck. Pull it out: the pressure presses the strips together.</source>
        <translation>Gonflez par un tube de 6 mm, au bout coupé en biais, poussé 25 mm au-delà de la soudure en travers du col. Retirez-le : la pression plaque les bandes l'une contre l'autre.</translation>
    </message>
    <message>
        <source>Fill to {pressure}, never above {safe}: film and seam then keep a margin of {margin}.</source>
        <translation>Gonflez à {pressure}, jamais au-dessus de {safe} : le film et la couture gardent alors une marge de {margin}.</translation>
    </message>
    <message>
        <source>Fill to {pressure}, never above {safe}: film and weld then keep a margin of {margin}.</source>
        <translation>Gonflez à {pressure}, jamais au-dessus de {safe} : le film et la soudure gardent alors une marge de {margin}.</translation>
    </message>
    <message>
        <source>Fill to {safe} at most: {pressure} is more than film and seam bear with a margin of {margin}. Mind your eyes.</source>
        <translation>Gonflez à {safe} au plus : {pressure}, c'est plus que ce que film et couture supportent avec une marge de {margin}. Protégez vos yeux.</translation>
    </message>
    <message>
        <source>Fill to {safe} at most: {pressure} is more than film and weld bear with a margin of {margin}. Mind your eyes.</source>
        <translation>Gonflez à {safe} au plus : {pressure}, c'est plus que ce que film et soudure supportent avec une marge de {margin}. Protégez vos yeux.</translation>
    </message>
    <message>
        <source>Fill with air a little and brush soapy water along the weld: bubbles show leaks. Weld once more there.</source>
        <translation>Mettez un peu d'air et passez de l'eau savonneuse le long de la soudure : des bulles montrent les fuites. Ressoudez à ces endroits.</translation>
    </message>
    <message>
        <source>Filled shape</source>
        <translation>Forme pleine</translation>
    </message>
    <message>
        <source>Filleted housing</source>
        <translation>Boîtier à congés</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Film Balloon {0} in FreeCAD {1}</source>
        <translation>Film Balloon {0} dans FreeCAD {1}</translation>
    </message>
    <message>
        <source>Film needed</source>
        <translation>Film nécessaire</translation>
    </message>
    <message>
        <source>Film needed: {0}</source>
        <translation>Film nécessaire : {0}</translation>
    </message>
    <message>
        <source>Film of your own</source>
        <translation>Votre propre film</translation>
    </message>
    <message>
        <source>Film that it takes</source>
        <translation>Film nécessaire</translation>
    </message>
    <message>
        <source>Film width</source>
        <translation>Largeur du film</translation>
    </message>
    <message>
        <source>Film {0} large is too much: write 500mm.</source>
        <translation>Un film de {0}, c'est trop : écrivez 500mm.</translation>
    </message>
    <message>
        <source>Film: {0}</source>
        <translation>Film : {0}</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>Films</translation>
    </message>
    <message>
        <source>Find how much the film stretched, and how far the weld draws the seam inward</source>
        <translation>Trouver de combien le film s'est étiré, et de combien la soudure tire la couture vers l'intérieur</translation>
    </message>
    <message>
        <source>Find its place</source>
        <translation>Trouver sa place</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Fit the film, too</source>
        <translation>Ajuster aussi le film</translation>
    </message>
    <message>
        <source>Fit to drawing</source>
        <translation>Ajuster au dessin</translation>
    </message>
    <message>
        <source>Fitting the pattern</source>
        <translation>Ajustement du patron</translation>
    </message>
    <message>
        <source>Flat pieces</source>
        <translation>Pièces à plat</translation>
    </message>
    <message>
        <source>Flattening needs scipy: install it with pip install scipy.</source>
        <translation>La mise à plat demande scipy : installez-le par pip install scipy.</translation>
    </message>
    <message>
        <source>Flower</source>
        <translation>Fleur</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Folder for the artwork</source>
        <translation>Dossier pour l'illustration</translation>
    </message>
    <message>
        <source>Follow every change at once</source>
        <translation>Suivre aussitôt chaque changement</translation>
    </message>
    <message>
        <source>Follows the body</source>
        <translation>Suit le corps</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Police</translation>
    </message>
    <message>
        <source>For Send to Silhouette of inkscape-silhouette. It looks for four marks, which lie on the layer Regmarks, are not cut, 10 mm from the edges of A4 and 190 and 277 mm apart: give that there, and four marks. Nothing is cut outside them. For other paper change page_mm in a copy.</source>
        <translation>Pour Send to Silhouette d'inkscape-silhouette. Il cherche quatre repères, qui sont sur le calque Regmarks, ne sont pas coupés, à 10 mm des bords d'une A4 et à 190 et 277 mm l'un de l'autre : indiquez-le là-bas, ainsi que quatre repères. Rien n'est coupé en dehors d'eux. Pour un autre papier, changez page_mm dans une copie.</translation>
    </message>
    <message>
        <source>For Send to Silhouette of inkscape-silhouette. The marks of a print lie on the layer Regmarks, which is not cut, 10 mm from the edges of A4 and 190 and 277 mm apart: give that there. Nothing is cut outside them. For other paper change page_mm in a copy.</source>
        <translation>Pour Send to Silhouette d'inkscape-silhouette. Les repères d'une impression sont sur le calque Regmarks, qui n'est pas coupé, à 10 mm des bords d'une A4 et à 190 et 277 mm l'un de l'autre : indiquez-le là-bas. Rien n'est coupé en dehors d'eux. Pour un autre papier, changez page_mm dans une copie.</translation>
    </message>
    <message>
        <source>For {0} of {1} pieces there is no room on the remnant: give film for the rest too.</source>
        <translation>Pour {0} pièces sur {1}, il n'y a pas de place sur la chute : donnez aussi du film pour le reste.</translation>
    </message>
    <message>
        <source>For {0} the drawing would be {1} large: choose a volume that makes it {2} to {3}.</source>
        <translation>Pour {0}, le dessin aurait {1} : choisissez un volume qui lui donne de {2} à {3}.</translation>
    </message>
    <message>
        <source>Forced</source>
        <translation>Forcée</translation>
    </message>
    <message>
        <source>Forget earlier photographs</source>
        <translation>Oublier les photos antérieures</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Frames are even in movement, not in time. Only the film has mass, the gas has none.</source>
        <translation>Les images sont régulières en mouvement, non en temps. Seul le film a une masse, le gaz n'en a pas.</translation>
    </message>
    <message>
        <source>FreeCAD does not start beside this one ({0}): install it for the Python that runs there.</source>
        <translation>Aucun autre FreeCAD ne démarre à côté de celui-ci ({0}) : installez-le pour le Python qui tourne là.</translation>
    </message>
    <message>
        <source>FreeCAD failed while {0} ({1}). {2}</source>
        <translation>FreeCAD a échoué pendant {0} ({1}). {2}</translation>
    </message>
    <message>
        <source>FreeCAD has no material card "{0}": choose one of its material editor.</source>
        <translation>FreeCAD n'a pas de fiche de matériau « {0} » : choisissez-en une de son éditeur de matériaux.</translation>
    </message>
    <message>
        <source>FreeCAD needs a home folder and a temporary folder that it can write to, and enough memory.</source>
        <translation>Il lui faut un dossier personnel et un dossier temporaire où il peut écrire, et de la mémoire.</translation>
    </message>
    <message>
        <source>FreeCAD stopped while {0} ({1}). {2}</source>
        <translation>FreeCAD s'est arrêté pendant {0} ({1}). {2}</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>From the flat film to the balloon at rest</source>
        <translation>Du film plat au ballon au repos</translation>
    </message>
    <message>
        <source>From this value, with its unit</source>
        <translation>De cette valeur, avec son unité</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Devant</translation>
    </message>
    <message>
        <source>Front and back as PNG and PDF, and as DXF and SVG with the same marks for the cutter</source>
        <translation>Devant et dos en PNG et PDF, et en DXF et SVG avec les mêmes repères pour la découpeuse</translation>
    </message>
    <message>
        <source>Front, back and a band between them: change its width</source>
        <translation>Avant, arrière et une bande entre eux : changez sa largeur</translation>
    </message>
    <message>
        <source>G-code, and no other format, has a tool: give both or none.</source>
        <translation>Le G-code, et aucun autre format, a un outil : donnez les deux ou aucun.</translation>
    </message>
    <message>
        <source>GRBL knows X, Y and Z only: leave turning_axis out, or take LinuxCNC or Marlin where an axis turns the tool.</source>
        <translation>GRBL ne connaît que X, Y et Z : omettez turning_axis, ou prenez LinuxCNC ou Marlin là où un axe tourne l'outil.</translation>
    </message>
    <message>
        <source>GRBL machine (G-code)</source>
        <translation>Machine GRBL (G-code)</translation>
    </message>
    <message>
        <source>Gaps of up to {0} between lines were closed.</source>
        <translation>Des écarts jusqu'à {0} entre lignes ont été fermés.</translation>
    </message>
    <message>
        <source>Gas</source>
        <translation>Gaz</translation>
    </message>
    <message>
        <source>Gas that it takes, at the pressure outside</source>
        <translation>Gaz nécessaire, à la pression extérieure</translation>
    </message>
    <message>
        <source>Give --artwork for the front too.</source>
        <translation>Donnez aussi --artwork pour le devant.</translation>
    </message>
    <message>
        <source>Give --png or --report html with --ground: it is the ground of these.</source>
        <translation>Donnez --png ou --report html avec --ground : c'en est le fond.</translation>
    </message>
    <message>
        <source>Give a number of panels, into which the body is divided.</source>
        <translation>Donnez un nombre de panneaux, en lesquels le corps est divisé.</translation>
    </message>
    <message>
        <source>Give a study either "{0}" or "{1}".</source>
        <translation>Donnez à une étude soit « {0} », soit « {1} ».</translation>
    </message>
    <message>
        <source>Give either --material, or all of --young, --poisson and --thickness.</source>
        <translation>Donnez soit --material, soit à la fois --young, --poisson et --thickness.</translation>
    </message>
    <message>
        <source>Give either --scheduler or --dask.</source>
        <translation>Donnez soit --scheduler, soit --dask.</translation>
    </message>
    <message>
        <source>Give either a volume or a lift as the goal.</source>
        <translation>Donnez comme but soit un volume, soit une portance.</translation>
    </message>
    <message>
        <source>Give one or two settings several values, such as 200, 300, 400, and each of the others one.</source>
        <translation>Donnez plusieurs valeurs à un ou deux réglages, par exemple 200, 300, 400, et une seule à chacun des autres.</translation>
    </message>
    <message>
        <source>Give the document the values of the chosen row</source>
        <translation>Donner au document les valeurs de la ligne choisie</translation>
    </message>
    <message>
        <source>Give {0} either "{1}" or "{2}", {3}.</source>
        <translation>Donnez à {0} soit « {1} », soit « {2} », {3}.</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Donnée</translation>
    </message>
    <message>
        <source>Glowforge</source>
        <translation>Glowforge</translation>
    </message>
    <message>
        <source>Glue</source>
        <translation>Colle</translation>
    </message>
    <message>
        <source>Glue a strip of {seal} along the dashed line. Let it dry under a weight.</source>
        <translation>Collez une bande de {seal} le long de la ligne en tirets. Laissez sécher sous un poids.</translation>
    </message>
    <message>
        <source>Glue a strip of {seal} along the dashed line; leave the mouth of the neck open. Let it dry under a weight.</source>
        <translation>Collez une bande de {seal} le long de la ligne en tirets ; laissez l'embouchure du col ouverte. Laissez sécher sous un poids.</translation>
    </message>
    <message>
        <source>Glue the lines inside the balloon.</source>
        <translation>Collez les lignes à l'intérieur du ballon.</translation>
    </message>
    <message>
        <source>Glue the seams. Stiffer along the web than across it; E is the geometric mean. Does not hold gas for long and creases sharply.</source>
        <translation>Collez les coutures. Plus raide dans le sens de la bande qu'en travers ; E est la moyenne géométrique. Ne retient pas longtemps le gaz et se plie vivement.</translation>
    </message>
    <message>
        <source>Glue the seams. Stiffer along the web than across it; E is the geometric mean. Porous: for a moment's inflation or with a lining.</source>
        <translation>Collez les coutures. Plus raide dans le sens de la bande qu'en travers ; E est la moyenne géométrique. Poreux : pour un gonflage bref ou avec une doublure.</translation>
    </message>
    <message>
        <source>Glued seam</source>
        <translation>Couture collée</translation>
    </message>
    <message>
        <source>Gores</source>
        <translation>Fuseaux</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Sens du film</translation>
    </message>
    <message>
        <source>Grain lies</source>
        <translation>Sens du film</translation>
    </message>
    <message>
        <source>Graphtec with ARMS (vinyl cutter)</source>
        <translation>Graphtec avec ARMS (plotter de découpe)</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Vert</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Fond</translation>
    </message>
    <message>
        <source>HPGL is written as polylines: give "arcs": false.</source>
        <translation>Le HPGL s'écrit en polylignes : donnez "arcs": false.</translation>
    </message>
    <message>
        <source>HPGL plotter or vinyl cutter</source>
        <translation>Traceur HPGL ou plotter de découpe</translation>
    </message>
    <message>
        <source>Half the outline and its axis; a copy of it travels in the document</source>
        <translation>Un demi-contour et son axe ; une copie voyage dans le document</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Cœur</translation>
    </message>
    <message>
        <source>Heart from a spreadsheet</source>
        <translation>Cœur piloté par un tableur</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Chaleur</translation>
    </message>
    <message>
        <source>Heat sealer on a plotter</source>
        <translation>Soudeuse sur traceur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Height between two lines; empty: 5 mm</source>
        <translation>Hauteur entre deux lignes ; vide : 5 mm</translation>
    </message>
    <message>
        <source>Helium</source>
        <translation>Hélium</translation>
    </message>
    <message>
        <source>High frequency</source>
        <translation>Haute fréquence</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}'</source>
        <translation>Trou {0} du panneau « {1} »</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}' lies outside its film. Move it, or take it out.</source>
        <translation>Le trou {0} du panneau « {1} » est hors de son film. Déplacez-le, ou retirez-le.</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}' runs counter-clockwise. Turn the order of its points round.</source>
        <translation>Le trou {0} du panneau « {1} » tourne dans le sens inverse des aiguilles. Inversez l'ordre de ses points.</translation>
    </message>
    <message>
        <source>Holes from</source>
        <translation>Trous dès</translation>
    </message>
    <message>
        <source>Holes of the mesh that were closed: {0}.</source>
        <translation>Trous du maillage qui ont été fermés : {0}.</translation>
    </message>
    <message>
        <source>Home, then set X0 Y0 at the lower left corner of the film and Z0 where the tip touches the layer over it (G92); nothing homes. Lay baking paper or PTFE between tip and film, tape the film flat.</source>
        <translation>Faites la prise d'origine, puis mettez X0 Y0 au coin inférieur gauche du film et Z0 où la pointe touche la couche posée dessus (G92) ; le fichier ne fait pas de prise d'origine. Posez du papier cuisson ou du PTFE entre la pointe et le film, fixez le film à plat au ruban adhésif.</translation>
    </message>
    <message>
        <source>Hot tip</source>
        <translation>Pointe chaude</translation>
    </message>
    <message>
        <source>Hot wheel</source>
        <translation>Roue chaude</translation>
    </message>
    <message>
        <source>Hours of welding, where they are known</source>
        <translation>Heures de soudage, là où elles sont connues</translation>
    </message>
    <message>
        <source>How a balloon follows its pattern can be worked out for an elastic weld alone: choose that one.</source>
        <translation>La façon dont un ballon suit son patron ne se calcule que pour une soudure élastique : choisissez celle-ci.</translation>
    </message>
    <message>
        <source>How far a closed cut runs past its start; empty: six times the knife's offset</source>
        <translation>De combien une coupe fermée dépasse son départ ; vide : six fois le décalage de la lame</translation>
    </message>
    <message>
        <source>How far a closed weld runs past its start, so that the joint is tight</source>
        <translation>De combien une soudure fermée dépasse son départ, pour que le raccord soit étanche</translation>
    </message>
    <message>
        <source>How far a swivel knife or wheel lies behind its axis; 0 where the machine makes up for it</source>
        <translation>De combien une lame pivotante ou une roue est en arrière de son axe ; 0 si la machine le compense</translation>
    </message>
    <message>
        <source>How far along it</source>
        <translation>À quelle distance le long d'elle</translation>
    </message>
    <message>
        <source>How far along its seam the opening is must be from 0 to 1.</source>
        <translation>La distance de l'ouverture le long de sa couture doit être de 0 à 1.</translation>
    </message>
    <message>
        <source>How far below the place where it touches the film it works: it presses so hard, or cuts so deep; of a laser its focus. Empty: not known yet</source>
        <translation>De combien il travaille plus bas que l'endroit où il touche le film : c'est sa pression, ou sa profondeur de coupe ; pour un laser, son foyer. Vide : pas encore connu</translation>
    </message>
    <message>
        <source>How far the balloon may be from the body on average, of the body's diagonal</source>
        <translation>De combien le ballon peut s'écarter du corps en moyenne, en part de la diagonale du corps</translation>
    </message>
    <message>
        <source>How far the outline moves if the weld creases could not be simulated. {0}</source>
        <translation>Le déplacement du contour si la soudure se froisse n'a pas pu être simulé. {0}</translation>
    </message>
    <message>
        <source>How far weld and film reach beyond the seam in the photograph; empty: as in the pattern, 0: folded back</source>
        <translation>De combien la soudure et le film dépassent la couture sur la photo ; vide : comme dans le patron, 0 : replié en arrière</translation>
    </message>
    <message>
        <source>How fast it goes along a line; empty: not known yet</source>
        <translation>À quelle vitesse il suit une ligne ; vide : pas encore connu</translation>
    </message>
    <message>
        <source>How long a way from waste film to a weld may be; 0 for none</source>
        <translation>Longueur que peut avoir un trajet depuis le film perdu jusqu'à une soudure ; 0 : aucun</translation>
    </message>
    <message>
        <source>How long it waits before it moves along a line: film warms, a beam burns in, a spindle starts</source>
        <translation>Combien de temps il attend avant de suivre une ligne : le film chauffe, un faisceau perce, une broche démarre</translation>
    </message>
    <message>
        <source>How wide shall it be?</source>
        <translation>Quelle largeur doit-il avoir ?</translation>
    </message>
    <message>
        <source>Hydrogen</source>
        <translation>Hydrogène</translation>
    </message>
    <message>
        <source>If the weld creases</source>
        <translation>Si la soudure se froisse</translation>
    </message>
    <message>
        <source>If the weld creases, the outline may lie up to {0} away near {1}.</source>
        <translation>Si la soudure se froisse, le contour peut s'écarter jusqu'à {0} près de {1}.</translation>
    </message>
    <message>
        <source>If the weld creases: {0} on average, at most {1}</source>
        <translation>Si la soudure se froisse : {0} en moyenne, {1} au plus</translation>
    </message>
    <message>
        <source>In no seam yet: {}</source>
        <translation>Encore dans aucune couture : {}</translation>
    </message>
    <message>
        <source>In {0} of {1} samples the pressure is above the safe one: fill it less.</source>
        <translation>Dans {0} échantillons sur {1}, la pression dépasse la pression sûre : gonflez-le moins.</translation>
    </message>
    <message>
        <source>Inflate as drawn</source>
        <translation>Gonfler tel que dessiné</translation>
    </message>
    <message>
        <source>Inflate now</source>
        <translation>Gonfler maintenant</translation>
    </message>
    <message>
        <source>Inflate with these values and show the balloon</source>
        <translation>Gonfler avec ces valeurs et montrer le ballon</translation>
    </message>
    <message>
        <source>Inflated</source>
        <translation>Gonflé</translation>
    </message>
    <message>
        <source>Inflating</source>
        <translation>Gonflage</translation>
    </message>
    <message>
        <source>Inflating in time</source>
        <translation>Gonflage dans le temps</translation>
    </message>
    <message>
        <source>Inflating {0}</source>
        <translation>Gonflage de {0}</translation>
    </message>
    <message>
        <source>Inflation</source>
        <translation>Gonflage</translation>
    </message>
    <message>
        <source>Ink, or a slip of baking paper</source>
        <translation>Encre, ou un bout de papier cuisson</translation>
    </message>
    <message>
        <source>Inkscape</source>
        <translation>Inkscape</translation>
    </message>
    <message>
        <source>Intake</source>
        <translation>Embout</translation>
    </message>
    <message>
        <source>Intake in a side part</source>
        <translation>Embout dans une partie secondaire</translation>
    </message>
    <message>
        <source>Intake on a thin part</source>
        <translation>Embout sur une partie mince</translation>
    </message>
    <message>
        <source>It came with the workbench: copy it to set it up as your own.</source>
        <translation>Elle est fournie avec l'atelier : copiez-la pour en faire la vôtre.</translation>
    </message>
    <message>
        <source>It holds {} of the air that a round balloon of as much film would.</source>
        <translation>Il contient {} de l'air que contiendrait un ballon rond d'autant de film.</translation>
    </message>
    <message>
        <source>It is filled to {0}, its safe pressure is {1}: fill it less.</source>
        <translation>Il est gonflé à {0}, sa pression sûre est de {1} : gonflez-le moins.</translation>
    </message>
    <message>
        <source>It is not inflated yet: choose Inflate now in its context menu, or switch Live on.</source>
        <translation>Il n'est pas encore gonflé : choisissez « Gonfler maintenant » dans son menu contextuel, ou activez Direct.</translation>
    </message>
    <message>
        <source>It is not repeated on the other side. {0}</source>
        <translation>Cela n'est pas répété de l'autre côté. {0}</translation>
    </message>
    <message>
        <source>It is wider now. Ctrl+Z takes that back.</source>
        <translation>Il est plus large maintenant. Ctrl+Z annule.</translation>
    </message>
    <message>
        <source>It lies</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>It meets what it was designed for</source>
        <translation>Il répond à ce pour quoi il a été conçu</translation>
    </message>
    <message>
        <source>It needs more places: give them all.</source>
        <translation>Il manque des endroits : donnez-les tous.</translation>
    </message>
    <message>
        <source>It takes {0} h at {1} m/min and {2} min for each seam.</source>
        <translation>Cela prend {0} h à {1} m/min et {2} min par couture.</translation>
    </message>
    <message>
        <source>It took longer than {0} s: take a coarser mesh, or raise --timeout.</source>
        <translation>Il a pris plus de {0} s : prenez un maillage plus grossier, ou augmentez --timeout.</translation>
    </message>
    <message>
        <source>Its pattern is gone: delete it.</source>
        <translation>Le patron de cette pièce n'existe plus : effacez-la.</translation>
    </message>
    <message>
        <source>Its process ended with {0} ({1}).</source>
        <translation>Son processus s'est terminé avec {0} ({1}).</translation>
    </message>
    <message>
        <source>Its process was ended by {0}.</source>
        <translation>Son processus a été arrêté par {0}.</translation>
    </message>
    <message>
        <source>Its process was ended by {0}. It may have lacked memory: take a coarser mesh.</source>
        <translation>Son processus a été arrêté par {0}. La mémoire a peut-être manqué : prenez un maillage plus grossier.</translation>
    </message>
    <message>
        <source>Its process was ended by {0}.{1}</source>
        <translation>Son processus a été arrêté par {0}.{1}</translation>
    </message>
    <message>
        <source>Its workers were killed again and again: take a coarser mesh, or start it again.</source>
        <translation>Ses workers ont été tués à plusieurs reprises : prenez un maillage plus grossier, ou relancez-le.</translation>
    </message>
    <message>
        <source>JSON</source>
        <translation>JSON</translation>
    </message>
    <message>
        <source>Jobs of a study is 0 or more: 0 takes one for each processor.</source>
        <translation>Jobs d'une étude vaut 0 ou plus : 0 en prend un par processeur.</translation>
    </message>
    <message>
        <source>Join the panels along the dashed line, {seal} wide, all the way round.</source>
        <translation>Assemblez les panneaux le long de la ligne en tirets, sur {seal} de large, tout autour.</translation>
    </message>
    <message>
        <source>Join the panels along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>Assemblez les panneaux le long de la ligne en tirets, sur {seal} de large ; laissez l'embouchure du col ouverte.</translation>
    </message>
    <message>
        <source>Join the panels along the lines inside the balloon.</source>
        <translation>Assemblez les panneaux le long des lignes à l'intérieur du ballon.</translation>
    </message>
    <message>
        <source>Joined</source>
        <translation>Reliées</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Keep the best</source>
        <translation>Garder le meilleur</translation>
    </message>
    <message>
        <source>Keep the film</source>
        <translation>Garder le film</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Garder les proportions</translation>
    </message>
    <message>
        <source>Keep what is left</source>
        <translation>Garder le reste</translation>
    </message>
    <message>
        <source>Keep what is left...</source>
        <translation>Garder le reste...</translation>
    </message>
    <message>
        <source>Kept, and offered by Export pattern: {}</source>
        <translation>Gardée, et proposée par « Exporter le patron » : {}</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Trait de coupe</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Lame</translation>
    </message>
    <message>
        <source>Knife offset</source>
        <translation>Décalage de lame</translation>
    </message>
    <message>
        <source>Kraft paper, 80 g/m²</source>
        <translation>Papier kraft, 80 g/m²</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Inscription</translation>
    </message>
    <message>
        <source>Labels need matplotlib: install it with pip install matplotlib, or leave the label empty.</source>
        <translation>Les inscriptions demandent matplotlib : installez-le par pip install matplotlib, ou laissez l'inscription vide.</translation>
    </message>
    <message>
        <source>Laid flat</source>
        <translation>Mis à plat</translation>
    </message>
    <message>
        <source>Laid one piece after another: the package spyrrow (pip install spyrrow) often finds a closer layout.</source>
        <translation>Disposé une pièce après l'autre : le paquet spyrrow (pip install spyrrow) trouve souvent une disposition plus serrée.</translation>
    </message>
    <message>
        <source>Largest strain</source>
        <translation>Plus grande déformation</translation>
    </message>
    <message>
        <source>Largest tension of the film</source>
        <translation>Plus grande tension du film</translation>
    </message>
    <message>
        <source>Laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>Lay a picture under the paper for tracing; press again to take it away</source>
        <translation>Glisser une image sous la feuille pour la décalquer ; presser encore pour l'enlever</translation>
    </message>
    <message>
        <source>Lay both valve strips on each other, their lines together. On the field marked on VALVE, INK put heat-resistant ink, or a slip of baking paper between the strips. Weld them along both long lines.</source>
        <translation>Posez les deux bandes de la valve l'une sur l'autre, ligne sur ligne. Sur le champ marqué de VALVE, INK, mettez de l'encre résistant à la chaleur, ou un bout de papier cuisson entre les bandes. Soudez-les le long des deux grandes lignes.</translation>
    </message>
    <message>
        <source>Lay edges of the same number on each other, inner sides together: arrows the same way, the lines across the weld and the notches on each other. Tape outside the cut.</source>
        <translation>Posez l'un sur l'autre les bords de même numéro, faces intérieures ensemble : flèches dans le même sens, traits en travers de la soudure et crans superposés. Scotchez hors de la coupe.</translation>
    </message>
    <message>
        <source>Lay out</source>
        <translation>Disposer</translation>
    </message>
    <message>
        <source>Lay out anew</source>
        <translation>Disposer à nouveau</translation>
    </message>
    <message>
        <source>Lay out on film</source>
        <translation>Disposer sur le film</translation>
    </message>
    <message>
        <source>Lay the grain of all panels along the line with two arrowheads.</source>
        <translation>Placez le sens du film de tous les panneaux le long de la ligne à deux pointes de flèche.</translation>
    </message>
    <message>
        <source>Lay the grain of both panels the same way.</source>
        <translation>Placez les deux panneaux dans le même sens du film.</translation>
    </message>
    <message>
        <source>Lay the panels on each other, sealing sides inward. Line them up by the notches or edges; tape outside the cut.</source>
        <translation>Posez les panneaux l'un sur l'autre, faces soudables à l'intérieur. Alignez-les par les encoches ou les bords ; fixez-les au ruban adhésif hors de la coupe.</translation>
    </message>
    <message>
        <source>Lay the panels on each other. Line them up by the notches or edges; tape outside the cut.</source>
        <translation>Posez les panneaux l'un sur l'autre. Alignez-les par les encoches ou les bords ; fixez-les au ruban adhésif hors de la coupe.</translation>
    </message>
    <message>
        <source>Lay the strips into the neck of one panel, end at the mouth, line on line. Tack them to this panel only, with two spots of weld on the line, beside the channel.</source>
        <translation>Posez les bandes dans le col d'un panneau, extrémité à l'embouchure, ligne sur ligne. Fixez-les à ce seul panneau par deux points de soudure sur la ligne, à côté du canal.</translation>
    </message>
    <message>
        <source>Layers, millimetres and arcs, to go on drawing.</source>
        <translation>Calques, millimètres et arcs, pour continuer à dessiner.</translation>
    </message>
    <message>
        <source>Laying out {0}</source>
        <translation>Disposition de {0}</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Leak test: fill with air through a tube in the neck, closed round it by hand or with tape, to at most {column} of water in a hose. Wait 15 min, brush soapy water along the seams. Mark with a pen where bubbles grow, let the air out, dry it, seal there once more, test again.</source>
        <translation>Essai d'étanchéité : gonflez à l'air par un tube dans le col, fermé autour à la main ou au ruban adhésif, à {column} d'eau au plus dans un tuyau. Attendez 15 min, passez de l'eau savonneuse le long des coutures. Marquez au stylo où grossissent des bulles, videz l'air, séchez, ressoudez là, refaites l'essai.</translation>
    </message>
    <message>
        <source>Leak test: fill with air to at most {column} of water in a hose. Wait 15 min, brush soapy water along the seams. Mark with a pen where bubbles grow, let the air out, dry it, seal there once more, test again.</source>
        <translation>Essai d'étanchéité : gonflez à l'air à {column} d'eau au plus dans un tuyau. Attendez 15 min, passez de l'eau savonneuse le long des coutures. Marquez au stylo où grossissent des bulles, videz l'air, séchez, ressoudez là, refaites l'essai.</translation>
    </message>
    <message>
        <source>Leave tabs so wide in the cuts, such as 0.4 mm, on straights, two or more on each and one in 100 mm, so that pieces stay in the film. It is kept for this machine</source>
        <translation>Laisser dans les coupes des attaches de cette largeur, par exemple 0.4 mm, sur les droites, deux ou plus sur chacune et une tous les 100 mm, pour que les pièces restent dans le film. C'est gardé pour cette machine</translation>
    </message>
    <message>
        <source>Left out: {0}</source>
        <translation>Omis : {0}</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Length of a gore</source>
        <translation>Longueur d'un fuseau</translation>
    </message>
    <message>
        <source>Length of the seams</source>
        <translation>Longueur des coutures</translation>
    </message>
    <message>
        <source>Length of the usual roll that it takes</source>
        <translation>Longueur nécessaire du rouleau habituel</translation>
    </message>
    <message>
        <source>Let all pieces lie as the pattern lays them</source>
        <translation>Poser toutes les pièces comme le patron les pose</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Lettre</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>Hauteur des lettres</translation>
    </message>
    <message>
        <source>Letter with a side band</source>
        <translation>Lettre à bande latérale</translation>
    </message>
    <message>
        <source>Letters on a ground that makes one balloon of them</source>
        <translation>Des lettres sur un fond qui en fait un seul ballon</translation>
    </message>
    <message>
        <source>Letters, digits, spaces and - only</source>
        <translation>Lettres, chiffres, espaces et - seulement</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Portance</translation>
    </message>
    <message>
        <source>Lift in g</source>
        <translation>Portance en g</translation>
    </message>
    <message>
        <source>Lift needs vertices of the balloon that hold it. Give those of its lower end.</source>
        <translation>La portance demande des nœuds du ballon qui la retiennent. Donnez ceux de son extrémité basse.</translation>
    </message>
    <message>
        <source>LightBurn (laser)</source>
        <translation>LightBurn (laser)</translation>
    </message>
    <message>
        <source>LightBurn has too few layers for panels in holes of panels: lay out fewer.</source>
        <translation>LightBurn a trop peu de calques pour des pièces dans les trous d'autres pièces : disposez-en moins.</translation>
    </message>
    <message>
        <source>LightBurn project (laser)</source>
        <translation>Projet LightBurn (laser)</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Lines it inside</source>
        <translation>Le double à l'intérieur</translation>
    </message>
    <message>
        <source>Lines that close around nothing beside the shapes were left out.</source>
        <translation>Les lignes à côté des formes qui n'entourent rien ont été omises.</translation>
    </message>
    <message>
        <source>Lines up to</source>
        <translation>Lignes jusqu'à</translation>
    </message>
    <message>
        <source>LinuxCNC machine (G-code)</source>
        <translation>Machine LinuxCNC (G-code)</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Direct</translation>
    </message>
    <message>
        <source>Longest piece of the band</source>
        <translation>Plus longue pièce de la bande</translation>
    </message>
    <message>
        <source>Look for the closest layout; Esc takes the best one so far</source>
        <translation>Chercher la disposition la plus serrée ; Échap prend la meilleure jusque-là</translation>
    </message>
    <message>
        <source>Loose ends of lines were joined to the drawing.</source>
        <translation>Des bouts de lignes libres ont été joints au dessin.</translation>
    </message>
    <message>
        <source>Loose film: {0}, wrinkled: {1}; wrinkles hide {2} of it</source>
        <translation>Film détendu : {0}, plissé : {1} ; les plis en cachent {2}</translation>
    </message>
    <message>
        <source>Low</source>
        <translation>Bas</translation>
    </message>
    <message>
        <source>Lower end</source>
        <translation>Extrémité basse</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Made with brush and pen: double-click the Outline to paint on</source>
        <translation>Fait au pinceau et au stylo : double-cliquez sur le contour pour continuer</translation>
    </message>
    <message>
        <source>Make a card</source>
        <translation>Faire une carte</translation>
    </message>
    <message>
        <source>Make a machine of your own with the values of this one</source>
        <translation>Faire une machine à vous avec les valeurs de celle-ci</translation>
    </message>
    <message>
        <source>Make a sketch of the cuts</source>
        <translation>Faire une esquisse des coupes</translation>
    </message>
    <message>
        <source>Make a test card: nobody states a temperature for this film.</source>
        <translation>Faites une carte d'essai : personne n'indique de température pour ce film.</translation>
    </message>
    <message>
        <source>Make it!</source>
        <translation>Fabriquer !</translation>
    </message>
    <message>
        <source>Make rows</source>
        <translation>Créer les lignes</translation>
    </message>
    <message>
        <source>Make the balloon smaller and inflate it again, until its pattern fits the bed. Weld and allowance keep their widths; one undo takes it back</source>
        <translation>Réduire le ballon et le gonfler à nouveau, jusqu'à ce que son patron tienne sur le plateau. La soudure et la marge gardent leur largeur ; une seule annulation suffit pour revenir en arrière</translation>
    </message>
    <message>
        <source>Making tool paths</source>
        <translation>Création des parcours d'outil</translation>
    </message>
    <message>
        <source>Mark a length</source>
        <translation>Marquer une longueur</translation>
    </message>
    <message>
        <source>Mark a length in the picture, and give its true length, such as 300 mm.</source>
        <translation>Marquez une longueur dans l'image, et donnez sa vraie longueur, par exemple 300 mm.</translation>
    </message>
    <message>
        <source>Mark a length…</source>
        <translation>Marquer une longueur…</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>Marks for</source>
        <translation>Repères pour</translation>
    </message>
    <message>
        <source>Marlin printer (G-code)</source>
        <translation>Imprimante Marlin (G-code)</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>May be cut</source>
        <translation>Peut être coupé</translation>
    </message>
    <message>
        <source>Mean distance from the body</source>
        <translation>Distance moyenne au corps</translation>
    </message>
    <message>
        <source>Measure (M)</source>
        <translation>Mesurer (M)</translation>
    </message>
    <message>
        <source>Measured on the inflated balloon.</source>
        <translation>Mesuré sur le ballon gonflé.</translation>
    </message>
    <message>
        <source>Membrane tension</source>
        <translation>Tension de membrane</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Fusionner</translation>
    </message>
    <message>
        <source>Mesh reuse needs scipy: install it with pip install scipy.</source>
        <translation>La réutilisation du maillage demande scipy : installez-le par pip install scipy.</translation>
    </message>
    <message>
        <source>Mesh size</source>
        <translation>Taille de maille</translation>
    </message>
    <message>
        <source>Mesh size (0: automatic)</source>
        <translation>Taille de maille (0 : automatique)</translation>
    </message>
    <message>
        <source>Meshing needs scipy: install it with pip install scipy.</source>
        <translation>Le maillage demande scipy : installez-le par pip install scipy.</translation>
    </message>
    <message>
        <source>Mimaki with register marks (vinyl cutter)</source>
        <translation>Mimaki avec repères (plotter de découpe)</translation>
    </message>
    <message>
        <source>Mind</source>
        <translation>Attention</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Miroir</translation>
    </message>
    <message>
        <source>Mirror piece</source>
        <translation>Refléter la pièce</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>More gores hardly help: change the profile.</source>
        <translation>Plus de fuseaux n'aident guère : changez le profil.</translation>
    </message>
    <message>
        <source>More: text, stamps, layers, symmetry, any colour (Q)</source>
        <translation>Plus : texte, tampons, calques, symétrie, autres couleurs (Q)</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Move piece</source>
        <translation>Déplacer la pièce</translation>
    </message>
    <message>
        <source>Move the pointer to bend the line, then click. Esc drops it.</source>
        <translation>Déplacez le pointeur pour courber la ligne, puis cliquez. Échap l'abandonne.</translation>
    </message>
    <message>
        <source>Move, add and remove nodes of the outline in a tab, over the picture</source>
        <translation>Déplacer, ajouter et enlever des nœuds du contour dans un onglet, sur l'image</translation>
    </message>
    <message>
        <source>My machines</source>
        <translation>Mes machines</translation>
    </message>
    <message>
        <source>My {}</source>
        <translation>Ma {}</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Nom de la machine</translation>
    </message>
    <message>
        <source>Native</source>
        <translation>Natif</translation>
    </message>
    <message>
        <source>Natural shape</source>
        <translation>Forme naturelle</translation>
    </message>
    <message>
        <source>Near {0} the film stays {1} from the body, which is too thin or too sharp there for panels. Cut such a part off, or divide the body along it.</source>
        <translation>Près de {0}, le film reste à {1} du corps, qui y est trop mince ou trop pointu pour des panneaux. Coupez une telle partie, ou divisez le corps le long d'elle.</translation>
    </message>
    <message>
        <source>Near {0} the inflated outline stays up to {1} from the drawing, over a length of {2}: film cannot follow it there. Round it off or widen it.</source>
        <translation>Près de {0}, le contour gonflé reste jusqu'à {1} du dessin, sur {2} : le film ne peut pas le suivre là. Arrondissez ou élargissez cet endroit.</translation>
    </message>
    <message>
        <source>Near {0} the inflated outline stays up to {1} from the drawing, over a length of {2}: the balloon folds across a hole or a spot. Make that larger, or leave it out.</source>
        <translation>Près de {0}, le contour gonflé reste jusqu'à {1} du dessin, sur {2} : le ballon se plie en travers d'un trou ou d'un point de soudure. Agrandissez ce trou ou ce point, ou supprimez-le.</translation>
    </message>
    <message>
        <source>Neck that chokes the air path</source>
        <translation>Col qui étrangle le passage de l'air</translation>
    </message>
    <message>
        <source>Needed</source>
        <translation>Nécessaire</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Jamais</translation>
    </message>
    <message>
        <source>Never cut PVC with a laser: it gives off hydrogen chloride, which is toxic and ruins the machine. Weld with high frequency or hot air. Stretches visibly: at 2 kPa the shape depends on the grade and on the pressure.</source>
        <translation>Ne coupez jamais le PVC au laser : il dégage du chlorure d'hydrogène, toxique, qui ruine la machine. Soudez par haute fréquence ou à l'air chaud. S'étire visiblement : à 2 kPa la forme dépend de la qualité et de la pression.</translation>
    </message>
    <message>
        <source>Never cut this film with a laser.</source>
        <translation>Ne coupez jamais ce film au laser.</translation>
    </message>
    <message>
        <source>New bag of panels</source>
        <translation>Nouveau sac de panneaux</translation>
    </message>
    <message>
        <source>New balloon from body</source>
        <translation>Nouveau ballon depuis un corps</translation>
    </message>
    <message>
        <source>New balloon from picture</source>
        <translation>Nouveau ballon depuis une image</translation>
    </message>
    <message>
        <source>New balloon from sketch</source>
        <translation>Nouveau ballon depuis une esquisse</translation>
    </message>
    <message>
        <source>New balloons</source>
        <translation>Nouveaux ballons</translation>
    </message>
    <message>
        <source>New body of gores</source>
        <translation>Nouveau corps de fuseaux</translation>
    </message>
    <message>
        <source>New, laid beside the others: {}.</source>
        <translation>Nouvelles, posées à côté des autres : {}.</translation>
    </message>
    <message>
        <source>Newmark</source>
        <translation>Newmark</translation>
    </message>
    <message>
        <source>No axis turns a {0}: leave {1} out.</source>
        <translation>Aucun axe ne tourne cet outil ({0}) : omettez {1}.</translation>
    </message>
    <message>
        <source>No balloon came within {0} of the body's diagonal: tried were {1} panels. This is the nearest one, {2}. Ask for less, or divide the body yourself where the film stays far from it.</source>
        <translation>Aucun ballon n'est resté à moins de {0} de la diagonale du corps : essayés, {1} panneaux. Voici le plus proche, {2}. Demandez moins, ou divisez vous-même le corps là où le film en reste loin.</translation>
    </message>
    <message>
        <source>No balloon can be inflated anew without it; patterns can be changed and written.</source>
        <translation>Sans lui, aucun ballon ne peut être gonflé de nouveau ; les patrons peuvent être modifiés et écrits.</translation>
    </message>
    <message>
        <source>No balloon has {0} and {1}: these limits exclude each other.</source>
        <translation>Aucun ballon n'a {0} et {1} : ces limites s'excluent.</translation>
    </message>
    <message>
        <source>No file could be made.</source>
        <translation>Aucun fichier n'a pu être créé.</translation>
    </message>
    <message>
        <source>No file for {0}: {1}</source>
        <translation>Pas de fichier pour {0} : {1}</translation>
    </message>
    <message>
        <source>No file is like '{0}' in '{1}'. Check the pattern and the folder.</source>
        <translation>Aucun fichier comme « {0} » dans « {1} ». Vérifiez le motif et le dossier.</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Sans limite</translation>
    </message>
    <message>
        <source>No longer in the pattern, with their places: {}.</source>
        <translation>Ne sont plus dans le patron, avec leurs places : {}.</translation>
    </message>
    <message>
        <source>No number of panels up to {} comes so near. {} panels: about {} off</source>
        <translation>Aucun nombre de panneaux jusqu'à {} n'approche autant. {} panneaux : écart d'environ {}</translation>
    </message>
    <message>
        <source>No panel has an edge "{0}": choose one of an outline or face of this bag.</source>
        <translation>Aucun panneau n'a de bord « {0} » : choisissez-en un d'un contour ou d'une face de ce sac.</translation>
    </message>
    <message>
        <source>No panel of the balloon is cut: make at least one of film.</source>
        <translation>Aucun panneau du ballon n'est coupé : faites-en au moins un en film.</translation>
    </message>
    <message>
        <source>No pattern can be drawn anew without it; documents keep theirs.</source>
        <translation>Sans lui, aucun patron ne peut être retracé ; les documents gardent les leurs.</translation>
    </message>
    <message>
        <source>No pattern here has pieces of "{0}": choose another film.</source>
        <translation>Aucun patron n'a ici de pièces en « {0} » : choisissez un autre film.</translation>
    </message>
    <message>
        <source>No process can be started beside this one ({0}).</source>
        <translation>Aucun processus ne peut être lancé à côté de celui-ci ({0}).</translation>
    </message>
    <message>
        <source>No row of {0} makes sense: {1}</source>
        <translation>Aucune ligne de {0} n'a de sens : {1}</translation>
    </message>
    <message>
        <source>No seam can be drawn near {0}.</source>
        <translation>Aucune couture ne peut être dessinée près de {0}.</translation>
    </message>
    <message>
        <source>No shape in the photograph is like the one that was expected: take it straight from the front, on a plain background without anything else in it.</source>
        <translation>Aucune forme de la photo ne ressemble à celle qui était attendue : prenez-la bien de face, sur un fond uni, sans rien d'autre dedans.</translation>
    </message>
    <message>
        <source>No shape stands out in the picture. Use stronger colours or a plainer background.</source>
        <translation>Aucune forme ne ressort de l'image. Prenez des couleurs plus vives ou un fond plus uni.</translation>
    </message>
    <message>
        <source>No size of the balloon fits a bed of {0}: weld, allowance, intake and control bar keep their sizes. Choose another machine.</source>
        <translation>Aucune taille du ballon ne tient sur un plateau de {0} : soudure, marge, embout et barre de contrôle gardent les leurs. Choisissez une autre machine.</translation>
    </message>
    <message>
        <source>No solver works here.</source>
        <translation>Aucun solveur ne marche ici.</translation>
    </message>
    <message>
        <source>No solver works here: {0}</source>
        <translation>Aucun solveur ne marche ici : {0}</translation>
    </message>
    <message>
        <source>No solver works here: {0} Build it or install the package scipy.</source>
        <translation>Aucun solveur ne marche ici : {0} Compilez-le ou installez le paquet scipy.</translation>
    </message>
    <message>
        <source>No speed and power are known for {0}, so none are written: set them in LightBurn, or give speed_mm_s and max_power_percent in a file of your machine.</source>
        <translation>Vitesse et puissance ne sont pas connues pour {0}, aucune n'est donc écrite : réglez-les dans LightBurn, ou donnez speed_mm_s et max_power_percent dans un fichier de votre machine.</translation>
    </message>
    <message>
        <source>No triangle of the mesh has an area. Save the body as a mesh of triangles.</source>
        <translation>Aucun triangle du maillage n'a de surface. Enregistrez le corps en maillage de triangles.</translation>
    </message>
    <message>
        <source>No worker of Dask can be reached at '{0}' ({1}): start a scheduler and workers, and give its address.</source>
        <translation>Aucun worker de Dask n'est joignable à « {0} » ({1}) : lancez un ordonnanceur et des workers, et donnez son adresse.</translation>
    </message>
    <message>
        <source>No, use NumPy</source>
        <translation>Non, prendre NumPy</translation>
    </message>
    <message>
        <source>Nobody but you knows the {0} of your {1} for this film: fill in My machines in FreeCAD, or give {2}.</source>
        <translation>Vous seul connaissez cette valeur de votre {1} pour ce film : {0}. Remplissez « Mes machines » dans FreeCAD, ou donnez {2}.</translation>
    </message>
    <message>
        <source>Nobody but you knows this: {}. Give one value, or several to try.</source>
        <translation>Vous seul le savez : {}. Donnez une valeur, ou plusieurs à essayer.</translation>
    </message>
    <message>
        <source>Nobody states a temperature for this film. Make a test card: weld strips with several temperatures and times, peel them, keep the best.</source>
        <translation>Personne n'indique de température pour ce film. Faites une carte d'essai : soudez des bandes à plusieurs températures et durées, pelez-les, gardez la meilleure.</translation>
    </message>
    <message>
        <source>Nodes of the outline</source>
        <translation>Nœuds du contour</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>None of {0} balloons could be made: the table says why.</source>
        <translation>Aucun de {0} ballons n'a pu être fait : le tableau dit pourquoi.</translation>
    </message>
    <message>
        <source>None of {0} balloons is within the limits; the nearest: {1}, asked for {2}.</source>
        <translation>Aucun de {0} ballons n'est dans les limites ; le plus proche : {1}, demandé : {2}.</translation>
    </message>
    <message>
        <source>Not all holes are seen in the photograph: those that are not count as wrong.</source>
        <translation>Tous les trous ne se voient pas sur la photo : ceux qui ne se voient pas comptent comme faux.</translation>
    </message>
    <message>
        <source>Not possible</source>
        <translation>Impossible</translation>
    </message>
    <message>
        <source>Notch with a stress peak</source>
        <translation>Entaille où la tension culmine</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Encoches</translation>
    </message>
    <message>
        <source>Notches of {0} do not end before the weld: the allowance is {1}.</source>
        <translation>Des encoches de {0} ne s'arrêtent pas avant la soudure : la marge est de {1}.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Note: {0}</source>
        <translation>Remarque : {0}</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Nothing can be computed without it; documents open and keep their shapes.</source>
        <translation>Sans lui, rien ne peut être calculé ; les documents s'ouvrent et gardent leurs formes.</translation>
    </message>
    <message>
        <source>Nothing here writes an MP4: choose a GIF, or install opencv-python-headless with pip.</source>
        <translation>Rien ici n'écrit de MP4 : choisissez un GIF, ou installez opencv-python-headless avec pip.</translation>
    </message>
    <message>
        <source>Nothing strays that is called "{0}": choose of {1}.</source>
        <translation>Rien de ce qui varie ne s'appelle « {0} » : choisissez parmi {1}.</translation>
    </message>
    <message>
        <source>Nothing to improve.</source>
        <translation>Rien à améliorer.</translation>
    </message>
    <message>
        <source>Nothing varies in {0}: write into its first row what does, such as Width.</source>
        <translation>Rien ne varie dans {0} : écrivez dans sa première ligne ce qui varie, par exemple Width.</translation>
    </message>
    <message>
        <source>Nothing varies: give "{0}" a column.</source>
        <translation>Rien ne varie : donnez une colonne à « {0} ».</translation>
    </message>
    <message>
        <source>Now pick the partner of {}.</source>
        <translation>Choisissez maintenant le partenaire de {}.</translation>
    </message>
    <message>
        <source>Nowhere on the seam is room for an intake of {0}: choose a narrower one, or a place for it.</source>
        <translation>Nulle part sur la couture il n'y a la place d'un embout de {0} : choisissez-en un plus étroit, ou une place pour lui.</translation>
    </message>
    <message>
        <source>Nozzle with flange</source>
        <translation>Buse à collerette</translation>
    </message>
    <message>
        <source>NumPy computes the same, 20 to 30 times slower.</source>
        <translation>NumPy calcule la même chose, 20 à 30 fois plus lentement.</translation>
    </message>
    <message>
        <source>NumPy took 20 to 30 times longer than the native solver, which fetch-solver fetches.</source>
        <translation>NumPy a mis 20 à 30 fois plus de temps que le solveur natif, que fetch-solver télécharge.</translation>
    </message>
    <message>
        <source>Number of panels</source>
        <translation>Nombre de panneaux</translation>
    </message>
    <message>
        <source>Number of values, both ends among them</source>
        <translation>Nombre de valeurs, les deux bouts compris</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Chiffres</translation>
    </message>
    <message>
        <source>OK, then {}</source>
        <translation>OK, puis {}</translation>
    </message>
    <message>
        <source>Of a card one field is kept: give --keep B3, or another one, and --name.</source>
        <translation>D'une carte on garde un champ : donnez --keep B3, ou un autre, et --name.</translation>
    </message>
    <message>
        <source>Of a symmetric outline the other side is edited, too</source>
        <translation>D'un contour symétrique, l'autre côté est modifié aussi</translation>
    </message>
    <message>
        <source>Of the bodies of the mesh only the largest is made; all in all there are: {0}.</source>
        <translation>Des corps du maillage, seul le plus grand est fait ; en tout il y en a : {0}.</translation>
    </message>
    <message>
        <source>Of the film of {0} nothing is left that is large enough to be used again.</source>
        <translation>Du film de {0}, il ne reste rien d'assez grand pour resservir.</translation>
    </message>
    <message>
        <source>Of the tip or wheel, 40 to 400 °C. Above 260 °C a layer of PTFE gives off poisonous fumes</source>
        <translation>De la pointe ou de la roue, de 40 à 400 °C. Au-dessus de 260 °C, une couche de PTFE dégage des fumées toxiques</translation>
    </message>
    <message>
        <source>Of {0}: sheet {1}.</source>
        <translation>En {0} : feuille {1}.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Désactivée</translation>
    </message>
    <message>
        <source>Off at most</source>
        <translation>Écart maximal</translation>
    </message>
    <message>
        <source>Off it at most</source>
        <translation>Écart maximal</translation>
    </message>
    <message>
        <source>Off on average</source>
        <translation>Écart moyen</translation>
    </message>
    <message>
        <source>Off the body</source>
        <translation>Écart au corps</translation>
    </message>
    <message>
        <source>Off the drawing</source>
        <translation>Écart au dessin</translation>
    </message>
    <message>
        <source>Off the drawing, profile or body on average</source>
        <translation>Écart moyen au dessin, au profil ou au corps</translation>
    </message>
    <message>
        <source>Off the drawing: {0} on average, at most {1}</source>
        <translation>Écart au dessin : {0} en moyenne, {1} au plus</translation>
    </message>
    <message>
        <source>Off the profile</source>
        <translation>Écart au profil</translation>
    </message>
    <message>
        <source>Off the {0}: {1} on average, 95 % below {2}, at most {3}</source>
        <translation>Écart ({0}) : {1} en moyenne, 95 % sous {2}, {3} au plus</translation>
    </message>
    <message>
        <source>Offer the native solver where it is missing</source>
        <translation>Proposer le solveur natif là où il manque</translation>
    </message>
    <message>
        <source>On a symmetric body a change is repeated where its mirror image lies</source>
        <translation>Sur un corps symétrique, un changement est répété là où se trouve son image miroir</translation>
    </message>
    <message>
        <source>On the way of the valve the balloon narrows to {0} at {1}; its channel takes {2} with its welds there. Make the neck wider or put it elsewhere, else the weld closes the valve.</source>
        <translation>Sur le chemin de la valve, le ballon se resserre à {0} en {1} ; son canal avec ses soudures y prend {2}. Élargissez le col ou placez-le ailleurs, sinon la soudure ferme la valve.</translation>
    </message>
    <message>
        <source>Once the seam is closed, turn the tail in through itself with a straw, at the mark beside the balloon, and fill through it up to the second mark. Pull the straw out: the air in the balloon presses the tail flat.</source>
        <translation>Une fois la couture fermée, retournez la queue à travers elle-même avec une paille, au repère près du ballon, et gonflez par elle jusqu'au second repère. Retirez la paille : l'air du ballon plaque la queue.</translation>
    </message>
    <message>
        <source>One large page</source>
        <translation>Une seule grande page</translation>
    </message>
    <message>
        <source>One-way tail</source>
        <translation>Queue anti-retour</translation>
    </message>
    <message>
        <source>Only a film with another stiffness across has a grain: give --young-across too.</source>
        <translation>Seul un film d'une autre raideur en travers a un sens privilégié : donnez aussi --young-across.</translation>
    </message>
    <message>
        <source>Only balloons of two equal panels are compared with a photograph: compare the panels of others one by one with --flat.</source>
        <translation>Seuls les ballons de deux panneaux égaux sont comparés à une photo : comparez les panneaux des autres un par un avec --flat.</translation>
    </message>
    <message>
        <source>Only balloons of two equal panels are compared with a photograph: compare the panels of others one by one, with the command compare and its --flat.</source>
        <translation>Seuls les ballons de deux panneaux égaux se comparent à une photo : comparez les panneaux des autres un par un, par la commande compare et son --flat.</translation>
    </message>
    <message>
        <source>Only grades of this film with a sealing layer weld: try scraps before you cut.</source>
        <translation>Seules les qualités de ce film à couche scellable se soudent : essayez sur des chutes avant de couper.</translation>
    </message>
    <message>
        <source>Only pieces that are no larger than this either way get tabs, such as 50 mm</source>
        <translation>Seules les pièces qui ne dépassent cela dans aucun sens reçoivent des attaches, par exemple 50 mm</translation>
    </message>
    <message>
        <source>Only the middle of the weld. A closed weld runs past its start, so that the joint is tight.</source>
        <translation>Seulement le milieu de la soudure. Une soudure fermée dépasse son début, pour que le raccord soit étanche.</translation>
    </message>
    <message>
        <source>Only the shape is compared, at the size that fits best</source>
        <translation>Seule la forme est comparée, à la taille qui va le mieux</translation>
    </message>
    <message>
        <source>Only {0} of film stay between two cuts near {1}; {2} wants {3}. It may tear or melt there.</source>
        <translation>Il ne reste que {0} de film entre deux coupes près de {1} ; {2} en veut {3}. Il peut s'y déchirer ou fondre.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouverte</translation>
    </message>
    <message>
        <source>Open edge: {}</source>
        <translation>Bord ouvert : {}</translation>
    </message>
    <message>
        <source>Open it, do not import it. Outline, holes and notches are on cut layers, without speed and power: take them from your material library. Welds (T1) and all that is drawn (T2) are on tool layers, which LightBurn never burns.</source>
        <translation>Ouvrez-le, ne l'importez pas. Contour, trous et encoches sont sur des calques de coupe, sans vitesse ni puissance : prenez-les dans votre bibliothèque de matériaux. Les soudures (T1) et tout ce qui est tracé (T2) sont sur des calques d'outil, que LightBurn ne brûle jamais.</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Ouverture</translation>
    </message>
    <message>
        <source>Opposite the intake</source>
        <translation>À l'opposé de l'embout</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Order of the seams</source>
        <translation>Ordre des coutures</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Outline edit {0} at {1} is left out. {2}</source>
        <translation>La modification {0} du contour en {1} est omise. {2}</translation>
    </message>
    <message>
        <source>Outline edit {0} does none of {1}. {2}</source>
        <translation>La modification {0} du contour ne fait rien de {1}. {2}</translation>
    </message>
    <message>
        <source>Outline edit {0} has an 'at' that does not fit. {1}</source>
        <translation>La modification {0} du contour a un 'at' qui ne convient pas. {1}</translation>
    </message>
    <message>
        <source>Outline edit {0} has an unknown '{1}'. Use {2}.</source>
        <translation>La modification {0} du contour a un « {1} » inconnu. Utilisez {2}.</translation>
    </message>
    <message>
        <source>Outline edit {0} has no place [x, y] as its 'to', or one too many. {1}</source>
        <translation>La modification {0} du contour n'a pas d'endroit [x, y] comme 'to', ou en a un de trop. {1}</translation>
    </message>
    <message>
        <source>Outline edit {0}: 'mirrored' is true or false.</source>
        <translation>Modification {0} du contour : 'mirrored' est true ou false.</translation>
    </message>
    <message>
        <source>Outline {}</source>
        <translation>Contour {}</translation>
    </message>
    <message>
        <source>Outline {}, holes: {}</source>
        <translation>Contour {}, trous : {}</translation>
    </message>
    <message>
        <source>Overcut</source>
        <translation>Surcoupe</translation>
    </message>
    <message>
        <source>PDF files, previews and labels need it; DXF, SVG and HPGL can be written.</source>
        <translation>Les fichiers PDF, les aperçus et les étiquettes en ont besoin ; DXF, SVG et HPGL peuvent être écrits.</translation>
    </message>
    <message>
        <source>PNG, JPEG or BMP</source>
        <translation>PNG, JPEG ou BMP</translation>
    </message>
    <message>
        <source>Pa, its own range</source>
        <translation>Pa, sa propre plage</translation>
    </message>
    <message>
        <source>Page {0} of {1}: column {2}, row {3}</source>
        <translation>Page {0} sur {1} : colonne {2}, ligne {3}</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
    <message>
        <source>Paint a balloon</source>
        <translation>Peindre un ballon</translation>
    </message>
    <message>
        <source>Paint a shape first: the decoration is seen on it alone.</source>
        <translation>Peignez d'abord une forme : le décor ne se voit que sur elle.</translation>
    </message>
    <message>
        <source>Paint both sides at once, mirrored (M)</source>
        <translation>Peindre les deux côtés à la fois, en miroir (M)</translation>
    </message>
    <message>
        <source>Paint broad, soft strokes: what is painted becomes a balloon.</source>
        <translation>Peindre à traits larges et doux : ce qui est peint devient un ballon.</translation>
    </message>
    <message>
        <source>Paint so many times around a centre ( , fewer, . more)</source>
        <translation>Peindre autant de fois autour d'un centre ( , moins, . plus)</translation>
    </message>
    <message>
        <source>Paint something first: a closed line is enough.</source>
        <translation>Peignez d'abord quelque chose : une ligne fermée suffit.</translation>
    </message>
    <message>
        <source>Paint what becomes the outline (D)</source>
        <translation>Peindre ce qui devient le contour (D)</translation>
    </message>
    <message>
        <source>Paint what is printed on the film and leaves the outline as it is (D)</source>
        <translation>Peindre ce qui est imprimé sur le film et laisse le contour tel quel (D)</translation>
    </message>
    <message>
        <source>Painted balloon</source>
        <translation>Ballon peint</translation>
    </message>
    <message>
        <source>Painted fish</source>
        <translation>Poisson peint</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panneau</translation>
    </message>
    <message>
        <source>Panel '{0}' crosses itself: divide the body otherwise there.</source>
        <translation>Le panneau « {0} » se croise : divisez-y le corps autrement.</translation>
    </message>
    <message>
        <source>Panel '{0}' crosses or nearly touches itself: separate the parts that meet there.</source>
        <translation>Le panneau « {0} » se croise ou se touche presque : séparez les parties qui s'y rejoignent.</translation>
    </message>
    <message>
        <source>Panel '{0}' is folded over: {1} crosses or touches another edge at {2}. Separate them.</source>
        <translation>Le panneau « {0} » est replié : {1} croise ou touche un autre bord à {2}. Séparez-les.</translation>
    </message>
    <message>
        <source>Panel '{0}' is only {1} wide at {2}, too narrow for welds of {3} along both of its sides. Make it wider, or the welds narrower.</source>
        <translation>Le panneau « {0} » n'a que {1} de large à {2}, trop étroit pour des soudures de {3} des deux côtés. Élargissez-le, ou rétrécissez les soudures.</translation>
    </message>
    <message>
        <source>Panel '{0}' is seen from inside: its points run clockwise. Mirror it, or turn their order round.</source>
        <translation>Le panneau « {0} » est vu de l'intérieur : ses points tournent dans le sens des aiguilles. Mettez-le en miroir, ou inversez leur ordre.</translation>
    </message>
    <message>
        <source>Panel '{0}' is the whole surface and has no edge: divide the body into more panels.</source>
        <translation>Le panneau « {0} » est toute la surface et n'a pas de bord : divisez le corps en plus de panneaux.</translation>
    </message>
    <message>
        <source>Panel '{0}' would cross itself when laid flat. {1}</source>
        <translation>Le panneau « {0} » se croiserait une fois mis à plat. {1}</translation>
    </message>
    <message>
        <source>Panel {0} goes round a part of the body: it is cut open there.</source>
        <translation>Le panneau {0} fait le tour d'une partie du corps : il y est ouvert par une coupe.</translation>
    </message>
    <message>
        <source>Panel {0} has a triangle with a vertex that is not there. Mesh it anew.</source>
        <translation>Le panneau {0} a un triangle avec un sommet qui n'existe pas. Maillez-le de nouveau.</translation>
    </message>
    <message>
        <source>Panel {0} has a vertex without triangles. Mesh it anew.</source>
        <translation>Le panneau {0} a un sommet sans triangles. Maillez-le de nouveau.</translation>
    </message>
    <message>
        <source>Panel {0} has an edge with more than two triangles. Mesh it anew.</source>
        <translation>Le panneau {0} a une arête avec plus de deux triangles. Maillez-le de nouveau.</translation>
    </message>
    <message>
        <source>Panel {0} has no edge {1} for the opening: say another one of its outer loop.</source>
        <translation>Le panneau {0} n'a pas de bord {1} pour l'ouverture : indiquez-en un autre de sa boucle extérieure.</translation>
    </message>
    <message>
        <source>Panel {0} has no room for its name: write it beside the cut when you lay it out.</source>
        <translation>Le panneau {0} n'a pas la place de son nom : écrivez-le à côté de la coupe quand vous le disposez.</translation>
    </message>
    <message>
        <source>Panel {0} has no room for numbers and arrows of seams: {1}. Its notches tell them apart.</source>
        <translation>Le panneau {0} n'a pas la place des numéros et des flèches des coutures : {1}. Ses encoches les distinguent.</translation>
    </message>
    <message>
        <source>Panel {0} is not cut: say another one for the opening.</source>
        <translation>Le panneau {0} n'est pas coupé : indiquez-en un autre pour l'ouverture.</translation>
    </message>
    <message>
        <source>Panel {0} is nowhere wider than {1}, and its welds are {2} wide: it hardly bulges. Make the balloon larger, the panel wider or the seal narrower.</source>
        <translation>Le panneau {0} n'est nulle part plus large que {1}, et ses soudures ont {2} de large : il se bombe à peine. Agrandissez le ballon, élargissez le panneau ou rétrécissez la soudure.</translation>
    </message>
    <message>
        <source>Panel {0} is open between its vertices {1} and {2}: the boundary is in no seam there. Seal it to another.</source>
        <translation>Le panneau {0} est ouvert entre ses sommets {1} et {2} : le bord n'y est dans aucune soudure. Soudez-le à un autre.</translation>
    </message>
    <message>
        <source>Panel {0} leans by {1} between front and back. Make the side band narrower there, or the parts of the drawing wider.</source>
        <translation>Le panneau {0} penche de {1} entre l'avant et l'arrière. Rétrécissez la bande latérale à cet endroit, ou élargissez les parties du dessin.</translation>
    </message>
    <message>
        <source>Panel {0} near {1} goes round the body and cannot be laid flat. Draw a seam across it.</source>
        <translation>Le panneau {0} près de {1} fait le tour du corps et ne peut pas être mis à plat. Dessinez une couture en travers.</translation>
    </message>
    <message>
        <source>Panel {0} of the JSON file has no name or no 'outer' loop. {1}</source>
        <translation>Le panneau {0} du fichier JSON n'a pas de nom ou pas de boucle 'outer'. {1}</translation>
    </message>
    <message>
        <source>Panel {0}: an intake of this kind leads through a seam. Say which one, or an edge of the panel such as {1}.0, or choose a nozzle.</source>
        <translation>Panneau {0} : un embout de ce genre traverse une couture. Dites laquelle, ou un bord du panneau comme {1}.0, ou choisissez une buse.</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panneaux</translation>
    </message>
    <message>
        <source>Panels and seams; a copy of them travels in the document</source>
        <translation>Panneaux et coutures ; une copie voyage dans le document</translation>
    </message>
    <message>
        <source>Panels are laid on the film in rows instead of closely; nothing else changes.</source>
        <translation>Les panneaux sont disposés en rangées au lieu d'être serrés ; rien d'autre ne change.</translation>
    </message>
    <message>
        <source>Panels laid flat: strained by {0} on average, at most {1}</source>
        <translation>Panneaux mis à plat : déformés de {0} en moyenne, {1} au plus</translation>
    </message>
    <message>
        <source>Panels with gussets, whose sizes come from a spreadsheet</source>
        <translation>Panneaux à soufflets, dont les dimensions viennent d'une feuille de calcul</translation>
    </message>
    <message>
        <source>Panels: {0}, of different shapes: {1}</source>
        <translation>Panneaux : {0}, de formes différentes : {1}</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Parts of the balloon may lean to one side or the other: the inflated outline is {0} to {1} from the drawing. Another width of the side band may hold them.</source>
        <translation>Des parties du ballon peuvent pencher d'un côté ou de l'autre : le contour gonflé est à {0} à {1} du dessin. Une autre largeur de la bande latérale peut les tenir.</translation>
    </message>
    <message>
        <source>Paste (Ctrl+V)</source>
        <translation>Coller (Ctrl+V)</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Patron</translation>
    </message>
    <message>
        <source>Pattern correction needs scipy: install it with pip install scipy.</source>
        <translation>La correction du patron demande scipy : installez-le par pip install scipy.</translation>
    </message>
    <message>
        <source>Pattern drawn 1 : {0}</source>
        <translation>Patron à l'échelle 1 : {0}</translation>
    </message>
    <message>
        <source>Pattern of the balloon, all pieces</source>
        <translation>Patron du ballon, toutes les pièces</translation>
    </message>
    <message>
        <source>Pattern on several pages</source>
        <translation>Patron sur plusieurs pages</translation>
    </message>
    <message>
        <source>Pattern written to {}</source>
        <translation>Patron écrit dans {}</translation>
    </message>
    <message>
        <source>Pattern {0} ({1} x {2} in), pages: {3}.</source>
        <translation>Patron {0} ({1} x {2} pouces), pages : {3}.</translation>
    </message>
    <message>
        <source>Pattern, cut two (one mirrored)</source>
        <translation>Patron, à couper deux fois (une fois en miroir)</translation>
    </message>
    <message>
        <source>Pattern, {0} panels</source>
        <translation>Patron, {0} panneaux</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Patrons</translation>
    </message>
    <message>
        <source>Patterns need shapely: install it with pip install shapely.</source>
        <translation>Les patrons demandent shapely : installez-le par pip install shapely.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Stylo</translation>
    </message>
    <message>
        <source>Pen drawing</source>
        <translation>Dessin au trait</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Photo</translation>
    </message>
    <message>
        <source>Pick an edge to see its partner.</source>
        <translation>Choisissez un bord pour voir son partenaire.</translation>
    </message>
    <message>
        <source>Pick an edge, then its partner, here or in the 3D view. Free edges: {}</source>
        <translation>Choisissez un bord, puis son partenaire, ici ou dans la vue 3D. Bords libres : {}</translation>
    </message>
    <message>
        <source>Pick the edge at which it is filled.</source>
        <translation>Choisissez le bord par lequel il est rempli.</translation>
    </message>
    <message>
        <source>Picture (PNG)</source>
        <translation>Image (PNG)</translation>
    </message>
    <message>
        <source>Picture, SVG, DXF or JSON</source>
        <translation>Image, SVG, DXF ou JSON</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Pictures are read by Qt and traced with SciPy instead, a little slower.</source>
        <translation>Les images sont lues par Qt et vectorisées avec SciPy à la place, un peu plus lentement.</translation>
    </message>
    <message>
        <source>Pictures need OpenCV or SciPy: install the package python3-opencv or python3-scipy.</source>
        <translation>Les images ont besoin d'OpenCV ou de SciPy : installez le paquet python3-opencv ou python3-scipy.</translation>
    </message>
    <message>
        <source>Pictures need OpenCV, which is missing or does not work here. Install the package python3-opencv (or opencv-python-headless), or open the picture inside FreeCAD.</source>
        <translation>Les images demandent OpenCV, qui manque ou ne marche pas ici. Installez le paquet python3-opencv (ou opencv-python-headless), ou ouvrez l'image dans FreeCAD.</translation>
    </message>
    <message>
        <source>Pictures of the work</source>
        <translation>Le travail en images</translation>
    </message>
    <message>
        <source>Pieces of the side band cannot be {0} long. Give 0 or more.</source>
        <translation>Les pièces de la bande latérale ne peuvent pas avoir {0} de long. Donnez 0 ou plus.</translation>
    </message>
    <message>
        <source>Pieces of {0} are too short for a side band of {1}. Allow longer ones.</source>
        <translation>Des pièces de {0} sont trop courtes pour une bande latérale de {1}. Permettez-en de plus longues.</translation>
    </message>
    <message>
        <source>Pieces: {}, on {}, {} used</source>
        <translation>Pièces : {}, sur {}, {} utilisés</translation>
    </message>
    <message>
        <source>Pipette</source>
        <translation>Pipette</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixels</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Place</translation>
    </message>
    <message>
        <source>Place by</source>
        <translation>Placer par</translation>
    </message>
    <message>
        <source>Place on the seam</source>
        <translation>Place sur la couture</translation>
    </message>
    <message>
        <source>Places of a seam</source>
        <translation>Points d'une couture</translation>
    </message>
    <message>
        <source>Places on the body in mm: two for a cut, one for the chosen seam to be moved to</source>
        <translation>Endroits sur le corps en mm : deux pour une coupe, un où déplacer la couture choisie</translation>
    </message>
    <message>
        <source>Plain PET does not weld to itself: take a grade with a sealing layer, or tape. The aluminium (some 50 nm) adds neither stiffness nor weight. What shops sell as Mylar balloons is mostly nylon-foil.</source>
        <translation>Le PET nu ne se soude pas à lui-même : prenez une qualité à couche scellable, ou du ruban adhésif. L'aluminium (quelque 50 nm) n'ajoute ni raideur ni masse. Ce que les magasins vendent comme ballons Mylar est le plus souvent du nylon-foil.</translation>
    </message>
    <message>
        <source>Plain paper (PDF)</source>
        <translation>Papier ordinaire (PDF)</translation>
    </message>
    <message>
        <source>Plain shell</source>
        <translation>Coque simple</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Play the inflation, or stop at a frame</source>
        <translation>Lire le gonflage, ou s'arrêter sur une image</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Tracer</translation>
    </message>
    <message>
        <source>Plotter units of 0.025 mm. Pen 1 draws the control bar, pen 2 cuts the notches, pen 3 the rest. Nothing is in the file that may not be cut. For a swivel knife set its offset, 0.25 mm is common. Cuts run 1 mm past their start: set overcut_mm to 0 where the cutter does that itself.</source>
        <translation>Unités de traceur de 0,025 mm. La plume 1 trace la barre de contrôle, la 2 coupe les encoches, la 3 le reste. Il n'y a rien dans le fichier qui ne puisse être coupé. Pour une lame pivotante, réglez son décalage ; 0,25 mm est courant. Les coupes dépassent leur début de 1 mm : mettez overcut_mm à 0 si la découpeuse le fait elle-même.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Pointe</translation>
    </message>
    <message>
        <source>Point {0} of the JSON file's 'profile' is not a pair of numbers. {1}</source>
        <translation>Le point {0} de 'profile' dans le fichier JSON n'est pas une paire de nombres. {1}</translation>
    </message>
    <message>
        <source>Point {0} of the JSON file's {1} is not a pair of numbers. {2}</source>
        <translation>Le point {0} de {1} du fichier JSON n'est pas une paire de nombres. {2}</translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation>Coefficient de Poisson</translation>
    </message>
    <message>
        <source>Polyethylene film (LDPE), 50 µm</source>
        <translation>Film polyéthylène (PEBD), 50 µm</translation>
    </message>
    <message>
        <source>Polylines at the real size with a layer and a colour for each role. CUT, CUT_INNER and NOTCH are cut, SEAL and WELD welded, all others drawn.</source>
        <translation>Polylignes à la taille réelle, avec un calque et une couleur par rôle. CUT, CUT_INNER et NOTCH sont coupés, SEAL et WELD soudés, tous les autres tracés.</translation>
    </message>
    <message>
        <source>Polylines in millimetres with a layer for each role: what every program reads. CUT, CUT_INNER and NOTCH are cut, SEAL and WELD welded, all others drawn.</source>
        <translation>Polylignes en millimètres avec un calque par rôle : ce que tout programme lit. CUT, CUT_INNER et NOTCH sont coupés, SEAL et WELD soudés, tous les autres tracés.</translation>
    </message>
    <message>
        <source>Pouch</source>
        <translation>Pochette</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Puissance</translation>
    </message>
    <message>
        <source>Predicted from the outline; not inflated yet.</source>
        <translation>Prévu d'après le contour ; pas encore gonflé.</translation>
    </message>
    <message>
        <source>Press a head to sort by it.</source>
        <translation>Cliquez sur un en-tête de colonne pour trier.</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Pression</translation>
    </message>
    <message>
        <source>Pressure inside, above that outside</source>
        <translation>Pression intérieure, au-dessus de l'extérieure</translation>
    </message>
    <message>
        <source>Pressure rises with height</source>
        <translation>La pression croît en hauteur</translation>
    </message>
    <message>
        <source>Pressure with the margin left</source>
        <translation>Pression qui laisse la marge</translation>
    </message>
    <message>
        <source>Pressure: {0}</source>
        <translation>Pression : {0}</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimer</translation>
    </message>
    <message>
        <source>Print at 100 % ("actual size"). The bar below must be 100 mm long.</source>
        <translation>Imprimez à 100 % (« taille réelle »). La barre ci-dessous doit mesurer 100 mm.</translation>
    </message>
    <message>
        <source>Print shop (PDF with CutContour)</source>
        <translation>Imprimeur (PDF avec CutContour)</translation>
    </message>
    <message>
        <source>Print the pieces</source>
        <translation>Imprimer les pièces</translation>
    </message>
    <message>
        <source>Print {0} at {1} dpi, all panels</source>
        <translation>Impression de {0} à {1} dpi, tous les panneaux</translation>
    </message>
    <message>
        <source>Print {0} at {1} dpi, front and back</source>
        <translation>Impression : {0} à {1} dpi, devant et dos</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Pull a line; then move the pointer to bend it, and click. A right click keeps it straight.</source>
        <translation>Tirez une ligne, puis déplacez le pointeur pour la courber et cliquez. Un clic droit la garde droite.</translation>
    </message>
    <message>
        <source>Pull a rectangle to copy (Ctrl+C) or cut (Ctrl+X); without one that is all. Ctrl+V pastes.</source>
        <translation>Tirez un rectangle pour copier (Ctrl+C) ou couper (Ctrl+X) ; sans lui, c'est tout. Ctrl+V colle.</translation>
    </message>
    <message>
        <source>Pull a shape to its size, up or down to turn it; Shift keeps it upright.</source>
        <translation>Tirez une forme à sa taille, vers le haut ou le bas pour la tourner ; Maj la garde droite.</translation>
    </message>
    <message>
        <source>Pull it, its corner, or the ring that turns it. Enter paints it, Esc drops it.</source>
        <translation>Tirez-le, son coin, ou l'anneau qui le tourne. Entrée le peint, Échap l'abandonne.</translation>
    </message>
    <message>
        <source>Pull the centre of the symmetry to its place, and turn its axis by the ring</source>
        <translation>Tirez le centre de la symétrie à sa place, et tournez son axe par l'anneau</translation>
    </message>
    <message>
        <source>Pull the paper. The middle button, or the space bar, does it with every tool; the wheel zooms.</source>
        <translation>Tirez la feuille. Le bouton du milieu ou la barre d'espace le font avec tout outil ; la molette zoome.</translation>
    </message>
    <message>
        <source>Pull the straw out and seal straight across the neck, beside the balloon.</source>
        <translation>Retirez la paille et soudez droit en travers du col, près du ballon.</translation>
    </message>
    <message>
        <source>Push a straw in, fill, pull it out and close the neck like the seam, straight across beside the balloon.</source>
        <translation>Glissez une paille, gonflez, retirez-la et fermez le col comme la couture, droit en travers près du ballon.</translation>
    </message>
    <message>
        <source>Push the nozzle through the hole of the front panel from inside, put the ring over it from outside, and join flange, film and ring like the seam, along the ring's line, before the panels are joined.</source>
        <translation>Passez la buse de l'intérieur par le trou du panneau de devant, posez l'anneau par-dessus à l'extérieur, et joignez collerette, film et anneau comme la couture, le long de la ligne de l'anneau, avant d'assembler les panneaux.</translation>
    </message>
    <message>
        <source>Put a picture on the paper, without its background</source>
        <translation>Poser une image sur la feuille, sans son fond</translation>
    </message>
    <message>
        <source>Put outline, balloon and pattern into the document, and print the pattern</source>
        <translation>Placer contour, ballon et patron dans le document, et imprimer le patron</translation>
    </message>
    <message>
        <source>Put the intake low</source>
        <translation>Placer l'embout en bas</translation>
    </message>
    <message>
        <source>Put the same moves into the document, as objects of FreeCAD's workbench Path (CAM since 1.0), which can simulate them and write them with its post processors</source>
        <translation>Placer les mêmes mouvements dans le document, comme objets de l'atelier Path de FreeCAD (CAM depuis 1.0), qui peut les simuler et les écrire avec ses post-processeurs</translation>
    </message>
    <message>
        <source>RDWorks (Ruida laser)</source>
        <translation>RDWorks (laser Ruida)</translation>
    </message>
    <message>
        <source>Reading a mesh needs scipy: install it with pip install scipy.</source>
        <translation>Lire un maillage demande scipy : l’installer avec pip install scipy.</translation>
    </message>
    <message>
        <source>Reads</source>
        <translation>Fichiers lus</translation>
    </message>
    <message>
        <source>Ready body</source>
        <translation>Corps prêt</translation>
    </message>
    <message>
        <source>Ready to make. Paint on, or press Make it!</source>
        <translation>Prêt à fabriquer. Continuez à peindre, ou pressez « Fabriquer ! ».</translation>
    </message>
    <message>
        <source>Real size, to cut out by hand. Print at 100 % and measure the control bar.</source>
        <translation>Taille réelle, à découper à la main. Imprimez à 100 % et mesurez la barre de contrôle.</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rouge</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Y)</source>
        <translation>Rétablir (Ctrl+Y)</translation>
    </message>
    <message>
        <source>Remnant</source>
        <translation>Chute</translation>
    </message>
    <message>
        <source>Remnants</source>
        <translation>Chutes</translation>
    </message>
    <message>
        <source>Remove (Del)</source>
        <translation>Enlever (Suppr)</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Réparer</translation>
    </message>
    <message>
        <source>Repair {0} cannot be read: delete it from Repairs.</source>
        <translation>La réparation {0} est illisible : effacez-la de « Repairs ».</translation>
    </message>
    <message>
        <source>Replace the file</source>
        <translation>Remplacer le fichier</translation>
    </message>
    <message>
        <source>Replace the files</source>
        <translation>Remplacer les fichiers</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Result that is shown as colours, with a legend</source>
        <translation>Résultat montré en couleurs, avec une légende</translation>
    </message>
    <message>
        <source>Results cannot be written as '{0}'. Choose {1}.</source>
        <translation>Les résultats ne peuvent pas être écrits en « {0} ». Choisissez {1}.</translation>
    </message>
    <message>
        <source>Results written to {}</source>
        <translation>Résultats écrits dans {}</translation>
    </message>
    <message>
        <source>Rim</source>
        <translation>Rebord</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Anneau</translation>
    </message>
    <message>
        <source>Ring that kinks where its weld creases</source>
        <translation>Anneau qui se coude là où sa soudure se froisse</translation>
    </message>
    <message>
        <source>Ring that warps</source>
        <translation>Anneau qui se gauchit</translation>
    </message>
    <message>
        <source>Roland with crop marks (vinyl cutter)</source>
        <translation>Roland avec repères de coupe (plotter de découpe)</translation>
    </message>
    <message>
        <source>Round pieces up to</source>
        <translation>Autour des pièces jusqu'à</translation>
    </message>
    <message>
        <source>Round this hole the balloon may kink: with a weld creased to {percent} of its stiffness the outline moves by up to {length}; with one {wanted} wide, creased as much, by {less}.</source>
        <translation>Autour de ce trou, le ballon peut se couder : avec une soudure froissée qui ne garde que {percent} de sa rigidité, le contour se déplace jusqu'à {length} ; avec une soudure large de {wanted}, froissée autant, de {less}.</translation>
    </message>
    <message>
        <source>Round this hole the balloon will not lie flat: a closed tube wants to curve more and twists out of its plane, here by about {length}. Open the ring, or seal the hole's area without cutting it out and keep it small.</source>
        <translation>Autour de ce trou, le ballon ne restera pas à plat : un tube fermé veut se courber davantage et se tord hors de son plan, ici d'environ {length}. Ouvrez l'anneau, ou soudez la zone du trou sans la découper et gardez-la petite.</translation>
    </message>
    <message>
        <source>Round this hole the balloon will not lie quite flat: a closed tube wants to curve more and twists out of its plane, here by about {length}.</source>
        <translation>Autour de ce trou, le ballon ne restera pas tout à fait à plat : un tube fermé veut se courber davantage et se tord hors de son plan, ici d'environ {length}.</translation>
    </message>
    <message>
        <source>Round with a radius of</source>
        <translation>Arrondir au rayon de</translation>
    </message>
    <message>
        <source>Row {0}: {1}</source>
        <translation>Ligne {0} : {1}</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Rows from below: {0}</source>
        <translation>Rangées depuis le bas : {0}</translation>
    </message>
    <message>
        <source>Rows: {0}, of these make no sense: {1}</source>
        <translation>Lignes : {0}, dont dénuées de sens : {1}</translation>
    </message>
    <message>
        <source>Rows: {0}, without a balloon: {1}</source>
        <translation>Lignes : {0}, sans ballon : {1}</translation>
    </message>
    <message>
        <source>S at full power</source>
        <translation>S à pleine puissance</translation>
    </message>
    <message>
        <source>STL, OBJ, PLY, 3MF or STEP</source>
        <translation>STL, OBJ, PLY, 3MF ou STEP</translation>
    </message>
    <message>
        <source>SVG files can be written but not read without it; pictures, DXF and JSON can be read.</source>
        <translation>Sans lui, les fichiers SVG peuvent être écrits mais non lus ; images, DXF et JSON peuvent l'être.</translation>
    </message>
    <message>
        <source>SVG files need the Python package svgelements. Install it with 'pip install svgelements', or save the drawing as DXF.</source>
        <translation>Les fichiers SVG demandent le paquet Python svgelements. Installez-le par « pip install svgelements », ou enregistrez le dessin en DXF.</translation>
    </message>
    <message>
        <source>SVG, DXF or JSON</source>
        <translation>SVG, DXF ou JSON</translation>
    </message>
    <message>
        <source>Safe pressure</source>
        <translation>Pression sûre</translation>
    </message>
    <message>
        <source>Safe pressure: {0}</source>
        <translation>Pression sûre : {0}</translation>
    </message>
    <message>
        <source>Safe pressure: {0}, less than its {1}</source>
        <translation>Pression sûre : {0}, moins que ses {1}</translation>
    </message>
    <message>
        <source>Safe to</source>
        <translation>Sûr jusqu'à</translation>
    </message>
    <message>
        <source>Samples need scipy: install it with pip install scipy.</source>
        <translation>Les échantillons demandent scipy : installez-le par pip install scipy.</translation>
    </message>
    <message>
        <source>Samples of a {0} need scipy: install it with pip install scipy, or take {1} ones.</source>
        <translation>Des échantillons de type {0} demandent scipy : installez-le par pip install scipy, ou prenez {1}.</translation>
    </message>
    <message>
        <source>Samples: {0}, of these failed: {1}, not at rest: {2}</source>
        <translation>Échantillons : {0}, dont échoués : {1}, pas au repos : {2}</translation>
    </message>
    <message>
        <source>Save as GIF or MP4</source>
        <translation>Enregistrer en GIF ou MP4</translation>
    </message>
    <message>
        <source>Save files…</source>
        <translation>Enregistrer les fichiers…</translation>
    </message>
    <message>
        <source>Save results</source>
        <translation>Enregistrer les résultats</translation>
    </message>
    <message>
        <source>Save results…</source>
        <translation>Enregistrer les résultats…</translation>
    </message>
    <message>
        <source>Save the inflation</source>
        <translation>Enregistrer le gonflage</translation>
    </message>
    <message>
        <source>Scale to fit</source>
        <translation>Réduire au plateau</translation>
    </message>
    <message>
        <source>Scaled to fit: the balloon is {0} wide instead of {1}.</source>
        <translation>Réduit au plateau : le ballon a {0} de large au lieu de {1}.</translation>
    </message>
    <message>
        <source>Scaled to fit: the drawing is {0} wide instead of {1}.</source>
        <translation>Réduit au plateau : le dessin a {0} de large au lieu de {1}.</translation>
    </message>
    <message>
        <source>Scaled to fit: {} wide instead of {}.</source>
        <translation>Réduit au plateau : {} de large au lieu de {}.</translation>
    </message>
    <message>
        <source>SciPy triangulates instead, a little slower.</source>
        <translation>SciPy triangule à sa place, un peu plus lentement.</translation>
    </message>
    <message>
        <source>Seal a disc on each point where four panels or more meet.</source>
        <translation>Soudez un disque sur chaque point où quatre panneaux ou plus se rejoignent.</translation>
    </message>
    <message>
        <source>Seal across the neck along its line, through panels and strips. The field keeps the channel open.</source>
        <translation>Soudez en travers du col le long de sa ligne, à travers panneaux et bandes. Le champ garde le canal ouvert.</translation>
    </message>
    <message>
        <source>Seal the lines inside.</source>
        <translation>Soudez les lignes intérieures.</translation>
    </message>
    <message>
        <source>Seal the outline, {seal} wide, all but the mouth of the neck.</source>
        <translation>Soudez le contour, sur {seal} de large, sauf l'embouchure du col.</translation>
    </message>
    <message>
        <source>Seal the outline, {seal} wide, all the way round.</source>
        <translation>Soudez le contour, sur {seal} de large, sur tout le tour.</translation>
    </message>
    <message>
        <source>Seal the seams in the order of the pictures along the dashed line, {seal} wide, from end to end.</source>
        <translation>Soudez les coutures dans l'ordre des images le long de la ligne tiretée, sur {seal} de large, d'un bout à l'autre.</translation>
    </message>
    <message>
        <source>Seal the seams in the order of the pictures along the dashed line, {seal} wide, from end to end. Leave the mouth of the neck open.</source>
        <translation>Soudez les coutures dans l'ordre des images le long de la ligne tiretée, sur {seal} de large, d'un bout à l'autre. Laissez ouverte la bouche du col.</translation>
    </message>
    <message>
        <source>Seal width</source>
        <translation>Largeur de soudure</translation>
    </message>
    <message>
        <source>Seal width (0: the film's)</source>
        <translation>Largeur de soudure (0 : celle du film)</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Couture</translation>
    </message>
    <message>
        <source>Seam edit {0}</source>
        <translation>Changement de couture {0}</translation>
    </message>
    <message>
        <source>Seam length</source>
        <translation>Longueur de couture</translation>
    </message>
    <message>
        <source>Seam length: {0}</source>
        <translation>Longueur de couture : {0}</translation>
    </message>
    <message>
        <source>Seam or edge</source>
        <translation>Couture ou bord</translation>
    </message>
    <message>
        <source>Seam {0} has no length: it begins and ends where {1} begins. Give two points; a whole loop is written as two seams.</source>
        <translation>La couture {0} n'a pas de longueur : elle commence et finit où {1} commence. Donnez deux points ; une boucle entière s'écrit en deux coutures.</translation>
    </message>
    <message>
        <source>Seam {0} is along a panel {1}, but there are {2}.</source>
        <translation>La soudure {0} longe un panneau {1}, mais il y en a {2}.</translation>
    </message>
    <message>
        <source>Seam {0} is along vertices that panel {1} does not have.</source>
        <translation>La soudure {0} longe des sommets que le panneau {1} n'a pas.</translation>
    </message>
    <message>
        <source>Seam {0} is at an end that stays open: say another one for the opening.</source>
        <translation>La couture {0} est à une extrémité qui reste ouverte : indiquez-en une autre pour l'ouverture.</translation>
    </message>
    <message>
        <source>Seam {0} is on hole {1} of panel '{2}', which has {3}. Check its sides.</source>
        <translation>La couture {0} est au trou {1} du panneau « {2} », qui en a {3}. Vérifiez ses côtés.</translation>
    </message>
    <message>
        <source>Seam {0} is on panel {1}, but there are {2}. Check its sides.</source>
        <translation>La couture {0} est au panneau {1}, mais il y en a {2}. Vérifiez ses côtés.</translation>
    </message>
    <message>
        <source>Seam {0} is on point {1} of panel '{2}', whose points there are 0 to {3}. Check its sides.</source>
        <translation>La couture {0} est au point {1} du panneau « {2} », dont les points y vont de 0 à {3}. Vérifiez ses côtés.</translation>
    </message>
    <message>
        <source>Seam {0} joins holes of panels {1} and {2}, where no intake can be: say another seam.</source>
        <translation>La couture {0} joint des trous des panneaux {1} et {2}, où aucun embout ne peut être : indiquez une autre couture.</translation>
    </message>
    <message>
        <source>Seam {0} joins the outside of the film to its inside, as in a Moebius strip. Turn one of its sides round.</source>
        <translation>La soudure {0} joint l'extérieur du film à son intérieur, comme dans un ruban de Möbius. Retournez l'un de ses côtés.</translation>
    </message>
    <message>
        <source>Seam {0} joins {1} vertices to {2}. Divide both sides into equally many parts.</source>
        <translation>La soudure {0} joint {1} sommets à {2}. Divisez les deux côtés en autant de parties.</translation>
    </message>
    <message>
        <source>Seam {0} leaves the boundary of panel {1}. Give its vertices in a row along it.</source>
        <translation>La soudure {0} quitte le bord du panneau {1}. Donnez ses sommets à la suite le long du bord.</translation>
    </message>
    <message>
        <source>Seam {0} of panels {1} is {2} long, and the intake takes {3} with its welds: make it narrower, or say another edge for the opening.</source>
        <translation>La couture {0} des panneaux {1} mesure {2}, et l'embout prend {3} avec ses soudures : rétrécissez-le, ou indiquez un autre bord pour l'ouverture.</translation>
    </message>
    <message>
        <source>Seam {0} of the JSON file has no two sides 'a' and 'b'. {1}</source>
        <translation>La couture {0} du fichier JSON n'a pas deux côtés 'a' et 'b'. {1}</translation>
    </message>
    <message>
        <source>Seam {0} of the list does none of {1}. {2}</source>
        <translation>La couture {0} de la liste ne fait rien de {1}. {2}</translation>
    </message>
    <message>
        <source>Seam {0} of the list has a place that is not [x, y, z]. {1}</source>
        <translation>La couture {0} de la liste a un endroit qui n'est pas [x, y, z]. {1}</translation>
    </message>
    <message>
        <source>Seam {0} of the list has an unknown '{1}'. Use {2}.</source>
        <translation>La couture {0} de la liste a un « {1} » inconnu. Utilisez {2}.</translation>
    </message>
    <message>
        <source>Seam {0} of the list: 'side' is '{1}' or '{2}', 'mirrored' is true or false.</source>
        <translation>Couture {0} de la liste : 'side' est « {1} » ou « {2} », 'mirrored' est true ou false.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, last, with the opening.</source>
        <translation>Couture {0} : {1} à {2}, en dernier, avec l'ouverture.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, last.</source>
        <translation>Couture {0} : {1} à {2}, en dernier.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, lying flat.</source>
        <translation>Couture {0} : {1} à {2}, à plat.</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, one edge turned round the other.</source>
        <translation>Couture {0} : {1} à {2}, un bord rabattu autour de l'autre.</translation>
    </message>
    <message>
        <source>Seam {}: {}</source>
        <translation>Couture {} : {}</translation>
    </message>
    <message>
        <source>Seam {}: {}; {}</source>
        <translation>Couture {} : {} ; {}</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Coutures</translation>
    </message>
    <message>
        <source>Seams and centres apart</source>
        <translation>Écart entre coutures et milieux</translation>
    </message>
    <message>
        <source>Seams and middles of gores: {0} apart at most</source>
        <translation>Coutures et milieux des fuseaux : au plus {0} d'écart</translation>
    </message>
    <message>
        <source>Seams that do not lie flat: {0}. Seal them bit by bit.</source>
        <translation>Coutures qui ne reposent pas à plat : {0}. Soudez-les petit à petit.</translation>
    </message>
    <message>
        <source>Seams that do not lie flat: {0}. Their allowance is cut into tabs that turn.</source>
        <translation>Coutures qui ne reposent pas à plat : {0}. Leur marge est découpée en languettes qui se rabattent.</translation>
    </message>
    <message>
        <source>Seams {0} and {1} hold the same piece of the boundary of panel {2}. Seal each piece once.</source>
        <translation>Les soudures {0} et {1} tiennent le même morceau du bord du panneau {2}. Soudez chaque morceau une fois.</translation>
    </message>
    <message>
        <source>Seams: {0}, where an edge must turn: {1}</source>
        <translation>Coutures : {0}, dont un bord doit se retourner : {1}</translation>
    </message>
    <message>
        <source>Second panel, mirrored</source>
        <translation>Second panneau, en miroir</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Select a sketch of half the outline, or choose where the profile comes from.</source>
        <translation>Choisissez une esquisse d'un demi-contour, ou d'où vient le profil.</translation>
    </message>
    <message>
        <source>Select a sketch, a wire or a face in the tree or the 3D view.</source>
        <translation>Sélectionnez une esquisse, un fil ou une face dans l'arborescence ou la vue 3D.</translation>
    </message>
    <message>
        <source>Select a solid or a mesh, or choose a file.</source>
        <translation>Sélectionnez un solide ou un maillage, ou choisissez un fichier.</translation>
    </message>
    <message>
        <source>Select all (Ctrl+A)</source>
        <translation>Tout sélectionner (Ctrl+A)</translation>
    </message>
    <message>
        <source>Select another</source>
        <translation>En choisir une autre</translation>
    </message>
    <message>
        <source>Select sketches or flat faces, or take a ready body or a file.</source>
        <translation>Choisissez des esquisses ou des faces planes, ou prenez un corps prêt ou un fichier.</translation>
    </message>
    <message>
        <source>Select sketches, wires or flat faces first.</source>
        <translation>Choisissez d'abord des esquisses, des fils ou des faces planes.</translation>
    </message>
    <message>
        <source>Self-sealing film valve</source>
        <translation>Valve de film autofermante</translation>
    </message>
    <message>
        <source>Set X0 Y0 at the lower left corner of the film, and Z0 where the tool touches it; nothing homes. A laser wants laser mode, $32=1.</source>
        <translation>Mettez X0 Y0 au coin inférieur gauche du film, et Z0 où l'outil le touche ; le fichier ne fait pas de prise d'origine. Un laser demande le mode laser, $32=1.</translation>
    </message>
    <message>
        <source>Set X0 Y0 at the lower left corner of the film, and Z0 where the tool touches it; nothing homes. For a swivel knife set its offset in a machine file of your own.</source>
        <translation>Mettez X0 Y0 au coin inférieur gauche du film, et Z0 où l'outil le touche ; le fichier ne fait pas de prise d'origine. Pour une lame pivotante, réglez son décalage dans votre propre fichier de machine.</translation>
    </message>
    <message>
        <source>Set the opening</source>
        <translation>Placer l'ouverture</translation>
    </message>
    <message>
        <source>Set up machines of your own</source>
        <translation>Régler vos propres machines</translation>
    </message>
    <message>
        <source>Shadows on the background were taken off.</source>
        <translation>Les ombres sur le fond ont été enlevées.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Shape that stays flat</source>
        <translation>Forme qui reste plate</translation>
    </message>
    <message>
        <source>Share of the feed near corners and in narrow bends</source>
        <translation>Part de l'avance près des coins et dans les courbes serrées</translation>
    </message>
    <message>
        <source>Share of the laser's full power; empty: not known yet</source>
        <translation>Part de la pleine puissance du laser ; vide : pas encore connue</translation>
    </message>
    <message>
        <source>Sharp or round (S)</source>
        <translation>Pointu ou rond (S)</translation>
    </message>
    <message>
        <source>Sheet length</source>
        <translation>Longueur de feuille</translation>
    </message>
    <message>
        <source>Sheet {} of {}</source>
        <translation>Feuille {} sur {}</translation>
    </message>
    <message>
        <source>Show all (0)</source>
        <translation>Montrer tout (0)</translation>
    </message>
    <message>
        <source>Show all pieces (0)</source>
        <translation>Montrer toutes les pièces (0)</translation>
    </message>
    <message>
        <source>Show the drawing and the silhouette over each other</source>
        <translation>Montrer le dessin et la silhouette superposés</translation>
    </message>
    <message>
        <source>Show the whole paper (0)</source>
        <translation>Montrer toute la feuille (0)</translation>
    </message>
    <message>
        <source>Shown on the pieces</source>
        <translation>Montré sur les pièces</translation>
    </message>
    <message>
        <source>Shown sheet</source>
        <translation>Feuille montrée</translation>
    </message>
    <message>
        <source>Shown side</source>
        <translation>Face montrée</translation>
    </message>
    <message>
        <source>Side '{0}' of seam {1} is not the name of a panel and two points. {2}</source>
        <translation>Le côté '{0}' de la couture {1} n'est pas le nom d'un panneau et deux points. {2}</translation>
    </message>
    <message>
        <source>Side '{0}' of seam {1} is on a panel '{2}' that is not there. {3}</source>
        <translation>Le côté '{0}' de la couture {1} est à un panneau « {2} » qui n'existe pas. {3}</translation>
    </message>
    <message>
        <source>Side band</source>
        <translation>Bande latérale</translation>
    </message>
    <message>
        <source>Side {0} of seam {1} runs the wrong way at {2}, which would seal the outside of the film to its inside, as in a Moebius strip: it goes {3} its loop. Swap the two points of {4}.</source>
        <translation>Le côté {0} de la couture {1} va à l'envers à {2}, ce qui souderait l'extérieur du film à son intérieur, comme dans un ruban de Möbius : il va {3} sa boucle. Échangez les deux points de {4}.</translation>
    </message>
    <message>
        <source>Silhouette Cameo 5 Alpha from Inkscape</source>
        <translation>Silhouette Cameo 5 Alpha depuis Inkscape</translation>
    </message>
    <message>
        <source>Silhouette Studio (vinyl cutter)</source>
        <translation>Silhouette Studio (plotter de découpe)</translation>
    </message>
    <message>
        <source>Silhouette error, largest</source>
        <translation>Erreur de silhouette, maximale</translation>
    </message>
    <message>
        <source>Silhouette error, mean</source>
        <translation>Erreur de silhouette, moyenne</translation>
    </message>
    <message>
        <source>Silhouette from Inkscape</source>
        <translation>Silhouette depuis Inkscape</translation>
    </message>
    <message>
        <source>Silhouette off the drawing</source>
        <translation>Écart de la silhouette au dessin</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Simulations use NumPy. "What works here" in the menu fetches the native solver later.</source>
        <translation>Les simulations utilisent NumPy. « Ce qui marche ici », dans le menu, télécharge le solveur natif plus tard.</translation>
    </message>
    <message>
        <source>Six gores from half an outline in a sketch: change their number</source>
        <translation>Six fuseaux d'après un demi-contour dans une esquisse : changez leur nombre</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Size from</source>
        <translation>Taille d'après</translation>
    </message>
    <message>
        <source>Size unknown</source>
        <translation>Taille inconnue</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>So far it is a line. Close it, or paint an area, and it becomes a balloon.</source>
        <translation>Pour l'instant c'est une ligne. Fermez-la, ou peignez une surface, et elle devient un ballon.</translation>
    </message>
    <message>
        <source>Soft PVC film, 0.2 mm</source>
        <translation>Film PVC souple, 0,2 mm</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solveur</translation>
    </message>
    <message>
        <source>Solver: {0}.</source>
        <translation>Solveur : {0}.</translation>
    </message>
    <message>
        <source>Solver: {0}. {1}</source>
        <translation>Solveur : {0}. {1}</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Broche</translation>
    </message>
    <message>
        <source>Split over beds</source>
        <translation>Répartir sur plateaux</translation>
    </message>
    <message>
        <source>Split over beds of {0}, the pattern leaves no waste film for two crosses {1} apart by which it is laid on anew: choose a larger bed, or lay the pieces out on sheets.</source>
        <translation>Réparti sur des plateaux de {0}, le patron ne laisse pas de film perdu pour deux croix à {1} l'une de l'autre par lesquelles reposer le film : choisissez un plateau plus grand, ou disposez les pièces sur des feuilles.</translation>
    </message>
    <message>
        <source>Spot in 16 panels</source>
        <translation>La vache Spot en 16 panneaux</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>Tampon</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Étoile</translation>
    </message>
    <message>
        <source>Start values for welding: {0} ({1}).</source>
        <translation>Valeurs de départ pour la soudure : {0} ({1}).</translation>
    </message>
    <message>
        <source>Start values, not tried on your film and tool: {start_values} ({start_sources}).</source>
        <translation>Valeurs de départ, non essayées sur votre film et votre outil : {start_values} ({start_sources}).</translation>
    </message>
    <message>
        <source>Stated is: {0} ({1}).</source>
        <translation>Ce qui est indiqué : {0} ({1}).</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>Stiffer across the web than along it (up to 4.5 against 2.5 GPa): cut both panels in the same direction. Only grades with a sealing layer weld; the gas barrier is poor.</source>
        <translation>Plus raide en travers de la bande que dans sa longueur (jusqu'à 4,5 contre 2,5 GPa) : coupez les deux panneaux dans le même sens. Seules les qualités à couche scellable se soudent ; la barrière aux gaz est médiocre.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>Arrêter (Échap)</translation>
    </message>
    <message>
        <source>Stop and keep the last result</source>
        <translation>Arrêter et garder le dernier résultat</translation>
    </message>
    <message>
        <source>Stopped. Your painting is still here.</source>
        <translation>Arrêté. Votre peinture est toujours là.</translation>
    </message>
    <message>
        <source>Stopping ...</source>
        <translation>Arrêt en cours ...</translation>
    </message>
    <message>
        <source>Straight from the front, from far away, on a plain background of another colour</source>
        <translation>Bien de face, de loin, sur un fond uni d'une autre couleur</translation>
    </message>
    <message>
        <source>Straw neck</source>
        <translation>Col à paille</translation>
    </message>
    <message>
        <source>Stretch of the film: {0}</source>
        <translation>Étirement du film : {0}</translation>
    </message>
    <message>
        <source>Strips</source>
        <translation>Bandes</translation>
    </message>
    <message>
        <source>Strips welded together</source>
        <translation>Bandes soudées ensemble</translation>
    </message>
    <message>
        <source>Studies on Dask need {0}: install it with pip install {1}, or leave --dask and --scheduler out ({2}).</source>
        <translation>Les études sur Dask demandent {0} : installez-le par pip install {1}, ou omettez --dask et --scheduler ({2}).</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>Such as Tip for PE</source>
        <translation>Par exemple Pointe pour PE</translation>
    </message>
    <message>
        <source>Summa with OPOS (vinyl cutter)</source>
        <translation>Summa avec OPOS (plotter de découpe)</translation>
    </message>
    <message>
        <source>Summa with OPOS XY (vinyl cutter)</source>
        <translation>Summa avec OPOS XY (plotter de découpe)</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>TPU-coated nylon fabric (70 den), 170 g/m²</source>
        <translation>Tissu nylon enduit TPU (70 den), 170 g/m²</translation>
    </message>
    <message>
        <source>Tab to tie it to</source>
        <translation>Languette d'attache</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Attaches</translation>
    </message>
    <message>
        <source>Tabs are left by a machine that cuts: give --machine too, and one that does.</source>
        <translation>Les attaches sont laissées par une machine qui coupe : donnez aussi --machine, et une qui le fait.</translation>
    </message>
    <message>
        <source>Tacked to one panel</source>
        <translation>Fixées à un panneau</translation>
    </message>
    <message>
        <source>Take a colour from the painting, or the picture under it</source>
        <translation>Prendre une couleur de la peinture, ou de l'image dessous</translation>
    </message>
    <message>
        <source>Take a tool to change the seams, or choose one and press Delete to merge.</source>
        <translation>Prenez un outil pour changer les coutures, ou choisissez-en une et appuyez sur Suppr pour fusionner.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Take everything off the paper</source>
        <translation>Tout enlever de la feuille</translation>
    </message>
    <message>
        <source>Take paint off</source>
        <translation>Enlever la peinture</translation>
    </message>
    <message>
        <source>Take seam apart</source>
        <translation>Défaire la couture</translation>
    </message>
    <message>
        <source>Take the last change of a seam back (Ctrl+Z in the 3D view)</source>
        <translation>Annuler le dernier changement d'une couture (Ctrl+Z dans la vue 3D)</translation>
    </message>
    <message>
        <source>Take the numbers of one of FreeCAD's material cards</source>
        <translation>Prendre les nombres d'une fiche de matériau de FreeCAD</translation>
    </message>
    <message>
        <source>Take the picture away</source>
        <translation>Enlever l'image</translation>
    </message>
    <message>
        <source>Take this row</source>
        <translation>Prendre cette ligne</translation>
    </message>
    <message>
        <source>Take what is selected</source>
        <translation>Prendre ce qui est sélectionné</translation>
    </message>
    <message>
        <source>Take {0} gores.</source>
        <translation>Prenez {0} fuseaux.</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Ruban adhésif</translation>
    </message>
    <message>
        <source>Tape along the dashed line, {seal} wide, all the way round.</source>
        <translation>Collez au ruban adhésif le long de la ligne en tirets, sur {seal} de large, tout autour.</translation>
    </message>
    <message>
        <source>Tape along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>Collez au ruban adhésif le long de la ligne en tirets, sur {seal} de large ; laissez l'embouchure du col ouverte.</translation>
    </message>
    <message>
        <source>Taped seam</source>
        <translation>Couture au ruban adhésif</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Corps visé</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>Temperatures need scipy: install it with pip install scipy.</source>
        <translation>Les températures demandent scipy : installez-le par pip install scipy.</translation>
    </message>
    <message>
        <source>Tension field</source>
        <translation>Champ de tension</translation>
    </message>
    <message>
        <source>Test card</source>
        <translation>Carte d'essai</translation>
    </message>
    <message>
        <source>Test card written to {}</source>
        <translation>Carte d'essai écrite dans {}</translation>
    </message>
    <message>
        <source>Test cards</source>
        <translation>Cartes d'essai</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>That of the front</source>
        <translation>Celle du devant</translation>
    </message>
    <message>
        <source>That of the outline</source>
        <translation>Celle du contour</translation>
    </message>
    <message>
        <source>That of the page</source>
        <translation>Celui de la page</translation>
    </message>
    <message>
        <source>That wide</source>
        <translation>Cette largeur</translation>
    </message>
    <message>
        <source>That would take {0} pages: choose larger paper or a smaller balloon.</source>
        <translation>Cela ferait {0} pages : choisissez un papier plus grand ou un ballon plus petit.</translation>
    </message>
    <message>
        <source>The "as_made" of the film {0} cannot be read: delete it from the file.</source>
        <translation>Le « as_made » du film {0} est illisible : effacez-le du fichier.</translation>
    </message>
    <message>
        <source>The 'at' of seam {0} of the list is no list of places. {1}</source>
        <translation>Le 'at' de la couture {0} de la liste n'est pas une liste d'endroits. {1}</translation>
    </message>
    <message>
        <source>The 'cut' of panel '{0}' is neither true nor false. Write one of them.</source>
        <translation>Le 'cut' du panneau « {0} » n'est ni true ni false. Écrivez l'un des deux.</translation>
    </message>
    <message>
        <source>The 'ease' of the JSON file is no part of a length. Give a number from 0 to 1.</source>
        <translation>Le 'ease' du fichier JSON n'est pas une part d'une longueur. Donnez un nombre de 0 à 1.</translation>
    </message>
    <message>
        <source>The 'holes' of panel '{0}' are not a list of loops. {1}</source>
        <translation>Les 'holes' du panneau « {0} » ne sont pas une liste de boucles. {1}</translation>
    </message>
    <message>
        <source>The 'natural_shape' of the JSON file is no length. Give the length of its gores.</source>
        <translation>La 'natural_shape' du fichier JSON n'est pas une longueur. Donnez la longueur de ses fuseaux.</translation>
    </message>
    <message>
        <source>The 'opening' of the JSON file has no panel and point. {0}</source>
        <translation>L''opening' du fichier JSON n'a pas de panneau ni de point. {0}</translation>
    </message>
    <message>
        <source>The 'panels' of seam {0} of the list are no names. {1}</source>
        <translation>Les 'panels' de la couture {0} de la liste ne sont pas des noms. {1}</translation>
    </message>
    <message>
        <source>The 'parts' of the JSON file are not a list of shapes. {0}</source>
        <translation>'parts' du fichier JSON n'est pas une liste de formes. {0}</translation>
    </message>
    <message>
        <source>The 'profile' of the JSON file needs at least two points. {0}</source>
        <translation>Le 'profile' du fichier JSON demande au moins deux points. {0}</translation>
    </message>
    <message>
        <source>The '{0}' of the JSON file are not a list of {1}. {2}</source>
        <translation>'{0}' du fichier JSON n'est pas une liste de {1}. {2}</translation>
    </message>
    <message>
        <source>The '{0}' of the body '{1}' is out of range. Choose {2}.</source>
        <translation>Le '{0}' du corps « {1} » est hors limites. Choisissez {2}.</translation>
    </message>
    <message>
        <source>The 3MF file has more than {0} bodies. Leave one of them in it.</source>
        <translation>Le fichier 3MF a plus de {0} corps. N'y laissez que l'un d'eux.</translation>
    </message>
    <message>
        <source>The 3MF file has no bodies. Save the body as a mesh of triangles.</source>
        <translation>Le fichier 3MF n'a pas de corps. Enregistrez le corps en maillage de triangles.</translation>
    </message>
    <message>
        <source>The 3MF file is damaged ({}). Save it once more.</source>
        <translation>Le fichier 3MF est abîmé ({}). Enregistrez-le à nouveau.</translation>
    </message>
    <message>
        <source>The 3MF file is too large. Simplify the mesh in the program it comes from.</source>
        <translation>Le fichier 3MF est trop grand. Simplifiez le maillage dans le programme d'où il vient.</translation>
    </message>
    <message>
        <source>The DXF file has errors; what could be read was taken from it.</source>
        <translation>Le fichier DXF a des erreurs ; ce qui était lisible en a été pris.</translation>
    </message>
    <message>
        <source>The DXF file {0}; millimetres are assumed.</source>
        <translation>Le fichier DXF {0} ; des millimètres sont supposés.</translation>
    </message>
    <message>
        <source>The G-code turns the tool by {0}. FreeCAD takes that axis for one that turns the work: its 3D view shows the path turned.</source>
        <translation>Le G-code tourne l'outil par {0}. FreeCAD prend cet axe pour un axe qui tourne la pièce usinée : sa vue 3D montre le parcours tourné.</translation>
    </message>
    <message>
        <source>The JSON file cannot be read ({0}). {1}</source>
        <translation>Le fichier JSON est illisible ({0}). {1}</translation>
    </message>
    <message>
        <source>The JSON file does not name its unit; millimetres are assumed.</source>
        <translation>Le fichier JSON ne nomme pas son unité ; des millimètres sont supposés.</translation>
    </message>
    <message>
        <source>The JSON file has no 'outer' loop. {0}</source>
        <translation>Le fichier JSON n'a pas de boucle 'outer'. {0}</translation>
    </message>
    <message>
        <source>The JSON file has no list of 'panels'. {0}</source>
        <translation>Le fichier JSON n'a pas de liste 'panels'. {0}</translation>
    </message>
    <message>
        <source>The JSON file has no list of 'seams'. {0}</source>
        <translation>Le fichier JSON n'a pas de liste 'seams'. {0}</translation>
    </message>
    <message>
        <source>The JSON file has the unknown unit {0}. Use one of {1}.</source>
        <translation>Le fichier JSON a l'unité inconnue {0}. Utilisez l'une de {1}.</translation>
    </message>
    <message>
        <source>The JSON file's {0} needs at least {1}. {2}</source>
        <translation>{0} du fichier JSON demande au moins {1}. {2}</translation>
    </message>
    <message>
        <source>The OBJ file has a face that is no list of points. Save it once more.</source>
        <translation>Le fichier OBJ a une face qui n'est pas une liste de points. Enregistrez-le à nouveau.</translation>
    </message>
    <message>
        <source>The OBJ file has no faces. Save the body as a mesh of triangles.</source>
        <translation>Le fichier OBJ n'a pas de faces. Enregistrez le corps en maillage de triangles.</translation>
    </message>
    <message>
        <source>The PLY file has no faces. Save the body as a mesh of triangles.</source>
        <translation>Le fichier PLY n'a pas de faces. Enregistrez le corps en maillage de triangles.</translation>
    </message>
    <message>
        <source>The PLY file is damaged: {} Save it once more.</source>
        <translation>Le fichier PLY est abîmé : {} Enregistrez-le à nouveau.</translation>
    </message>
    <message>
        <source>The Poisson's ratio {0} is not between 0 and 0.5: give one such as 0.38.</source>
        <translation>Le coefficient de Poisson {0} n'est pas entre 0 et 0,5 : donnez par exemple 0.38.</translation>
    </message>
    <message>
        <source>The Python package {0} is missing. {1} To get it: pip install {2}</source>
        <translation>Le paquet Python {0} manque. {1} Pour l'obtenir : pip install {2}</translation>
    </message>
    <message>
        <source>The STL file is damaged, as it ends too early, or no STL file at all. Save it once more.</source>
        <translation>Le fichier STL est abîmé, car il finit trop tôt, ou n'est pas un fichier STL. Enregistrez-le à nouveau.</translation>
    </message>
    <message>
        <source>The STL file is damaged: it has no triangles, or half of one. Save it once more.</source>
        <translation>Le fichier STL est abîmé : il n'a pas de triangles, ou une moitié d'un seul. Enregistrez-le à nouveau.</translation>
    </message>
    <message>
        <source>The SVG file cannot be read ({0}). Save it as plain SVG once more.</source>
        <translation>Le fichier SVG est illisible ({0}). Enregistrez-le à nouveau en SVG simple.</translation>
    </message>
    <message>
        <source>The SVG file defines entities, which are not read. Save it as plain SVG.</source>
        <translation>Le fichier SVG définit des entités, qui ne sont pas lues. Enregistrez-le en SVG simple.</translation>
    </message>
    <message>
        <source>The SVG file has a '{0}' of endless length. Save it as plain SVG once more.</source>
        <translation>Le fichier SVG a un « {0} » d'une longueur sans fin. Enregistrez-le à nouveau en SVG simple.</translation>
    </message>
    <message>
        <source>The SVG file has too many attributes. Save it as plain SVG once more.</source>
        <translation>Le fichier SVG a trop d'attributs. Enregistrez-le à nouveau en SVG simple.</translation>
    </message>
    <message>
        <source>The SVG file has too many styles. Save it as plain SVG once more.</source>
        <translation>Le fichier SVG a trop de styles. Enregistrez-le à nouveau en SVG simple.</translation>
    </message>
    <message>
        <source>The SVG file is damaged ({0}). Save it once more.</source>
        <translation>Le fichier SVG est abîmé ({0}). Enregistrez-le à nouveau.</translation>
    </message>
    <message>
        <source>The Young's modulus across the grain {0} is too large for one along it of {1}: turn the grain by 90 degrees and exchange the two.</source>
        <translation>Le module d'Young en travers, {0}, est trop grand pour celui en long de {1} : tournez le sens du film de 90 degrés et échangez les deux.</translation>
    </message>
    <message>
        <source>The accuracy decides the number of panels: give one of them.</source>
        <translation>La précision décide du nombre de panneaux : donnez l'un des deux.</translation>
    </message>
    <message>
        <source>The accuracy must be above 0 and below 1: 0.003 is within 0.3 % of the diagonal.</source>
        <translation>La précision doit être au-dessus de 0 et au-dessous de 1 : 0.003, c'est à 0,3 % de la diagonale près.</translation>
    </message>
    <message>
        <source>The accuracy must be above 0 and below 1: 0.01 is within 1 % of the profile.</source>
        <translation>La précision doit être au-dessus de 0 et au-dessous de 1 : 0.01 reste à 1 % du profil.</translation>
    </message>
    <message>
        <source>The altitude {0} m is out of range: give one up to 11000 m.</source>
        <translation>L'altitude {0} m est hors limites : donnez au plus 11000 m.</translation>
    </message>
    <message>
        <source>The axis that turns the wheel or knife along the path, 0 along X, counter-clockwise from above; none for one that swivels or is round</source>
        <translation>L'axe qui tourne la roue ou la lame le long du parcours, 0 selon X, dans le sens inverse des aiguilles vu d'en haut ; aucun pour un outil qui pivote de lui-même ou qui est rond</translation>
    </message>
    <message>
        <source>The bag has no opening through which it is filled. Name the edge at which it stays open, such as edge 1 of panel '{0}', or make it without an intake.</source>
        <translation>Le sac n'a pas d'ouverture par où le remplir. Nommez le bord où il reste ouvert, comme le bord 1 du panneau « {0} », ou faites-le sans embout.</translation>
    </message>
    <message>
        <source>The bag has {0} panels, more than {1}. Make it of fewer, larger ones.</source>
        <translation>Le sac a {0} panneaux, plus que {1}. Faites-le de panneaux moins nombreux et plus grands.</translation>
    </message>
    <message>
        <source>The balloon</source>
        <translation>Le ballon</translation>
    </message>
    <message>
        <source>The balloon has no opening: say at which edge it is filled, or choose no intake.</source>
        <translation>Le ballon n'a pas d'ouverture : dites par quel bord il est rempli, ou ne choisissez pas d'embout.</translation>
    </message>
    <message>
        <source>The balloon has nothing that is called '{0}': {1}.</source>
        <translation>Le ballon n'a rien qui s'appelle « {0} » : {1}.</translation>
    </message>
    <message>
        <source>The balloon has parts too thin to fit the film with: use a wider shape.</source>
        <translation>Le ballon a des parties trop minces pour y ajuster le film : prenez une forme plus large.</translation>
    </message>
    <message>
        <source>The balloon is not near rest. Inflate it anew.</source>
        <translation>Le ballon n'est pas près du repos. Gonflez-le de nouveau.</translation>
    </message>
    <message>
        <source>The balloon is nowhere {0} wide behind its intake: choose another intake angle or a narrower intake, else air enters slowly.</source>
        <translation>Le ballon n'a nulle part {0} de large derrière son embout : choisissez une autre direction ou un embout plus étroit, sinon l'air entre lentement.</translation>
    </message>
    <message>
        <source>The balloon must be thicker than 0, not {0}. Give its thickness.</source>
        <translation>Le ballon doit être plus épais que 0, pas {0}. Donnez son épaisseur.</translation>
    </message>
    <message>
        <source>The balloon of {0} gores is {1} of its diagonal away from the profile on average, and {2} was asked for: its seams stand out by up to {3} over the middle of the gores. {4}</source>
        <translation>Le ballon de {0} fuseaux est en moyenne à {1} de sa diagonale du profil, et {2} était demandé : ses coutures dépassent le milieu des fuseaux jusqu'à {3}. {4}</translation>
    </message>
    <message>
        <source>The balloon stays {0} from the body on average, {1} of its diagonal: flat panels bulge between their seams. Take more than {2} panels.</source>
        <translation>Le ballon reste en moyenne à {0} du corps, {1} de sa diagonale : des panneaux plats se bombent entre leurs coutures. Prenez plus de {2} panneaux.</translation>
    </message>
    <message>
        <source>The balloon whose weld creases did not come to rest; what is told of it is its last good state.</source>
        <translation>Le ballon dont la soudure se froisse n'est pas arrivé au repos ; ce qui en est dit vaut pour son dernier bon état.</translation>
    </message>
    <message>
        <source>The bar of {0} does not fit between marks that are {1} apart: make the balloon larger, or print several beside each other.</source>
        <translation>La barre de {0} ne tient pas entre des repères distants de {1} : agrandissez le ballon, ou imprimez-en plusieurs côte à côte.</translation>
    </message>
    <message>
        <source>The bending floor must be between 0 and 1, not {0}. Usual is {1}.</source>
        <translation>Le plancher de flexion doit être entre 0 et 1, pas {0}. L'usage est {1}.</translation>
    </message>
    <message>
        <source>The bleed must be from 0 to {0}, not {1}.</source>
        <translation>Le fond perdu doit être de 0 à {0}, pas {1}.</translation>
    </message>
    <message>
        <source>The body '{0}' has no '{1}'. It has {2}.</source>
        <translation>Le corps « {0} » n'a pas de '{1}'. Il a {2}.</translation>
    </message>
    <message>
        <source>The body has no plane of symmetry.</source>
        <translation>Le corps n'a pas de plan de symétrie.</translation>
    </message>
    <message>
        <source>The body has no seam. Draw seams, or take 2 panels or more.</source>
        <translation>Le corps n'a pas de couture. Dessinez des coutures, ou prenez au moins 2 panneaux.</translation>
    </message>
    <message>
        <source>The body has no seam. Draw seams, or take 2 panels or more.{0}</source>
        <translation>Le corps n'a pas de couture. Dessinez des coutures, ou prenez au moins 2 panneaux.{0}</translation>
    </message>
    <message>
        <source>The body has nothing near {0}. Give a place on its surface.</source>
        <translation>Le corps n'a rien près de {0}. Donnez un endroit sur sa surface.</translation>
    </message>
    <message>
        <source>The body is thinner than {0} over {1} of its surface: film bulges there. Make such parts of two panels of their own, or thicker.</source>
        <translation>Le corps est plus mince que {0} sur {1} de sa surface : le film s’y bombe. Faire de telles parties en deux panneaux à part, ou plus épaisses.</translation>
    </message>
    <message>
        <source>The body is {0} long. Give a width or a height, so that it is between {1} and {2}.</source>
        <translation>Le corps a {0} de long. Donnez une largeur ou une hauteur, pour qu'il soit entre {1} et {2}.</translation>
    </message>
    <message>
        <source>The body of the mesh is flat: it encloses {0} % of its size. Give a closed body, or a drawing for two equal panels.</source>
        <translation>Le corps du maillage est plat : il enferme {0} % de sa taille. Donnez un corps fermé, ou un dessin pour deux panneaux égaux.</translation>
    </message>
    <message>
        <source>The body of the profile is {0} high and {1} wide: no balloon is so flat. Draw its profile higher, or make it of two panels.</source>
        <translation>Le corps du profil a {0} de haut et {1} de large : aucun ballon n'est si plat. Dessinez son profil plus haut, ou faites-le de deux panneaux.</translation>
    </message>
    <message>
        <source>The camera finds the dots round a print, on the layer Register; the fifth tells how the sheet lies. The layer Register is not cut.</source>
        <translation>La caméra trouve les points autour d'une impression, sur le calque Register ; le cinquième dit comment la feuille est posée. Le calque Register n'est pas coupé.</translation>
    </message>
    <message>
        <source>The caps are too large for the ball. Choose a smaller diameter for them.</source>
        <translation>Les calottes sont trop grandes pour la balle. Choisissez-leur un diamètre plus petit.</translation>
    </message>
    <message>
        <source>The card has no field {0}: choose one of {1}.</source>
        <translation>La carte n'a pas de champ {0} : choisissez parmi {1}.</translation>
    </message>
    <message>
        <source>The cluster cannot be made ({0}): check the file that --cluster names.</source>
        <translation>Le cluster ne peut pas être créé ({0}) : vérifiez le fichier que --cluster indique.</translation>
    </message>
    <message>
        <source>The colour would run out: close the line around this place first.</source>
        <translation>La couleur déborderait : fermez d'abord la ligne autour de cet endroit.</translation>
    </message>
    <message>
        <source>The connection to {0} ended before the whole native solver had come. Try again. {1}</source>
        <translation>La connexion à {0} s'est terminée avant que tout le solveur natif soit arrivé. Réessayez. {1}</translation>
    </message>
    <message>
        <source>The copied picture</source>
        <translation>L'image copiée</translation>
    </message>
    <message>
        <source>The cutter finds the four discs round a print itself. VersaWorks prints discs of its own: give it the PDF for print and cut instead. The layer REGISTRATION is not cut.</source>
        <translation>Le plotter trouve lui-même les quatre disques autour d'une impression. VersaWorks imprime ses propres disques : donnez-lui plutôt le PDF d'impression et de découpe. Le calque REGISTRATION n'est pas coupé.</translation>
    </message>
    <message>
        <source>The cutter finds the squares at both sides of a print itself, on the layer Regmark, which is not cut. Set their size of 3 mm and their distances there, where its program does not read them. Feed the sheet with its lower edge first.</source>
        <translation>Le plotter trouve lui-même les carrés des deux côtés d'une impression, sur le calque Regmark, qui n'est pas coupé. Réglez-y leur taille de 3 mm et leurs distances si son programme ne les lit pas. Engagez la feuille par son bord inférieur.</translation>
    </message>
    <message>
        <source>The drawing cannot be reached everywhere: the silhouette is up to {} off it.</source>
        <translation>Le dessin ne peut pas être atteint partout : la silhouette s'en écarte jusqu'à {}.</translation>
    </message>
    <message>
        <source>The drawing has a curve through more than {0} points. Save it as a polyline.</source>
        <translation>Le dessin a une courbe par plus de {0} points. Enregistrez-la en polyligne.</translation>
    </message>
    <message>
        <source>The drawing has blocks or copies that show themselves. Remove those from it.</source>
        <translation>Le dessin a des blocs ou des copies qui se montrent eux-mêmes. Enlevez-les.</translation>
    </message>
    <message>
        <source>The drawing has more than {0} elements, with those of its blocks and copies. Leave only the outline and its holes in it.</source>
        <translation>Le dessin a plus de {0} éléments, avec ceux de ses blocs et copies. N'y laissez que le contour et ses trous.</translation>
    </message>
    <message>
        <source>The drawing has more than {0} groups or blocks inside each other. Take them apart in the program it comes from.</source>
        <translation>Le dessin a plus de {0} groupes ou blocs les uns dans les autres. Dissociez-les dans le programme d'où il vient.</translation>
    </message>
    <message>
        <source>The drawing has more than {0} points. Simplify it in the program it comes from, or leave only the outline and its holes in it.</source>
        <translation>Le dessin a plus de {0} points. Simplifiez-le dans le programme d'où il vient, ou n'y laissez que le contour et ses trous.</translation>
    </message>
    <message>
        <source>The drawing has no closed line. Draw one, and turn texts and groups into paths.</source>
        <translation>Le dessin n'a pas de ligne fermée. Tracez-en une, et changez textes et groupes en chemins.</translation>
    </message>
    <message>
        <source>The drawing has no line. {0}</source>
        <translation>Le dessin n'a pas de ligne. {0}</translation>
    </message>
    <message>
        <source>The drawing has points more than {0} km from its origin. Move it there, and give it a size between 1 mm and 100 m.</source>
        <translation>Le dessin a des points à plus de {0} km de son origine. Ramenez-le là, et donnez-lui une taille de 1 mm à 100 m.</translation>
    </message>
    <message>
        <source>The drawing has too much text in its styles and transforms. Save it as plain SVG once more.</source>
        <translation>Le dessin a trop de texte dans ses styles et transformations. Enregistrez-le à nouveau en SVG simple.</translation>
    </message>
    <message>
        <source>The drawing has {0} lines beside the axis, not one. {1}</source>
        <translation>Le dessin a {0} lignes à côté de l'axe, et non une. {1}</translation>
    </message>
    <message>
        <source>The drawing has {0} shape and no number {1}: choose another Part, or delete this balloon.</source>
        <translation>Le dessin a {0} forme et pas de numéro {1} : choisissez une autre « Part », ou supprimez ce ballon.</translation>
    </message>
    <message>
        <source>The drawing has {0} shapes and no number {1}: choose another Part, or delete this balloon.</source>
        <translation>Le dessin a {0} formes et pas de numéro {1} : choisissez une autre « Part », ou supprimez ce ballon.</translation>
    </message>
    <message>
        <source>The drawing is open: a line starts at {0} and ends {1} away at {2}. Close it.</source>
        <translation>Le dessin est ouvert : une ligne commence en {0} et finit à {1} de là, en {2}. Fermez-la.</translation>
    </message>
    <message>
        <source>The drawing takes more than {0} s to read. Simplify it in the program it comes from, or leave only the outline and its holes in it.</source>
        <translation>Lire le dessin prend plus de {0} s. Simplifiez-le dans le programme d'où il vient, ou n'y laissez que le contour et ses trous.</translation>
    </message>
    <message>
        <source>The drawing was made symmetric: its halves were {0} apart, the left one was kept.</source>
        <translation>Le dessin a été rendu symétrique : ses moitiés différaient de {0}, la gauche a été gardée.</translation>
    </message>
    <message>
        <source>The drawing would be smaller than {0}: choose a larger lift.</source>
        <translation>Le dessin serait plus petit que {0} : choisissez une portance plus grande.</translation>
    </message>
    <message>
        <source>The drawing; a copy of it travels in the document</source>
        <translation>Le dessin ; une copie en reste dans le document</translation>
    </message>
    <message>
        <source>The edges of the chosen seam are free again</source>
        <translation>Les bords de la couture choisie sont de nouveau libres</translation>
    </message>
    <message>
        <source>The end of a seam cannot be moved alone. Take hold of the seam between its ends.</source>
        <translation>Le bout d'une couture ne peut pas être déplacé seul. Saisissez la couture entre ses bouts.</translation>
    </message>
    <message>
        <source>The error of {0} is of the whole contour: leave "along" out.</source>
        <translation>L'erreur de {0} vaut pour tout le contour : omettez « along ».</translation>
    </message>
    <message>
        <source>The error of {0} is per {1}: write "{2}" or "{3}".</source>
        <translation>L'erreur de {0} est par {1} : écrivez « {2} » ou « {3} ».</translation>
    </message>
    <message>
        <source>The faces of {0} cannot be told from each other in a mesh. Repair the solid, or give a mesh of it.</source>
        <translation>Les faces de {0} ne peuvent pas être distinguées dans un maillage. Réparez le solide, ou donnez-en un maillage.</translation>
    </message>
    <message>
        <source>The field {0} of this card makes no machine: {1}</source>
        <translation>Le champ {0} de cette carte ne fait pas une machine : {1}</translation>
    </message>
    <message>
        <source>The file does not name its unit: the largest size in it, {0}, is taken as metres. Give a width to have another one.</source>
        <translation>Le fichier ne nomme pas son unité : sa plus grande dimension, {0}, est prise en mètres. Donnez une largeur pour en avoir une autre.</translation>
    </message>
    <message>
        <source>The file has no solid that can be read. Save it once more as STEP.</source>
        <translation>Le fichier n'a pas de solide lisible. Enregistrez-le à nouveau en STEP.</translation>
    </message>
    <message>
        <source>The file is XML but no SVG drawing. Choose a drawing.</source>
        <translation>Le fichier est du XML mais pas un dessin SVG. Choisissez un dessin.</translation>
    </message>
    <message>
        <source>The file is damaged or not a DXF file. Save it once more.</source>
        <translation>Le fichier est abîmé ou n'est pas un fichier DXF. Enregistrez-le à nouveau.</translation>
    </message>
    <message>
        <source>The file of gases {0} is of no use: {1}. Install it anew.</source>
        <translation>Le fichier des gaz {0} est inutilisable : {1}. Réinstallez-le.</translation>
    </message>
    <message>
        <source>The file of rules {0} is of no use: {1}. Install it anew.</source>
        <translation>Le fichier des règles {0} est inutilisable : {1}. Réinstallez-le.</translation>
    </message>
    <message>
        <source>The file of the pattern</source>
        <translation>L'export des patrons</translation>
    </message>
    <message>
        <source>The file of what is left of another layout: pieces are laid inside it first</source>
        <translation>Le fichier de ce qui reste d'une autre disposition : les pièces y sont posées d'abord</translation>
    </message>
    <message>
        <source>The file test-card.json that was written with the card</source>
        <translation>Le fichier test-card.json qui a été écrit avec la carte</translation>
    </message>
    <message>
        <source>The file {0} is of no use: {1}. Install it anew.</source>
        <translation>Le fichier {0} est inutilisable : {1}. Réinstallez-le.</translation>
    </message>
    <message>
        <source>The files that it, or its program, opens</source>
        <translation>Les fichiers qu'elle, ou son programme, ouvre</translation>
    </message>
    <message>
        <source>The film '{0}' has no mass. Give its areal density.</source>
        <translation>Le film « {0} » n'a pas de masse. Donnez sa masse surfacique.</translation>
    </message>
    <message>
        <source>The film came to rest</source>
        <translation>Le film est arrivé au repos</translation>
    </message>
    <message>
        <source>The film comes as near as {0} to the body, and a margin of {1} was asked for. Take more panels, or a larger margin.</source>
        <translation>Le film s'approche jusqu'à {0} du corps, alors qu'une marge de {1} est demandée. Prendre plus de panneaux ou une marge plus grande.</translation>
    </message>
    <message>
        <source>The film did not come to rest: its numbers are estimates.</source>
        <translation>Le film n'est pas arrivé au repos : ses nombres sont des estimations.</translation>
    </message>
    <message>
        <source>The film file {0} calls itself "{1}": give both the same name.</source>
        <translation>Le fichier de film {0} se nomme « {1} » : donnez aux deux le même nom.</translation>
    </message>
    <message>
        <source>The film file {0} is of no use: {1}</source>
        <translation>Le fichier de film {0} est inutilisable : {1}</translation>
    </message>
    <message>
        <source>The film file {0} lacks {1}: add it.</source>
        <translation>Il manque {1} au fichier de film {0} : ajoutez-le.</translation>
    </message>
    <message>
        <source>The film folds up and nothing of it is seen from above: make the shape thicker.</source>
        <translation>Le film se replie et rien n'en est visible d'en haut : faites la forme plus épaisse.</translation>
    </message>
    <message>
        <source>The film lies from {0} to {1} outside of the body</source>
        <translation>Le film est de {0} à {1} à l'extérieur du corps</translation>
    </message>
    <message>
        <source>The film needs a width of more than two spacings, and no spacing below 0.</source>
        <translation>Le film doit être plus large que deux espacements, et aucun espacement sous 0.</translation>
    </message>
    <message>
        <source>The film of shop-bought foil balloons: 15 µm oriented nylon 6 with an aluminium coat, 15 µm polyethylene inside. Weld PE to PE. Nylon takes up moisture and is then softer.</source>
        <translation>Le film des ballons du commerce : 15 µm de nylon 6 orienté avec une couche d'aluminium, 15 µm de polyéthylène à l'intérieur. Soudez PE sur PE. Le nylon prend l'humidité et s'assouplit alors.</translation>
    </message>
    <message>
        <source>The film passes through itself near {0}, which the simulation does not feel: the balloon will look otherwise there. Move those parts away from each other.</source>
        <translation>Le film passe à travers lui-même près de {0}, ce que la simulation ne sent pas : le ballon y aura un autre aspect. Éloignez ces parties l'une de l'autre.</translation>
    </message>
    <message>
        <source>The film stays up to {0} away from the profile, even half way between the seams and the middle of the gores: it cannot take this shape. Round the profile where it is flat, hollow or sharp.</source>
        <translation>Le film reste jusqu'à {0} du profil, même à mi-chemin entre les coutures et le milieu des fuseaux : il ne peut pas prendre cette forme. Arrondissez le profil où il est plat, creux ou pointu.</translation>
    </message>
    <message>
        <source>The first {0} of {1} rows, without a balloon: {2}</source>
        <translation>Les {0} premières de {1} lignes, sans ballon : {2}</translation>
    </message>
    <message>
        <source>The first {0} rows; the others are in table.csv.</source>
        <translation>Les {0} premières lignes ; les autres sont dans table.csv.</translation>
    </message>
    <message>
        <source>The folder '{0}' has vanished: bring it back or choose another one, and start the study again.</source>
        <translation>Le dossier « {0} » a disparu : rétablissez-le ou choisissez-en un autre, et relancez l'étude.</translation>
    </message>
    <message>
        <source>The free edition opens DXF, not SVG. Choose "as is" for the size in the import preferences. Silhouette adds the knife's offset and overcut. Nothing is in the file that may not be cut. Studio draws registration marks itself, print them from there; or set page A4, inset 10.01 mm, length 8.38 mm and thickness 0.99 mm there (0.394, 0.33 and 0.039 in) and lay the file's marks on them, not to be cut: a print has the same. Nothing is cut outside them.</source>
        <translation>L'édition gratuite ouvre le DXF, pas le SVG. Choisissez « tel quel » pour la taille dans les préférences d'importation. Silhouette ajoute le décalage de la lame et la surcoupe. Rien dans le fichier n'est à ne pas couper. Studio dessine lui-même les repères, imprimez-les de là ; ou réglez-y page A4, retrait 10.01 mm, longueur 8.38 mm et épaisseur 0.99 mm (0.394, 0.33 et 0.039 pouce), et posez dessus les repères du fichier, sans les couper : une impression a les mêmes. Rien n'est coupé en dehors d'eux.</translation>
    </message>
    <message>
        <source>The goal has {0} combinations to choose from, of which each is tried: list 1 to {1}.</source>
        <translation>Le but a {0} combinaisons au choix, dont chacune est essayée : énumérez-en 1 à {1}.</translation>
    </message>
    <message>
        <source>The goal is no JSON object: write {0}.</source>
        <translation>Le but n'est pas un objet JSON : écrivez {0}.</translation>
    </message>
    <message>
        <source>The grain's angle {0} is no number: give degrees from the x axis.</source>
        <translation>L'angle du sens du film, {0}, n'est pas un nombre : donnez des degrés depuis l'axe x.</translation>
    </message>
    <message>
        <source>The gussets are deeper than the pouch is high. Choose a smaller depth.</source>
        <translation>Les soufflets sont plus profonds que la pochette n'est haute. Choisissez une profondeur plus petite.</translation>
    </message>
    <message>
        <source>The hand beside the shape is as large as a grown-up's</source>
        <translation>La main à côté de la forme a la taille de celle d'un adulte</translation>
    </message>
    <message>
        <source>The hole at {0} is too small for a {1} seal, and its weld reaches {2} into the balloon: make the hole at least {3} wide, or the seal narrower.</source>
        <translation>Le trou en {0} est trop petit pour une soudure de {1}, et elle empiète de {2} sur le ballon : donnez au trou au moins {3} de large, ou rétrécissez la soudure.</translation>
    </message>
    <message>
        <source>The hole at {0} is welded but not cut out: for that, make it wider than two seals with their allowances, {1}.</source>
        <translation>Le trou en {0} est soudé mais pas découpé : pour cela, faites-le plus large que deux soudures avec leurs marges, {1}.</translation>
    </message>
    <message>
        <source>The hole at {0} lies in another hole; remove one of them.</source>
        <translation>Le trou en {0} est dans un autre trou ; enlevez l'un des deux.</translation>
    </message>
    <message>
        <source>The hole at {0} lies outside the outline; move it inside.</source>
        <translation>Le trou en {0} est hors du contour ; ramenez-le à l'intérieur.</translation>
    </message>
    <message>
        <source>The holes of a filled shape stay, the lines of a pen drawing are filled inside</source>
        <translation>Les trous d'une forme pleine restent, les lignes d'un dessin au trait sont remplies à l'intérieur</translation>
    </message>
    <message>
        <source>The inflated outline stays {0} from the drawing on average: film cannot follow this shape everywhere. Round off notches and widen thin parts.</source>
        <translation>Le contour gonflé reste en moyenne à {0} du dessin : le film ne peut pas suivre partout cette forme. Arrondissez les entailles et élargissez les parties minces.</translation>
    </message>
    <message>
        <source>The inflated outline stays {0} from the drawing on average: the balloon folds across a hole or a spot.</source>
        <translation>Le contour gonflé reste en moyenne à {0} du dessin : le ballon se plie en travers d'un trou ou d'un point de soudure.</translation>
    </message>
    <message>
        <source>The intake cannot lead into a hole of panel {0}: say another edge for the opening.</source>
        <translation>L'embout ne peut pas mener dans un trou du panneau {0} : indiquez un autre bord pour l'ouverture.</translation>
    </message>
    <message>
        <source>The intake file {0} calls itself "{1}": give both the same name.</source>
        <translation>Le fichier d'embout {0} se nomme « {1} » : donnez aux deux le même nom.</translation>
    </message>
    <message>
        <source>The intake file {0} is of no use: {1}</source>
        <translation>Le fichier d'embout {0} est inutilisable : {1}</translation>
    </message>
    <message>
        <source>The intake file {0} lacks {1}: add it.</source>
        <translation>Il manque {1} au fichier d'embout {0} : ajoutez-le.</translation>
    </message>
    <message>
        <source>The intake is at the farthest point, on a part that becomes {measured} as thick as the balloon: there it is tied, hangs and is held. A low place carries it better.</source>
        <translation>L'embout est au point le plus éloigné, sur une partie qui n'atteint que {measured} de l'épaisseur du ballon : c'est là qu'on attache, suspend et tient le ballon. Une place en bas le porte mieux.</translation>
    </message>
    <message>
        <source>The intake opens into a part with {percent} of the film; the rest fills through something narrower than the intake. Move it to the largest part.</source>
        <translation>L'embout donne dans une partie qui a {percent} du film ; le reste se remplit par un passage plus étroit que lui. Déplacez-le vers la plus grande partie.</translation>
    </message>
    <message>
        <source>The intake was left out of the comparison.</source>
        <translation>L'embout a été laissé hors de la comparaison.</translation>
    </message>
    <message>
        <source>The intake would run into another part of the balloon: choose another angle or length for it.</source>
        <translation>L'embout heurterait une autre partie du ballon : choisissez un autre angle ou une autre longueur.</translation>
    </message>
    <message>
        <source>The intake's angle must be a number.</source>
        <translation>L'angle de l'embout doit être un nombre.</translation>
    </message>
    <message>
        <source>The intake's direction is of two equal panels: of many, say a seam and how far along it.</source>
        <translation>La direction de l'embout est celle de deux panneaux égaux : pour plusieurs, indiquez une couture et la distance le long d'elle.</translation>
    </message>
    <message>
        <source>The intake's length must be above 0, up to 100 m: give it about 30 mm.</source>
        <translation>La longueur de l'embout doit dépasser 0, jusqu'à 100 m : donnez-lui environ 30 mm.</translation>
    </message>
    <message>
        <source>The intake's place along the seam must be a length.</source>
        <translation>La place de l'embout le long de la couture doit être une longueur.</translation>
    </message>
    <message>
        <source>The intake's place cannot be "{0}": choose {1}.</source>
        <translation>La place de l'embout ne peut pas être « {0} » : choisissez {1}.</translation>
    </message>
    <message>
        <source>The intake's width must be between 0.01 mm and 10 m: give it about 10 mm.</source>
        <translation>La largeur de l'embout doit être entre 0,01 mm et 10 m : donnez-lui environ 10 mm.</translation>
    </message>
    <message>
        <source>The intakes of two chambers run into each other: leave a gap in the weld between them, or choose another place for the first.</source>
        <translation>Les embouts de deux chambres se heurtent : laissez un passage dans la soudure entre elles, ou placez le premier ailleurs.</translation>
    </message>
    <message>
        <source>The label "{0}" is {1} long, and the film is only {2} wide: take a shorter text or lower letters.</source>
        <translation>L'inscription « {0} » fait {1} de long, et le film n'a que {2} de large : prenez un texte plus court ou des lettres plus basses.</translation>
    </message>
    <message>
        <source>The last {length} of this tip stay flat. A radius of {wanted} makes it rounder.</source>
        <translation>Le bout de cette pointe reste plat, sur {length}. Un rayon de {wanted} l'arrondit.</translation>
    </message>
    <message>
        <source>The layer MARK of the machine file {0}.json takes notches only. Rename it NOTCH, and where your machine can draw, add the layers FOLD and PEN.</source>
        <translation>Le calque MARK du fichier de machine {0}.json ne prend que les encoches. Renommez-le NOTCH, et si votre machine peut tracer, ajoutez les calques FOLD et PEN.</translation>
    </message>
    <message>
        <source>The layout failed: give the pieces more room.</source>
        <translation>La disposition a échoué : donnez plus de place aux pièces.</translation>
    </message>
    <message>
        <source>The layout of {0} is older than its patterns: recompute it.</source>
        <translation>La disposition de {0} est plus ancienne que ses patrons : recalculez-la.</translation>
    </message>
    <message>
        <source>The layout on film</source>
        <translation>Le fichier de disposition sur film</translation>
    </message>
    <message>
        <source>The layout was stopped; nothing was changed.</source>
        <translation>La disposition a été arrêtée ; rien n'a changé.</translation>
    </message>
    <message>
        <source>The line at {0} divides no panel.</source>
        <translation>La ligne en {0} ne divise aucun panneau.</translation>
    </message>
    <message>
        <source>The line at {0} misses the body.</source>
        <translation>La ligne en {0} manque le corps.</translation>
    </message>
    <message>
        <source>The lines make up for a kerf of {0} already: leave LightBurn's kerf offset at 0.</source>
        <translation>Les lignes compensent déjà un trait de coupe de {0} : laissez à 0 le décalage du trait de coupe (kerf) de LightBurn.</translation>
    </message>
    <message>
        <source>The lines of the drawing do not close around anything: the outline follows the lines.</source>
        <translation>Les lignes du dessin n'entourent rien : le contour suit les lignes.</translation>
    </message>
    <message>
        <source>The machine file {0} calls itself "{1}": give both the same name.</source>
        <translation>Le fichier de machine {0} se nomme « {1} » : donnez aux deux le même nom.</translation>
    </message>
    <message>
        <source>The machine file {0} is of no use: {1}</source>
        <translation>Le fichier de machine {0} est inutilisable : {1}</translation>
    </message>
    <message>
        <source>The machine file {0} lacks {1}: add it.</source>
        <translation>Il manque {1} au fichier de machine {0} : ajoutez-le.</translation>
    </message>
    <message>
        <source>The machine that finds the print again by its registration marks, printed round it</source>
        <translation>La machine qui retrouve l'impression par les repères imprimés autour</translation>
    </message>
    <message>
        <source>The marks round the print span {0}, and {1} takes at most {2}: make the balloon smaller, or print and cut it on another machine.</source>
        <translation>Les repères autour de l'impression couvrent {0}, et {1} prend au plus {2} : réduisez le ballon, ou imprimez-le et coupez-le sur une autre machine.</translation>
    </message>
    <message>
        <source>The mesh has a triangle with a point that is not there. Save it once more.</source>
        <translation>Le maillage a un triangle avec un point qui n'existe pas. Enregistrez-le à nouveau.</translation>
    </message>
    <message>
        <source>The mesh has a vertex without triangles. Mesh the outline anew.</source>
        <translation>Le maillage a un nœud sans triangle. Remaillez le contour.</translation>
    </message>
    <message>
        <source>The mesh has no triangle. Save the body as a mesh of triangles.</source>
        <translation>Le maillage n'a pas de triangle. Enregistrez le corps en maillage de triangles.</translation>
    </message>
    <message>
        <source>The mesh has too many triangles, more than {0}. Simplify it in the program that it comes from.</source>
        <translation>Le maillage a trop de triangles, plus de {0}. Simplifiez-le dans le programme d'où il vient.</translation>
    </message>
    <message>
        <source>The mesh is flat. Give a closed body, or a drawing for two equal panels.</source>
        <translation>Le maillage est plat. Donnez un corps fermé, ou un dessin pour deux panneaux égaux.</translation>
    </message>
    <message>
        <source>The mesh is not closed: a hole is {0} % of its size long round. Close it in the program that the mesh comes from.</source>
        <translation>Le maillage n'est pas fermé : le tour d'un trou fait {0} % de sa taille. Fermez-le dans le programme d'où vient le maillage.</translation>
    </message>
    <message>
        <source>The mesh size is {0}: give one above 0.</source>
        <translation>La taille de maille est {0} : donnez-en une au-dessus de 0.</translation>
    </message>
    <message>
        <source>The mesh was made simpler. Its triangles were: {0}.</source>
        <translation>Le maillage a été simplifié. Nombre de triangles qu’il avait : {0}.</translation>
    </message>
    <message>
        <source>The moving picture was stopped.</source>
        <translation>L'animation a été arrêtée.</translation>
    </message>
    <message>
        <source>The native solver cannot be saved. {0}</source>
        <translation>Le solveur natif ne peut pas être enregistré. {0}</translation>
    </message>
    <message>
        <source>The native solver could not be fetched from {0} ({1}). Try again when the network is there. {2}</source>
        <translation>Le solveur natif n'a pas pu être téléchargé de {0} ({1}). Réessayez quand le réseau sera là. {2}</translation>
    </message>
    <message>
        <source>The native solver is here already.</source>
        <translation>Le solveur natif est déjà là.</translation>
    </message>
    <message>
        <source>The native solver is in use now.</source>
        <translation>Le solveur natif est maintenant utilisé.</translation>
    </message>
    <message>
        <source>The native solver is not available: {0} Use the NumPy solver.</source>
        <translation>Le solveur natif n'est pas disponible : {0} Utilisez le solveur NumPy.</translation>
    </message>
    <message>
        <source>The native solver is not installed. Everything works without it, but simulations take 20 to 30 times longer. Fetch it now?</source>
        <translation>Le solveur natif n'est pas installé. Tout marche sans lui, mais les simulations prennent 20 à 30 fois plus de temps. Le télécharger maintenant ?</translation>
    </message>
    <message>
        <source>The native solver was fetched, but does not run here: {0}</source>
        <translation>Le solveur natif a été téléchargé, mais ne marche pas ici : {0}</translation>
    </message>
    <message>
        <source>The native solver was not fetched: stopped.</source>
        <translation>Le solveur natif n'a pas été téléchargé : arrêté.</translation>
    </message>
    <message>
        <source>The native solver, which is faster, is not available: {0}</source>
        <translation>Le solveur natif, plus rapide, n'est pas disponible : {0}</translation>
    </message>
    <message>
        <source>The nozzle's flange must be wider than its bore.</source>
        <translation>La collerette de la buse doit être plus large que son alésage.</translation>
    </message>
    <message>
        <source>The number that the controller takes for full power: $30 of GRBL</source>
        <translation>Le nombre que la commande prend pour la pleine puissance : $30 de GRBL</translation>
    </message>
    <message>
        <source>The opening is at point {0} of panel '{1}', whose points are 0 to {2}. Choose one of them.</source>
        <translation>L'ouverture est au point {0} du panneau « {1} », dont les points vont de 0 à {2}. Choisissez l'un d'eux.</translation>
    </message>
    <message>
        <source>The opening is on a panel '{0}' that is not there. {1}</source>
        <translation>L'ouverture est à un panneau « {0} » qui n'existe pas. {1}</translation>
    </message>
    <message>
        <source>The opening is on panel {0}, but there are {1}. Choose one of them.</source>
        <translation>L'ouverture est au panneau {0}, mais il y en a {1}. Choisissez l'un d'eux.</translation>
    </message>
    <message>
        <source>The options cannot be used ({0}). See --help.</source>
        <translation>Les options sont inutilisables ({0}). Voyez --help.</translation>
    </message>
    <message>
        <source>The outline cannot be mirrored about its axis: draw it symmetric, or leave that.</source>
        <translation>Le contour ne peut pas être reflété sur son axe : dessinez-le symétrique, ou laissez cela.</translation>
    </message>
    <message>
        <source>The outline comes to its axis more than once. {0}</source>
        <translation>Le contour vient plus d'une fois à son axe. {0}</translation>
    </message>
    <message>
        <source>The outline crosses or nearly touches itself near {0}: separate the parts that meet there.</source>
        <translation>Le contour se croise ou se touche presque près de {0} : séparez les parties qui s'y rencontrent.</translation>
    </message>
    <message>
        <source>The outline crosses or touches itself and cannot be meshed: separate the parts that meet.</source>
        <translation>Le contour se croise ou se touche et ne peut pas être maillé : séparez les parties qui se rencontrent.</translation>
    </message>
    <message>
        <source>The outline crosses or touches itself and cannot be mirrored; part the lines.</source>
        <translation>Le contour se croise ou se touche et ne peut pas être reflété ; séparez les lignes.</translation>
    </message>
    <message>
        <source>The outline does not pass there any more: delete the edit.</source>
        <translation>Le contour ne passe plus par là : effacez la modification.</translation>
    </message>
    <message>
        <source>The outline encloses no area; draw a closed shape with at least three corners.</source>
        <translation>Le contour n'entoure aucune surface ; tracez une forme fermée d'au moins trois sommets.</translation>
    </message>
    <message>
        <source>The outline has a coordinate that is not a number; correct it in the drawing.</source>
        <translation>Le contour a une coordonnée qui n'est pas un nombre ; corrigez-la dans le dessin.</translation>
    </message>
    <message>
        <source>The outline has no straight upright side on its left, so its axis is missing. {0}</source>
        <translation>Le contour n'a pas de côté droit et vertical à sa gauche, son axe manque donc. {0}</translation>
    </message>
    <message>
        <source>The outline runs another way there: delete the edit.</source>
        <translation>Le contour y passe autrement : effacez la modification.</translation>
    </message>
    <message>
        <source>The outline's {0} of {1} cannot be made; bring it to a size between 1 mm and 100 m.</source>
        <translation>Le contour ne peut pas avoir une {0} de {1} ; amenez-le à une taille entre 1 mm et 100 m.</translation>
    </message>
    <message>
        <source>The page will be in English, as no font here has the letters of your language: install IPAexGothic or Noto Sans CJK JP, and open this panel again.</source>
        <translation>La page sera en anglais, car aucune police n'a ici les caractères de votre langue : installez IPAexGothic ou Noto Sans CJK JP, puis rouvrez ce panneau.</translation>
    </message>
    <message>
        <source>The painting cannot be written to '{}': is the disk full?</source>
        <translation>La peinture ne peut pas être écrite dans « {} » : le disque est-il plein ?</translation>
    </message>
    <message>
        <source>The panels are sealed to {0} bodies. Inflate each by itself.</source>
        <translation>Les panneaux forment {0} corps. Gonflez chacun séparément.</translation>
    </message>
    <message>
        <source>The panels are sealed to {0} bodies: panel '{1}' does not hang together with panel '{2}'. Make a bag of each body.</source>
        <translation>Les panneaux sont soudés en {0} corps : le panneau « {1} » ne tient pas au panneau « {2} ». Faites un sac de chaque corps.</translation>
    </message>
    <message>
        <source>The panels have no names. {0}</source>
        <translation>Les panneaux n'ont pas de noms. {0}</translation>
    </message>
    <message>
        <source>The panels have other points than those that were meshed. Mesh the bag anew.</source>
        <translation>Les panneaux ont d'autres points que ceux du maillage. Maillez le sac à nouveau.</translation>
    </message>
    <message>
        <source>The panels have {0} points, more than {1}. Simplify them in the program that they come from.</source>
        <translation>Les panneaux ont {0} points, plus que {1}. Simplifiez-les dans le programme d'où ils viennent.</translation>
    </message>
    <message>
        <source>The part round {0} has no rim for an intake: leave a gap in the welds round it.</source>
        <translation>La partie autour de {0} n'a pas de bord pour un embout : laissez un passage dans les soudures qui l'entourent.</translation>
    </message>
    <message>
        <source>The pattern becomes too thin for its mesh. Widen the thin parts, or use a finer mesh.</source>
        <translation>Le patron devient trop mince pour son maillage. Élargissez les parties minces, ou prenez un maillage plus fin.</translation>
    </message>
    <message>
        <source>The pattern crosses itself near {0}: simplify the drawing there.</source>
        <translation>Le patron se croise près de {0} : simplifiez-y le dessin.</translation>
    </message>
    <message>
        <source>The pattern has no lines for {0}, which takes {1}: choose another machine.</source>
        <translation>Le patron n'a pas de lignes pour {0}, qui prend {1} : choisissez une autre machine.</translation>
    </message>
    <message>
        <source>The pattern is being fitted to the painting ...</source>
        <translation>Le patron est ajusté à la peinture ...</translation>
    </message>
    <message>
        <source>The pattern measures {0}, the bed of {1} is {2}</source>
        <translation>Le patron mesure {0}, le plateau de {1} {2}</translation>
    </message>
    <message>
        <source>The photograph shows the back: it was mirrored.</source>
        <translation>La photo montre le dos : elle a été mise en miroir.</translation>
    </message>
    <message>
        <source>The photograph shows too many shapes: take one of the balloon alone, on a plain background.</source>
        <translation>La photo montre trop de formes : prenez-en une du ballon seul, sur un fond uni.</translation>
    </message>
    <message>
        <source>The picture has a single colour. Choose one that shows a shape on a background.</source>
        <translation>L'image n'a qu'une couleur. Choisissez-en une qui montre une forme sur un fond.</translation>
    </message>
    <message>
        <source>The picture has no plain background around the shape. Use one with a background of one colour or a transparent one.</source>
        <translation>L'image n'a pas de fond uni autour de la forme. Prenez-en une à fond d'une seule couleur ou transparent.</translation>
    </message>
    <message>
        <source>The picture is empty: all of it is transparent. Choose a picture that shows a shape.</source>
        <translation>L'image est vide : elle est toute transparente. Choisissez-en une qui montre une forme.</translation>
    </message>
    <message>
        <source>The picture is too small to see a shape. Use {0} pixels or more across.</source>
        <translation>L'image est trop petite pour y voir une forme. Prenez au moins {0} pixels de large.</translation>
    </message>
    <message>
        <source>The picture is traced as it is without a choice of yours</source>
        <translation>L'image est tracée comme sans choix de votre part</translation>
    </message>
    <message>
        <source>The picture of a body of gores goes all round: leave out --artwork-back.</source>
        <translation>L'image d'un corps de fuseaux fait tout le tour : retirez --artwork-back.</translation>
    </message>
    <message>
        <source>The picture was read as a pen drawing: the inside of its lines is filled.</source>
        <translation>L'image a été lue comme un dessin au trait : l'intérieur de ses lignes est rempli.</translation>
    </message>
    <message>
        <source>The picture, and all figures as JSON</source>
        <translation>L'image, et tous les chiffres en JSON</translation>
    </message>
    <message>
        <source>The pieces of the intake "{0}" are cut from {1}: they have a file of their own, with all of them for each balloon.</source>
        <translation>Les pièces de l'embout « {0} » se coupent dans {1} : elles ont un fichier à part, avec toutes les pièces pour chaque ballon.</translation>
    </message>
    <message>
        <source>The pieces of the intake "{0}" are of {1}, which does not weld to {2}: choose another intake, or a film that it welds to: {3}.</source>
        <translation>Les pièces de l'embout « {0} » sont en {1}, qui ne se soude pas à {2} : choisissez un autre embout, ou un film auquel cela se soude : {3}.</translation>
    </message>
    <message>
        <source>The place {0} is not on panels {1}, between which the seam lies.</source>
        <translation>L'endroit {0} n'est pas sur les panneaux {1}, entre lesquels se trouve la couture.</translation>
    </message>
    <message>
        <source>The plane through {0} divides no panel.</source>
        <translation>Le plan par {0} ne divise aucun panneau.</translation>
    </message>
    <message>
        <source>The plane through {0} does not meet the body.</source>
        <translation>Le plan par {0} ne rencontre pas le corps.</translation>
    </message>
    <message>
        <source>The plotter finds the marks of a print itself. Set mark type 1 and a size of 10 mm there. The layer REGISTRATION is not cut. The knife's offset belongs into the plotter.</source>
        <translation>Le plotter trouve lui-même les repères d'une impression. Réglez-y le type de repère 1 et une taille de 10 mm. Le calque REGISTRATION n'est pas coupé. Le décalage de la lame se règle dans le plotter.</translation>
    </message>
    <message>
        <source>The plotter finds the marks of a print itself. Set shape 1 and a size of 10 mm there. FineCut takes marks only that it made itself: let it make them in the place of these. The layer REGISTRATION is not cut.</source>
        <translation>Le plotter trouve lui-même les repères d'une impression. Réglez-y la forme 1 et une taille de 10 mm. FineCut ne prend que les repères qu'il a faits lui-même : laissez-le les faire à la place de ceux-ci. Le calque REGISTRATION n'est pas coupé.</translation>
    </message>
    <message>
        <source>The pressure at the lower end must be 0 or more.</source>
        <translation>La pression à l'extrémité basse doit être 0 ou plus.</translation>
    </message>
    <message>
        <source>The pressure must be positive and at most {0}, not {1}. A party balloon has about 2 kPa.</source>
        <translation>La pression doit être positive et d'au plus {0}, pas {1}. Un ballon de fête a environ 2 kPa.</translation>
    </message>
    <message>
        <source>The pressure must grow upwards: give a gradient of 0 or more.</source>
        <translation>La pression doit croître vers le haut : donnez un gradient de 0 ou plus.</translation>
    </message>
    <message>
        <source>The preview picture needs matplotlib: install it with pip install matplotlib.</source>
        <translation>L'image d'aperçu demande matplotlib : installez-le par pip install matplotlib.</translation>
    </message>
    <message>
        <source>The print has {0}, and {1} looks for others: print once more with its marks ({2}).</source>
        <translation>L'impression a {0}, et {1} en cherche d'autres : imprimez à nouveau avec ses repères ({2}).</translation>
    </message>
    <message>
        <source>The print measures {0}, and between the marks of {1} there are {2} on paper of {3}: make the balloon smaller, or give larger paper as page_mm of the marks in a file of your machine.</source>
        <translation>L'impression mesure {0}, et entre les repères de {1} il y a {2} sur un papier de {3} : réduisez le ballon, ou donnez un plus grand papier comme page_mm des repères dans un fichier de votre machine.</translation>
    </message>
    <message>
        <source>The print measures {0}, and {1} takes at most {2}: make the balloon smaller, or print and cut it on another machine.</source>
        <translation>L'impression mesure {0}, et {1} prend au plus {2} : réduisez le ballon, ou imprimez-le et coupez-le sur une autre machine.</translation>
    </message>
    <message>
        <source>The print on film</source>
        <translation>L'impression sur film</translation>
    </message>
    <message>
        <source>The print reaches into the marks of {0}, or comes nearer than {1}: make the balloon smaller, or give larger paper as page_mm of the marks in a file of your machine.</source>
        <translation>L'impression entre dans les repères de {0}, ou en approche à moins de {1} : réduisez le ballon, ou donnez un plus grand papier comme page_mm des repères dans un fichier de votre machine.</translation>
    </message>
    <message>
        <source>The profile crosses or touches itself at {0}. Draw a simple line.</source>
        <translation>Le profil se croise ou se touche à {0}. Dessinez une ligne simple.</translation>
    </message>
    <message>
        <source>The profile goes to the other side of its axis at the height {0}: the radius is {1}. Draw one half only.</source>
        <translation>Le profil passe de l'autre côté de son axe à la hauteur {0} : le rayon est {1}. Dessinez une seule moitié.</translation>
    </message>
    <message>
        <source>The profile has more than {0} points. Simplify it.</source>
        <translation>Le profil a plus de {0} points. Simplifiez-le.</translation>
    </message>
    <message>
        <source>The profile is a closed line that does not run along its axis. Draw one half of the section, from the lower to the upper end.</source>
        <translation>Le profil est une ligne fermée qui ne suit pas son axe. Dessinez une moitié de la coupe, de l'extrémité basse à la haute.</translation>
    </message>
    <message>
        <source>The profile is too slender for a disc of {0} at its {1} end. Let the gores meet in a point there.</source>
        <translation>Le profil est trop mince pour un disque de {0} à son extrémité ({1}). Laissez les fuseaux s'y rejoindre en pointe.</translation>
    </message>
    <message>
        <source>The profile is {0} large. Give it a size between {1} and {2}, and check its unit.</source>
        <translation>Le profil mesure {0}. Donnez-lui une taille entre {1} et {2}, et vérifiez son unité.</translation>
    </message>
    <message>
        <source>The profile lies on its axis. Draw the half outline at a distance from it.</source>
        <translation>Le profil est sur son axe. Dessinez le demi-contour à une distance de lui.</translation>
    </message>
    <message>
        <source>The profile needs at least two points, each a pair of numbers: radius and height.</source>
        <translation>Le profil demande au moins deux points, chacun une paire de nombres : rayon et hauteur.</translation>
    </message>
    <message>
        <source>The profile touches its axis at the height {0}, which parts the balloon in two. Keep it away from the axis there.</source>
        <translation>Le profil touche son axe à la hauteur {0}, ce qui partage le ballon en deux. Écartez-le de l'axe à cet endroit.</translation>
    </message>
    <message>
        <source>The radius of the corner relief must be 0 or above.</source>
        <translation>Le rayon du dégagement d'angle doit être 0 ou plus.</translation>
    </message>
    <message>
        <source>The remnant is of {0} film, and no piece here is cut from that.</source>
        <translation>La chute est en film {0}, et aucune pièce n'y est coupée ici.</translation>
    </message>
    <message>
        <source>The remnant {0} is of no use: {1}</source>
        <translation>La chute {0} est inutilisable : {1}</translation>
    </message>
    <message>
        <source>The remnant {0} lacks {1}: add it.</source>
        <translation>Il manque {1} à la chute {0} : ajoutez-le.</translation>
    </message>
    <message>
        <source>The repair at {0} no longer fits, {1}: take it back or draw that part anew.</source>
        <translation>La réparation en {0} ne convient plus, {1} : annulez-la ou redessinez cette partie.</translation>
    </message>
    <message>
        <source>The rest of the job</source>
        <translation>Le reste</translation>
    </message>
    <message>
        <source>The rim is the width of the weld and of the film beside it: give 0 to 1 m.</source>
        <translation>Le rebord est la largeur de la soudure et du film à côté : donnez de 0 à 1 m.</translation>
    </message>
    <message>
        <source>The row has more cells than there are columns: leave out what is too much.</source>
        <translation>La ligne a plus de cellules qu'il n'y a de colonnes : retirez ce qui est en trop.</translation>
    </message>
    <message>
        <source>The row has no input: give it the name of a drawing.</source>
        <translation>La ligne n'a pas d'entrée : donnez-lui le nom d'un dessin.</translation>
    </message>
    <message>
        <source>The same in all rows</source>
        <translation>Identique dans toutes les lignes</translation>
    </message>
    <message>
        <source>The same length as it is, such as 300 mm</source>
        <translation>La même longueur en vrai, par exemple 300 mm</translation>
    </message>
    <message>
        <source>The scale '{0}' cannot be used: {1}.</source>
        <translation>L'échelle « {0} » est inutilisable : {1}.</translation>
    </message>
    <message>
        <source>The scale of {0} over {1} pixels has no length: mark two points that are far apart, and give the distance between them.</source>
        <translation>L'échelle de {0} sur {1} pixels n'a pas de longueur : marquez deux points éloignés l'un de l'autre, et donnez la distance entre eux.</translation>
    </message>
    <message>
        <source>The scheduler of Dask went away: start it and the study again; nothing is lost.</source>
        <translation>L'ordonnanceur de Dask a disparu : relancez-le, puis l'étude ; rien n'est perdu.</translation>
    </message>
    <message>
        <source>The seal width must be between 0.01 mm and 1 m, the allowance between 0 and 1 m.</source>
        <translation>La largeur de soudure doit être entre 0,01 mm et 1 m, la marge entre 0 et 1 m.</translation>
    </message>
    <message>
        <source>The seam near {0} divides no panel.</source>
        <translation>La couture près de {0} ne divise aucun panneau.</translation>
    </message>
    <message>
        <source>The seam near {0} is one of {1}, not of {2}.</source>
        <translation>La couture près de {0} est à {1}, pas à {2}.</translation>
    </message>
    <message>
        <source>The seam near {0} would divide panels {1}, not {2}.</source>
        <translation>La couture près de {0} diviserait les panneaux {1}, pas {2}.</translation>
    </message>
    <message>
        <source>The seams of {0} gores stand out by up to {1} over their middles. More gores make the body rounder.</source>
        <translation>Les coutures de {0} fuseaux dépassent leurs milieux jusqu'à {1}. Plus de fuseaux rendent le corps plus rond.</translation>
    </message>
    <message>
        <source>The search for a goal asks for a few balloons at a time, of this machine: leave out --scheduler and --dask.</source>
        <translation>La recherche d'un but demande peu de ballons à la fois, à cette machine : omettez --scheduler et --dask.</translation>
    </message>
    <message>
        <source>The search for a goal finds its balloons one after the other: leave out --shard, --script, --dry-run and --collect; what is there already is not made again.</source>
        <translation>La recherche d'un but trouve ses ballons l'un après l'autre : omettez --shard, --script, --dry-run et --collect ; ce qui est déjà là n'est pas refait.</translation>
    </message>
    <message>
        <source>The search for a goal needs scipy: install it with pip install scipy.</source>
        <translation>La recherche d'un but demande scipy : installez-le par pip install scipy.</translation>
    </message>
    <message>
        <source>The search was stopped; what was made stays.</source>
        <translation>La recherche a été arrêtée ; ce qui a été fait reste.</translation>
    </message>
    <message>
        <source>The search with optuna needs its package: install it with pip install optuna, or leave out "search".</source>
        <translation>La recherche avec optuna demande son paquet : installez-le par pip install optuna, ou omettez "search".</translation>
    </message>
    <message>
        <source>The seed is a whole number from 0 up, not {0}.</source>
        <translation>La graine est un nombre entier à partir de 0, pas {0}.</translation>
    </message>
    <message>
        <source>The selected sketches, wires and flat faces become the panels</source>
        <translation>Les esquisses, fils et faces planes sélectionnés deviennent les panneaux</translation>
    </message>
    <message>
        <source>The settings lack "{0}": write {"{1}": {2}} into their file.</source>
        <translation>Il manque « {0} » aux réglages : écrivez {"{1}": {2}} dans leur fichier.</translation>
    </message>
    <message>
        <source>The shape has the colour of a shadow: shadows on the background count as part of it.</source>
        <translation>La forme a la couleur d'une ombre : les ombres sur le fond comptent comme en faisant partie.</translation>
    </message>
    <message>
        <source>The shape in the photograph measures {0}, {1} were expected: check the scale, or whether it is the right photograph.</source>
        <translation>La forme de la photo mesure {0}, {1} étaient attendus : vérifiez l'échelle, ou si c'est la bonne photo.</translation>
    </message>
    <message>
        <source>The shape in the picture is too frayed to trace. Use a clearer picture.</source>
        <translation>La forme de l'image est trop effrangée pour être suivie. Prenez une image plus nette.</translation>
    </message>
    <message>
        <source>The shape is only {0} thick near {1}, too thin for a mesh of {2}: make it thicker there, or use a mesh size of at most {3}.</source>
        <translation>La forme n'a que {0} d'épaisseur près de {1}, trop mince pour un maillage de {2} : épaississez-la là, ou prenez une taille de maille d'au plus {3}.</translation>
    </message>
    <message>
        <source>The shape touches the {0} border of the photograph: take one that shows all of it on a plain background.</source>
        <translation>La forme touche le bord de la photo ({0}) : prenez-en une qui la montre tout entière, sur un fond uni.</translation>
    </message>
    <message>
        <source>The shape touches the {0} border of the picture; if it was cut off there, leave more margin.</source>
        <translation>La forme touche le bord de l'image ({0}) ; si elle y a été coupée, laissez plus de marge.</translation>
    </message>
    <message>
        <source>The side band has no width: give its width, or the thickness of the balloon.</source>
        <translation>La bande latérale n'a pas de largeur : donnez sa largeur, ou l'épaisseur du ballon.</translation>
    </message>
    <message>
        <source>The side band is too wide for this drawing, whose parts are about {0} wide: give it at most {1}.</source>
        <translation>La bande latérale est trop large pour ce dessin, dont les parties ont environ {0} de large : donnez-lui au plus {1}.</translation>
    </message>
    <message>
        <source>The side band must be wider than 0, not {0}. Give it 20 mm or so.</source>
        <translation>La bande latérale doit être plus large que 0, pas {0}. Donnez-lui environ 20 mm.</translation>
    </message>
    <message>
        <source>The side band of {0} leaves nothing of the front, whose widest part is {1} wide: give it at most {2}.</source>
        <translation>La bande latérale de {0} ne laisse rien de l'avant, dont la partie la plus large a {1} : donnez-lui au plus {2}.</translation>
    </message>
    <message>
        <source>The sides of seam {0} are not equally long: {1}, {2}. Make them equally long, or allow them ease.</source>
        <translation>Les côtés de la couture {0} ne sont pas de même longueur : {1}, {2}. Égalisez-les, ou permettez-leur de l'aisance.</translation>
    </message>
    <message>
        <source>The sides of seam {0} are {1} and {2} long. Make them equally long.</source>
        <translation>Les côtés de la soudure {0} mesurent {1} et {2}. Donnez-leur la même longueur.</translation>
    </message>
    <message>
        <source>The simulation cannot take its first step. Check the outline for degenerate parts.</source>
        <translation>La simulation ne peut pas faire son premier pas. Cherchez des parties dégénérées dans le contour.</translation>
    </message>
    <message>
        <source>The simulation did not come to rest; the shape shown is its last good state. Try a coarser mesh.</source>
        <translation>La simulation n'est pas arrivée au repos ; la forme montrée est son dernier bon état. Essayez un maillage plus grossier.</translation>
    </message>
    <message>
        <source>The simulation failed: {0}. Check the outline for degenerate parts.</source>
        <translation>La simulation a échoué : {0}. Cherchez des parties dégénérées dans le contour.</translation>
    </message>
    <message>
        <source>The simulation has no finite start. Check the outline for degenerate parts.</source>
        <translation>La simulation n'a pas de départ fini. Cherchez des parties dégénérées dans le contour.</translation>
    </message>
    <message>
        <source>The simulation was stopped.</source>
        <translation>La simulation a été arrêtée.</translation>
    </message>
    <message>
        <source>The size comes from {0}: make it smaller there, or of more and narrower panels.</source>
        <translation>La taille vient de {0} : réduisez-le là, ou faites-le de panneaux plus nombreux et plus étroits.</translation>
    </message>
    <message>
        <source>The size comes from {0}: make it smaller there.</source>
        <translation>La taille vient de {0} : réduisez-la là.</translation>
    </message>
    <message>
        <source>The size follows from a volume or a lift: choose a smaller one.</source>
        <translation>Un volume ou une portance décide de la taille : choisissez-en moins.</translation>
    </message>
    <message>
        <source>The size of {0} is set by an expression: change the value that it uses.</source>
        <translation>La taille de {0} suit une expression : changez ce à quoi elle se réfère.</translation>
    </message>
    <message>
        <source>The slant of a cone is longer than its radius. Choose a longer slant.</source>
        <translation>La génératrice d'un cône est plus longue que son rayon. Choisissez-en une plus longue.</translation>
    </message>
    <message>
        <source>The smallest radius is {0}, near {1}; {2} follows {3}. It will come out rounder there.</source>
        <translation>Le plus petit rayon est {0}, près de {1} ; {2} suit {3}. Cela sortira plus rond à cet endroit.</translation>
    </message>
    <message>
        <source>The solver '{0}' needs the Python package scipy. Install it or use the native solver.</source>
        <translation>Le solveur « {0} » demande le paquet Python scipy. Installez-le ou utilisez le solveur natif.</translation>
    </message>
    <message>
        <source>The speed of welding must be above 0, and the time for each seam not below it.</source>
        <translation>La vitesse de soudage doit être au-dessus de 0, et la durée pour chaque couture pas au-dessous.</translation>
    </message>
    <message>
        <source>The spread of {0} cannot be {1}: write it with its unit, such as "{2}".</source>
        <translation>La dispersion de {0} ne peut pas être {1} : écrivez-la avec son unité, par exemple « {2} ».</translation>
    </message>
    <message>
        <source>The spread of {0} has "{1}", which is none of {2}.</source>
        <translation>La dispersion de {0} a « {1} », qui n'est aucun de {2}.</translation>
    </message>
    <message>
        <source>The spread of {0} is {1}: give one above 0, or leave it out.</source>
        <translation>La dispersion de {0} est {1} : donnez-en une supérieure à 0, ou omettez-la.</translation>
    </message>
    <message>
        <source>The spread of {0} is {1}: write one {2}.</source>
        <translation>La dispersion de {0} est {1} : écrivez-en une, {2}.</translation>
    </message>
    <message>
        <source>The step of {0} has another unit than its ends: write the same one.</source>
        <translation>Le pas de {0} a une autre unité que ses bornes : écrivez la même.</translation>
    </message>
    <message>
        <source>The strips of valves are not here: lay them out on a sheet of their own, with "Valve film".</source>
        <translation>Les bandes des valves ne sont pas ici : disposez-les sur une feuille à part, avec « Film de valve ».</translation>
    </message>
    <message>
        <source>The study cannot go on ({0}).</source>
        <translation>L'étude ne peut pas continuer ({0}).</translation>
    </message>
    <message>
        <source>The study has no inputs: give it a column 'input' with the names of drawings.</source>
        <translation>L'étude n'a pas d'entrées : donnez-lui une colonne « input » avec les noms de dessins.</translation>
    </message>
    <message>
        <source>The study has no rows.</source>
        <translation>L'étude n'a pas de lignes.</translation>
    </message>
    <message>
        <source>The study has the column {0} twice.</source>
        <translation>L'étude a deux fois la colonne {0}.</translation>
    </message>
    <message>
        <source>The study has {0} rows, more than {1}: take fewer values, or give --most {2} if that is meant.</source>
        <translation>L'étude a {0} lignes, plus que {1} : prenez moins de valeurs, ou donnez --most {2} si c'est voulu.</translation>
    </message>
    <message>
        <source>The study has {0} rows, more than {1}: take fewer values.</source>
        <translation>L'étude a {0} lignes, plus que {1} : prenez moins de valeurs.</translation>
    </message>
    <message>
        <source>The study is no JSON object: begin it with {"vary": ...}.</source>
        <translation>L'étude n'est pas un objet JSON : commencez-la par {"vary": ...}.</translation>
    </message>
    <message>
        <source>The study was stopped.</source>
        <translation>L'étude a été arrêtée.</translation>
    </message>
    <message>
        <source>The summary cannot be shown ({0}); {1}.</source>
        <translation>Le résumé ne peut pas être affiché ({0}) ; {1}.</translation>
    </message>
    <message>
        <source>The surface cannot be laid flat: some of its triangles have no area, or a panel hangs together in a point only. Repair the body, or take another number of panels.</source>
        <translation>La surface ne peut pas être mise à plat : certains de ses triangles n'ont pas d'aire, ou un panneau ne tient qu'en un point. Réparer le corps ou prendre un autre nombre de panneaux.</translation>
    </message>
    <message>
        <source>The surface crosses itself, at ({0}) of the mesh. Film cannot follow it there. Triangles that cross others: {1}.</source>
        <translation>La surface se croise, en ({0}) du maillage. Le film ne peut pas la suivre là. Triangles qui en croisent d'autres : {1}.</translation>
    </message>
    <message>
        <source>The surface of the mesh has no outside, as a Moebius strip. Give the mesh of a solid.</source>
        <translation>La surface du maillage n'a pas d'extérieur, comme un ruban de Möbius. Donnez le maillage d'un solide.</translation>
    </message>
    <message>
        <source>The temperature of the {0}, {1} degrees Celsius, is out of range: give one such as 20C.</source>
        <translation>La température ({0}) de {1} degrés Celsius est hors limites : donnez par exemple 20C.</translation>
    </message>
    <message>
        <source>The test card measures {0}, the bed of {1} is {2}: try fewer values, or say with --bed how large it is.</source>
        <translation>La carte d'essai mesure {0}, le plateau de {1} {2} : essayez moins de valeurs, ou dites avec --bed quelle est sa taille.</translation>
    </message>
    <message>
        <source>The thickness of the balloon decides the width of its side band: give one of them.</source>
        <translation>L'épaisseur du ballon décide de la largeur de sa bande latérale : donnez l'une des deux.</translation>
    </message>
    <message>
        <source>The tie tab at {0} degrees would run into another part: choose another angle.</source>
        <translation>La languette à {0} degrés heurterait une autre partie : choisissez un autre angle.</translation>
    </message>
    <message>
        <source>The valve reaches {0} into the balloon, past the weld at {1}: put the intake where the balloon is longer, or take another one.</source>
        <translation>La valve entre de {0} dans le ballon, au-delà de la soudure en {1} : placez l'embout où le ballon est plus long, ou prenez-en un autre.</translation>
    </message>
    <message>
        <source>The vertices along both sides of seam {0} are up to {1} apart. Put them at equal lengths along it.</source>
        <translation>Les sommets des deux côtés de la soudure {0} sont écartés de {1} au plus. Placez-les à des longueurs égales.</translation>
    </message>
    <message>
        <source>The volume must be positive, not {0}.</source>
        <translation>Le volume doit être positif, pas {0}.</translation>
    </message>
    <message>
        <source>The way from the intake into the balloon narrows to {0}, and the intake is {1} wide: put it where the balloon is wider, else air enters slowly.</source>
        <translation>Le passage de l'embout dans le ballon se resserre à {0}, et l'embout a {1} de large : placez-le où le ballon est plus large, sinon l'air entre lentement.</translation>
    </message>
    <message>
        <source>The weld draws the seam inward by {0}</source>
        <translation>La soudure tire la couture vers l'intérieur, de {0}</translation>
    </message>
    <message>
        <source>The width and the height must be more than 0.</source>
        <translation>La largeur et la hauteur doivent être plus que 0.</translation>
    </message>
    <message>
        <source>The width of the passages must be 0 or above.</source>
        <translation>La largeur des passages doit être 0 ou plus.</translation>
    </message>
    <message>
        <source>The worker on {0}</source>
        <translation>Le worker sur {0}</translation>
    </message>
    <message>
        <source>The worker on {0} cannot work: {1}</source>
        <translation>Le worker sur {0} ne peut pas travailler : {1}</translation>
    </message>
    <message>
        <source>The {0} "{1}" of the material card {2} cannot be read: correct the card.</source>
        <translation>Le {0} « {1} » de la fiche de matériau {2} est illisible : corrigez la fiche.</translation>
    </message>
    <message>
        <source>The {0} bears {1} here with a margin of {2}, and the pressure is {3}. Inflate it to less, or take a stronger film.</source>
        <translation>{0} : supporte ici {1} avec une marge de {2}, et la pression est de {3}. Gonflez moins, ou prenez un film plus solide.</translation>
    </message>
    <message>
        <source>The {0} crosses or touches itself at {1}; part the lines there.</source>
        <translation>Croisement ou contact ({0}) en {1} ; séparez-y les lignes.</translation>
    </message>
    <message>
        <source>The {0} encloses no area; draw a closed shape with at least three corners.</source>
        <translation>Aucune surface entourée ({0}) ; tracez une forme fermée d'au moins trois sommets.</translation>
    </message>
    <message>
        <source>The {0} end of the profile is '{1}'. Use one of {2}.</source>
        <translation>L'extrémité ({0}) du profil est « {1} ». Utilisez l'un de {2}.</translation>
    </message>
    <message>
        <source>The {0} end of the profile is {1} away from the axis, so no gores can meet there in a point. Close it with a disc, or leave it open.</source>
        <translation>L'extrémité ({0}) du profil est à {1} de l'axe, aucun fuseau ne peut donc s'y rejoindre en pointe. Fermez-la par un disque, ou laissez-la ouverte.</translation>
    </message>
    <message>
        <source>The {0} file has a point that is no three numbers. Save it once more.</source>
        <translation>Le fichier {0} a un point qui n'est pas fait de trois nombres. Enregistrez-le à nouveau.</translation>
    </message>
    <message>
        <source>The {0} is {1} mm: give one above 0, for example 300 mm.</source>
        <translation>La dimension ({0}) est de {1} mm : donnez-en une au-dessus de 0, par exemple 300 mm.</translation>
    </message>
    <message>
        <source>The {0} is {1} off its goal: change the goal by as much.</source>
        <translation>Le but ({0}) est manqué de {1} : corrigez-le d'autant.</translation>
    </message>
    <message>
        <source>The {0} is {1}, not between {2} and {3} {4}: give one such as {5}.</source>
        <translation>La valeur ({0}) est {1}, pas entre {2} et {3} {4} : donnez par exemple {5}.</translation>
    </message>
    <message>
        <source>The {0} line crosses itself near {1}: simplify the drawing there.</source>
        <translation>La ligne {0} se croise près de {1} : simplifiez-y le dessin.</translation>
    </message>
    <message>
        <source>The {0} line runs back along itself near {1}: simplify the drawing there.</source>
        <translation>La ligne {0} revient sur elle-même près de {1} : simplifiez-y le dessin.</translation>
    </message>
    <message>
        <source>The {0} line that begins at {1} is open: programs fill, offset and cut closed lines only. Close it.</source>
        <translation>La ligne {0} qui commence en {1} est ouverte : les programmes ne remplissent, décalent et coupent que des lignes fermées. Fermez-la.</translation>
    </message>
    <message>
        <source>The {0} must be between 0 and {1}.</source>
        <translation>{0} doit être entre 0 et {1}.</translation>
    </message>
    <message>
        <source>The {0} of a {1} must be from {2} to {3}.</source>
        <translation>Pour {1}, {0} doit être de {2} à {3}.</translation>
    </message>
    <message>
        <source>The {0} strays by {1} % in sample {2}, which leaves nothing of it: give a smaller spread.</source>
        <translation>Dans l'échantillon {2}, l'écart est de {1} % et ne laisse rien ({0}) : donnez une dispersion plus petite.</translation>
    </message>
    <message>
        <source>Their depth</source>
        <translation>Leur profondeur</translation>
    </message>
    <message>
        <source>There are no panels: choose sketches or flat faces.</source>
        <translation>Il n'y a pas de panneaux : choisissez des esquisses ou des faces planes.</translation>
    </message>
    <message>
        <source>There are seams in the planes of symmetry already.</source>
        <translation>Il y a déjà des coutures dans les plans de symétrie.</translation>
    </message>
    <message>
        <source>There can be 0 to {0} notches, not {1}, with a depth above 0.</source>
        <translation>Il peut y avoir de 0 à {0} encoches, pas {1}, d'une profondeur au-dessus de 0.</translation>
    </message>
    <message>
        <source>There can be 1 to {0} copies, not {1}.</source>
        <translation>Il peut y avoir de 1 à {0} copies, pas {1}.</translation>
    </message>
    <message>
        <source>There is a machine {0} already: give this one another name.</source>
        <translation>Il y a déjà une machine {0} : donnez un autre nom à celle-ci.</translation>
    </message>
    <message>
        <source>There is advice about two equal panels only: of many, the warnings tell.</source>
        <translation>Les conseils ne portent que sur deux panneaux égaux : pour plusieurs, les avertissements le disent.</translation>
    </message>
    <message>
        <source>There is no "{0}" to repair in {1}: see its advice.</source>
        <translation>Il n'y a pas de « {0} » à réparer dans {1} : voyez ses conseils.</translation>
    </message>
    <message>
        <source>There is no column '{0}': {1}.</source>
        <translation>Il n'y a pas de colonne « {0} » : {1}.</translation>
    </message>
    <message>
        <source>There is no file '{0}'. Check the name and the folder.</source>
        <translation>Il n'y a pas de fichier « {0} ». Vérifiez le nom et le dossier.</translation>
    </message>
    <message>
        <source>There is no file {0}, and no such ready body: check the name and the folder.</source>
        <translation>Il n'y a pas de fichier {0}, ni de corps prêt de ce nom : vérifiez le nom et le dossier.</translation>
    </message>
    <message>
        <source>There is no file {0}: check the name and the folder.</source>
        <translation>Il n'y a pas de fichier {0} : vérifiez le nom et le dossier.</translation>
    </message>
    <message>
        <source>There is no file {}: check the name and the folder.</source>
        <translation>Il n'y a pas de fichier {} : vérifiez le nom et le dossier.</translation>
    </message>
    <message>
        <source>There is no film "{0}": choose one of {1}.</source>
        <translation>Il n'y a pas de film « {0} » : choisissez parmi {1}.</translation>
    </message>
    <message>
        <source>There is no gas "{0}": choose one of {1}.</source>
        <translation>Il n'y a pas de gaz « {0} » : choisissez parmi {1}.</translation>
    </message>
    <message>
        <source>There is no hole any more: delete the edit.</source>
        <translation>Il n'y a plus de trou : effacez la modification.</translation>
    </message>
    <message>
        <source>There is no hole at {0}: give a place on its edge.</source>
        <translation>Il n'y a pas de trou en {0} : donnez un endroit sur son bord.</translation>
    </message>
    <message>
        <source>There is no intake "{0}": choose one of {1}.</source>
        <translation>Il n'y a pas d'embout « {0} » : choisissez parmi {1}.</translation>
    </message>
    <message>
        <source>There is no joining "{0}": choose one of {1}.</source>
        <translation>Il n'y a pas d'assemblage « {0} » : choisissez parmi {1}.</translation>
    </message>
    <message>
        <source>There is no language "{0}": choose one of {1}.</source>
        <translation>Il n'y a pas de langue « {0} » : choisissez parmi {1}.</translation>
    </message>
    <message>
        <source>There is no look "{0}": choose one of {1}.</source>
        <translation>Il n'y a pas d'aspect « {0} » : choisissez parmi {1}.</translation>
    </message>
    <message>
        <source>There is no machine "{0}": choose one of {1}, or give a .json file.</source>
        <translation>Il n'y a pas de machine « {0} » : choisissez parmi {1}, ou donnez un fichier .json.</translation>
    </message>
    <message>
        <source>There is no native solver for {0}. {1}</source>
        <translation>Il n'y a pas de solveur natif pour {0}. {1}</translation>
    </message>
    <message>
        <source>There is no native solver to be fetched for this version yet. {0}</source>
        <translation>Il n'y a pas encore de solveur natif à télécharger pour cette version. {0}</translation>
    </message>
    <message>
        <source>There is no node near {0}: add one there.</source>
        <translation>Il n'y a pas de nœud près de {0} : ajoutez-en un là.</translation>
    </message>
    <message>
        <source>There is no outline at {0} degrees from the centre: choose another intake angle.</source>
        <translation>Il n'y a pas de contour à {0} degrés du centre : choisissez un autre angle d'embout.</translation>
    </message>
    <message>
        <source>There is no panel. Give at least one.</source>
        <translation>Il n'y a aucun panneau. Donnez-en au moins un.</translation>
    </message>
    <message>
        <source>There is no paper "{0}" for the assembly sheet: choose A4 or Letter.</source>
        <translation>Il n'y a pas de papier « {0} » pour la fiche de montage : choisissez A4 ou Letter.</translation>
    </message>
    <message>
        <source>There is no paper "{0}": choose A4, A3 or Letter.</source>
        <translation>Il n'y a pas de papier « {0} » : choisissez A4, A3 ou Letter.</translation>
    </message>
    <message>
        <source>There is no picture to paste: copy one first.</source>
        <translation>Il n'y a pas d'image à coller : copiez-en une d'abord.</translation>
    </message>
    <message>
        <source>There is no picture to print: choose one, as the balloon has none of its own.</source>
        <translation>Il n'y a pas d'image à imprimer : choisissez-en une, car le ballon n'en a pas.</translation>
    </message>
    <message>
        <source>There is no picture to print: choose one, as the outline has none of its own.</source>
        <translation>Il n'y a pas d'image à imprimer : choisissez-en une, le contour n'en a pas.</translation>
    </message>
    <message>
        <source>There is no ready body '{0}'. Choose one of {1}.</source>
        <translation>Il n'y a pas de corps prêt « {0} ». Choisissez l'un de {1}.</translation>
    </message>
    <message>
        <source>There is no result '{0}': take {1}.</source>
        <translation>Il n'y a pas de résultat « {0} » : prenez {1}.</translation>
    </message>
    <message>
        <source>There is no room for a flange of {0} in its middle: choose another panel or a smaller one.</source>
        <translation>Il n'y a pas de place en son milieu pour une bride de {0} : choisissez un autre panneau ou une plus petite.</translation>
    </message>
    <message>
        <source>There is no room for a flange of {0} there: choose another place or a smaller one.</source>
        <translation>Il n'y a pas la place d'une collerette de {0} à cet endroit : choisissez une autre place ou une plus petite.</translation>
    </message>
    <message>
        <source>There is no seam between panels {0}.</source>
        <translation>Il n'y a pas de couture entre les panneaux {0}.</translation>
    </message>
    <message>
        <source>There is no seam near {0}.</source>
        <translation>Il n'y a pas de couture près de {0}.</translation>
    </message>
    <message>
        <source>There is no seam {0} for the opening: the seams are 1 to {1}.</source>
        <translation>Il n'y a pas de couture {0} pour l'ouverture : les coutures vont de 1 à {1}.</translation>
    </message>
    <message>
        <source>There is no share {0} of {1}: write one from 1/{2} on.</source>
        <translation>Il n'y a pas de part {0} sur {1} : écrivez-en une à partir de 1/{2}.</translation>
    </message>
    <message>
        <source>There is no sheet {0}: give a number from 1 to {1}.</source>
        <translation>Il n'y a pas de feuille {0} : donnez un numéro de 1 à {1}.</translation>
    </message>
    <message>
        <source>There is no solver named '{0}'. Use 'native', 'numpy' or 'newmark'.</source>
        <translation>Il n'y a pas de solveur nommé « {0} ». Utilisez 'native', 'numpy' ou 'newmark'.</translation>
    </message>
    <message>
        <source>There is no symmetry "{0}": choose one of {1}.</source>
        <translation>Il n'y a pas de symétrie « {0} » : choisissez parmi {1}.</translation>
    </message>
    <message>
        <source>There is nothing to copy: paint something, or select it.</source>
        <translation>Il n'y a rien à copier : peignez quelque chose, ou sélectionnez-le.</translation>
    </message>
    <message>
        <source>There is too little memory for this: take a coarser mesh, or close other programs.</source>
        <translation>Il n'y a pas assez de mémoire pour cela : prenez un maillage plus grossier, ou fermez d'autres programmes.</translation>
    </message>
    <message>
        <source>There is too little memory for this: take a coarser mesh, or close other programs. Details are in '{0}'.</source>
        <translation>Il n'y a pas assez de mémoire pour cela : prenez un maillage plus grossier, ou fermez d'autres programmes. Les détails sont dans « {0} ».</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Thickness of the balloon</source>
        <translation>Épaisseur du ballon</translation>
    </message>
    <message>
        <source>Thickness of the pen ([ thinner, ] thicker)</source>
        <translation>Épaisseur du trait ([ plus fin, ] plus épais)</translation>
    </message>
    <message>
        <source>This Python has no working ctypes module, which SciPy and the native solver need: patterns can be changed and written, but no balloon can be inflated anew. Take another build of FreeCAD or of Python.</source>
        <translation>Ce Python n'a pas de module ctypes qui marche, dont SciPy et le solveur natif ont besoin : les patrons peuvent être modifiés et écrits, mais aucun ballon ne peut être gonflé de nouveau. Prenez une autre version compilée de FreeCAD ou de Python.</translation>
    </message>
    <message>
        <source>This arm is too thin to fill: drawn {width} wide, it becomes {measured} thick. Make it {wanted} wide.</source>
        <translation>Ce bras est trop mince pour se remplir : dessiné large de {width}, il devient épais de {measured}. Faites-le large de {wanted}.</translation>
    </message>
    <message>
        <source>This arm is too thin to fill: {}. Make it {}?</source>
        <translation>Ce bras est trop mince pour se remplir : {}. Le faire large de {} ?</translation>
    </message>
    <message>
        <source>This arm stays much thinner than the rest: drawn {width} wide, it becomes {measured} thick. For a rounder one make it {wanted} wide.</source>
        <translation>Ce bras reste bien plus mince que le reste : dessiné large de {width}, il devient épais de {measured}. Pour l'arrondir, faites-le large de {wanted}.</translation>
    </message>
    <message>
        <source>This balloon has not been worked out yet: start the study again.</source>
        <translation>Ce ballon n'a pas encore été calculé : relancez l'étude.</translation>
    </message>
    <message>
        <source>This balloon holds less than {0} at any pressure that suits its film: {1} at {2}. Change the size of the balloon or the volume.</source>
        <translation>Ce ballon contient moins de {0} à toute pression qui convient à son film : {1} à {2}. Changez la taille du ballon ou le volume.</translation>
    </message>
    <message>
        <source>This balloon holds more than {0} at any pressure that suits its film: {1} at {2}. Change the size of the balloon or the volume.</source>
        <translation>Ce ballon contient plus de {0} à toute pression qui convient à son film : {1} à {2}. Changez la taille du ballon ou le volume.</translation>
    </message>
    <message>
        <source>This cannot be shown ({0}).</source>
        <translation>Cela ne peut pas être affiché ({0}).</translation>
    </message>
    <message>
        <source>This gas is not lighter than the air around, so the balloon never floats: choose another gas or a higher temperature of the gas.</source>
        <translation>Ce gaz n'est pas plus léger que l'air autour, le ballon ne flotte donc jamais : choisissez un autre gaz ou une température du gaz plus élevée.</translation>
    </message>
    <message>
        <source>This gives no whole number: {}</source>
        <translation>Cela ne donne pas de nombre entier : {}</translation>
    </message>
    <message>
        <source>This is a fault of the program, not yours, and its details cannot be written anywhere. Please report it: {0}, {1}.</source>
        <translation>C'est une erreur du programme, pas la vôtre, et ses détails ne peuvent être écrits nulle part. Merci de la signaler : {0}, {1}.</translation>
    </message>
    <message>
        <source>This is a fault of the program, not yours. Its details are in '{0}': please report it with this file.</source>
        <translation>C'est une erreur du programme, pas la vôtre. Ses détails sont dans « {0} » : merci de la signaler avec ce fichier.</translation>
    </message>
    <message>
        <source>This is shape {0} of the {1} in the drawing.</source>
        <translation>C'est la forme {0} des {1} du dessin.</translation>
    </message>
    <message>
        <source>This neck chokes the air: inside it is as wide as a tube of {measured} of film, the intake is {intake}. {behind} of the balloon fill through it. Make it {wanted} wide.</source>
        <translation>Ce col étrangle l'air : l'intérieur vaut un tube de {measured} de film, l'embout fait {intake}. {behind} du ballon se remplissent par lui. Faites-le large de {wanted}.</translation>
    </message>
    <message>
        <source>This neck is too thin to let the air through: {}. Make it {}?</source>
        <translation>Ce col est trop mince pour laisser passer l'air : {}. Le faire large de {} ?</translation>
    </message>
    <message>
        <source>This neck slows the filling: inside it is as wide as a tube of {measured} of film, the intake is {intake}. {behind} of the balloon fill through it. For quicker filling make it {wanted} wide.</source>
        <translation>Ce col ralentit le gonflage : l'intérieur vaut un tube de {measured} de film, l'embout fait {intake}. {behind} du ballon se remplissent par lui. Pour un gonflage plus rapide, faites-le large de {wanted}.</translation>
    </message>
    <message>
        <source>This notch pulls the film {measured} as tight as elsewhere, so that it wrinkles there. A radius of {wanted} eases that.</source>
        <translation>Cette entaille tend le film {measured} plus qu'ailleurs, si bien qu'il s'y plisse. Un rayon de {wanted} atténue cela.</translation>
    </message>
    <message>
        <source>This notch pulls the film {measured} as tight as elsewhere; it wrinkles there and is where it would tear. Round it with a radius of {wanted}.</source>
        <translation>Cette entaille tend le film {measured} plus qu'ailleurs ; il s'y plisse et s'y déchirerait. Arrondissez-la au rayon de {wanted}.</translation>
    </message>
    <message>
        <source>This row is not worked out: choose Work out.</source>
        <translation>Cette ligne n'est pas calculée : choisissez Calculer.</translation>
    </message>
    <message>
        <source>This shape does not tell a stretch of the film from a weld that draws the seam inward: it is either a stretch of {0}, or a weld that draws it inward by {1}.</source>
        <translation>Cette forme ne distingue pas un étirement du film d'une soudure qui tire la couture vers l'intérieur : c'est soit un étirement de {0}, soit une soudure qui la tire vers l'intérieur, de {1}.</translation>
    </message>
    <message>
        <source>This shape stays flat: it holds {percent} of the air that a round balloon of as much film would. Fewer and wider parts make it rounder.</source>
        <translation>Cette forme reste plate : elle contient {percent} de l'air que contiendrait un ballon rond d'autant de film. Des parties moins nombreuses et plus larges l'arrondissent.</translation>
    </message>
    <message>
        <source>This shape stays rather flat: it holds {percent} of the air that a round balloon of as much film would. Fewer and wider parts make it rounder.</source>
        <translation>Cette forme reste assez plate : elle contient {percent} de l'air que contiendrait un ballon rond d'autant de film. Des parties moins nombreuses et plus larges l'arrondissent.</translation>
    </message>
    <message>
        <source>This tip stays flat over {length}: it is too pointed. Round it with a radius of {wanted}.</source>
        <translation>Cette pointe reste plate sur {length} : elle est trop effilée. Arrondissez-la au rayon de {wanted}.</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>Tie a ribbon round the neck, and to it a weight heavier than the {lift} that {gas} lifts. No metallic ribbon on foil, never let it fly.</source>
        <translation>Nouez un ruban autour du col, et à ce ruban un poids plus lourd que les {lift} que porte le gaz ({gas}). Pas de ruban métallique sur un film métallisé, et ne le laissez jamais s'envoler.</translation>
    </message>
    <message>
        <source>Tie a ribbon round the neck, to hang it up or to hold it: it does not float.</source>
        <translation>Nouez un ruban autour du col, pour le suspendre ou le tenir : il ne flotte pas.</translation>
    </message>
    <message>
        <source>Tip that stays flat</source>
        <translation>Pointe qui reste plate</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>To cut, your settings of {cut_machine}: {cut}.</source>
        <translation>Pour couper, vos réglages de {cut_machine} : {cut}.</translation>
    </message>
    <message>
        <source>To let the gas out, cut the seal across the neck off.</source>
        <translation>Pour vider le gaz, coupez la soudure en travers du col.</translation>
    </message>
    <message>
        <source>To let the gas out, push a straw in through the neck until it hisses, and press gently. Keep the balloon flat, not folded: it can be filled again.</source>
        <translation>Pour vider le gaz, glissez une paille par le col jusqu'à ce que cela siffle, et pressez doucement. Gardez le ballon à plat, non plié : il peut être regonflé.</translation>
    </message>
    <message>
        <source>To this value, with its unit</source>
        <translation>À cette valeur, avec son unité</translation>
    </message>
    <message>
        <source>To weld, your settings of {weld_machine}: {weld}.</source>
        <translation>Pour souder, vos réglages de {weld_machine} : {weld}.</translation>
    </message>
    <message>
        <source>Tolerances are worked out for two equal panels of one shape: </source>
        <translation>Les tolérances sont calculées pour deux panneaux égaux d'une seule forme : </translation>
    </message>
    <message>
        <source>Tolerances are worked out for two equal panels, of which one is simulated: leave out --two-panels, and take a drawing.</source>
        <translation>Les tolérances sont calculées pour deux panneaux égaux, dont un est simulé : omettez --two-panels, et prenez un dessin.</translation>
    </message>
    <message>
        <source>Too many samples could not be made to say which pressure 95 of 100 balloons bear.</source>
        <translation>Trop d'échantillons n'ont pas pu être faits pour dire quelle pression 95 ballons sur 100 supportent.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Tool paths</source>
        <translation>Parcours d'outil</translation>
    </message>
    <message>
        <source>Tool paths are not split over beds: write the G-code, or choose a larger bed.</source>
        <translation>Les parcours d'outil ne se répartissent pas sur plusieurs plateaux : écrivez le G-code, ou choisissez un plateau plus grand.</translation>
    </message>
    <message>
        <source>Tool paths, no file</source>
        <translation>Parcours d'outil, pas de fichier</translation>
    </message>
    <message>
        <source>Tracing paper, 92 g/m²</source>
        <translation>Papier calque, 92 g/m²</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparent</translation>
    </message>
    <message>
        <source>Triangle {0} of panel {1} has no area. Mesh the panel anew.</source>
        <translation>Le triangle {0} du panneau {1} n'a pas d'aire. Maillez le panneau de nouveau.</translation>
    </message>
    <message>
        <source>Triangle {0} of panel {1} runs clockwise. Mesh the panel anew.</source>
        <translation>Le triangle {0} du panneau {1} tourne dans le sens horaire. Maillez le panneau de nouveau.</translation>
    </message>
    <message>
        <source>Triangles of the mesh that lay on others were left out: {0}.</source>
        <translation>Triangles du maillage posés sur d'autres, laissés de côté : {0}.</translation>
    </message>
    <message>
        <source>Triangles of the mesh that stood on its surface, or were walls inside it, were left out: {0}.</source>
        <translation>Triangles du maillage dressés sur sa surface, ou cloisons à l'intérieur, laissés de côté : {0}.</translation>
    </message>
    <message>
        <source>Triangles of the mesh that were the wrong way round were turned: {0}.</source>
        <translation>Triangles du maillage qui étaient à l'envers, retournés : {0}.</translation>
    </message>
    <message>
        <source>Triangles of the mesh whose points are no numbers were left out: {0}.</source>
        <translation>Triangles du maillage dont les points ne sont pas des nombres, laissés de côté : {0}.</translation>
    </message>
    <message>
        <source>Triangles that crossed others were cut out, and closed: {0}.</source>
        <translation>Triangles qui en croisaient d'autres, découpés, et les trous refermés : {0}.</translation>
    </message>
    <message>
        <source>True length</source>
        <translation>Vraie longueur</translation>
    </message>
    <message>
        <source>Try temperature and time on two scraps: the weld must stretch or tear before it opens.</source>
        <translation>Essayez température et durée sur deux chutes : la soudure doit s'étirer ou se déchirer avant de s'ouvrir.</translation>
    </message>
    <message>
        <source>Turn piece</source>
        <translation>Tourner la pièce</translation>
    </message>
    <message>
        <source>Turning axis</source>
        <translation>Axe de rotation</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Se rabat</translation>
    </message>
    <message>
        <source>Turns a minute; empty: not known yet</source>
        <translation>Tours par minute ; vide : pas encore connu</translation>
    </message>
    <message>
        <source>Twelve panels that follow a solid: change its sizes in the spreadsheet</source>
        <translation>Douze panneaux qui suivent un solide : changez ses dimensions dans le tableur</translation>
    </message>
    <message>
        <source>Two circles: change their diameters in the sketch</source>
        <translation>Deux cercles : changez leurs diamètres dans l'esquisse</translation>
    </message>
    <message>
        <source>Two equal panels have one seam: what is said of the seam or edge of the opening has no effect. Say the direction of the intake, or its place along the seam.</source>
        <translation>Deux panneaux égaux ont une seule couture : ce qui est dit de la couture ou du bord de l'ouverture n'a pas d'effet. Indiquez la direction de l'embout, ou sa place le long de la couture.</translation>
    </message>
    <message>
        <source>Two equal panels lie flat and have no lower end. Give lift to a standing body.</source>
        <translation>Deux panneaux égaux sont à plat et n'ont pas d'extrémité basse. Donnez de la portance à un corps debout.</translation>
    </message>
    <message>
        <source>Two panels</source>
        <translation>Deux panneaux</translation>
    </message>
    <message>
        <source>Two panels of the JSON file are called '{0}'. Give each a name of its own.</source>
        <translation>Deux panneaux du fichier JSON s'appellent « {0} ». Donnez à chacun son nom.</translation>
    </message>
    <message>
        <source>Two panels with a grain aslant are no mirror images. Turn the grain along x or y.</source>
        <translation>Deux panneaux à sens oblique ne sont pas des images miroir. Tournez le sens du film selon x ou y.</translation>
    </message>
    <message>
        <source>Two shapes meet at {0}; part them, or join them into one.</source>
        <translation>Deux formes se touchent en {0} ; séparez-les, ou joignez-les en une.</translation>
    </message>
    <message>
        <source>Type = for an expression</source>
        <translation>Tapez = pour une expression</translation>
    </message>
    <message>
        <source>Type two places for a cut, such as 10 0 50; 10 20 50, or choose a seam and type one.</source>
        <translation>Tapez deux endroits pour une coupe, comme 10 0 50; 10 20 50, ou choisissez une couture et tapez-en un.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Annuler (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Uniform errors along a seam need scipy: pip install scipy.</source>
        <translation>Des erreurs uniformes le long d'une couture demandent scipy : pip install scipy.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Unit of the numbers in its files</source>
        <translation>Unité des nombres dans ses fichiers</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Inconnu</translation>
    </message>
    <message>
        <source>Upload the SVG as a cut image and compare the control bar: some versions read the size at 72 dpi. Nothing is in the file that may not be cut. It adds the knife's offset and overcut itself. Design Space prints marks of its own (Print Then Cut), round at most 9.25 x 6.75 in: a print has none, and is refused where it is larger. Where yours takes more, raise most_mm in a copy.</source>
        <translation>Chargez le SVG comme image à découper et comparez la barre de contrôle : certaines versions lisent la taille à 72 dpi. Rien dans le fichier n'est à ne pas couper. Le décalage de la lame et la surcoupe sont ajoutés d'office. Design Space imprime ses propres repères (Print Then Cut), autour de 9.25 x 6.75 pouces au plus : une impression n'en a pas, et est refusée si elle est plus grande. Si le vôtre accepte plus, augmentez most_mm dans une copie.</translation>
    </message>
    <message>
        <source>Upper end</source>
        <translation>Extrémité haute</translation>
    </message>
    <message>
        <source>Use it as --machine {0}; in FreeCAD it is among the machines.</source>
        <translation>Utilisez-la avec --machine {0} ; dans FreeCAD elle est parmi les machines.</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Utilisé</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Valve film</source>
        <translation>Film de valve</translation>
    </message>
    <message>
        <source>Valve, on one panel</source>
        <translation>Valve, sur un panneau</translation>
    </message>
    <message>
        <source>Vary</source>
        <translation>Faire varier</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violet foncé</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Volume of the body: {0}, the balloon has {1} of it</source>
        <translation>Volume du corps : {0}, le ballon en a {1}</translation>
    </message>
    <message>
        <source>Warm air</source>
        <translation>Air chaud</translation>
    </message>
    <message>
        <source>Water column</source>
        <translation>Colonne d'eau</translation>
    </message>
    <message>
        <source>Weakest place</source>
        <translation>Point le plus faible</translation>
    </message>
    <message>
        <source>Weakest place: {0} at {1}</source>
        <translation>Point le plus faible : {0} en {1}</translation>
    </message>
    <message>
        <source>Weakest place: {0} at {1}, estimated: the film did not come to rest</source>
        <translation>Point le plus faible : {0} en {1}, estimé : le film n'est pas arrivé au repos</translation>
    </message>
    <message>
        <source>Web page that turns the balloon (HTML)</source>
        <translation>Page web qui tourne le ballon (HTML)</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Weight of film, welds and valve</source>
        <translation>Masse du film, des soudures et de la valve</translation>
    </message>
    <message>
        <source>Weld</source>
        <translation>Soudure</translation>
    </message>
    <message>
        <source>Weld TPU to TPU with an iron or hot air, 10 mm wide. Warp and weft are stiff, the bias is soft: the model takes one modulus for all directions. Stiffer after the first inflations.</source>
        <translation>Soudez TPU sur TPU au fer ou à l'air chaud, sur 10 mm. Chaîne et trame sont raides, le biais est souple : le modèle prend un seul module pour toutes les directions. Plus raide après les premiers gonflages.</translation>
    </message>
    <message>
        <source>Weld across the neck along its line, through panels and strips: the field keeps the channel open. Pull the slip out and blow through the valve.</source>
        <translation>Soudez en travers du col le long de sa ligne, à travers panneaux et bandes : le champ garde le canal ouvert. Retirez le papier cuisson et soufflez par la valve.</translation>
    </message>
    <message>
        <source>Weld along the dashed line, {seal} wide, all the way round.</source>
        <translation>Soudez le long de la ligne en tirets, sur {seal} de large, tout autour.</translation>
    </message>
    <message>
        <source>Weld along the dashed line, {seal} wide. Leave the mouth of the neck open.</source>
        <translation>Soudez le long de la ligne en tirets, sur {seal} de large. Laissez l'embouchure du col ouverte.</translation>
    </message>
    <message>
        <source>Weld and cut</source>
        <translation>Soudure et coupe</translation>
    </message>
    <message>
        <source>Weld overrun</source>
        <translation>Dépassement de soudure</translation>
    </message>
    <message>
        <source>Weld rigidity</source>
        <translation>Rigidité de la soudure</translation>
    </message>
    <message>
        <source>Weld the lines inside the balloon.</source>
        <translation>Soudez les lignes à l'intérieur du ballon.</translation>
    </message>
    <message>
        <source>Weld the two strips together along their lines; over the marked field, heat-resistant ink or a slip of baking paper keeps the channel open. Tack them to one panel, their end at the mouth; then weld round the balloon and across the neck. Fill with a 6 mm tube: the pressure closes the strips.</source>
        <translation>Soudez les deux bandes ensemble le long de leurs lignes ; sur le champ marqué, de l'encre résistant à la chaleur ou un bout de papier cuisson garde le canal ouvert. Fixez-les à un panneau, l'extrémité à l'embouchure ; soudez ensuite autour du ballon et en travers du col. Gonflez avec un tube de 6 mm : la pression ferme les bandes.</translation>
    </message>
    <message>
        <source>Weld with high frequency along the dashed line, {seal} wide, all the way round.</source>
        <translation>Soudez par haute fréquence le long de la ligne en tirets, sur {seal} de large, tout autour.</translation>
    </message>
    <message>
        <source>Weld with high frequency along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>Soudez par haute fréquence le long de la ligne en tirets, sur {seal} de large ; laissez l'embouchure du col ouverte.</translation>
    </message>
    <message>
        <source>Weld: {}</source>
        <translation>Soudure : {}</translation>
    </message>
    <message>
        <source>Welded across, last</source>
        <translation>Soudées en travers, en dernier</translation>
    </message>
    <message>
        <source>Welding</source>
        <translation>Soudage</translation>
    </message>
    <message>
        <source>Welding: {0}</source>
        <translation>Soudage : {0}</translation>
    </message>
    <message>
        <source>Welds easily with an impulse sealer or an iron. Yields at about 9 MPa, half its tensile strength, and creeps: keep the pressure low.</source>
        <translation>Se soude facilement à la soudeuse à impulsion ou au fer. Cède vers 9 MPa, la moitié de sa résistance, et flue : gardez la pression basse.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>What is behind the balloon</source>
        <translation>Ce qui est derrière le ballon</translation>
    </message>
    <message>
        <source>What is cut is a line in the spot colour CutContour, which prints over the picture and leaves no gap in it. With artwork both are in artwork-print-and-cut-pdf.pdf. The shop's program adds marks of its own.</source>
        <translation>Ce qui est coupé est une ligne dans le ton direct CutContour, qui s'imprime sur l'image sans y laisser de vide. Avec une illustration, les deux sont dans artwork-print-and-cut-pdf.pdf. Le programme de l'imprimeur ajoute ses propres repères.</translation>
    </message>
    <message>
        <source>What is left of other film is of one film: choose patterns of one film for it.</source>
        <translation>Les chutes sont d'un seul film : choisissez pour elles des patrons d'un seul film.</translation>
    </message>
    <message>
        <source>What it can work on, such as 600 x 400 mm, or 600 mm for a roll; empty where there is no limit</source>
        <translation>Ce qu'elle peut travailler, par exemple 600 x 400 mm, ou 600 mm pour un rouleau ; vide s'il n'y a pas de limite</translation>
    </message>
    <message>
        <source>What it holds</source>
        <translation>Ce qu'elle porte</translation>
    </message>
    <message>
        <source>What it takes to make it</source>
        <translation>Ce qu'il faut pour le faire</translation>
    </message>
    <message>
        <source>What most shops ask for: R12, closed polylines, nothing on the sheet that is not cut. R12 knows no unit, so the file's name tells it.</source>
        <translation>Ce que demandent la plupart des ateliers : R12, polylignes fermées, rien sur la feuille qui ne soit coupé. R12 ne connaît pas d'unité, le nom du fichier la dit donc.</translation>
    </message>
    <message>
        <source>What shows the balloon</source>
        <translation>Ce qui montre le ballon</translation>
    </message>
    <message>
        <source>What the chosen gas carries besides</source>
        <translation>Ce que le gaz choisi porte en plus</translation>
    </message>
    <message>
        <source>What this film costs, without what is left over</source>
        <translation>Coût de ce film, sans les chutes</translation>
    </message>
    <message>
        <source>What this gas costs</source>
        <translation>Coût de ce gaz</translation>
    </message>
    <message>
        <source>What this machine can work on, such as 600 x 400 mm, or 600 mm for a roll; empty where there is no limit. It is kept for this machine</source>
        <translation>Ce que cette machine peut travailler, par exemple 600 x 400 mm, ou 600 mm pour un rouleau ; vide s'il n'y a pas de limite. C'est gardé pour cette machine</translation>
    </message>
    <message>
        <source>What works here</source>
        <translation>Ce qui marche ici</translation>
    </message>
    <message>
        <source>What you want to read when you choose this machine, such as film and separating layer</source>
        <translation>Ce que vous voulez lire en choisissant cette machine, comme le film et la couche de séparation</translation>
    </message>
    <message>
        <source>What {0} sent is not the native solver of this release: its SHA-256 is another one. It was not kept. {1}</source>
        <translation>Ce que {0} a envoyé n'est pas le solveur natif de cette version : son SHA-256 est différent. Il n'a pas été gardé. {1}</translation>
    </message>
    <message>
        <source>When all shards are done, --collect writes the table.</source>
        <translation>Quand toutes les parts sont faites, --collect écrit le tableau.</translation>
    </message>
    <message>
        <source>Where an edge is cut into tabs, turn it round the other one tab by tab while you seal.</source>
        <translation>Où un bord est découpé en languettes, rabattez-le autour de l'autre languette par languette en soudant.</translation>
    </message>
    <message>
        <source>Where the film wrinkles</source>
        <translation>Où le film se plisse</translation>
    </message>
    <message>
        <source>Whether the {0} of the intake's pieces welds to {1} is not known: try it on a scrap first.</source>
        <translation>On ne sait pas si {0}, la matière des pièces de l'embout, se soude à {1} : essayez d'abord sur une chute.</translation>
    </message>
    <message>
        <source>While this is pressed, the edge that you pick is where it is filled</source>
        <translation>Tant que ce bouton est enfoncé, le bord choisi est celui par où il est rempli</translation>
    </message>
    <message>
        <source>While this is pressed, the ring in the 3D view moves the intake</source>
        <translation>Tant que ceci est enfoncé, l'anneau de la vue 3D déplace l'embout</translation>
    </message>
    <message>
        <source>While this is pressed, what you select becomes the source</source>
        <translation>Tant que ceci est enfoncé, ce que vous sélectionnez devient la source</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanc</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Width hidden in wrinkles</source>
        <translation>Largeur cachée dans les plis</translation>
    </message>
    <message>
        <source>Width of film that the beam or cutter takes away: cuts are moved outward by half of it</source>
        <translation>Largeur de film que le faisceau ou la découpeuse enlève : les coupes sont décalées de la moitié vers l'extérieur</translation>
    </message>
    <message>
        <source>Width of the balloon when it is inflated</source>
        <translation>Largeur du ballon une fois gonflé</translation>
    </message>
    <message>
        <source>Will it float?</source>
        <translation>Flottera-t-il ?</translation>
    </message>
    <message>
        <source>Will it float? {0}</source>
        <translation>Flottera-t-il ? {0}</translation>
    </message>
    <message>
        <source>With --scale {0} the size tells nothing of the film: give the photograph's scale to fit it.</source>
        <translation>Avec --scale {0}, la taille ne dit rien du film : donnez l'échelle de la photo pour l'ajuster.</translation>
    </message>
    <message>
        <source>With a side band the balloon of this drawing becomes {0} to {1} thick, not {2}. Choose a thickness between, or draw its parts wider or narrower.</source>
        <translation>Avec une bande latérale, le ballon de ce dessin aura de {0} à {1} d'épaisseur, pas {2}. Choisissez une épaisseur entre les deux, ou dessinez ses parties plus larges ou plus étroites.</translation>
    </message>
    <message>
        <source>With so few samples, {0}, nobody can say which pressure 95 of 100 balloons bear: take {1} or more.</source>
        <translation>{0} échantillons sont trop peu pour dire quelle pression 95 ballons sur 100 supportent : prenez-en {1} ou plus.</translation>
    </message>
    <message>
        <source>With the fonts of this computer {0} cannot be drawn, letter by letter from left to right: leave that out of the label, or install a font that has it and start again.</source>
        <translation>Avec les polices de cet ordinateur, {0} ne peut pas être tracé, lettre par lettre de gauche à droite : omettez-le dans l'inscription, ou installez une police qui l'a et redémarrez.</translation>
    </message>
    <message>
        <source>With {0} panels some would cross themselves when laid flat: the body has {1}.</source>
        <translation>Avec {0} panneaux, certains se croiseraient une fois mis à plat : le corps en a {1}.</translation>
    </message>
    <message>
        <source>With {0} to {1} panels some would cross themselves when laid flat: give more panels.</source>
        <translation>Avec {0} à {1} panneaux, certains se croiseraient une fois mis à plat : donnez plus de panneaux.</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>À moins de</translation>
    </message>
    <message>
        <source>Without this seam panel {0} goes round the body and cannot be laid flat.</source>
        <translation>Sans cette couture, le panneau {0} fait le tour du corps et ne peut pas être mis à plat.</translation>
    </message>
    <message>
        <source>Work out</source>
        <translation>Calculer</translation>
    </message>
    <message>
        <source>Work out how near balloons of 6 to 60 panels come to the body</source>
        <translation>Calculer à quel point des ballons de 6 à 60 panneaux s'approchent du corps</translation>
    </message>
    <message>
        <source>Wrinkles</source>
        <translation>Plis</translation>
    </message>
    <message>
        <source>Write all results for ParaView (.vtu) or NumPy (.npz), or the shape alone (.stl)</source>
        <translation>Écrire tous les résultats pour ParaView (.vtu) ou NumPy (.npz), ou la forme seule (.stl)</translation>
    </message>
    <message>
        <source>Write anyway</source>
        <translation>Écrire quand même</translation>
    </message>
    <message>
        <source>Write files…</source>
        <translation>Écrire les fichiers…</translation>
    </message>
    <message>
        <source>Write several files, each as large as the bed. Crosses in waste film tell how the film is laid on anew for the next one</source>
        <translation>Écrire plusieurs fichiers, chacun grand comme le plateau. Des croix dans le film perdu disent comment reposer le film pour le suivant</translation>
    </message>
    <message>
        <source>Write the file although it is larger than the bed</source>
        <translation>Écrire le fichier bien qu'il soit plus grand que le plateau</translation>
    </message>
    <message>
        <source>Write the pieces as they lie, and the artwork if it is shown, to a PDF in real size</source>
        <translation>Écrire les pièces comme elles sont posées, avec l'illustration si elle est montrée, dans un PDF en taille réelle</translation>
    </message>
    <message>
        <source>Write these frames as a moving picture, with the artwork, on white</source>
        <translation>Écrire ces images en animation, avec l'impression, sur fond blanc</translation>
    </message>
    <message>
        <source>Write what is left of the film to a file, for another layout</source>
        <translation>Écrire ce qui reste du film dans un fichier, pour une autre disposition</translation>
    </message>
    <message>
        <source>Write {"a": ["top", 0, 1], "b": ["side", 3, 2]}.</source>
        <translation>Écrivez {"a": ["top", 0, 1], "b": ["side", 3, 2]}.</translation>
    </message>
    <message>
        <source>Write {"do": "add", "at": [[0.3, 0.5]]}.</source>
        <translation>Écrivez {"do": "add", "at": [[0.3, 0.5]]}.</translation>
    </message>
    <message>
        <source>Write {"do": "cut", "at": [[0, 0, 50], [100, 0, 20]]}.</source>
        <translation>Écrivez {"do": "cut", "at": [[0, 0, 50], [100, 0, 20]]}.</translation>
    </message>
    <message>
        <source>Write {"name": "top", "outer": [[0, 0], [300, 0], [150, 200]]}.</source>
        <translation>Écrivez {"name": "top", "outer": [[0, 0], [300, 0], [150, 200]]}.</translation>
    </message>
    <message>
        <source>Write {"panel": "side", "at": 2}.</source>
        <translation>Écrivez {"panel": "side", "at": 2}.</translation>
    </message>
    <message>
        <source>Write {"unit": "mm", "outer": [[0, 0], [300, 0], [150, 200]]}.</source>
        <translation>Écrivez {"unit": "mm", "outer": [[0, 0], [300, 0], [150, 200]]}.</translation>
    </message>
    <message>
        <source>Write {"unit": "mm", "profile": [[0, 0], [150, 200], [0, 400]]}.</source>
        <translation>Écrivez {"unit": "mm", "profile": [[0, 0], [150, 200], [0, 400]]}.</translation>
    </message>
    <message>
        <source>Writing DXF needs ezdxf: install it with pip install ezdxf, or use the SVG file.</source>
        <translation>Écrire du DXF demande ezdxf : installez-le par pip install ezdxf, ou prenez le fichier SVG.</translation>
    </message>
    <message>
        <source>Writing PDF needs matplotlib: install it with pip install matplotlib, or use the SVG file.</source>
        <translation>L'écriture de PDF a besoin de matplotlib : installez-le avec pip install matplotlib, ou prenez le fichier SVG.</translation>
    </message>
    <message>
        <source>Writing the test card</source>
        <translation>Écriture de la carte d'essai</translation>
    </message>
    <message>
        <source>Writing {0}</source>
        <translation>Écriture de {0}</translation>
    </message>
    <message>
        <source>Written to {}</source>
        <translation>Écrit dans {}</translation>
    </message>
    <message>
        <source>Written to {}, in real size on {}: print it at 100 %.</source>
        <translation>Écrit dans {}, en taille réelle sur {} : imprimez à 100 %.</translation>
    </message>
    <message>
        <source>Wrote {0}</source>
        <translation>{0} écrit</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Jaune</translation>
    </message>
    <message>
        <source>You paint on: {}</source>
        <translation>Vous peignez sur : {}</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>Module d'Young</translation>
    </message>
    <message>
        <source>Young's modulus across the grain</source>
        <translation>Module d'Young en travers du film</translation>
    </message>
    <message>
        <source>Young's modulus of the film</source>
        <translation>Module d'Young du film</translation>
    </message>
    <message>
        <source>Zünd Cut Center (flat bed)</source>
        <translation>Zünd Cut Center (table à plat)</translation>
    </message>
    <message>
        <source>["200mm", "300mm"], {"linspace": ["1kPa", "3kPa", 5]} with how many, {"range": [6, 12, 2]} with the step, {"between": ["1kPa", "3kPa"]} for samples, or {"glob": "drawings/*.png"}</source>
        <translation>["200mm", "300mm"], {"linspace": ["1kPa", "3kPa", 5]} avec le nombre, {"range": [6, 12, 2]} avec le pas, {"between": ["1kPa", "3kPa"]} pour des échantillons, ou {"glob": "drawings/*.png"}</translation>
    </message>
    <message>
        <source>a LightBurn project has layers up to {0}: change the pen.</source>
        <translation>un projet LightBurn a des calques jusqu'à {0} : changez la plume.</translation>
    </message>
    <message>
        <source>a body consists of itself, or of one that is not there</source>
        <translation>un corps est fait de lui-même, ou d'un corps qui n'existe pas</translation>
    </message>
    <message>
        <source>a body hangs together</source>
        <translation>un corps est d'un seul tenant</translation>
    </message>
    <message>
        <source>a comma, quote or bracket is missing or too much in line {0}</source>
        <translation>à la ligne {0}, une virgule, un guillemet ou une parenthèse manque ou est de trop</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>une coordonnée n'est pas un nombre</translation>
    </message>
    <message>
        <source>a density</source>
        <translation>une masse volumique</translation>
    </message>
    <message>
        <source>a face is no list of points.</source>
        <translation>une face n'est pas une liste de points.</translation>
    </message>
    <message>
        <source>a force</source>
        <translation>une force</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>une longueur</translation>
    </message>
    <message>
        <source>a loop is no list of at least three points [x, y].</source>
        <translation>une boucle n'est pas une liste d'au moins trois points [x, y].</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>une masse</translation>
    </message>
    <message>
        <source>a number without a unit</source>
        <translation>un nombre sans unité</translation>
    </message>
    <message>
        <source>a point is no three numbers.</source>
        <translation>un point n'est pas fait de trois nombres.</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>une pression</translation>
    </message>
    <message>
        <source>a sleeve has an end</source>
        <translation>un manchon a un bout</translation>
    </message>
    <message>
        <source>a temperature</source>
        <translation>une température</translation>
    </message>
    <message>
        <source>a transform is not a number</source>
        <translation>une transformation n'est pas un nombre</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>un volume</translation>
    </message>
    <message>
        <source>a {0} file has a unit of its own: give "unit": "mm".</source>
        <translation>un fichier {0} a sa propre unité : donnez "unit": "mm".</translation>
    </message>
    <message>
        <source>about {}</source>
        <translation>env. {}</translation>
    </message>
    <message>
        <source>about {} x {}, {} thick, {}</source>
        <translation>environ {} x {}, épais de {}, {}</translation>
    </message>
    <message>
        <source>air</source>
        <translation>air</translation>
    </message>
    <message>
        <source>all files were written before to {0}</source>
        <translation>tous les fichiers étaient déjà écrits dans {0}</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>un angle</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>une aire</translation>
    </message>
    <message>
        <source>another run has been writing there for a minute</source>
        <translation>une autre exécution y écrit depuis une minute</translation>
    </message>
    <message>
        <source>another unit</source>
        <translation>une autre unité</translation>
    </message>
    <message>
        <source>any accuracy</source>
        <translation>précision quelconque</translation>
    </message>
    <message>
        <source>apart {} in the mean, 95 % below {}, at most {}</source>
        <translation>écart moyen {}, 95 % sous {}, au plus {}</translation>
    </message>
    <message>
        <source>areal density</source>
        <translation>masse surfacique</translation>
    </message>
    <message>
        <source>artwork.pdf was left out. {0}</source>
        <translation>artwork.pdf a été omis. {0}</translation>
    </message>
    <message>
        <source>as made is larger</source>
        <translation>réalisé plus grand</translation>
    </message>
    <message>
        <source>as made is smaller</source>
        <translation>réalisé plus petit</translation>
    </message>
    <message>
        <source>at most </source>
        <translation>au plus </translation>
    </message>
    <message>
        <source>at most {0}</source>
        <translation>au plus {0}</translation>
    </message>
    <message>
        <source>at most {} ({})</source>
        <translation>au plus {} ({})</translation>
    </message>
    <message>
        <source>at most {} {}</source>
        <translation>au plus {} {}</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>back</source>
        <translation>dos</translation>
    </message>
    <message>
        <source>baking paper</source>
        <translation>papier cuisson</translation>
    </message>
    <message>
        <source>balloon {0} of {1}</source>
        <translation>ballon {0} sur {1}</translation>
    </message>
    <message>
        <source>balloon {0} of {1} at most</source>
        <translation>ballon {0} sur {1} au plus</translation>
    </message>
    <message>
        <source>balloon {0} of {1}, {2}</source>
        <translation>ballon {0} sur {1}, {2}</translation>
    </message>
    <message>
        <source>balloons</source>
        <translation>ballons</translation>
    </message>
    <message>
        <source>bar or iron {0}</source>
        <translation>barre ou fer {0}</translation>
    </message>
    <message>
        <source>bed_mm is {0}: give [width, height], [width, null] for a roll, or null where there is no limit.</source>
        <translation>bed_mm est {0} : donnez [width, height], [width, null] pour un rouleau, ou null s'il n'y a pas de limite.</translation>
    </message>
    <message>
        <source>both lie on borders of one piece</source>
        <translation>les deux sont sur des bords d'une même pièce</translation>
    </message>
    <message>
        <source>choose Drawn as filled shape</source>
        <translation>mettez « Dessiné comme » sur « Forme pleine »</translation>
    </message>
    <message>
        <source>colour index {0} and pen {1} of {2} must be from 1 to 255.</source>
        <translation>l'indice de couleur {0} et la plume {1} de {2} doivent être de 1 à 255.</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>connexion</translation>
    </message>
    <message>
        <source>crosses for the eye</source>
        <translation>croix pour l'œil</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>coupe</translation>
    </message>
    <message>
        <source>cut inside</source>
        <translation>coupe intérieure</translation>
    </message>
    <message>
        <source>cutting error</source>
        <translation>erreur de coupe</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>profondeur</translation>
    </message>
    <message>
        <source>designing a balloon</source>
        <translation>conception d'un ballon</translation>
    </message>
    <message>
        <source>does not name its unit</source>
        <translation>ne nomme pas son unité</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>dessin</translation>
    </message>
    <message>
        <source>drawn mark</source>
        <translation>repère tracé</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>temporisation</translation>
    </message>
    <message>
        <source>edge {0} of {1}panel '{2}'</source>
        <translation>bord {0} du {1}panneau « {2} »</translation>
    </message>
    <message>
        <source>edges {0} to {1}</source>
        <translation>bords {0} à {1}</translation>
    </message>
    <message>
        <source>empty: </source>
        <translation>vide : </translation>
    </message>
    <message>
        <source>feed</source>
        <translation>avance</translation>
    </message>
    <message>
        <source>feed in corners</source>
        <translation>avance dans les coins</translation>
    </message>
    <message>
        <source>fetch the native solver from the network, where the workbench came without it</source>
        <translation>télécharger le solveur natif par le réseau, là où l'atelier est arrivé sans lui</translation>
    </message>
    <message>
        <source>fetching</source>
        <translation>téléchargement</translation>
    </message>
    <message>
        <source>few panels</source>
        <translation>peu de panneaux</translation>
    </message>
    <message>
        <source>film</source>
        <translation>film</translation>
    </message>
    <message>
        <source>film and valve weigh {0}</source>
        <translation>film et valve pèsent {0}</translation>
    </message>
    <message>
        <source>fitted to {0}</source>
        <translation>ajusté à {0}</translation>
    </message>
    <message>
        <source>fold</source>
        <translation>pli</translation>
    </message>
    <message>
        <source>front</source>
        <translation>devant</translation>
    </message>
    <message>
        <source>gas</source>
        <translation>gaz</translation>
    </message>
    <message>
        <source>given by the user</source>
        <translation>donné par l'utilisateur</translation>
    </message>
    <message>
        <source>glued seam</source>
        <translation>couture collée</translation>
    </message>
    <message>
        <source>glued seam inside</source>
        <translation>couture collée intérieure</translation>
    </message>
    <message>
        <source>grain at {}°</source>
        <translation>sens du film à {}°</translation>
    </message>
    <message>
        <source>height</source>
        <translation>hauteur</translation>
    </message>
    <message>
        <source>helium</source>
        <translation>hélium</translation>
    </message>
    <message>
        <source>hide {} of the film's width</source>
        <translation>cachent {} de la largeur du film</translation>
    </message>
    <message>
        <source>hint</source>
        <translation>indication</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>trou</translation>
    </message>
    <message>
        <source>hole {0} of panel '{1}'</source>
        <translation>trou {0} du panneau « {1} »</translation>
    </message>
    <message>
        <source>hot tip</source>
        <translation>pointe chaude</translation>
    </message>
    <message>
        <source>hot tip at {0}</source>
        <translation>pointe chaude à {0}</translation>
    </message>
    <message>
        <source>hot wheel</source>
        <translation>roue chaude</translation>
    </message>
    <message>
        <source>hydrogen</source>
        <translation>hydrogène</translation>
    </message>
    <message>
        <source>if the weld creases: {0}</source>
        <translation>si la soudure se froisse : {0}</translation>
    </message>
    <message>
        <source>in both sides of seam {0}</source>
        <translation>des deux côtés de la couture {0}</translation>
    </message>
    <message>
        <source>in seams {0} and {1}</source>
        <translation>dans les coutures {0} et {1}</translation>
    </message>
    <message>
        <source>in the mean {}</source>
        <translation>en moyenne {}</translation>
    </message>
    <message>
        <source>in the mean {} ({})</source>
        <translation>en moyenne {} ({})</translation>
    </message>
    <message>
        <source>in the mean {}, 95 % below {}, at most {}</source>
        <translation>en moyenne {}, 95 % sous {}, au plus {}</translation>
    </message>
    <message>
        <source>in {}</source>
        <translation>dans {}</translation>
    </message>
    <message>
        <source>inflated</source>
        <translation>gonflé</translation>
    </message>
    <message>
        <source>inflated {0}, {1}</source>
        <translation>gonflé {0}, {1}</translation>
    </message>
    <message>
        <source>inflating</source>
        <translation>gonflage</translation>
    </message>
    <message>
        <source>inflating in time</source>
        <translation>gonflage dans le temps</translation>
    </message>
    <message>
        <source>intake piece {0}</source>
        <translation>pièce d'embout {0}</translation>
    </message>
    <message>
        <source>it ends too early.</source>
        <translation>il finit trop tôt.</translation>
    </message>
    <message>
        <source>it has {0} shapes: give 1 to {1}.</source>
        <translation>elle a {0} formes : donnez de 1 à {1}.</translation>
    </message>
    <message>
        <source>it is nested too deeply</source>
        <translation>il est imbriqué trop profondément</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>ce n'est pas un fichier</translation>
    </message>
    <message>
        <source>it is thinner than any film. Make it wider.</source>
        <translation>il est plus mince que tout film. Élargissez-le.</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>il est trop gros</translation>
    </message>
    <message>
        <source>it would grow together with another part</source>
        <translation>elle se joindrait à une autre partie</translation>
    </message>
    <message>
        <source>its header cannot be understood.</source>
        <translation>son en-tête ne peut pas être compris.</translation>
    </message>
    <message>
        <source>its header has no end.</source>
        <translation>son en-tête n'a pas de fin.</translation>
    </message>
    <message>
        <source>its lines cross or touch: give the edge of one piece of film, and its holes.</source>
        <translation>ses lignes se croisent ou se touchent : donnez le bord d'une seule pièce de film, et ses trous.</translation>
    </message>
    <message>
        <source>its points have lists.</source>
        <translation>ses points ont des listes.</translation>
    </message>
    <message>
        <source>its points have no x, y and z.</source>
        <translation>ses points n'ont pas de x, y et z.</translation>
    </message>
    <message>
        <source>knife</source>
        <translation>lame</translation>
    </message>
    <message>
        <source>known of two equal panels alone</source>
        <translation>connu pour deux panneaux égaux seulement</translation>
    </message>
    <message>
        <source>laser</source>
        <translation>laser</translation>
    </message>
    <message>
        <source>layer {0} of the LightBurn project has two speeds or powers: give its roles one.</source>
        <translation>le calque {0} du projet LightBurn a deux vitesses ou puissances : donnez-en une seule à ses rôles.</translation>
    </message>
    <message>
        <source>laying out</source>
        <translation>disposition</translation>
    </message>
    <message>
        <source>laying out, {0} so far</source>
        <translation>disposition, {0} jusqu'ici</translation>
    </message>
    <message>
        <source>lead-in</source>
        <translation>entrée</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>length</source>
        <translation>longueur</translation>
    </message>
    <message>
        <source>less than</source>
        <translation>moins de</translation>
    </message>
    <message>
        <source>less than its {} with a margin of {} ({})</source>
        <translation>moins que ses {} avec une marge de {} ({})</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>portance</translation>
    </message>
    <message>
        <source>lift of the tool</source>
        <translation>levée de l'outil</translation>
    </message>
    <message>
        <source>line_mm of marks is {0}, and size_mm {1}: a line is at most half as wide as its mark.</source>
        <translation>line_mm des repères est {0}, et size_mm {1} : une ligne est au plus large comme la moitié de son repère.</translation>
    </message>
    <message>
        <source>loose: {}</source>
        <translation>détendu : {}</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>bas</translation>
    </message>
    <message>
        <source>making a balloon of a study</source>
        <translation>la création d'un ballon d'une étude</translation>
    </message>
    <message>
        <source>making the document</source>
        <translation>la création du document</translation>
    </message>
    <message>
        <source>marks is {0}: give {"style": ...}, or leave it out for crosses.</source>
        <translation>marks est {0} : donnez {"style": ...}, ou omettez-le pour des croix.</translation>
    </message>
    <message>
        <source>marks of size_mm {0} and inset_mm {1} do not fit on a page_mm of {2}: give a larger page or smaller marks.</source>
        <translation>des repères de size_mm {0} et inset_mm {1} ne tiennent pas sur une page_mm de {2} : donnez une page plus grande ou des repères plus petits.</translation>
    </message>
    <message>
        <source>marks of style {0} have no "{1}": only {2}.</source>
        <translation>les repères de style {0} n'ont pas de « {1} » : seulement {2}.</translation>
    </message>
    <message>
        <source>marks of style {0} lack {1}: add it.</source>
        <translation>il manque {1} aux repères de style {0} : ajoutez-le.</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>masse</translation>
    </message>
    <message>
        <source>may be cut</source>
        <translation>peut être coupé</translation>
    </message>
    <message>
        <source>min_power_percent of {0} is more than max_power_percent: exchange the two.</source>
        <translation>min_power_percent de {0} est plus que max_power_percent : échangez les deux.</translation>
    </message>
    <message>
        <source>mirrored: its other side is up, with its print and sealing side</source>
        <translation>en miroir : son autre face est dessus, avec son impression et sa face soudable</translation>
    </message>
    <message>
        <source>more than</source>
        <translation>plus de</translation>
    </message>
    <message>
        <source>moved at {0}</source>
        <translation>avancée à {0}</translation>
    </message>
    <message>
        <source>name a property of the balloon</source>
        <translation>indiquez une propriété du ballon</translation>
    </message>
    <message>
        <source>names the unit {0}, which is not a usual one</source>
        <translation>nomme l'unité {0}, qui n'est pas courante</translation>
    </message>
    <message>
        <source>near {0} two of its edges are closer than {1}, and their welds run into each other: make the balloon larger or the seal narrower.</source>
        <translation>près de {0}, deux de ses bords sont à moins de {1}, et leurs soudures se mêlent : agrandissez le ballon ou rétrécissez la soudure.</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>no drawing to compare with</source>
        <translation>pas de dessin à comparer</translation>
    </message>
    <message>
        <source>no file was written</source>
        <translation>aucun fichier n'a été écrit</translation>
    </message>
    <message>
        <source>no layer is written: name at least CUT.</source>
        <translation>aucun calque n'est écrit : nommez au moins CUT.</translation>
    </message>
    <message>
        <source>nobody knows "{0}" of a tool: it may be one of {1}.</source>
        <translation>personne ne connaît « {0} » d'un outil : ce peut être {1}.</translation>
    </message>
    <message>
        <source>nobody knows "{0}": it may be one of {1}.</source>
        <translation>personne ne connaît « {0} » : ce peut être {1}.</translation>
    </message>
    <message>
        <source>nobody knows the start value "{0}": it may be one of {1}.</source>
        <translation>personne ne connaît la valeur de départ « {0} » : elle peut être l'une de {1}.</translation>
    </message>
    <message>
        <source>not converged: </source>
        <translation>non convergé : </translation>
    </message>
    <message>
        <source>notch</source>
        <translation>encoche</translation>
    </message>
    <message>
        <source>nothing is left that is large enough to be used again</source>
        <translation>il ne reste rien d'assez grand pour resservir</translation>
    </message>
    <message>
        <source>number for full power</source>
        <translation>nombre pour la pleine puissance</translation>
    </message>
    <message>
        <source>one of its values is of another kind than it must be</source>
        <translation>une de ses valeurs n'est pas du type voulu</translation>
    </message>
    <message>
        <source>only a PDF has spot colours: give "format": "pdf", or leave them out.</source>
        <translation>seul un PDF a des tons directs : donnez "format": "pdf", ou omettez-les.</translation>
    </message>
    <message>
        <source>opacity</source>
        <translation>opacité</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>contour</translation>
    </message>
    <message>
        <source>outward of marks is {0}: write true or false.</source>
        <translation>outward des repères est {0} : écrivez true ou false.</translation>
    </message>
    <message>
        <source>over</source>
        <translation>en fonction de</translation>
    </message>
    <message>
        <source>pass {0}: {1}</source>
        <translation>passe {0} : {1}</translation>
    </message>
    <message>
        <source>passes of {0} is {1}: give a whole number.</source>
        <translation>passes de {0} est {1} : donnez un nombre entier.</translation>
    </message>
    <message>
        <source>pieces {0}, on a remnant of {1}, {2} used</source>
        <translation>pièces {0}, sur une chute de {1}, {2} utilisés</translation>
    </message>
    <message>
        <source>pieces {0}, on {1}, {2} used</source>
        <translation>pièces {0}, sur {1}, {2} utilisés</translation>
    </message>
    <message>
        <source>place "{0}" is neither {1} nor {2}.</source>
        <translation>place « {0} » n'est ni {1} ni {2}.</translation>
    </message>
    <message>
        <source>power</source>
        <translation>puissance</translation>
    </message>
    <message>
        <source>pressed for {0}</source>
        <translation>pressé pendant {0}</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>pression</translation>
    </message>
    <message>
        <source>pressure at filling</source>
        <translation>pression au gonflage</translation>
    </message>
    <message>
        <source>printing</source>
        <translation>impression</translation>
    </message>
    <message>
        <source>reading the photograph</source>
        <translation>lecture de la photo</translation>
    </message>
    <message>
        <source>reading the solid</source>
        <translation>la lecture du solide</translation>
    </message>
    <message>
        <source>remnants {0}, {1}</source>
        <translation>chutes {0}, {1}</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>safe to {}, margin {}</source>
        <translation>sûr jusqu'à {}, marge {}</translation>
    </message>
    <message>
        <source>safe to: is being worked out</source>
        <translation>sûr jusqu'à : calcul en cours</translation>
    </message>
    <message>
        <source>seal width</source>
        <translation>largeur de soudure</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>couture</translation>
    </message>
    <message>
        <source>seam inside</source>
        <translation>couture intérieure</translation>
    </message>
    <message>
        <source>serious</source>
        <translation>grave</translation>
    </message>
    <message>
        <source>size {0}, {1}</source>
        <translation>taille {0}, {1}</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>speed of the spindle</source>
        <translation>vitesse de la broche</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>broche</translation>
    </message>
    <message>
        <source>square_mm of marks is larger than size_mm, {0}: make it smaller.</source>
        <translation>square_mm des repères dépasse size_mm, {0} : réduisez-le.</translation>
    </message>
    <message>
        <source>stale: </source>
        <translation>périmé : </translation>
    </message>
    <message>
        <source>stale: belongs to earlier values</source>
        <translation>périmé : appartient à des valeurs antérieures</translation>
    </message>
    <message>
        <source>start_values are of films that are welded by heat: give "joining": "heat" too.</source>
        <translation>start_values est pour les films soudés à chaud : donnez aussi "joining": "heat".</translation>
    </message>
    <message>
        <source>start_values are {0}: give the values with their sources, or leave them out.</source>
        <translation>start_values est {0} : donnez les valeurs avec leurs sources, ou omettez-les.</translation>
    </message>
    <message>
        <source>stopped; {0}.</source>
        <translation>arrêté ; {0}.</translation>
    </message>
    <message>
        <source>strain {}</source>
        <translation>déformation {}</translation>
    </message>
    <message>
        <source>strength</source>
        <translation>résistance</translation>
    </message>
    <message>
        <source>strength of film and weld</source>
        <translation>résistance du film et de la soudure</translation>
    </message>
    <message>
        <source>strength of the film not known</source>
        <translation>résistance du film inconnue</translation>
    </message>
    <message>
        <source>such as {"normal": "{0}"}</source>
        <translation>par exemple {"normal": "{0}"}</translation>
    </message>
    <message>
        <source>taped seam</source>
        <translation>couture au ruban adhésif</translation>
    </message>
    <message>
        <source>taped seam inside</source>
        <translation>couture intérieure au ruban adhésif</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>température</translation>
    </message>
    <message>
        <source>temperature after filling</source>
        <translation>température après le gonflage</translation>
    </message>
    <message>
        <source>test-card.json</source>
        <translation>test-card.json</translation>
    </message>
    <message>
        <source>the answer is not HTTP</source>
        <translation>la réponse n'est pas du HTTP</translation>
    </message>
    <message>
        <source>the balloons that were made stay, and the same command goes on</source>
        <translation>les ballons déjà faits restent, et la même commande continue</translation>
    </message>
    <message>
        <source>the colour "{0}" is not written like #ff0000.</source>
        <translation>la couleur « {0} » n'est pas écrite comme #ff0000.</translation>
    </message>
    <message>
        <source>the columns are the options of the command line</source>
        <translation>les colonnes sont les options de la ligne de commande</translation>
    </message>
    <message>
        <source>the connection ended too soon</source>
        <translation>la connexion s'est terminée trop tôt</translation>
    </message>
    <message>
        <source>the connection timed out</source>
        <translation>pas de réponse dans le délai</translation>
    </message>
    <message>
        <source>the file name "{0}" may have letters, digits, spaces, _, - and . only.</source>
        <translation>le nom de fichier « {0} » ne peut avoir que lettres, chiffres, espaces, _, - et .</translation>
    </message>
    <message>
        <source>the film weighs {0}</source>
        <translation>le film pèse {0}</translation>
    </message>
    <message>
        <source>the last line of each piece is its CUT.</source>
        <translation>la dernière ligne de chaque pièce est son CUT.</translation>
    </message>
    <message>
        <source>the layer name "{0}" may have 1 to 31 of A-Z, a-z, 0-9, _, - and $ only.</source>
        <translation>le nom de calque « {0} » ne peut avoir que de 1 à 31 des caractères A-Z, a-z, 0-9, _, - et $.</translation>
    </message>
    <message>
        <source>the layer {0} lacks {1}: give speed and power together, or neither.</source>
        <translation>il manque {1} au calque {0} : donnez vitesse et puissance ensemble, ou aucune des deux.</translation>
    </message>
    <message>
        <source>the marks of {0}</source>
        <translation>les repères de {0}</translation>
    </message>
    <message>
        <source>the name "{0}" of the stock goes into file names: take letters a to z.</source>
        <translation>le nom « {0} » de stock entre dans des noms de fichiers : prenez des lettres de a à z.</translation>
    </message>
    <message>
        <source>the nearest are {0}</source>
        <translation>les plus proches sont {0}</translation>
    </message>
    <message>
        <source>the sealing side {0} is no polymer: give one such as "PE", or "none".</source>
        <translation>la face soudable {0} n'est pas un polymère : donnez par exemple « PE », ou « none ».</translation>
    </message>
    <message>
        <source>the separating layer "{0}" is none of {1}: take one.</source>
        <translation>la couche de séparation « {0} » n'est aucune de {1} : prenez-en une.</translation>
    </message>
    <message>
        <source>the spot colour "{0}" may have letters, digits, _ and - only.</source>
        <translation>le ton direct « {0} » ne peut avoir que des lettres, des chiffres, _ et -.</translation>
    </message>
    <message>
        <source>the style of marks</source>
        <translation>le style des repères</translation>
    </message>
    <message>
        <source>the tool "{0}" is none of {1}.</source>
        <translation>l'outil « {0} » n'est aucun de {1}.</translation>
    </message>
    <message>
        <source>the weld rigidity lacks its source: write where it is from, or "assumed".</source>
        <translation>la rigidité de la soudure n'a pas de source : écrivez d'où elle vient, ou « assumed ».</translation>
    </message>
    <message>
        <source>there is no model in it</source>
        <translation>il ne contient pas de modèle</translation>
    </message>
    <message>
        <source>there is no such corner</source>
        <translation>il n'y a pas de tel angle</translation>
    </message>
    <message>
        <source>there is no such part</source>
        <translation>il n'y a pas de telle partie</translation>
    </message>
    <message>
        <source>there is no unit "{0}": write "mm".</source>
        <translation>il n'y a pas d'unité « {0} » : écrivez "mm".</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>épaisseur</translation>
    </message>
    <message>
        <source>thickness of the film</source>
        <translation>épaisseur du film</translation>
    </message>
    <message>
        <source>thin PE film, 30 to 50 µm</source>
        <translation>film PE mince, 30 à 50 µm</translation>
    </message>
    <message>
        <source>through a layer of {0}</source>
        <translation>à travers une couche de {0}</translation>
    </message>
    <message>
        <source>tight: {}</source>
        <translation>tendu : {}</translation>
    </message>
    <message>
        <source>times that of flat film</source>
        <translation>fois celle du film à plat</translation>
    </message>
    <message>
        <source>trial of the pattern: {0}</source>
        <translation>essai du patron : {0}</translation>
    </message>
    <message>
        <source>trial {0}, {1}</source>
        <translation>essai {0}, {1}</translation>
    </message>
    <message>
        <source>true to shape</source>
        <translation>forme fidèle</translation>
    </message>
    <message>
        <source>turned by {}°</source>
        <translation>tournée de {}°</translation>
    </message>
    <message>
        <source>unknown: this film has no strength</source>
        <translation>inconnue : ce film n'a pas de résistance</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>à jour</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>warm air</source>
        <translation>air chaud</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>avertissement</translation>
    </message>
    <message>
        <source>weld</source>
        <translation>soudure</translation>
    </message>
    <message>
        <source>weld inside</source>
        <translation>soudure intérieure</translation>
    </message>
    <message>
        <source>welding error</source>
        <translation>erreur de soudage</translation>
    </message>
    <message>
        <source>what came out</source>
        <translation>ce qui en est sorti</translation>
    </message>
    <message>
        <source>width</source>
        <translation>largeur</translation>
    </message>
    <message>
        <source>width_mm must be above 0, and taper from 0.2 to 1.</source>
        <translation>width_mm doit dépasser 0, et taper être de 0,2 à 1.</translation>
    </message>
    <message>
        <source>without a word</source>
        <translation>sans un mot</translation>
    </message>
    <message>
        <source>wrinkled: {}</source>
        <translation>plissé : {}</translation>
    </message>
    <message>
        <source>writing files</source>
        <translation>écriture des fichiers</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>{0} "{1}" is none of {2}.</source>
        <translation>{0} « {1} » n'est aucun de {2}.</translation>
    </message>
    <message>
        <source>{0} ({1}, margin {2})</source>
        <translation>{0} ({1}, marge {2})</translation>
    </message>
    <message>
        <source>{0} It is left out.</source>
        <translation>{0} Il est omis.</translation>
    </message>
    <message>
        <source>{0} and {1} lines meet near {2}: move the hole inward or make the allowance narrower.</source>
        <translation>Les lignes {0} et {1} se rencontrent près de {2} : déplacez le trou vers l'intérieur ou réduisez la marge.</translation>
    </message>
    <message>
        <source>{0} at least {1}</source>
        <translation>{0} d'au moins {1}</translation>
    </message>
    <message>
        <source>{0} at most {1}</source>
        <translation>{0} d'au plus {1}</translation>
    </message>
    <message>
        <source>{0} balloons cannot be laid out: give 1 or more.</source>
        <translation>{0} ballons ne peuvent pas être disposés : donnez-en 1 ou plus.</translation>
    </message>
    <message>
        <source>{0} begins in {1} and ends in {2}: write both in one unit.</source>
        <translation>{0} commence en {1} et finit en {2} : écrivez les deux dans une seule unité.</translation>
    </message>
    <message>
        <source>{0} belongs to no balloon: choose an outline, a balloon or a pattern.</source>
        <translation>{0} n'appartient à aucun ballon : choisissez un contour, un ballon ou un patron.</translation>
    </message>
    <message>
        <source>{0} cannot be "{1}": {2}</source>
        <translation>{0} ne peut pas être « {1} » : {2}</translation>
    </message>
    <message>
        <source>{0} cannot be deleted: {1}. See who may write there.</source>
        <translation>{0} ne peut pas être supprimé : {1}. Voyez qui peut y écrire.</translation>
    </message>
    <message>
        <source>{0} cannot be loaded ({1}).</source>
        <translation>{0} ne peut pas être chargé ({1}).</translation>
    </message>
    <message>
        <source>{0} cannot be read ({1}): write {2}.</source>
        <translation>{0} est illisible ({1}) : écrivez {2}.</translation>
    </message>
    <message>
        <source>{0} cannot be varied: choose a number, a word or a choice.</source>
        <translation>{0} ne peut pas varier : prenez un nombre, un mot ou un choix.</translation>
    </message>
    <message>
        <source>{0} cannot make crosses in the film to lay it on anew (layer REGISTRATION): choose another machine, or make the balloon smaller.</source>
        <translation>{0} ne peut pas faire de croix dans le film pour le reposer (calque REGISTRATION) : choisissez une autre machine, ou réduisez le ballon.</translation>
    </message>
    <message>
        <source>{0} cannot work: {1}</source>
        <translation>{0} ne peut pas travailler : {1}</translation>
    </message>
    <message>
        <source>{0} changed since. Choose Inflate now in its context menu, or switch Live on.</source>
        <translation>Changé depuis : {0}. Choisissez « Gonfler maintenant » dans son menu contextuel, ou activez Direct.</translation>
    </message>
    <message>
        <source>{0} does not have the native solver (answer {1}). Try again later. {2}</source>
        <translation>{0} n'a pas le solveur natif (réponse {1}). Réessayez plus tard. {2}</translation>
    </message>
    <message>
        <source>{0} does not see the folder '{1}': choose one that all machines share.</source>
        <translation>{0} ne voit pas le dossier « {1} » : choisissez-en un que toutes les machines partagent.</translation>
    </message>
    <message>
        <source>{0} dots per inch cannot be printed well: give {1} to {2}.</source>
        <translation>{0} points par pouce s'impriment mal : donnez de {1} à {2}.</translation>
    </message>
    <message>
        <source>{0} follows itself: choose something that is not made of it.</source>
        <translation>{0} se suit soi-même : choisissez ce qui n'en est pas fait.</translation>
    </message>
    <message>
        <source>{0} follows {1}: edit that.</source>
        <translation>{0} suit {1} : modifiez celui-ci.</translation>
    </message>
    <message>
        <source>{0} gap between the lines closed, the widest {1} of the drawing's width.</source>
        <translation>{0} écart entre les lignes fermé, large de {1} de la largeur du dessin.</translation>
    </message>
    <message>
        <source>{0} gaps between the lines closed, the widest {1} of the drawing's width.</source>
        <translation>{0} écarts entre les lignes fermés, le plus large {1} de la largeur du dessin.</translation>
    </message>
    <message>
        <source>{0} goes up to {1}, and {2} bears {3}: give less.</source>
        <translation>{0} va jusqu'à {1}, et {2} supporte {3} : donnez moins.</translation>
    </message>
    <message>
        <source>{0} has a point that is no number or farther away than {1}. Check its coordinates and the unit.</source>
        <translation>{0} a un point qui n'est pas un nombre ou qui est plus loin que {1}. Vérifiez ses coordonnées et l'unité.</translation>
    </message>
    <message>
        <source>{0} has a speed and a power, which only layers below {1} of a LightBurn project have: remove them.</source>
        <translation>{0} a une vitesse et une puissance, que seuls ont les calques au-dessous de {1} d'un projet LightBurn : retirez-les.</translation>
    </message>
    <message>
        <source>{0} has an error: repair it.</source>
        <translation>{0} a une erreur : réparez-la.</translation>
    </message>
    <message>
        <source>{0} has fewer than three points. Give all of its corners.</source>
        <translation>{0} a moins de trois points. Donnez tous ses sommets.</translation>
    </message>
    <message>
        <source>{0} has interface {1}, but {2} is needed.</source>
        <translation>{0} a l'interface {1}, mais il faut {2}.</translation>
    </message>
    <message>
        <source>{0} has no "{1}": it has {2}.</source>
        <translation>{0} n'a pas de « {1} » : il a {2}.</translation>
    </message>
    <message>
        <source>{0} has no area: all of its points lie on a line. Check its coordinates.</source>
        <translation>{0} n'a pas de surface : tous ses points sont sur une ligne. Vérifiez ses coordonnées.</translation>
    </message>
    <message>
        <source>{0} has no balloon: choose the one that is to be varied.</source>
        <translation>{0} n'a pas de ballon : choisissez celui que l'on fait varier.</translation>
    </message>
    <message>
        <source>{0} has no drawing yet: choose a picture.</source>
        <translation>{0} n'a pas encore de dessin : choisissez une image.</translation>
    </message>
    <message>
        <source>{0} has no outline to edit: choose a balloon from a picture.</source>
        <translation>{0} n'a pas de contour à modifier : choisissez un ballon fait d'une image.</translation>
    </message>
    <message>
        <source>{0} has no pattern: choose a balloon.</source>
        <translation>{0} n'a pas de patron : choisissez un ballon.</translation>
    </message>
    <message>
        <source>{0} has no piece {1}: its pieces are {2}.</source>
        <translation>{0} n'a pas de pièce {1} : ses pièces sont {2}.</translation>
    </message>
    <message>
        <source>{0} has no result yet: recompute it.</source>
        <translation>{0} n'a pas encore de résultat : recalculez-le.</translation>
    </message>
    <message>
        <source>{0} has no room between its ends: write the smaller one first.</source>
        <translation>{0} n'a pas de place entre ses bornes : écrivez la plus petite d'abord.</translation>
    </message>
    <message>
        <source>{0} has no rows: write the values of each balloon below the headings.</source>
        <translation>{0} n'a pas de lignes : écrivez les valeurs de chaque ballon sous les en-têtes.</translation>
    </message>
    <message>
        <source>{0} has no shape. Choose a solid or a mesh.</source>
        <translation>{0} n'a pas de forme. Choisissez un solide ou un maillage.</translation>
    </message>
    <message>
        <source>{0} has no shape: select a sketch, a wire or a face.</source>
        <translation>{0} n'a pas de forme : sélectionnez une esquisse, un fil ou une face.</translation>
    </message>
    <message>
        <source>{0} has no table: choose a spreadsheet of the document.</source>
        <translation>{0} n'a pas de tableau : choisissez une feuille de calcul du document.</translation>
    </message>
    <message>
        <source>{0} has no values: write {1}.</source>
        <translation>{0} n'a pas de valeurs : écrivez {1}.</translation>
    </message>
    <message>
        <source>{0} has not been built.</source>
        <translation>{0} n'a pas été compilé.</translation>
    </message>
    <message>
        <source>{0} has several faces: select one of them.</source>
        <translation>{0} a plusieurs faces : sélectionnez-en une.</translation>
    </message>
    <message>
        <source>{0} has several faces: select those that are panels.</source>
        <translation>{0} a plusieurs faces : sélectionnez celles qui sont des panneaux.</translation>
    </message>
    <message>
        <source>{0} has two columns for {1}: leave one out.</source>
        <translation>{0} a deux colonnes pour {1} : retirez-en une.</translation>
    </message>
    <message>
        <source>{0} has version {1}, not {2}: install the same one everywhere.</source>
        <translation>{0} a la version {1}, et non {2} : installez la même partout.</translation>
    </message>
    <message>
        <source>{0} has {1} bodies: choose one of them.</source>
        <translation>{0} a {1} corps : choisissez l'un d'eux.</translation>
    </message>
    <message>
        <source>{0} has {1} construction lines: leave one of them, which is the axis.</source>
        <translation>{0} a {1} lignes de construction : n'en laissez qu'une, qui est l'axe.</translation>
    </message>
    <message>
        <source>{0} has {1} pieces now: delete it.</source>
        <translation>{0} a maintenant {1} pièces : effacez celle-ci.</translation>
    </message>
    <message>
        <source>{0} hole with a thin line round it was filled, as a pen's: choose Drawn as filled shape to keep it.</source>
        <translation>{0} trou entouré d'une ligne mince a été rempli comme dans un dessin au trait : mettez « Dessiné comme » sur « Forme pleine » pour le garder.</translation>
    </message>
    <message>
        <source>{0} holes with a thin line round them were filled, as a pen's: choose Drawn as filled shape to keep them.</source>
        <translation>{0} trous entourés d'une ligne mince ont été remplis comme dans un dessin au trait : mettez « Dessiné comme » sur « Forme pleine » pour les garder.</translation>
    </message>
    <message>
        <source>{0} is a file</source>
        <translation>{0} est un fichier</translation>
    </message>
    <message>
        <source>{0} is a folder</source>
        <translation>{0} est un dossier</translation>
    </message>
    <message>
        <source>{0} is an edge of a hole: choose one of an outer loop as the opening.</source>
        <translation>{0} est un bord d'un trou : choisissez comme ouverture un bord d'une boucle extérieure.</translation>
    </message>
    <message>
        <source>{0} is at an end of its range: a wider one may hold a better balloon.</source>
        <translation>{0} est à une extrémité de sa plage : une plus large contient peut-être un meilleur ballon.</translation>
    </message>
    <message>
        <source>{0} is curved both ways: it is cut into {1} strips.</source>
        <translation>{0} est courbé dans les deux sens : coupé en {1} bandes.</translation>
    </message>
    <message>
        <source>{0} is damaged or incomplete ({1}). Install the workbench anew.</source>
        <translation>{0} est abîmé ou incomplet ({1}). Réinstallez l'atelier.</translation>
    </message>
    <message>
        <source>{0} is damaged or incomplete. Install the workbench anew.</source>
        <translation>{0} est abîmé ou incomplet. Réinstallez l'atelier.</translation>
    </message>
    <message>
        <source>{0} is damaged: install the workbench anew, or go on without the native solver.</source>
        <translation>{0} est abîmé : réinstallez l'atelier, ou continuez sans le solveur natif.</translation>
    </message>
    <message>
        <source>{0} is damaged: remove it and start the study again.</source>
        <translation>{0} est endommagé : supprimez-le et relancez l'étude.</translation>
    </message>
    <message>
        <source>{0} is empty: draw a closed line in it.</source>
        <translation>{0} est vide : tracez-y une ligne fermée.</translation>
    </message>
    <message>
        <source>{0} is empty: draw a line in it.</source>
        <translation>{0} est vide : dessinez-y une ligne.</translation>
    </message>
    <message>
        <source>{0} is empty: draw half an outline in it, beside the vertical axis.</source>
        <translation>{0} est vide : dessinez-y un demi-contour, à côté de l'axe vertical.</translation>
    </message>
    <message>
        <source>{0} is hollow: choose a solid without a space inside.</source>
        <translation>{0} est creux : choisissez un solide sans vide à l'intérieur.</translation>
    </message>
    <message>
        <source>{0} is in no seam. Seal it to another edge.</source>
        <translation>{0} n'est dans aucune couture. Soudez-le à un autre bord.</translation>
    </message>
    <message>
        <source>{0} is in no seam: join it to another edge.</source>
        <translation>{0} n'est dans aucune couture : assemblez-le à un autre bord.</translation>
    </message>
    <message>
        <source>{0} is in the document {1}: copy it into {2} first.</source>
        <translation>{0} est dans le document {1} : copiez-le d'abord dans {2}.</translation>
    </message>
    <message>
        <source>{0} is in two seams: take one of them away.</source>
        <translation>{0} est dans deux coutures : retirez l'une d'elles.</translation>
    </message>
    <message>
        <source>{0} is left out. {1}</source>
        <translation>{0} est laissé de côté. {1}</translation>
    </message>
    <message>
        <source>{0} is neither DXF nor SVG: let the name end in .dxf or .svg.</source>
        <translation>{0} n'est ni DXF ni SVG : terminez le nom par .dxf ou .svg.</translation>
    </message>
    <message>
        <source>{0} is neither VTU, NPZ nor STL: let the name end in .vtu, .npz or .stl.</source>
        <translation>{0} n'est ni VTU, ni NPZ, ni STL : terminez le nom par .vtu, .npz ou .stl.</translation>
    </message>
    <message>
        <source>{0} is no body: give a solid, a mesh or the path of a file.</source>
        <translation>{0} n'est pas un corps : donnez un solide, un maillage ou le chemin d'un fichier.</translation>
    </message>
    <message>
        <source>{0} is no file for the web: let the name end in .glb, .html, .png, .gif or .mp4.</source>
        <translation>{0} n'est pas un fichier pour le web : terminez le nom par .glb, .html, .png, .gif ou .mp4.</translation>
    </message>
    <message>
        <source>{0} is no number</source>
        <translation>{0} n'est pas un nombre</translation>
    </message>
    <message>
        <source>{0} is no number: list its values.</source>
        <translation>{0} n'est pas un nombre : énumérez ses valeurs.</translation>
    </message>
    <message>
        <source>{0} is no number: write its values into the table.</source>
        <translation>{0} n'est pas un nombre : écrivez ses valeurs dans le tableau.</translation>
    </message>
    <message>
        <source>{0} is none of the names that are known</source>
        <translation>{0} n'est aucun des noms connus</translation>
    </message>
    <message>
        <source>{0} is not a coordinate</source>
        <translation>{0} n'est pas une coordonnée</translation>
    </message>
    <message>
        <source>{0} is not closed: film can only be filled where it is. Choose a solid.</source>
        <translation>{0} n'est pas fermé : un film ne peut se remplir que s'il est fermé. Choisissez un solide.</translation>
    </message>
    <message>
        <source>{0} is not flat: a balloon is cut from flat film, so draw it in one plane.</source>
        <translation>{0} n'est pas plan : un ballon se découpe dans du film plat, dessinez-le donc dans un plan.</translation>
    </message>
    <message>
        <source>{0} is not flat: draw half the outline in a sketch.</source>
        <translation>{0} n'est pas plan : dessinez le demi-contour dans une esquisse.</translation>
    </message>
    <message>
        <source>{0} is not joined by heat: {1} is not made for it.</source>
        <translation>{0} ne s'assemble pas à chaud : {1} n'est pas fait pour cela.</translation>
    </message>
    <message>
        <source>{0} is not printed on {1}: choose an artwork of this pattern.</source>
        <translation>{0} n'est pas imprimé sur {1} : prenez une illustration de ce patron.</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1}</source>
        <translation>{0} n'est pas à jour. {1}</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1} Repair that and recompute.</source>
        <translation>{0} n'est pas à jour. {1} Réparez cela et recalculez.</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1} Repair that, recompute and export again.</source>
        <translation>{0} n'est pas à jour. {1} Réparez cela, recalculez et exportez à nouveau.</translation>
    </message>
    <message>
        <source>{0} is not worked out yet: recompute the document.</source>
        <translation>{0} n'est pas encore calculé : recalculez le document.</translation>
    </message>
    <message>
        <source>{0} is open: close its line.</source>
        <translation>{0} est ouvert : fermez sa ligne.</translation>
    </message>
    <message>
        <source>{0} is too large a number, or none</source>
        <translation>{0} est un nombre trop grand, ou n'en est pas un</translation>
    </message>
    <message>
        <source>{0} is {1} long, {2} is {3}: make them equally long.</source>
        <translation>{0} mesure {1}, {2} {3} : donnez-leur la même longueur.</translation>
    </message>
    <message>
        <source>{0} is {1} long. Scale it, so that it is between {2} and {3}.</source>
        <translation>{0} mesure {1} de long. Le mettre à l'échelle pour qu'il soit entre {2} et {3}.</translation>
    </message>
    <message>
        <source>{0} is {1}. Seal each edge once: side a goes along its loop from its first point to its second, b against it.</source>
        <translation>{0} est {1}. Soudez chaque bord une fois : le côté a suit sa boucle du premier point au second, b la remonte.</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number from {2} to {3}.</source>
        <translation>{0} est {1} : donnez un nombre de {2} à {3}.</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number, or [least, most].</source>
        <translation>{0} est {1} : donnez un nombre, ou [least, most].</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number.</source>
        <translation>{0} est {1} : donnez un nombre.</translation>
    </message>
    <message>
        <source>{0} is {1}: give numbers from {2} to {3}, the smaller one first.</source>
        <translation>{0} est {1} : donnez des nombres de {2} à {3}, le plus petit d'abord.</translation>
    </message>
    <message>
        <source>{0} is {1}: give {2}, or leave it out.</source>
        <translation>{0} vaut {1} : donnez {2}, ou omettez-le.</translation>
    </message>
    <message>
        <source>{0} is {1}: write it as {"value": ..., "source": "who says so"}.</source>
        <translation>{0} est {1} : écrivez-le comme {"value": ..., "source": "who says so"}.</translation>
    </message>
    <message>
        <source>{0} is {1}: write true or false.</source>
        <translation>{0} est {1} : écrivez true ou false.</translation>
    </message>
    <message>
        <source>{0} lacks its source: write who states it. What nobody states is left out.</source>
        <translation>Il manque une source à {0} : écrivez qui l'indique. Ce que personne n'indique s'omet.</translation>
    </message>
    <message>
        <source>{0} left out ({1}).</source>
        <translation>{0} omises ({1}).</translation>
    </message>
    <message>
        <source>{0} lies on both sides of its axis: draw half the outline, on one side.</source>
        <translation>{0} est des deux côtés de son axe : dessinez le demi-contour d'un seul côté.</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: no, at no size.</source>
        <translation>{0} : porte {1}, {2} ; non, à aucune taille.</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: no. From {3} width on it would.</source>
        <translation>{0} : porte {1}, {2} ; non. À partir de {3} de large, si.</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: yes, and it carries {3}.</source>
        <translation>{0} : porte {1}, {2} ; oui, et le ballon porte encore {3}.</translation>
    </message>
    <message>
        <source>{0} mm on paper = {1} of film</source>
        <translation>{0} mm sur le papier = {1} de film</translation>
    </message>
    <message>
        <source>{0} mm with an error of {1} mm</source>
        <translation>{0} mm avec une erreur de {1} mm</translation>
    </message>
    <message>
        <source>{0} must never be cut with a laser: choose a machine with a knife.</source>
        <translation>{0} ne doit jamais être coupé au laser : choisissez une machine à lame.</translation>
    </message>
    <message>
        <source>{0} needs a unit: write {1} instead of {2}.</source>
        <translation>{0} demande une unité : écrivez {1} au lieu de {2}.</translation>
    </message>
    <message>
        <source>{0} never gets from '{1}' to '{2}' by '{3}'.</source>
        <translation>{0} ne va jamais de « {1} » à « {2} » par « {3} ».</translation>
    </message>
    <message>
        <source>{0} notches are closer than {1}: take fewer.</source>
        <translation>{0} encoches sont plus serrées que {1} : prenez-en moins.</translation>
    </message>
    <message>
        <source>{0} of a roll {1} wide</source>
        <translation>{0} d'un rouleau de {1} de large</translation>
    </message>
    <message>
        <source>{0} of its size</source>
        <translation>{0} de sa taille</translation>
    </message>
    <message>
        <source>{0} of marks is {1}: give [width, height], or leave it out.</source>
        <translation>{0} des repères est {1} : donnez [width, height], ou omettez-le.</translation>
    </message>
    <message>
        <source>{0} of marks is {1}: give a number from {2} to {3}.</source>
        <translation>{0} des repères est {1} : donnez un nombre de {2} à {3}.</translation>
    </message>
    <message>
        <source>{0} of {1} cannot be {2}: take another value.</source>
        <translation>{0} de {1} ne peut pas être {2} : prenez une autre valeur.</translation>
    </message>
    <message>
        <source>{0} of {1} follows the expression '{2}': vary what that is made of.</source>
        <translation>{0} de {1} suit l'expression « {2} » : faites varier ce dont elle est faite.</translation>
    </message>
    <message>
        <source>{0} of {1} is {2}, but its expression '{3}' gives {4}: change the expression.</source>
        <translation>{0} de {1} est {2}, mais le résultat de son expression « {3} » est {4} : changez l'expression.</translation>
    </message>
    <message>
        <source>{0} open line was left out.</source>
        <translation>{0} ligne ouverte a été omise.</translation>
    </message>
    <message>
        <source>{0} open lines were left out.</source>
        <translation>{0} lignes ouvertes ont été omises.</translation>
    </message>
    <message>
        <source>{0} over {1}</source>
        <translation>{0} en fonction de {1}</translation>
    </message>
    <message>
        <source>{0} panels meet at one point, which no weld closes: seal the cap from the sheet over it, or tape it.</source>
        <translation>{0} panneaux se rejoignent en un point qu'aucune soudure ne ferme : soudez-y la calotte de la feuille, ou scotchez-le.</translation>
    </message>
    <message>
        <source>{0} reads no G-code: choose a machine that does.</source>
        <translation>{0} ne lit pas le G-code : choisissez une machine qui le fait.</translation>
    </message>
    <message>
        <source>{0} reads {1}, which has no pages: choose paper.</source>
        <translation>{0} lit {1}, qui n'a pas de pages : choisissez le papier.</translation>
    </message>
    <message>
        <source>{0} runs between two ends: say how to take samples in "{1}".</source>
        <translation>{0} varie entre deux bornes : dites dans « {1} » comment tirer des échantillons.</translation>
    </message>
    <message>
        <source>{0} seams cannot be sealed lying flat, least of all seam {1} of panels {2}: one edge turns by {3} in all to follow the other. Seal them bit by bit, or round the corners.</source>
        <translation>{0} coutures ne peuvent pas être soudées à plat, la couture {1} des panneaux {2} moins que toute autre : un bord tourne de {3} en tout pour suivre l'autre. Soudez-les petit à petit, ou arrondissez les coins.</translation>
    </message>
    <message>
        <source>{0} small speck was dropped.</source>
        <translation>{0} petite tache a été omise.</translation>
    </message>
    <message>
        <source>{0} small specks were dropped.</source>
        <translation>{0} petites taches ont été omises.</translation>
    </message>
    <message>
        <source>{0} takes from 1 to {1} equal parts, not '{2}'.</source>
        <translation>{0} prend de 1 à {1} parties égales, pas « {2} ».</translation>
    </message>
    <message>
        <source>{0} thin line is</source>
        <translation>{0} ligne mince</translation>
    </message>
    <message>
        <source>{0} thin lines are</source>
        <translation>{0} lignes minces</translation>
    </message>
    <message>
        <source>{0} times</source>
        <translation>{0} fois</translation>
    </message>
    <message>
        <source>{0} tiny hole was filled.</source>
        <translation>{0} trou minuscule a été rempli.</translation>
    </message>
    <message>
        <source>{0} tiny holes were filled.</source>
        <translation>{0} trous minuscules ont été remplis.</translation>
    </message>
    <message>
        <source>{0} turns a minute</source>
        <translation>{0} tours par minute</translation>
    </message>
    <message>
        <source>{0} was left out. {1}</source>
        <translation>{0} a été omis. {1}</translation>
    </message>
    <message>
        <source>{0} weld outside the shapes left out.</source>
        <translation>{0} soudure hors des formes omise.</translation>
    </message>
    <message>
        <source>{0} welds outside the shapes left out.</source>
        <translation>{0} soudures hors des formes omises.</translation>
    </message>
    <message>
        <source>{0} wide, {1} long</source>
        <translation>{0} de large, {1} de long</translation>
    </message>
    <message>
        <source>{0} with an error of {1}</source>
        <translation>{0} avec une erreur de {1}</translation>
    </message>
    <message>
        <source>{0} with valve {1}</source>
        <translation>{0} avec une valve de {1}</translation>
    </message>
    <message>
        <source>{0}, inflated: {1}</source>
        <translation>{0}, gonflé : {1}</translation>
    </message>
    <message>
        <source>{0}: '{1}' is no number, write one such as 20.</source>
        <translation>{0} : « {1} » n'est pas un nombre, écrivez-en un comme 20.</translation>
    </message>
    <message>
        <source>{0}: it is split over several files. Cut them in their order, and lay the film on anew each time so that its crosses are where the next file has them.</source>
        <translation>{0} : il est réparti sur plusieurs fichiers. Coupez-les dans leur ordre, et reposez le film chaque fois de sorte que ses croix soient où le fichier suivant les a.</translation>
    </message>
    <message>
        <source>{0}: its file lacks {1}: add it.</source>
        <translation>{0} : il manque {1} à son fichier : ajoutez-le.</translation>
    </message>
    <message>
        <source>{0}: lay its pieces out on sheets of that size, make the balloon smaller, or write the file anyway.</source>
        <translation>{0} : disposez ses pièces sur des feuilles de cette taille, réduisez le ballon, ou faites écrire le fichier quand même.</translation>
    </message>
    <message>
        <source>{0}: make the balloon smaller, choose another machine or paper, or write the file anyway.</source>
        <translation>{0} : réduisez le ballon, choisissez une autre machine ou un autre papier, ou faites écrire le fichier quand même.</translation>
    </message>
    <message>
        <source>{0}: the file is written anyway.</source>
        <translation>{0} : le fichier est écrit quand même.</translation>
    </message>
    <message>
        <source>{0}: what changes it most</source>
        <translation>{0} : ce qui compte le plus</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0} : {1}</translation>
    </message>
    <message>
        <source>{0}: {1} mm is out of range, give {2} to {3} mm.</source>
        <translation>{0} : {1} mm est hors limites, donnez de {2} à {3} mm.</translation>
    </message>
    <message>
        <source>{0}; wider than the usual roll</source>
        <translation>{0} ; plus large que le rouleau habituel</translation>
    </message>
    <message>
        <source>{0}take a drawing, without a side band or gores.</source>
        <translation>{0}prenez un dessin, sans bande latérale ni fuseaux.</translation>
    </message>
    <message>
        <source>{0}this drawing has {1} shapes, study one at a time.</source>
        <translation>{0}ce dessin a {1} formes, étudiez-les une à une.</translation>
    </message>
    <message>
        <source>{0}what is shown is the last good state. Lower the pressure or change the mesh size.</source>
        <translation>{0}ce qui est montré est le dernier bon état. Baissez la pression ou changez la taille de maille.</translation>
    </message>
    <message>
        <source>{0}{1} has no length. Take one of its points out.</source>
        <translation>{0}{1} n'a pas de longueur. Retirez l'un de ses points.</translation>
    </message>
    <message>
        <source>{} (unusable)</source>
        <translation>{} (inutilisable)</translation>
    </message>
    <message>
        <source>{} ({})</source>
        <translation>{} ({})</translation>
    </message>
    <message>
        <source>{} MB from {}; the file is checked before it is used, and nothing is sent.</source>
        <translation>{} MB de {} ; le fichier est vérifié avant d'être utilisé, et rien n'est envoyé.</translation>
    </message>
    <message>
        <source>{} at ({})</source>
        <translation>{} en ({})</translation>
    </message>
    <message>
        <source>{} gores are enough for {} of the profile's diagonal</source>
        <translation>{} fuseaux suffisent pour {} de la diagonale du profil</translation>
    </message>
    <message>
        <source>{} gores, as many as {} of the profile's diagonal need</source>
        <translation>{} fuseaux, autant que {} de la diagonale du profil en demandent</translation>
    </message>
    <message>
        <source>{} in the mean, at most {}</source>
        <translation>{} en moyenne, au plus {}</translation>
    </message>
    <message>
        <source>{} inside</source>
        <translation>{} dedans</translation>
    </message>
    <message>
        <source>{} is among the films</source>
        <translation>{} est parmi les films</translation>
    </message>
    <message>
        <source>{} is among the machines of Export pattern</source>
        <translation>{} est parmi les machines de « Exporter le patron »</translation>
    </message>
    <message>
        <source>{} is in the tree</source>
        <translation>{} est dans l'arborescence</translation>
    </message>
    <message>
        <source>{} is there already: give another name.</source>
        <translation>{} existe déjà : donnez un autre nom.</translation>
    </message>
    <message>
        <source>{} is there already: tick "Replace the file", or give another name.</source>
        <translation>{} existe déjà : cochez « Remplacer le fichier », ou donnez un autre nom.</translation>
    </message>
    <message>
        <source>{} is there already: tick "Replace the files", or choose another folder.</source>
        <translation>{} existe déjà : cochez « Remplacer les fichiers », ou choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>{} ms, {}, frame {} of {}</source>
        <translation>{} ms, {}, image {} sur {}</translation>
    </message>
    <message>
        <source>{} of it wrinkles, {} is loose</source>
        <translation>{} plissé, {} détendu</translation>
    </message>
    <message>
        <source>{} of the profile's diagonal take {} gores</source>
        <translation>{} de la diagonale du profil demandent {} fuseaux</translation>
    </message>
    <message>
        <source>{} of them cannot be made:</source>
        <translation>Dont {} sans ballon :</translation>
    </message>
    <message>
        <source>{} of {}</source>
        <translation>{} de {}</translation>
    </message>
    <message>
        <source>{} of {} rows are worked out.</source>
        <translation>{} lignes sur {} sont calculées.</translation>
    </message>
    <message>
        <source>{} outside</source>
        <translation>{} dehors</translation>
    </message>
    <message>
        <source>{} panels, {} of seams, {} inside</source>
        <translation>{} panneaux, {} de coutures, {} à l'intérieur</translation>
    </message>
    <message>
        <source>{} panels, {} seams of {}</source>
        <translation>{} panneaux, {} coutures, {} de long</translation>
    </message>
    <message>
        <source>{} panels: about {} off, {} of seams, {} h of welding</source>
        <translation>{} panneaux : écart d'environ {}, {} de coutures, {} h de soudage</translation>
    </message>
    <message>
        <source>{} px</source>
        <translation>{} px</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>de {} à {}</translation>
    </message>
    <message>
        <source>{} x {}, {} thick, {}</source>
        <translation>{} x {}, épais de {}, {}</translation>
    </message>
    <message>
        <source>{}, at most {}</source>
        <translation>{}, au plus {}</translation>
    </message>
    <message>
        <source>{}, carries {} with {}</source>
        <translation>{}, porte {} avec {}</translation>
    </message>
    <message>
        <source>{}, floats from {} width on with {}</source>
        <translation>{}, flotte dès {} de large avec {}</translation>
    </message>
    <message>
        <source>{}, never floats with {}</source>
        <translation>{}, ne flotte jamais avec {}</translation>
    </message>
    <message>
        <source>{}, row {}</source>
        <translation>{}, ligne {}</translation>
    </message>
    <message>
        <source>{}, seam {}</source>
        <translation>{}, couture {}</translation>
    </message>
    <message>
        <source>{}: film {}, seam and neck {}</source>
        <translation>{} : film {}, couture et col {}</translation>
    </message>
    <message>
        <source>{}: film {}, seam and neck {}, valve {}</source>
        <translation>{} : film {}, couture et col {}, valve {}</translation>
    </message>
    <message>
        <source>{}: they differ by {}</source>
        <translation>{} : ils diffèrent de {}</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{} : {}</translation>
    </message>
    <message>
        <source>{}: {}, flat</source>
        <translation>{} : {}, à plat</translation>
    </message>
    <message>
        <source>{}: {}, nodes</source>
        <translation>{} : {}, nœuds</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Advice</name>
    <message>
        <source>Advice</source>
        <translation>Conseils</translation>
    </message>
    <message>
        <source>Show which parts of a shape will inflate badly, and repair them</source>
        <translation>Montre quelles parties d'une forme se gonfleront mal, et les répare</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Animate</name>
    <message>
        <source>Animate inflation</source>
        <translation>Animer le gonflage</translation>
    </message>
    <message>
        <source>Play how the balloon inflates, from the flat film to rest, with a slider</source>
        <translation>Joue comment le ballon se gonfle, du film plat au repos, avec un curseur</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Artwork</name>
    <message>
        <source>Artwork</source>
        <translation>Illustration</translation>
    </message>
    <message>
        <source>Print a picture on the film so that it reads right on the inflated balloon</source>
        <translation>Imprimer une image sur le film pour qu'elle soit juste sur le ballon gonflé</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_AssemblySheet</name>
    <message>
        <source>Assembly sheet</source>
        <translation>Fiche de montage</translation>
    </message>
    <message>
        <source>Tell what the balloon takes and whether it floats, and write one page on how to make it</source>
        <translation>Dit ce que demande le ballon et s'il flotte, et écrit une page sur sa fabrication</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ColourMap</name>
    <message>
        <source>Colour map</source>
        <translation>Carte de couleurs</translation>
    </message>
    <message>
        <source>Show tension, wrinkles, thickness and other results as colours on the balloon</source>
        <translation>Montre tension, plis, épaisseur et autres résultats en couleurs sur le ballon</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Compare</name>
    <message>
        <source>Compare with a photograph</source>
        <translation>Comparer à une photo</translation>
    </message>
    <message>
        <source>Lay a photograph of the finished balloon over the simulated one, and see how near it came</source>
        <translation>Poser une photo du ballon fini sur le ballon simulé, et voir de combien ils diffèrent</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_EditOutline</name>
    <message>
        <source>Edit outline</source>
        <translation>Modifier le contour</translation>
    </message>
    <message>
        <source>Move, add and remove nodes of the outline over its picture, and set how the picture is read</source>
        <translation>Déplacer, ajouter et enlever des nœuds du contour sur son image, et régler la lecture de l'image</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Equipment</name>
    <message>
        <source>Show the solver in use, and which packages are missing and what that costs</source>
        <translation>Montre le solveur utilisé, et quels paquets manquent et ce que cela coûte</translation>
    </message>
    <message>
        <source>What works here</source>
        <translation>Ce qui marche ici</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Examples</name>
    <message>
        <source>Examples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>Open a finished balloon, to look at it and to change it</source>
        <translation>Ouvre un ballon terminé, à regarder et à modifier</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ExportForWeb</name>
    <message>
        <source>Export for the web</source>
        <translation>Exporter pour le web</translation>
    </message>
    <message>
        <source>Write the balloon with its artwork as a web page that turns it, as a 3D model or as a picture</source>
        <translation>Écrire le ballon avec son impression : page web qui le tourne, modèle 3D ou image</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ExportPattern</name>
    <message>
        <source>Export pattern</source>
        <translation>Exporter le patron</translation>
    </message>
    <message>
        <source>Write the flat pattern of a balloon for a cutter, a plotter, a heat sealer or a printer</source>
        <translation>Écrit le patron à plat d'un ballon pour une découpeuse, un traceur, une soudeuse ou une imprimante</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromBody</name>
    <message>
        <source>Find the panels of a balloon that fills the selected solid or mesh</source>
        <translation>Trouver les panneaux d'un ballon qui remplit le solide ou le maillage sélectionné</translation>
    </message>
    <message>
        <source>New balloon from body</source>
        <translation>Nouveau ballon depuis un corps</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromPanels</name>
    <message>
        <source>New bag of panels</source>
        <translation>Nouveau sac de panneaux</translation>
    </message>
    <message>
        <source>Seal flat panels along their edges: selected sketches and faces, a ready body or a file</source>
        <translation>Souder des panneaux plats le long de leurs bords : esquisses et faces sélectionnées, un corps prêt ou un fichier</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromPicture</name>
    <message>
        <source>New balloon from picture</source>
        <translation>Nouveau ballon depuis une image</translation>
    </message>
    <message>
        <source>Trace a picture, SVG, DXF or JSON file and design the balloon that looks like it</source>
        <translation>Suit une image, un fichier SVG, DXF ou JSON et conçoit le ballon qui lui ressemble</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromProfile</name>
    <message>
        <source>Design the gores of a ball, an airship or another round body from half its outline</source>
        <translation>Concevoir les fuseaux d'une balle, d'un dirigeable ou d'un autre corps rond d'après un demi-contour</translation>
    </message>
    <message>
        <source>New body of gores</source>
        <translation>Nouveau corps de fuseaux</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromSketch</name>
    <message>
        <source>Design the balloon that looks like the selected sketch, wire or face and follows it</source>
        <translation>Conçoit le ballon qui ressemble à l'esquisse, au fil ou à la face choisis et les suit</translation>
    </message>
    <message>
        <source>New balloon from sketch</source>
        <translation>Nouveau ballon depuis une esquisse</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Machines</name>
    <message>
        <source>My machines</source>
        <translation>Mes machines</translation>
    </message>
    <message>
        <source>Set up cutters, lasers, sealers and printers of your own: bed, file format, kerf, knife and tool</source>
        <translation>Régler vos propres découpeuses, lasers, soudeuses et imprimantes : plateau, format de fichier, trait de coupe, lame et outil</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Nest</name>
    <message>
        <source>Lay out on film</source>
        <translation>Disposer sur le film</translation>
    </message>
    <message>
        <source>Lay the panels of one or several balloons closely on a roll or on sheets of film</source>
        <translation>Disposer de près les panneaux d'un ou de plusieurs ballons sur un rouleau ou des feuilles de film</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Paint</name>
    <message>
        <source>Draw with pen and brush, and watch the balloon and its pattern grow beside it</source>
        <translation>Dessiner au stylo et au pinceau, et voir le ballon et son patron grandir à côté</translation>
    </message>
    <message>
        <source>Paint a balloon</source>
        <translation>Peindre un ballon</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_PatternView</name>
    <message>
        <source>Pattern view</source>
        <translation>Vue du patron</translation>
    </message>
    <message>
        <source>Show all panels flat in a tab of their own: pick an edge to see its partner, and measure</source>
        <translation>Montrer tous les panneaux à plat dans leur onglet : choisir un bord montre son vis-à-vis ; et mesurer</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Study</name>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>Work out many variants of a balloon from a spreadsheet, and compare them</source>
        <translation>Calculer de nombreuses variantes d'un ballon à partir d'une feuille de calcul, et les comparer</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_TestCard</name>
    <message>
        <source>Find feed, power, temperature or depth of a tool for a film: weld or cut a card of fields</source>
        <translation>Trouver avance, puissance, température ou profondeur d'un outil pour un film : souder ou couper une carte de champs</translation>
    </message>
    <message>
        <source>Test card</source>
        <translation>Carte d'essai</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Film &amp;Balloon</source>
        <translation>&amp;Ballon en film</translation>
    </message>
    <message>
        <source>Film Balloon</source>
        <translation>Ballon en film</translation>
    </message>
</context>
</TS>

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>A line of text where the film is widest, as outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A tab with a hole to tie the balloon to, outside the weld</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a neck through which the balloon is filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area of film inside the welds, both panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Around the balloon, in degrees Celsius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic evens out a nearly symmetric picture, Forced any drawing: its left half is mirrored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corners of all loops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corners of all welds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corners of the pattern's seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corners of the welds inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct the pattern until the balloon looks like the drawing, or not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrections of the pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of the grain, from the x axis of the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of the neck, counter-clockwise from the x axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of the tab from the middle of the pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance that 95 % of the silhouette keep to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film left outside the weld</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film of both panels with weld and intake, in grams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film that wrinkles where it is compressed, or a shell that does not, for comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film, model and solver of the result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit inside width and height instead of stretching to both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow every change at once; switch it off for heavy models and inflate when you ask for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD's material card that the values were taken from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height above the sea</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of its capital letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the drawing; 0 follows from the width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the inflated balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the piece of film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inner width of the neck</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It carries itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label of the values the mesh belongs to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger dimension before repairs, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance between drawing and silhouette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest membrane tension in N/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest strain of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least bending stiffness, in units of the usual least one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of a notch; at most the allowance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the neck from the seam outward; 0 is automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the weld</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines and arcs within 0.02 mm in place of many short lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean distance between drawing and silhouette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notches to lay both films on each other by, evenly along the cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of corners of each loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of corners of each seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of corners of each weld</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of holes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of seams, then the number of vertices of each seam and weld</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of warm air, in degrees Celsius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the film's area that is slack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the film's area that is wrinkled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture, SVG, DXF or JSON file; a copy travels in the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point the neck from the centre to the farthest point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poisson's ratio of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pressure in the inflated balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pressure inside, above that outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the tab opposite the intake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remarks made during the design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remarks made while the outline was found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remarks made while the pattern was drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roundness: 1 for a disc, 0 for a flat thing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulate both panels instead of one and its mirror image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the triangles; 0 is automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sketch, wire or face that the outline follows instead of a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solver that was used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solver: compiled, NumPy, or the best of them; Newmark follows the inflation in time, slowly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps of the solver in the last inflation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tension over the section at which the film tears; 0: not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The balloon that is cut from this pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film resists bending</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mesh shown is an equilibrium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline of the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline whose drawing this one shares; empty: its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The silhouette is within the tolerance of the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole report as JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness of the inflated balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up to date, or what is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version of this object's properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertices along all seams, then along all welds inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertices of each triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertices of the flat panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertices of the inflated upper film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertices of the lower film where both were simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume of the balloon, from which the pressure follows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume of the inflated balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume that decides the size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of the film in kg per square metre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What decides the size: the outline as it is, a volume to hold or a load to carry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What fills it when it shall float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is given: the pressure, or the volume that it shall reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it carries with its gas, in grams; below 0 it sinks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it shall carry besides itself, in grams; 0 makes it float just so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the balloon is made of; Custom lets you give your own values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the coach has changed in the drawing, one repair each; delete an entry to take it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the outline was read from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to do along each wire of the shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What would make the balloon better</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which shape of the drawing it is; 1 is the largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width from which it carries itself; 0 when never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the drawing; 0 follows from the height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the inflated balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the piece of film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the weld that this film needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the weld; 0 takes the film's</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Young's modulus across the grain; 0 means no grain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Young's modulus of the film</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench</name>
    <message>
        <source> is not ready: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>"{0}" is no colour: give one such as "#cc294d".</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>"{0}" is no sum of L, W, S, A and millimetres, such as "0.5 W + 2".</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>"{0}" may not use {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' cannot be read ({1}). Check the name and its access.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' has {1} x {2} pixels, more than {3} million. Make it smaller; 2000 pixels across are plenty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is colder than anything; write a temperature as 20C, 68F or 293K.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is damaged or not a DXF file. Save it once more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is damaged or not a picture ({1}). Save it as PNG, JPEG or BMP once more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is damaged or not a picture. Save it as PNG, JPEG or BMP once more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is empty. Choose another file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is larger than {1} MB. Simplify the drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is neither SVG, DXF nor JSON. Save the drawing as one of these.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is not a drawing that can be read. Use PNG, JPEG, BMP, SVG, DXF or JSON.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is not a file name: leave out the folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is not a picture that can be read. Save it as PNG, JPEG or BMP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is not a temperature; write it as 20C, 68F or 293K.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{0}' is not a {1}; write it as {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{}' is not a picture. Save it as PNG, JPEG or BMP once more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A corner relief of {0} would cut into the weld: choose a smaller radius or a wider allowance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A drawing with welds inside cannot be made symmetric: draw it so, and leave the symmetry off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A drawing with welds inside is not made symmetric: draw it so, and turn this off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A hole meets the outline or another hole at {0}; keep some film between them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A hole would open or close: draw that part anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A label has up to {0} letters, and a height above 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A lift of {0} g cannot be made: give one such as 5g.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A lift of {0} kg is out of reach: {1} m large, this balloon would carry {2} kg. Choose a lighter film or gas, a smaller lift, or a rounder shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A lift of {0} kg is out of reach: {1} m large, this balloon would lack {2} kg. Choose a lighter film or gas, a smaller lift, or a rounder shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A mesh of {0} is too coarse for a shape of {1}: use at most {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A mesh of {0} would need more than a million vertices for a shape of {1}: use at least {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A number of an intake is empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A passage of {0} is left open in the weld at {1}, so that air reaches both sides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture has no size of its own. Give the width or the height of the balloon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strict reader that wants plain polylines. Layers are told apart by colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A volume of {0} litres cannot be made: give one such as 10l.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A volume to inflate to and a goal for the size exclude each other: leave one out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A weld has no length; draw a line, or a circle for a spot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A weld leaves the film at {0}; keep it inside.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A weld meets the outline, itself or another weld at {0}; keep some film between them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A weld runs too near to another one or to the outline at ({0}, {1}) mm for this mesh: move it away, or use a smaller mesh size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Advice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After welding, turn the tail in through itself with a straw, at the mark beside the balloon, and fill through it up to the second mark. Pull the straw out: the air in the balloon presses the tail flat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air intake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aluminised BOPP foil, 30 µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aluminised PET ("Mylar"), 25 µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aluminised nylon/PE foil (party balloon), 30 µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An animation needs at least two frames, not {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An intake of {0} does not reach past the cut: give it at least {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm too thin to fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bending stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Black</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue 0 mm, green {:.0f} mm, red {:.0f} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both panels are on the sheet: only the front one gets the hole of the nozzle. Cut it once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot write to {0}: {1}. Choose another folder, or make room there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checked: nothing is in the way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a picture or a sketch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the balloon that it belongs to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the outline to inflate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the open task panel first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates really are inches, and the header says so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cricut Design Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Custom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut two strips from thin PE film and weld them together along their two lines; weld one strip to each panel across the neck, along its mark, with the strips' end at the mouth and their sides under the weld; then weld the panels. Fill with a straw: the pressure presses the strips together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting shop (DXF R12)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting shop in inches (DXF R2000)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DXF files can be neither read nor written without it; SVG files can.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DXF files need the Python package ezdxf. Install it with 'pip install ezdxf', or save the drawing as SVG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a closed line, or paint an area: it becomes a balloon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw lines. A closed line becomes a balloon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E across the grain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each stroke colour becomes an operation of its own. DXF is not read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every layer becomes a colour of the cut list; layers that share a colour would be merged. Set the import unit to millimetres. Switch the SEAL and REGISTRATION layers off, or give the control bar a light engraving.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill a closed line, or give an area another colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FilmBalloonPainting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find its direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit to drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For {0} litres the drawing would be {1} large: choose a volume that makes it {2} to {3} m.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD has no material card "{0}": choose one of its material editor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaps of up to {0} between lines were closed ({1} loops).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give either a volume or a lift as the goal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glowforge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glue the seams. Stiffer along the web than across it; E is the geometric mean. Does not hold gas for long and creases sharply.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glue the seams. Stiffer along the web than across it; E is the geometric mean. Porous: for a moment's inflation or with a lining.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HPGL is written as polylines: give "arcs": false.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HPGL plotter or vinyl cutter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heat sealer on a plotter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Helium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hydrogen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inflate as drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inflate with these values and show the balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inkscape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intake in a side part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is not inflated yet: choose Inflate now in its context menu, or switch Live on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kraft paper, 80 g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labels need matplotlib: install it with pip install matplotlib, or leave the label empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers, millimetres and arcs, to go on drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lift in g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LightBurn (laser)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines that close around nothing beside the shapes were left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make it!</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured on the inflated balloon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh reuse needs scipy: install it with pip install scipy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshing needs pythoncdt or scipy: install one of them with pip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshing needs scipy: install it with pip install scipy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the pointer to bend the line, then click. Esc drops it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Native</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near ({0}, {1}) mm the inflated outline stays up to {2} from the drawing, along {3}: film cannot follow it there. Round it off or widen it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Neck that chokes the air path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Never cut PVC with a laser: it gives off hydrogen chloride, which is toxic and ruins the machine. Weld with high frequency or hot air. Stretches visibly: at 2 kPa the shape depends on the grade and on the pressure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New balloon from picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New balloon from sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newmark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No balloon can be inflated anew without it; patterns can be changed and written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file for {0}: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No pattern can be drawn anew without it; documents keep theirs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No shape stands out in the picture. Use stronger colours or a plainer background.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No solver works here: {0} Build it or install the package scipy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not possible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notch with a stress peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notches of {0} do not end before the weld: the allowance is {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing can be computed without it; documents open and keep their shapes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to improve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nozzle with flange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NumPy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One large page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One-way tail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the middle of the weld. A closed weld runs past its start, so that the joint is tight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only {0} of film stay between two cuts near {1}; {2} wants {3}. It may tear or melt there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline {} x {}, {} holes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF files need it; DXF, SVG and HPGL can be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pa, its own range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint a balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint both sides at once, mirrored (M)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint broad, soft strokes: what is painted becomes a balloon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint something first: a closed line is enough.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Painted balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern correction needs scipy: install it with pip install scipy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern written to {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patterns need shapely: install it with pip install shapely.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture, SVG, DXF or JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures are read by Qt and traced with SciPy or NumPy instead, a little slower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures need OpenCV, which is missing or does not work here. Install the package python3-opencv (or opencv-python-headless), or open the picture inside FreeCAD.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain PET does not weld to itself: take a grade with a sealing layer, or tape. The aluminium (some 50 nm) adds neither stiffness nor weight. What shops sell as Mylar balloons is mostly nylon-foil.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain paper (PDF)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain shell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plotter units of 0.025 mm. Pen 1 draws the control bar, pen 2 the marks, pen 3 cuts. For a swivel knife set its offset, 0.25 mm is common.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point {0} of the JSON file's {1} is not a pair of numbers. {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polyethylene film (LDPE), 50 µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Predicted from the outline; not inflated yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previews and labels need it; everything else works.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pull a line; then move the pointer to bend it, and click. A right click keeps it straight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pull the paper. The middle button, or the space bar, does it with every tool; the wheel zooms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push a straw in, fill, pull it out and weld straight across the neck beside the balloon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push the nozzle through the hole of the front panel from inside, put the ring over it from outside, and weld flange, film and ring together along the ring's line before the panels are joined.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put outline, balloon and pattern into the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RDWorks (Ruida laser)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Real size, to cut out by hand. Print at 100 % and measure the control bar.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repair {0} cannot be read: delete it from Repairs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results cannot be written as '{0}'. Choose {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ring that warps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round this hole the balloon will not lie flat: a closed tube wants to curve more and twists out of its plane, here by about {length}. Open the ring, or seal the hole's area without cutting it out and keep it small.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round with a radius of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roundness {:.0f} % of a disc's.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SVG files can be written but not read without it; pictures, DXF and JSON can be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SVG files need the Python package svgelements. Install it with 'pip install svgelements', or save the drawing as DXF.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SciPy triangulates instead, a little slower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seal width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a sketch, a wire or a face in the tree or the 3D view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Self-sealing film valve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape that stays flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silhouette Studio (vinyl cutter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SizeGoal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So far it is a line. Close it, or paint an area, and it becomes a balloon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soft PVC film, 0.2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffer across the web than along it (up to 4.5 against 2.5 GPa): cut both panels in the same direction. Only grades with a sealing layer weld; the gas barrier is poor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straw neck</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TPU-coated nylon fabric (70 den), 170 g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take paint off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tension field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The 'parts' of the JSON file are not a list of shapes. {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The '{0}' of the JSON file are not a list of {1}. {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The DXF file has too many lines. Leave only the outline and its holes in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The DXF file {0}; millimetres are assumed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The JSON file cannot be read ({0}). {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The JSON file does not name its unit; millimetres are assumed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The JSON file has no 'outer' loop. {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The JSON file has the unknown unit {0}. Use one of {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The JSON file's {0} needs at least {1}. {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Poisson's ratio {0} is not between 0 and 0.5: give one such as 0.38.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Python package {0} is missing. {1} To get it: pip install {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SVG file cannot be read ({0}). Save it as plain SVG once more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SVG file defines entities, which are not read. Save it as plain SVG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SVG file has too many elements, or some that use themselves. Simplify it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SVG file is damaged ({0}). Save it once more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Young's modulus across the grain {0} Pa is too large for one along it of {1} Pa: turn the grain by 90 degrees and exchange the two.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The altitude {0} m is out of range: give one up to 11000 m.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The balloon is nowhere {0} wide behind its intake: choose another intake angle or a narrower intake, else air enters slowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bending floor must be between 0 and 1, not {0}. Usual is {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour would run out: close the line around this place first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing has no closed line. Draw one, and turn texts and groups into paths.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing has {0} shape{1} and no number {2}: choose another Part, or delete this balloon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing is open: a line starts at {0} and ends {1} away at {2}. Close it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing was made symmetric: its halves were {0} apart, the left one was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing would be smaller than {0}: choose a larger lift.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing; a copy of it travels in the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is XML but no SVG drawing. Choose a drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file of gases {0} is of no use: {1}. Install it anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file of rules {0} is of no use: {1}. Install it anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film '{0}' has no mass. Give its areal density.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film file {0} calls itself "{1}": give both the same name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film file {0} is of no use: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film file {0} lacks {1}: add it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film of shop-bought foil balloons: 15 µm oriented nylon 6 with an aluminium coat, 15 µm polyethylene inside. Weld PE to PE. Nylon takes up moisture and is then softer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The free edition opens DXF, not SVG. Choose "as is" for the size in the import preferences. Silhouette makes its own registration marks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The grain's angle {0} is no number: give degrees from the x axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hole at ({0}, {1}) mm is too small for a {2} seal, and its weld reaches {3} into the balloon: make the hole at least {4} wide, or the seal narrower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hole at ({0}, {1}) mm is welded but not cut out: for that, make it wider than two seals with their allowances, {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hole at {0} lies in another hole; remove one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hole at {0} lies outside the outline; move it inside.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The inflated outline stays {0} from the drawing on average: film cannot follow this shape everywhere. Round off notches and widen thin parts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intake file {0} calls itself "{1}": give both the same name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intake file {0} is of no use: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intake file {0} lacks {1}: add it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intake opens into a part with {percent} of the film; the rest fills through something narrower than the intake. Move it to the largest part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intake would run into another part of the balloon: choose another angle or length for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intake's angle must be a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intake's place along the seam must be a length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intake's width and length must be above 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intakes of two chambers run into each other: leave a gap in the weld between them, or choose another place for the first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The label "{0}" has no letter that can be drawn: write it in other letters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The label "{0}" is {1} long, and the film is only {2} wide: take a shorter text or lower letters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lines of the drawing do not close around anything: the outline follows the lines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machine file {0} calls itself "{1}": give both the same name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machine file {0} is of no use: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machine file {0} lacks {1}: add it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mesh has a vertex without triangles. Mesh the outline anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mesh size is {0} mm: give one above 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The native solver is not available: {0} Use the NumPy solver.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nozzle's flange must be wider than its bore.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline cannot be mirrored about its axis: draw it symmetric, or leave that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline crosses or nearly touches itself near ({0}, {1}) mm: separate the parts that meet there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline crosses or touches itself and cannot be meshed: separate the parts that meet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline crosses or touches itself and cannot be mirrored; part the lines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline encloses no area; draw a closed shape with at least three corners.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline has a coordinate that is not a number; correct it in the drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline's {0} of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The painting cannot be written to '{}': is the disk full?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part round {0} has no rim for an intake: leave a gap in the welds round it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pattern becomes too thin for its mesh. Widen the thin parts, or use a finer mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pattern crosses itself near ({0}, {1}) mm: simplify the drawing there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pattern has no lines for {0}, which takes {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pattern is being fitted to the painting ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pattern is not symmetric: the balloon buckles to one side, and this comes nearer to the drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pattern measures {0}, the bed of {1} {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture has a single colour. Choose one that shows a shape on a background.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture has no plain background around the shape. Use one with a background of one colour or a transparent one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is empty: all of it is transparent. Choose a picture that shows a shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is too small to see a shape. Use {0} pixels or more across.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture was read as a pen drawing: the inside of its lines is filled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pressure must be positive, not {0} Pa. A party balloon has about 2 kPa.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The radius of the corner relief must be 0 or above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The repair at {0} no longer fits, {1}: take it back or draw that part anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The seal width must be above 0 and the allowance not below 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shape in the picture is too frayed to trace. Use a clearer picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shape is only {0} mm thick near ({1}, {2}) mm, too thin for a mesh of {3}: make it thicker there, or use a mesh size of at most {4} mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shape touches the {0} border of the picture; if it was cut off there, leave more margin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation cannot take its first step. Check the outline for degenerate parts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation did not come to rest; the shape shown is its last good state. Try a coarser mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation failed: {0}. Check the outline for degenerate parts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation has no finite start. Check the outline for degenerate parts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest radius is {0}, near {1}; {2} follows {3}. It will come out rounder there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The solver '{0}' needs the Python package scipy. Install it or use the native solver.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The solver stopped; the report view tells why.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The temperature of the {0}, {1} degrees Celsius, is out of range: give one such as 20C.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tie tab at {0} degrees would run into another part: choose another angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume must be positive, not {0} m3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The way from the intake into the balloon narrows to {0}, and the intake is {1} wide: put it where the balloon is wider, else air enters slowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The width of the passages must be 0 or above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {0} "{1}" of the material card {2} cannot be read: correct the card.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {0} crosses or touches itself at {1}; part the lines there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {0} encloses no area; draw a closed shape with at least three corners.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {0} is {1} % off what was wanted: correct the goal by as much.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {0} is {1} mm: give one above 0, for example 300 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {0} line crosses itself near {1}: simplify the drawing there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {0} line that begins at {1} is open: programs fill, offset and cut closed lines only. Close it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {0} {1} is not between {2} and {3} {4}: give one such as {5}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There can be 0 to {0} notches, not {1}, with a depth above 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There can be 1 to {0} copies, not {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no backend "{0}": choose {1}, or leave it out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file '{0}'. Check the name and the folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file {0}: check the name and the folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file {}: check the name and the folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no film "{0}": choose one of {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no gas "{0}": choose one of {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no intake "{0}": choose one of {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no look "{0}": choose one of {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no machine "{0}": choose one of {1}, or give a .json file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no outline at {0} degrees from the centre: choose another intake angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no room for a flange of {0} there: choose another place or a smaller one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no solver named '{0}'. Use 'native', 'numpy' or 'newmark'.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no symmetry "{0}": choose one of {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness of the pen ([ thinner, ] thicker)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This arm is too thin to fill: drawn {width} wide, it becomes {measured} thick. Make it {wanted} wide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This arm is too thin to fill: {}. Make it {}?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This balloon holds {0} {1} litres at any pressure that suits its film: {2} litres at {3} Pa. Change the size of the balloon or the volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This gas is not lighter than the air around, so the balloon never floats: choose another gas or a higher temperature of the gas.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is shape {0} of the {1} in the drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This neck chokes the air: inside it is as wide as a tube of {measured} of film, the intake is {intake}. {behind} of the balloon fill through it. Make it {wanted} wide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This neck is too thin to let the air through: {}. Make it {}?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This notch pulls the film {measured} as tight as elsewhere; it wrinkles there and is where it would tear. Round it with a radius of {wanted}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This shape stays flat: it holds {percent} of the air that a disc of as much film would. Fewer and wider parts make it rounder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This tip stays flat over {length}: it is too pointed. Round it with a radius of {wanted}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tip that stays flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracing paper, 92 g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two panels with a grain aslant are no mirror images. Turn the grain along x or y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two shapes meet at {0}; part them, or join them into one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upload the SVG as a cut image and compare the control bar: some versions read the size at 72 dpi.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Violet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warm air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weld TPU to TPU with an iron or hot air, 10 mm wide. Warp and weft are stiff, the bias is soft: the model takes one modulus for all directions. Stiffer after the first inflations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Welds easily with an impulse sealer or an iron. Yields at about 9 MPa, half its tensile strength, and creeps: keep the pressure low.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What most shops ask for: R12, closed polylines, nothing on the sheet that is not cut. R12 knows no unit, so the file's name tells it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What works here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While this is pressed, what you select becomes the source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the balloon when it is inflated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write {"unit": "mm", "outer": [[0, 0], [300, 0], [150, 200]]}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing DXF needs ezdxf: install it with pip install ezdxf, or use the SVG file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing PDF needs reportlab: install it with pip install reportlab, or use the SVG file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Young's modulus across the grain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a {0} file has a unit of its own: give "unit": "mm".</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>balloon {0} of {1}, {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bed_mm is {0}: give [width, height], or null where there is no limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bring it to a</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colour index {0} and pen {1} of {2} must be from 1 to 255.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not name its unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it would grow together with another part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>names the unit {0}, which is not a usual one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no layer is written: name at least CUT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nobody knows "{0}": it may be one of {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not converged: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place "{0}" is neither {1} nor {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the colour "{0}" is not written like #ff0000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last line of each piece is its CUT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the layer name "{0}" may have 1 to 31 of A-Z, 0-9, _, - and $ only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width_mm must be above 0, and taper from 0.2 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} "{1}" is none of {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} and {1} lines meet near {2}: move the hole inward or make the allowance narrower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} cannot be loaded ({1}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} changed since. Choose Inflate now in its context menu, or switch Live on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} gap{1} between the lines closed, the widest {2} % of the drawing's width.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} has interface {1}, but {2} is needed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} has no pattern: choose a balloon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} has no result yet: recompute it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} has no shape: select a sketch, a wire or a face.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} has not been built.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} has several faces: select one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is empty: draw a closed line in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is neither DXF nor SVG: let the name end in .dxf or .svg.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is neither VTU, NPZ nor STL: let the name end in .vtu, .npz or .stl.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is not a coordinate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is not flat: a balloon is cut from flat film, so draw it in one plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is not up to date. {1} Repair that, recompute and export again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is {1}: give a number from {2} to {3}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is {1}: write true or false.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} loose ends of lines were joined to the drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} notches are closer than {1}: take fewer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} open line was left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} open lines were left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} reads {1}, which has no pages: choose paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} small speck was dropped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} small specks were dropped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} thin line is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} thin lines are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} tiny hole was filled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} tiny holes were filled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} was left out. {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} weld{1} outside the shapes left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} {1} cannot be made; {2} size between 1 mm and 100 m.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: make the balloon smaller, or choose another machine or paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: turn the pattern by 90 degrees there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}what is shown is the last good state. Lower the pressure or change the mesh size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{:.0f} % wrinkled, {:.0f} % slack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{:.1f} x {:.1f} mm, weld {:.0f} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{:.2f} mm, at most {:.2f} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{:.3g} g, carries {:.3g} g with {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{:.3g} g, floats from {:.0f} mm width on with {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{:.3g} g, never floats with {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} x {}, {} thick, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: {}. Esc stops.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Advice</name>
    <message>
        <source>Advice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show which parts of a shape will inflate badly, and repair them</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Equipment</name>
    <message>
        <source>Show the solver in use, and which packages are missing and what that costs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What works here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ExportPattern</name>
    <message>
        <source>Export pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the flat pattern of a balloon for a cutter, a plotter, a heat sealer or a printer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromPicture</name>
    <message>
        <source>New balloon from picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace a picture, SVG, DXF or JSON file and design the balloon that looks like it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromSketch</name>
    <message>
        <source>Design the balloon that looks like the selected sketch, wire or face and follows it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New balloon from sketch</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Paint</name>
    <message>
        <source>Draw with pen and brush, and watch the balloon and its pattern grow beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint a balloon</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>App::Property</name>
    <message>
      <source>1st: 4-node tetrahedra; 2nd: 10-node tetrahedra with their mid-side nodes on the surface</source>
      <translation>1st: 4-Knoten-Tetraeder; 2nd: 10-Knoten-Tetraeder, deren Mittelknoten auf der Oberfläche liegen</translation>
    </message>
    <message>
      <source>A case that takes longer is ended</source>
      <translation>Ein Fall, der länger braucht, wird beendet</translation>
    </message>
    <message>
      <source>Another number gives other cases</source>
      <translation>Eine andere Zahl gibt andere Fälle</translation>
    </message>
    <message>
      <source>Box from a corner, sphere around its centre, cylinder along its axis, or all that is near the references</source>
      <translation>Quader von einer Ecke aus, Kugel um ihren Mittelpunkt, Zylinder entlang seiner Achse, oder alles nahe den Referenzen</translation>
    </message>
    <message>
      <source>By how much neighbouring elements may differ in size at most</source>
      <translation>Um welchen Faktor sich die Größen benachbarter Elemente höchstens unterscheiden dürfen</translation>
    </message>
    <message>
      <source>Cases at once; 0: as many as the processors</source>
      <translation>Fälle gleichzeitig; 0: so viele wie Prozessorkerne</translation>
    </message>
    <message>
      <source>Edge length to which it grows outside; 0: the size of the mesh</source>
      <translation>Kantenlänge, bis zu der sie außen wächst; 0: die Größe des Netzes</translation>
    </message>
    <message>
      <source>Edge lengths there, mm</source>
      <translation>Kantenlängen dort, mm</translation>
    </message>
    <message>
      <source>Edges along a full circle of any curved face or edge; 0: sizes do not follow curvature</source>
      <translation>Kanten auf einem vollen Kreis jeder gekrümmten Fläche oder Kante; 0: die Größe folgt der Krümmung nicht</translation>
    </message>
    <message>
      <source>Edges, steps and strips of faces smaller than this get no elements of their own; 0: those below a two-hundredth of Size, or fewer where the part cannot be meshed without them; negative: none</source>
      <translation>Kanten, Absätze und Flächenstreifen, die kleiner sind, bekommen keine eigenen Elemente; 0: solche unter einem Zweihundertstel von Size, oder weniger, wo das Bauteil so nicht vernetzt werden kann; negativ: keine</translation>
    </message>
    <message>
      <source>Elements across thin walls; 0: sizes do not follow thickness</source>
      <translation>Elemente quer durch dünne Wände; 0: die Größe folgt der Dicke nicht</translation>
    </message>
    <message>
      <source>Elements of the mesh: tetrahedra, or triangles or segments where faces or edges are meshed</source>
      <translation>Elemente des Netzes: Tetraeder, oder Dreiecke oder Balkenelemente, wo Flächen oder Kanten vernetzt sind</translation>
    </message>
    <message>
      <source>Everything about the last mesh or update, as JSON</source>
      <translation>Alles über die letzte Vernetzung oder Aktualisierung, als JSON</translation>
    </message>
    <message>
      <source>Everything about the last solution, as JSON</source>
      <translation>Alles über die letzte Lösung, als JSON</translation>
    </message>
    <message>
      <source>FEM mesh groups</source>
      <translation>FEM-Netzgruppen</translation>
    </message>
    <message>
      <source>Faces, edges and vertices from which the distance is measured</source>
      <translation>Flächen, Kanten und Eckpunkte, von denen aus der Abstand gemessen wird</translation>
    </message>
    <message>
      <source>Files to keep of each case: mesh, inp, frd</source>
      <translation>Dateien, die von jedem Fall bleiben: mesh, inp, frd</translation>
    </message>
    <message>
      <source>FreeCAD's own result object, for FEM's result panel, filters and pipeline</source>
      <translation>FreeCADs eigenes Ergebnisobjekt, für Ergebnisfenster, Filter und Pipeline von FEM</translation>
    </message>
    <message>
      <source>Give the mesh in this document the groups of every face, edge and feature, too. Exported files have them always</source>
      <translation>Dem Netz in diesem Dokument auch die Gruppen jeder Fläche, jeder Kante und jedes Formelements geben. Exportierte Dateien haben sie immer</translation>
    </message>
    <message>
      <source>Height of the box or the cylinder, along its z axis</source>
      <translation>Höhe des Quaders oder des Zylinders, entlang seiner z-Achse</translation>
    </message>
    <message>
      <source>How far around them, mm</source>
      <translation>Wie weit um sie herum, mm</translation>
    </message>
    <message>
      <source>How far from the references the inner size reaches</source>
      <translation>Wie weit von den Referenzen die innere Größe reicht</translation>
    </message>
    <message>
      <source>How the cases are chosen</source>
      <translation>Wie die Fälle ausgewählt werden</translation>
    </message>
    <message>
      <source>In how many places smaller elements are asked for</source>
      <translation>An wie vielen Stellen kleinere Elemente verlangt sind</translation>
    </message>
    <message>
      <source>Largest displacement, mm</source>
      <translation>Größte Verschiebung, mm</translation>
    </message>
    <message>
      <source>Largest von Mises stress, MPa</source>
      <translation>Größte Vergleichsspannung (von Mises), MPa</translation>
    </message>
    <message>
      <source>Leaves the refinement out</source>
      <translation>Lässt die Verfeinerung weg</translation>
    </message>
    <message>
      <source>Length of the box, along its x axis</source>
      <translation>Länge des Quaders, entlang seiner x-Achse</translation>
    </message>
    <message>
      <source>Local sizes: FEM mesh refinements</source>
      <translation>Lokale Größen: FEM-Netzverfeinerungen</translation>
    </message>
    <message>
      <source>Mean of three times (of triangles, twice) the inscribed over the circumscribed radius; 1 for regular elements</source>
      <translation>Mittel von dreimal (bei Dreiecken zweimal) Inkugel- durch Umkugelradius; 1 für regelmäßige Elemente</translation>
    </message>
    <message>
      <source>Nodes of the mesh</source>
      <translation>Knoten des Netzes</translation>
    </message>
    <message>
      <source>Number of cases, where the sampling takes any number</source>
      <translation>Anzahl der Fälle, wo der Versuchsplan jede Anzahl zulässt</translation>
    </message>
    <message>
      <source>Over how much it grows to the outer size; 0: as fast as the mesh's Growth allows</source>
      <translation>Über welche Strecke sie zur äußeren Größe wächst; 0: so schnell, wie Growth des Netzes es zulässt</translation>
    </message>
    <message>
      <source>Parts that lie on one another share faces, and the mesh its nodes there</source>
      <translation>Bauteile, die aufeinander liegen, teilen sich Flächen, und das Netz dort seine Knoten</translation>
    </message>
    <message>
      <source>Processor threads to use; 0: all. The mesh is the same for any number</source>
      <translation>Prozessorkerne, die rechnen; 0: alle. Das Netz ist für jede Anzahl dasselbe</translation>
    </message>
    <message>
      <source>Processor threads to use; 0: all. The result is the same for any number</source>
      <translation>Prozessorkerne, die rechnen; 0: alle. Das Ergebnis ist für jede Anzahl dasselbe</translation>
    </message>
    <message>
      <source>Radius of the sphere or the cylinder</source>
      <translation>Radius der Kugel oder des Zylinders</translation>
    </message>
    <message>
      <source>Save the mesh in FreeCAD's own form, too. Without that a large document is saved in a tenth of the time and has a third of the size, but only FeatureMesh finds the mesh in it</source>
      <translation>Das Netz auch in FreeCADs eigener Form speichern. Ohne sie wird ein großes Dokument in einem Zehntel der Zeit gespeichert und hat ein Drittel der Größe, aber nur FeatureMesh findet das Netz darin</translation>
    </message>
    <message>
      <source>Share of the elements kept by the last update</source>
      <translation>Anteil der Elemente, die die letzte Aktualisierung behalten hat</translation>
    </message>
    <message>
      <source>Share of the nodes kept bit for bit by the last update</source>
      <translation>Anteil der Knoten, die die letzte Aktualisierung Bit für Bit behalten hat</translation>
    </message>
    <message>
      <source>Smallest angle between two faces of an element, or at a corner of a triangle</source>
      <translation>Kleinster Winkel zwischen zwei Flächen eines Elements oder an der Ecke eines Dreiecks</translation>
    </message>
    <message>
      <source>Smallest angle in degrees that new elements are improved towards; below 30 is faster, above 35 is rarely reached</source>
      <translation>Kleinster Winkel in Grad, bis zu dem neue Elemente verbessert werden; unter 30 geht es schneller, über 35 wird selten erreicht</translation>
    </message>
    <message>
      <source>Smallest edge length that curvature, thin walls and growth may ask for; 0: a tenth of Size</source>
      <translation>Kleinste Kantenlänge, die Krümmung, dünne Wände und Wachstum verlangen dürfen; 0: ein Zehntel von Size</translation>
    </message>
    <message>
      <source>Solve whenever the document was recomputed</source>
      <translation>Nach jeder Neuberechnung des Dokuments lösen</translation>
    </message>
    <message>
      <source>Solves the cases; automatic: live where that is enough</source>
      <translation>Löst die Fälle; automatic: mitlaufend, wo das reicht</translation>
    </message>
    <message>
      <source>The analysis that is solved for each case</source>
      <translation>Die Analyse, die für jeden Fall gelöst wird</translation>
    </message>
    <message>
      <source>The container whose parts these are, or the link that is shown</source>
      <translation>Der Container, dessen Bauteile dies sind, oder die Verknüpfung, die gezeigt wird</translation>
    </message>
    <message>
      <source>The faces that joined parts share</source>
      <translation>Die Flächen, die verbundene Bauteile sich teilen</translation>
    </message>
    <message>
      <source>The faces, edges and vertices of the responses, which are followed through edits</source>
      <translation>Die Flächen, Kanten und Eckpunkte der Zielgrößen, denen durch Änderungen gefolgt wird</translation>
    </message>
    <message>
      <source>The mesh object whose mesh this analysis is solved with</source>
      <translation>Das Netzobjekt, mit dessen Netz diese Analyse gelöst wird</translation>
    </message>
    <message>
      <source>The mesh's numbers of the nodes</source>
      <translation>Die Nummern der Knoten im Netz</translation>
    </message>
    <message>
      <source>The meshed part</source>
      <translation>Das vernetzte Bauteil</translation>
    </message>
    <message>
      <source>The part as it was when loads were given other references after the last mesh</source>
      <translation>Das Bauteil, wie es war, als Lasten nach dem letzten Netz andere Verweise bekamen</translation>
    </message>
    <message>
      <source>The part that is varied</source>
      <translation>Das Bauteil, das verändert wird</translation>
    </message>
    <message>
      <source>The part to mesh</source>
      <translation>Das zu vernetzende Bauteil</translation>
    </message>
    <message>
      <source>The parts, in the order of the solids of the shape</source>
      <translation>Die Bauteile, in der Reihenfolge der Volumenkörper der Form</translation>
    </message>
    <message>
      <source>The places, in the part's own frame</source>
      <translation>Die Stellen, im eigenen Koordinatensystem des Teils</translation>
    </message>
    <message>
      <source>The smallest edge length that is asked for</source>
      <translation>Die kleinste Kantenlänge, die verlangt ist</translation>
    </message>
    <message>
      <source>Time the last mesh or update took</source>
      <translation>Dauer der letzten Vernetzung oder Aktualisierung</translation>
    </message>
    <message>
      <source>Time the last solution took</source>
      <translation>Dauer der letzten Lösung</translation>
    </message>
    <message>
      <source>Update the mesh whenever the document is recomputed</source>
      <translation>Das Netz bei jeder Neuberechnung des Dokuments aktualisieren</translation>
    </message>
    <message>
      <source>Wanted edge length of the elements</source>
      <translation>Gewünschte Kantenlänge der Elemente</translation>
    </message>
    <message>
      <source>Wanted edge length of the elements inside</source>
      <translation>Gewünschte Kantenlänge der Elemente darin</translation>
    </message>
    <message>
      <source>What is asked of each case, such as max_mises@Face3</source>
      <translation>Was von jedem Fall gefragt ist, etwa max_mises@Face3</translation>
    </message>
    <message>
      <source>What is meshed: solids with tetrahedra, faces with triangles (shells), edges with segments (beams); From shape: solids and what is beside them, else faces, else edges</source>
      <translation>Was vernetzt wird: Solids: Volumenkörper mit Tetraedern; Faces: Flächen mit Dreiecken (Schalen); Edges: Kanten mit Balkenelementen; From shape: Volumenkörper und was neben ihnen ist, sonst Flächen, sonst Kanten</translation>
    </message>
    <message>
      <source>What is varied, such as Fillet.Radius=2:6</source>
      <translation>Was verändert wird, etwa Fillet.Radius=2:6</translation>
    </message>
    <message>
      <source>What it referred to and is gone; it needs new references</source>
      <translation>Worauf es sich bezog und was es nicht mehr gibt; es braucht neue Referenzen</translation>
    </message>
    <message>
      <source>What loads, supports, materials and refinements referred to, as JSON</source>
      <translation>Worauf sich Lasten, Lager, Werkstoffe und Verfeinerungen bezogen, als JSON</translation>
    </message>
    <message>
      <source>What of its references was clicked through a link, with the path to it</source>
      <translation>Welche seiner Referenzen über eine Verknüpfung angeklickt wurden, mit dem Pfad dorthin</translation>
    </message>
    <message>
      <source>What of the analysis is solved: mesh, materials, supports, loads</source>
      <translation>Was von der Analyse gelöst wird: Netz, Werkstoffe, Lager, Lasten</translation>
    </message>
    <message>
      <source>What the next update needs</source>
      <translation>Was die nächste Aktualisierung braucht</translation>
    </message>
    <message>
      <source>What the parameters have to keep, such as Fillet.Radius &lt; 5</source>
      <translation>Was die Parameter einhalten müssen, etwa Fillet.Radius &lt; 5</translation>
    </message>
    <message>
      <source>Where the cases are kept</source>
      <translation>Wo die Fälle liegen</translation>
    </message>
    <message>
      <source>Where the solids of the parts were when they were put together</source>
      <translation>Wo die Volumenkörper der Bauteile waren, als sie zusammengefügt wurden</translation>
    </message>
    <message>
      <source>Whether the mesh fits the part, and if not, why</source>
      <translation>Ob das Netz zum Bauteil passt, und wenn nicht, warum</translation>
    </message>
    <message>
      <source>Whether the result is that of the part as it is, and if not, why</source>
      <translation>Ob das Ergebnis zum Bauteil gehört, wie es ist, und wenn nicht, warum</translation>
    </message>
    <message>
      <source>Which state SavedState is, by which it is found after undo</source>
      <translation>Welcher Zustand SavedState ist; danach wird er nach dem Rückgängigmachen gefunden</translation>
    </message>
    <message>
      <source>Which state of the mesh the result is of</source>
      <translation>Zu welchem Stand des Netzes das Ergebnis gehört</translation>
    </message>
    <message>
      <source>Why the last solution failed, as JSON</source>
      <translation>Warum die letzte Lösung gescheitert ist, als JSON</translation>
    </message>
    <message>
      <source>Why the last update failed, as JSON</source>
      <translation>Warum die letzte Aktualisierung gescheitert ist, als JSON</translation>
    </message>
    <message>
      <source>Width of the box, along its y axis</source>
      <translation>Breite des Quaders, entlang seiner y-Achse</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh</name>
    <message>
      <source> (%d inside the part before)</source>
      <translation> (%d davon vorher im Inneren des Bauteils)</translation>
    </message>
    <message>
      <source> (%d now inside the part)</source>
      <translation> (%d davon jetzt im Inneren des Bauteils)</translation>
    </message>
    <message>
      <source> (before the last edit)</source>
      <translation> (vor der letzten Änderung)</translation>
    </message>
    <message>
      <source> deg</source>
      <translation>°</translation>
    </message>
    <message>
      <source> of {part:text}</source>
      <translation> von {part:text}</translation>
    </message>
    <message>
      <source>%s acts along %s, which is gone; open it and choose its direction again</source>
      <translation>%s wirkt entlang %s, das es nicht mehr gibt; öffnen und die Richtung neu wählen</translation>
    </message>
    <message>
      <source>%s has the mesh %s, and an analysis is solved with one mesh.</source>
      <translation>%s hat das Netz %s, und eine Analyse wird mit einem Netz gelöst.</translation>
    </message>
    <message>
      <source>%s is there already. Replace it?</source>
      <translation>%s gibt es schon. Ersetzen?</translation>
    </message>
    <message>
      <source>%s refers to %s, which is gone; choose another face, edge or solid for it</source>
      <translation>%s bezieht sich auf %s, das es nicht mehr gibt; dafür eine andere Fläche, eine andere Kante oder einen anderen Volumenkörper wählen</translation>
    </message>
    <message>
      <source>%s was edited and not recomputed; recompute the document (Edit, Refresh) before solving</source>
      <translation>%s wurde geändert und nicht neu berechnet; vor dem Lösen das Dokument neu berechnen (Bearbeiten, Aktualisieren)</translation>
    </message>
    <message>
      <source>%s was written to %s (%s)</source>
      <translation>%s wurde nach %s geschrieben (%s)</translation>
    </message>
    <message>
      <source>, did you mean {name:text}?</source>
      <translation>, war {name:text} gemeint?</translation>
    </message>
    <message>
      <source>, not of {foreign:text}</source>
      <translation>, nicht von {foreign:text}</translation>
    </message>
    <message>
      <source>--method optuna needs Optuna: install Debian's package python3-optuna</source>
      <translation>--method optuna braucht Optuna: Debians Paket python3-optuna installieren</translation>
    </message>
    <message>
      <source>--scheduler needs Dask: install Debian's package python3-distributed</source>
      <translation>--scheduler braucht Dask: Debians Paket python3-distributed installieren</translation>
    </message>
    <message>
      <source>--slurm needs Slurm's program sbatch, which is not on this machine's path; run the study on a machine that submits Slurm jobs</source>
      <translation>--slurm braucht Slurms Programm sbatch, das auf dieser Maschine nicht im Suchpfad ist; die Studie auf einer Maschine rechnen, die Slurm-Jobs abschickt</translation>
    </message>
    <message>
      <source>--slurm needs dask-jobqueue, which is not among Debian's packages: python3 -m pip install dask-jobqueue</source>
      <translation>--slurm braucht dask-jobqueue, das nicht unter Debians Paketen ist: python3 -m pip install dask-jobqueue</translation>
    </message>
    <message>
      <source>10-node tetrahedra have mid-side nodes on the surface; 4-node ones are too stiff in bending</source>
      <translation>10-Knoten-Tetraeder haben Mittelknoten auf der Oberfläche; 4-Knoten-Tetraeder sind auf Biegung zu steif</translation>
    </message>
    <message>
      <source>: not {objects:text}</source>
      <translation>: nicht {objects:text}</translation>
    </message>
    <message>
      <source>; did you mean {names:messages}?</source>
      <translation>; war {names:messages} gemeint?</translation>
    </message>
    <message>
      <source>; its parts are {names:text}</source>
      <translation>; seine Teile sind {names:text}</translation>
    </message>
    <message>
      <source>A part of the mesh has no material. Give every solid one.</source>
      <translation>Ein Teil des Netzes hat keinen Werkstoff. Jedem Volumenkörper einen geben.</translation>
    </message>
    <message>
      <source>About %d million elements need about %d GB of memory; %d GB are free.</source>
      <translation>Etwa %d Millionen Elemente brauchen etwa %d GB Speicher; %d GB sind frei.</translation>
    </message>
    <message>
      <source>Across walls</source>
      <translation>In Wänden</translation>
    </message>
    <message>
      <source>All cases at once</source>
      <translation>Alle Fälle zugleich</translation>
    </message>
    <message>
      <source>All of the part is smaller than the details that are ignored. Ask for a smaller size, or ignore smaller details only (property IgnoreBelow).</source>
      <translation>Das ganze Bauteil ist kleiner als die Einzelheiten, die übergangen werden. Eine kleinere Elementgröße verlangen oder nur kleinere Einzelheiten übergehen (Eigenschaft IgnoreBelow).</translation>
    </message>
    <message>
      <source>An adopted mesh keeps its element order. Mesh the part from scratch for another one.</source>
      <translation>Ein übernommenes Netz behält seine Elementordnung. Für eine andere das Bauteil vollständig neu vernetzen.</translation>
    </message>
    <message>
      <source>Box-Behnken needs at least three parameters, not {count:count}; take central_composite</source>
      <translation>Box-Behnken braucht mindestens drei Parameter, nicht {count:count}; stattdessen central_composite nehmen</translation>
    </message>
    <message>
      <source>CalculiX failed (exit code {code:count}): {why:messages}</source>
      <translation>CalculiX ist gescheitert (Rückgabewert {code:count}): {why:messages}</translation>
    </message>
    <message>
      <source>CalculiX found {modes:count} {modes:mode|modes}; ask its solver for more</source>
      <translation>CalculiX fand {modes:count} {modes:Eigenform|Eigenformen}; bei seinem Löser mehr anfordern</translation>
    </message>
    <message>
      <source>CalculiX gave no displacements for {analysis:text}</source>
      <translation>CalculiX lieferte keine Verschiebungen für {analysis:text}</translation>
    </message>
    <message>
      <source>CalculiX gave what is no number for {analysis:text}: look at its loads, materials and units, or choose another MatrixSolverType</source>
      <translation>CalculiX lieferte für {analysis:text} etwas, das keine Zahl ist: prüfen Sie Lasten, Materialien und Einheiten, oder wählen Sie einen anderen MatrixSolverType</translation>
    </message>
    <message>
      <source>CalculiX got nothing of {loads:text}, for which FreeCAD found no elements</source>
      <translation>CalculiX erhielt nichts von {loads:text}: FreeCAD fand dafür keine Elemente</translation>
    </message>
    <message>
      <source>CalculiX got nothing of {loads:text}, which FreeCAD does not write for the type of analysis {kind:text}</source>
      <translation>CalculiX erhielt nichts von {loads:text}, was FreeCAD für die Analyseart {kind:text} nicht schreibt</translation>
    </message>
    <message>
      <source>CalculiX left no readable result: {why:messages}</source>
      <translation>CalculiX hinterließ kein lesbares Ergebnis: {why:messages}</translation>
    </message>
    <message>
      <source>CalculiX was ended from outside ({signal:text})</source>
      <translation>CalculiX wurde von außen beendet ({signal:text})</translation>
    </message>
    <message>
      <source>CalculiX's program is set to {path:text}, which cannot be run; choose another one in FreeCAD's preferences, FEM &gt; CalculiX</source>
      <translation>Als Programm von CalculiX ist {path:text} eingestellt, das nicht ausgeführt werden kann; in FreeCADs Einstellungen, FEM &gt; CalculiX, ein anderes wählen</translation>
    </message>
    <message>
      <source>CalculiX's program is set to {path:text}, which is not CalculiX; choose another one in FreeCAD's preferences, FEM &gt; CalculiX</source>
      <translation>Als Programm von CalculiX ist {path:text} eingestellt, das nicht CalculiX ist; in FreeCADs Einstellungen, FEM &gt; CalculiX, ein anderes wählen</translation>
    </message>
    <message>
      <source>Compromises between {one:messages} and {other:messages}</source>
      <translation>Kompromisse zwischen {one:messages} und {other:messages}</translation>
    </message>
    <message>
      <source>Details of the part far smaller than the elements force an angle below 2 degrees on {elements:count} {elements:element|elements}: {details:messages}. Results there are poor. Take them out of the features that make them (points of a sketch that nearly coincide, a step as shallow), or mesh finer there.</source>
      <translation>Einzelheiten des Bauteils, die viel kleiner als die Elemente sind, erzwingen einen Winkel unter 2 Grad an {elements:count} {elements:Element|Elementen}: {details:messages}. Ergebnisse dort sind ungenau. Sie aus den Formelementen entfernen, die sie erzeugen (Skizzenpunkte, die fast zusammenfallen, eine ebenso flache Stufe), oder dort feiner vernetzen.</translation>
    </message>
    <message>
      <source>Details smaller than {below:length} have no elements of their own: {places:entities}.</source>
      <translation>Details unter {below:length} haben keine eigenen Elemente: {places:entities}.</translation>
    </message>
    <message>
      <source>Engine</source>
      <translation>Rechenprogramm</translation>
    </message>
    <message>
      <source>Error of the mesh</source>
      <translation>Fehler des Netzes</translation>
    </message>
    <message>
      <source>FreeCAD cannot open {path:text}: {why:messages}</source>
      <translation>FreeCAD kann {path:text} nicht öffnen: {why:messages}</translation>
    </message>
    <message>
      <source>FreeCAD cannot read the meshes of {path:text}: that takes {needed:number} MB in the folder for temporary files, {folder:text}, where {room:number} MB can be written; make room, or set TMPDIR to another folder</source>
      <translation>FreeCAD kann die Netze von {path:text} nicht lesen: Das braucht {needed:number} MB im Ordner für temporäre Dateien, {folder:text}, in den {room:number} MB geschrieben werden können; Platz schaffen oder TMPDIR auf einen anderen Ordner setzen</translation>
    </message>
    <message>
      <source>FreeCAD cannot write a mesh to the folder for temporary files, {folder:text}; is it full?</source>
      <translation>FreeCAD kann kein Netz in den Ordner für temporäre Dateien, {folder:text}, schreiben; ist er voll?</translation>
    </message>
    <message>
      <source>FreeCAD could not write CalculiX's input for {analysis:text}: {why:text}; is there a load of 0, on nothing, or on a face and an edge at once?</source>
      <translation>FreeCAD konnte die Eingabe für CalculiX zu {analysis:text} nicht schreiben: {why:text}; gibt es eine Last von 0, auf nichts, oder auf einer Fläche und einer Kante zugleich?</translation>
    </message>
    <message>
      <source>FreeCAD crashed ({signal:text})</source>
      <translation>FreeCAD ist abgestürzt ({signal:text})</translation>
    </message>
    <message>
      <source>FreeCAD does not answer</source>
      <translation>FreeCAD antwortet nicht</translation>
    </message>
    <message>
      <source>FreeCAD ended</source>
      <translation>FreeCAD hat sich beendet</translation>
    </message>
    <message>
      <source>FreeCAD ended ({why:messages})</source>
      <translation>FreeCAD hat sich beendet ({why:messages})</translation>
    </message>
    <message>
      <source>FreeCAD ended with exit code {code:count}</source>
      <translation>FreeCAD endete mit dem Rückgabewert {code:count}</translation>
    </message>
    <message>
      <source>FreeCAD made a shape of {part:text} that is not valid</source>
      <translation>FreeCAD hat für {part:text} eine ungültige Form erzeugt</translation>
    </message>
    <message>
      <source>FreeCAD refuses {value:text} for {object:text}.{name:text} (it would take {taken:text})</source>
      <translation>FreeCAD nimmt {value:text} für {object:text}.{name:text} nicht an (es nähme {taken:text})</translation>
    </message>
    <message>
      <source>FreeCAD refuses {value:text} for {object:text}.{name:text}: {why:messages}</source>
      <translation>FreeCAD nimmt {value:text} für {object:text}.{name:text} nicht an: {why:messages}</translation>
    </message>
    <message>
      <source>FreeCAD refuses {value:text} for {target:text}: {why:messages}</source>
      <translation>FreeCAD nimmt {value:text} für {target:text} nicht an: {why:messages}</translation>
    </message>
    <message>
      <source>FreeCAD wrote no document</source>
      <translation>FreeCAD hat kein Dokument geschrieben</translation>
    </message>
    <message>
      <source>FreeCAD {later:text} saved this document: what FreeCAD {version:text} does not know of it is not in the file that was written now, and an edit of it may fail</source>
      <translation>FreeCAD {later:text} hat dieses Dokument gespeichert: was FreeCAD {version:text} davon nicht kennt, ist nicht in der Datei, die jetzt geschrieben wurde, und eine Änderung daran kann scheitern</translation>
    </message>
    <message>
      <source>FreeCAD {version:text} cannot read all of {path:text}{objects:messages}, and writing it would lose that; write another file with --out, or take the FreeCAD that it was made with</source>
      <translation>FreeCAD {version:text} kann nicht alles von {path:text} lesen{objects:messages}, und es ginge beim Schreiben verloren; mit --out eine andere Datei schreiben oder das FreeCAD nehmen, mit dem sie gemacht wurde</translation>
    </message>
    <message>
      <source>FreeCAD's General Fuse makes another shape of {part:text}, so it cannot be joined to the parts that it touches; check it (Part: Check geometry)</source>
      <translation>FreeCADs „General Fuse“ macht aus {part:text} eine andere Form, deshalb lässt es sich nicht mit den Bauteilen verbinden, die es berührt; die Form prüfen (Part: Geometrie prüfen)</translation>
    </message>
    <message>
      <source>Its libraries</source>
      <translation>Bibliotheken</translation>
    </message>
    <message>
      <source>Leave it there</source>
      <translation>Dort lassen</translation>
    </message>
    <message>
      <source>Less of both: {cases:text}.</source>
      <translation>Weniger von beidem: {cases:text}.</translation>
    </message>
    <message>
      <source>Log</source>
      <translation>Protokoll</translation>
    </message>
    <message>
      <source>Mesh all the same</source>
      <translation>Trotzdem vernetzen</translation>
    </message>
    <message>
      <source>Nothing is beside {edges:entities}: the faces there lie on one another, as of a slit without a width in the midst of the part. Take out or widen the feature that made it, or ask for details below a smaller length to be ignored.</source>
      <translation>Neben {edges:entities} liegt nichts: Die Flächen dort liegen aufeinander, wie die eines Schlitzes ohne Breite mitten im Teil. Entfernen oder verbreitern Sie das Feature, das ihn erzeugt hat, oder lassen Sie nur Details unter einer kleineren Länge weg.</translation>
    </message>
    <message>
      <source>Of the energy norm: how far stresses may be off in the mean, because the elements are not smaller</source>
      <translation>In der Energienorm: wie weit Spannungen im Mittel falsch sein dürfen, weil die Elemente nicht kleiner sind</translation>
    </message>
    <message>
      <source>Pareto front</source>
      <translation>Pareto-Front</translation>
    </message>
    <message>
      <source>Refine where it is off</source>
      <translation>Verfeinern, wo er groß ist</translation>
    </message>
    <message>
      <source>Refinement by error</source>
      <translation>Verfeinerung nach Fehler</translation>
    </message>
    <message>
      <source>Responses over parameters</source>
      <translation>Zielgrößen über Parametern</translation>
    </message>
    <message>
      <source>Sampling</source>
      <translation>Versuchsplan</translation>
    </message>
    <message>
      <source>Study of {document:text}</source>
      <translation>Studie von {document:text}</translation>
    </message>
    <message>
      <source>System</source>
      <translation>System</translation>
    </message>
    <message>
      <source>Take its place</source>
      <translation>Seinen Platz nehmen</translation>
    </message>
    <message>
      <source>The adopted mesh can take its place; %s stays in the document.</source>
      <translation>Das übernommene Netz kann seinen Platz nehmen; %s bleibt im Dokument.</translation>
    </message>
    <message>
      <source>The expression %s drives this; change it in the property editor</source>
      <translation>Der Ausdruck %s bestimmt dies; im Eigenschafteneditor ändern</translation>
    </message>
    <message>
      <source>The geometry kernel failed: {why:text}. Check the shape (Part: Check geometry).</source>
      <translation>Der Geometriekern ist gescheitert: {why:text}. Die Form prüfen (Part: Geometrie prüfen).</translation>
    </message>
    <message>
      <source>The main effect is the response's mean change from a parameter's lowest to its highest value; the indices are Sobol's shares of the variance. All are of the response surface: they mean no more than its error allows, which is that of cases left out of the fit.</source>
      <translation>Der Haupteffekt ist die mittlere Änderung der Zielgröße vom kleinsten zum größten Wert eines Parameters; die Indizes sind die Anteile an der Varianz nach Sobol. Alle gelten für die Antwortfläche: Sie sagen nicht mehr, als deren Fehler zulässt, der an Fällen bestimmt ist, die bei der Anpassung weggelassen wurden.</translation>
    </message>
    <message>
      <source>The mesh has more than {limit:count} {limit:element|elements}: it is saved in FeatureMesh's form only, in a tenth of the time. A FreeCAD without FeatureMesh finds no mesh in the document then; to save FreeCAD's form, too, set SavedForFreeCAD to Always.</source>
      <translation>Das Netz hat mehr als {limit:count} {limit:Element|Elemente}: Es wird nur in FeatureMeshs Form gespeichert, in einem Zehntel der Zeit. Ein FreeCAD ohne FeatureMesh findet dann kein Netz im Dokument; um auch FreeCADs Form zu speichern, SavedForFreeCAD auf Always setzen.</translation>
    </message>
    <message>
      <source>The mesh is in no analysis: %s has %s already, and an analysis is solved with one mesh. Drag the other one out of it and this one into it, if this one is to be solved.</source>
      <translation>Das Netz ist in keiner Analyse: %s hat schon %s, und eine Analyse wird mit einem Netz gelöst. Soll dieses gelöst werden, das andere aus ihr heraus- und dieses hineinziehen.</translation>
    </message>
    <message>
      <source>The mesh is not valid: {finding:messages} (and {more:count} more). Try another size, or check the shape there (Part: Check geometry).</source>
      <translation>Das Netz ist nicht gültig: {finding:messages} (und {more:count} weitere). Eine andere Größe versuchen, oder die Form dort prüfen (Part: Geometrie prüfen).</translation>
    </message>
    <message>
      <source>The mesh is not valid: {finding:messages}. Try another size, or check the shape there (Part: Check geometry).</source>
      <translation>Das Netz ist nicht gültig: {finding:messages}. Eine andere Größe versuchen, oder die Form dort prüfen (Part: Geometrie prüfen).</translation>
    </message>
    <message>
      <source>The mesh is not valid: {triangles:count} {triangles:surface triangle is|surface triangles are} turned over, the first on {face:entities} at {place:point}. The face bends too much there for this size; ask for a smaller size on it.</source>
      <translation>Das Netz ist nicht gültig: {triangles:count} {triangles:Dreieck der Oberfläche ist|Dreiecke der Oberfläche sind} umgeklappt, das erste auf {face:entities} bei {place:point}. Die Fläche krümmt sich dort zu stark für diese Größe; auf ihr eine kleinere Größe wählen.</translation>
    </message>
    <message>
      <source>The mesh is too fine for the live solver, whose matrix would have more than 2 billion entries. Choose a larger size.</source>
      <translation>Das Netz ist zu fein für den mitlaufenden Löser, dessen Matrix mehr als 2 Milliarden Einträge hätte. Eine größere Größe wählen.</translation>
    </message>
    <message>
      <source>The new mesh can take its place, with its refinements, groups, size and order; %s stays in the document.</source>
      <translation>Das neue Netz kann seinen Platz nehmen, mit seinen Verfeinerungen, Gruppen, seiner Größe und Ordnung; %s bleibt im Dokument.</translation>
    </message>
    <message>
      <source>The number of elements across walls is {asked:number}; it must not be negative (0 turns it off).</source>
      <translation>Die Zahl der Elemente in Wänden ist {asked:number}; sie darf nicht negativ sein (0 schaltet ab).</translation>
    </message>
    <message>
      <source>The reactions are off by {share:number} % of the loads, since CalculiX's iterative solver ends early; with a direct one, the property MatrixSolverType of {solver:text}, they are not</source>
      <translation>Die Reaktionskräfte weichen um {share:number} % der Lasten ab, da der iterative Löser von CalculiX früh endet; mit einem direkten, Eigenschaft MatrixSolverType von {solver:text}, tun sie das nicht</translation>
    </message>
    <message>
      <source>The smallest angle that the part does not force is {angle:number} degrees, at {place:entities}: stresses are poor there. Mesh finer there, by a local size or a refinement zone, or take details out that are much smaller than the edge length.</source>
      <translation>Der kleinste Winkel, den das Bauteil nicht erzwingt, ist {angle:number} Grad, bei {place:entities}: Spannungen dort sind ungenau. Dort mit einer lokalen Größe oder einer Verfeinerungszone feiner vernetzen oder Einzelheiten weglassen, die viel kleiner als die Kantenlänge sind.</translation>
    </message>
    <message>
      <source>There are too few cases for response surfaces of {parameters:count} {parameters:parameter|parameters}; add some.</source>
      <translation>Es sind zu wenige Fälle für Antwortflächen von {parameters:count} {parameters:Parameter|Parametern}; weitere hinzufügen.</translation>
    </message>
    <message>
      <source>These solids touch or overlap without sharing faces: {solids:messages} ({faces:messages}). Each has a mesh of its own: no load passes between them but by ties and contacts, and where they overlap the material counts twice. If that is not meant, fuse them, or let them share faces: by Part's Boolean Fragments, or, where they are the parts of a container, by the property Join of its object 'Parts of ...'.</source>
      <translation>Diese Volumenkörper berühren oder überlappen sich, ohne Flächen zu teilen: {solids:messages} ({faces:messages}). Jeder hat ein eigenes Netz: Zwischen ihnen geht außer durch Verbindungen (Tie) und Kontakte keine Last über, und wo sie sich überlappen, zählt der Werkstoff doppelt. Wenn das nicht gewollt ist, sie vereinigen oder Flächen teilen lassen: mit den Booleschen Fragmenten von Part oder, wenn es Bauteile eines Containers sind, mit der Eigenschaft Join seines Objekts „Bauteile von ...“.</translation>
    </message>
    <message>
      <source>These vertices are nearer to another one than {distance:length} and share its node: {vertices:entities}.</source>
      <translation>Diese Eckpunkte liegen näher als {distance:length} an einem anderen und teilen sich dessen Knoten: {vertices:entities}.</translation>
    </message>
    <message>
      <source>These vertices lie within a millionth of the part's size of another one and share its node: {vertices:entities}.</source>
      <translation>Diese Eckpunkte liegen auf ein Millionstel der Bauteilgröße genau an einem anderen und teilen sich dessen Knoten: {vertices:entities}.</translation>
    </message>
    <message>
      <source>This is in no mesh. Drag it to one in the tree.</source>
      <translation>Dies ist in keinem Netz. Im Baum auf eines ziehen.</translation>
    </message>
    <message>
      <source>Wanted</source>
      <translation>Gewünscht</translation>
    </message>
    <message>
      <source>What matters</source>
      <translation>Was wichtig ist</translation>
    </message>
    <message>
      <source>What the colours over the mesh mean when the last update is shown</source>
      <translation>Was die Farben über dem Netz bedeuten, wenn die letzte Aktualisierung gezeigt wird</translation>
    </message>
    <message>
      <source>Where memory runs out, what is not saved is lost. A larger size makes fewer elements.</source>
      <translation>Wenn der Speicher nicht reicht, geht verloren, was nicht gespeichert ist. Eine größere Elementgröße macht weniger Elemente.</translation>
    </message>
    <message>
      <source>a body, or a Part object with a solid</source>
      <translation>einen Körper oder ein Part-Objekt mit einem Volumenkörper</translation>
    </message>
    <message>
      <source>a case needs about {needed:text} GB of memory, and {free:text} GB are free; take a coarser mesh, or free memory</source>
      <translation>ein Fall braucht etwa {needed:text} GB Speicher, und {free:text} GB sind frei; ein gröberes Netz nehmen oder Speicher freigeben</translation>
    </message>
    <message>
      <source>a case needs at least one thread, not {threads:count}</source>
      <translation>ein Fall braucht mindestens einen Prozessorkern, nicht {threads:count}</translation>
    </message>
    <message>
      <source>a list in square brackets</source>
      <translation>eine Liste in eckigen Klammern</translation>
    </message>
    <message>
      <source>a live result</source>
      <translation>ein mitlaufendes Ergebnis</translation>
    </message>
    <message>
      <source>a mesh</source>
      <translation>einem Netz</translation>
    </message>
    <message>
      <source>a mesh of FeatureMesh</source>
      <translation>ein Netz von FeatureMesh</translation>
    </message>
    <message>
      <source>a number</source>
      <translation>eine Zahl</translation>
    </message>
    <message>
      <source>a reference is an object and a name, such as (part, "Face3"), not {reference:text}</source>
      <translation>ein Verweis ist ein Objekt und ein Name, etwa (part, "Face3"), nicht {reference:text}</translation>
    </message>
    <message>
      <source>a refinement zone</source>
      <translation>eine Verfeinerungszone</translation>
    </message>
    <message>
      <source>a response has no name: {response:text}</source>
      <translation>eine Zielgröße hat keinen Namen: {response:text}</translation>
    </message>
    <message>
      <source>a response has no {key:text}; known are {known:text}</source>
      <translation>eine Zielgröße hat kein {key:text}; es gibt {known:text}</translation>
    </message>
    <message>
      <source>a response is a text such as "max_mises" or a table, not {response:text}</source>
      <translation>eine Zielgröße ist ein Text wie "max_mises" oder eine Tabelle, nicht {response:text}</translation>
    </message>
    <message>
      <source>a result</source>
      <translation>ein Ergebnis</translation>
    </message>
    <message>
      <source>a step of the meshing was ended from outside, as the system does where memory is short; close other programs, or choose a larger size</source>
      <translation>ein Schritt der Vernetzung wurde von außen beendet, wie es das System bei Speichermangel tut; andere Programme schließen oder eine größere Größe wählen</translation>
    </message>
    <message>
      <source>a study asks for figures of solids, of shells or of beams alone, and {part:text} has several of them in one analysis; study a part of one kind, or ask for its volume or area only</source>
      <translation>eine Studie fragt nach Werten von Volumenkörpern, von Schalen oder von Balken allein, und {part:text} hat mehrere davon in einer Analyse; ein Bauteil einer Art untersuchen, oder nur nach seinem Volumen oder seiner Fläche fragen</translation>
    </message>
    <message>
      <source>a study has at most {most:count} cases; {cases:count} are too many</source>
      <translation>eine Studie hat höchstens {most:count} Fälle; {cases:count} sind zu viele</translation>
    </message>
    <message>
      <source>a table</source>
      <translation>eine Tabelle</translation>
    </message>
    <message>
      <source>a table is written as csv or json, not {format:text}</source>
      <translation>eine Tabelle wird als csv oder json geschrieben, nicht als {format:text}</translation>
    </message>
    <message>
      <source>a text in quotes</source>
      <translation>ein Text in Anführungszeichen</translation>
    </message>
    <message>
      <source>a whole number</source>
      <translation>eine ganze Zahl</translation>
    </message>
    <message>
      <source>a worker cannot open the base document: {why:messages}</source>
      <translation>ein Arbeitsprozess kann das Ausgangsdokument nicht öffnen: {why:messages}</translation>
    </message>
    <message>
      <source>a worker cannot start: {why:messages}; see the worker logs in {folder:text}</source>
      <translation>ein Arbeitsprozess kann nicht starten: {why:messages}; siehe die Protokolle der Arbeitsprozesse in {folder:text}</translation>
    </message>
    <message>
      <source>about %s %%</source>
      <translation>etwa %s %%</translation>
    </message>
    <message>
      <source>about {hours:number} h left</source>
      <translation>noch etwa {hours:number} h</translation>
    </message>
    <message>
      <source>about {millions:count} million</source>
      <translation>etwa {millions:count} {millions:Million|Millionen}</translation>
    </message>
    <message>
      <source>about {minutes:count} min left</source>
      <translation>noch etwa {minutes:count} min</translation>
    </message>
    <message>
      <source>about {seconds:count} s left</source>
      <translation>noch etwa {seconds:count} s</translation>
    </message>
    <message>
      <source>active: {nodes:count} {nodes:node kept as start position|nodes kept as start positions}, free to move</source>
      <translation>beweglich: {nodes:count} {nodes:Knoten|Knoten}, als Startlage behalten</translation>
    </message>
    <message>
      <source>additive</source>
      <translation>additiv</translation>
    </message>
    <message>
      <source>all loads act on what the supports hold, so nothing moves; look at the faces, edges and vertices that they are on</source>
      <translation>alle Lasten wirken auf das, was die Lager halten, so dass sich nichts bewegt; die Flächen, Kanten und Ecken ansehen, auf denen sie sind</translation>
    </message>
    <message>
      <source>an analysis</source>
      <translation>eine Analyse</translation>
    </message>
    <message>
      <source>and %d more: let the mouse rest here</source>
      <translation>und %d weitere: den Mauszeiger hier ruhen lassen</translation>
    </message>
    <message>
      <source>around one face or edge at most {most:count} million are made</source>
      <translation>um eine Fläche oder Kante werden höchstens {most:count} Millionen gemacht</translation>
    </message>
    <message>
      <source>at most {most:count} million are made</source>
      <translation>höchstens {most:count} Millionen werden gemacht</translation>
    </message>
    <message>
      <source>at {place:messages}</source>
      <translation>bei {place:messages}</translation>
    </message>
    <message>
      <source>at {place:messages} (radius {before:length} -&gt; {after:length})</source>
      <translation>bei {place:messages} (Radius {before:length} → {after:length})</translation>
    </message>
    <message>
      <source>base</source>
      <translation>Basis</translation>
    </message>
    <message>
      <source>before and after</source>
      <translation>davor und danach</translation>
    </message>
    <message>
      <source>being solved for the first time</source>
      <translation>wird zum ersten Mal gelöst</translation>
    </message>
    <message>
      <source>boolean</source>
      <translation>boolesch</translation>
    </message>
    <message>
      <source>buckling factor {mode:count}</source>
      <translation>Knickfaktor {mode:count}</translation>
    </message>
    <message>
      <source>built from source</source>
      <translation>aus dem Quelltext gebaut</translation>
    </message>
    <message>
      <source>cannot read '{text:text}'; a parameter is OBJECT.PROPERTY=LOW:HIGH, with :LEVELS for a grid, or OBJECT.PROPERTY=A,B,C</source>
      <translation>„{text:text}“ ist nicht lesbar; ein Parameter ist OBJEKT.EIGENSCHAFT=VON:BIS, mit :STUFEN für ein Gitter, oder OBJEKT.EIGENSCHAFT=A,B,C</translation>
    </message>
    <message>
      <source>cannot read the edit '{edit:text}', it has to be OBJECT.PROPERTY=VALUE</source>
      <translation>die Änderung „{edit:text}“ ist nicht lesbar, sie muss OBJEKT.EIGENSCHAFT=WERT sein</translation>
    </message>
    <message>
      <source>cannot read the response '{response:text}'; it is KIND, KIND@PLACE or KIND:p95</source>
      <translation>die Zielgröße „{response:text}“ ist nicht lesbar; sie ist ART, ART@ORT oder ART:p95</translation>
    </message>
    <message>
      <source>cannot read {path:text}: {why:messages}</source>
      <translation>{path:text} kann nicht gelesen werden: {why:messages}</translation>
    </message>
    <message>
      <source>cannot set {target:text}; of placements it can be Base.x, Base.y, Base.z, Rotation.Angle, Rotation.Axis.x and so on, of vectors x, y and z</source>
      <translation>{target:text} kann nicht gesetzt werden; von Platzierungen geht Base.x, Base.y, Base.z, Rotation.Angle, Rotation.Axis.x und so weiter, von Vektoren x, y und z</translation>
    </message>
    <message>
      <source>cannot write {path:text}: there is no folder {folder:text}</source>
      <translation>{path:text} kann nicht geschrieben werden: den Ordner {folder:text} gibt es nicht</translation>
    </message>
    <message>
      <source>cannot write {path:text}: {why:messages}</source>
      <translation>{path:text} kann nicht geschrieben werden: {why:messages}</translation>
    </message>
    <message>
      <source>case {case:count}</source>
      <translation>Fall {case:count}</translation>
    </message>
    <message>
      <source>case {case:count} ({values:text})</source>
      <translation>Fall {case:count} ({values:text})</translation>
    </message>
    <message>
      <source>cases</source>
      <translation>Fälle</translation>
    </message>
    <message>
      <source>change of</source>
      <translation>Änderung von</translation>
    </message>
    <message>
      <source>common</source>
      <translation>gemeinsam</translation>
    </message>
    <message>
      <source>compromises are between two responses, not {responses:text}</source>
      <translation>Kompromisse gibt es zwischen zwei Zielgrößen, nicht {responses:text}</translation>
    </message>
    <message>
      <source>copies</source>
      <translation>Kopien</translation>
    </message>
    <message>
      <source>displacement in x</source>
      <translation>Verschiebung in x</translation>
    </message>
    <message>
      <source>displacement in y</source>
      <translation>Verschiebung in y</translation>
    </message>
    <message>
      <source>displacement in z</source>
      <translation>Verschiebung in z</translation>
    </message>
    <message>
      <source>dress-up</source>
      <translation>Fase, Rundung und Ähnliches</translation>
    </message>
    <message>
      <source>files of studies need Python 3.11 or newer, which this FreeCAD has not</source>
      <translation>Dateien von Studien brauchen Python 3.11 oder neuer, das dieses FreeCAD nicht hat</translation>
    </message>
    <message>
      <source>first solution: %s</source>
      <translation>erste Lösung: %s</translation>
    </message>
    <message>
      <source>first-order index</source>
      <translation>Index erster Ordnung</translation>
    </message>
    <message>
      <source>force</source>
      <translation>Kraft</translation>
    </message>
    <message>
      <source>force in x</source>
      <translation>Kraft in x</translation>
    </message>
    <message>
      <source>force in y</source>
      <translation>Kraft in y</translation>
    </message>
    <message>
      <source>force in z</source>
      <translation>Kraft in z</translation>
    </message>
    <message>
      <source>force on all supports in x</source>
      <translation>Kraft auf alle Lager in x</translation>
    </message>
    <message>
      <source>force on all supports in y</source>
      <translation>Kraft auf alle Lager in y</translation>
    </message>
    <message>
      <source>force on all supports in z</source>
      <translation>Kraft auf alle Lager in z</translation>
    </message>
    <message>
      <source>frequency {mode:count}</source>
      <translation>Eigenfrequenz {mode:count}</translation>
    </message>
    <message>
      <source>from</source>
      <translation>entnommen aus</translation>
    </message>
    <message>
      <source>from a clone</source>
      <translation>aus einem Klon</translation>
    </message>
    <message>
      <source>from a wheel</source>
      <translation>aus einem Wheel</translation>
    </message>
    <message>
      <source>from the portable zip</source>
      <translation>aus dem portablen ZIP-Archiv</translation>
    </message>
    <message>
      <source>grey: new nodes, which have no value from before</source>
      <translation>grau: neue Knoten, für die es keinen früheren Wert gibt</translation>
    </message>
    <message>
      <source>in FreeCAD's process</source>
      <translation>im Prozess von FreeCAD</translation>
    </message>
    <message>
      <source>in a process of its own</source>
      <translation>in einem eigenen Prozess</translation>
    </message>
    <message>
      <source>infeasible</source>
      <translation>nicht machbar</translation>
    </message>
    <message>
      <source>installed as an addon</source>
      <translation>als Addon installiert</translation>
    </message>
    <message>
      <source>installed by the system's packages</source>
      <translation>durch Pakete des Systems installiert</translation>
    </message>
    <message>
      <source>instances</source>
      <translation>Exemplare</translation>
    </message>
    <message>
      <source>is missing</source>
      <translation>fehlt</translation>
    </message>
    <message>
      <source>it does not answer</source>
      <translation>er antwortet nicht</translation>
    </message>
    <message>
      <source>it ended at once</source>
      <translation>er hat sich sofort beendet</translation>
    </message>
    <message>
      <source>it ended with code {code:count}</source>
      <translation>er endete mit dem Rückgabewert {code:count}</translation>
    </message>
    <message>
      <source>it lacks its {part:text}</source>
      <translation>ihm fehlt {part:text}</translation>
    </message>
    <message>
      <source>it says nothing of why</source>
      <translation>es sagt nicht, warum</translation>
    </message>
    <message>
      <source>it took longer than the limit of {seconds:number} s; try `study resume --retry-failed` with a longer --time-limit</source>
      <translation>er brauchte länger als die Grenze von {seconds:number} s; `study resume --retry-failed` mit einem längeren --time-limit versuchen</translation>
    </message>
    <message>
      <source>it took more memory than the limit of {limit:number} GB; try `study resume --retry-failed` with a larger --memory-limit</source>
      <translation>er brauchte mehr Speicher als die Grenze von {limit:number} GB; `study resume --retry-failed` mit einem größeren --memory-limit versuchen</translation>
    </message>
    <message>
      <source>it was ended from outside ({signal:text})</source>
      <translation>er wurde von außen beendet ({signal:text})</translation>
    </message>
    <message>
      <source>it was ended {times:count} {times:time|times}: {why:messages}</source>
      <translation>er wurde {times:count}-mal beendet: {why:messages}</translation>
    </message>
    <message>
      <source>its checksum is wrong</source>
      <translation>seine Prüfsumme ist falsch</translation>
    </message>
    <message>
      <source>its surface is far larger than its border encloses, as if it ran back and forth</source>
      <translation>ihre Oberfläche ist weit größer als das, was ihr Rand umschließt, als liefe sie hin und her</translation>
    </message>
    <message>
      <source>kept: {elements:count} {elements:element|elements} ({share:text} %)</source>
      <translation>behalten: {elements:count} {elements:Element|Elemente} ({share:text} %)</translation>
    </message>
    <message>
      <source>least {goal:text}: {case:messages}</source>
      <translation>kleinster Wert von {goal:text}: {case:messages}</translation>
    </message>
    <message>
      <source>least {least:text}, mean {mean:text}, greatest {greatest:text};
{bad:count} of {all:count} {all:element|elements} {bad:is|are} beyond the limit</source>
      <translation>kleinster {least:text}, Mittel {mean:text}, größter {greatest:text};
{bad:count} von {all:count} {all:Element|Elementen} {bad:liegt|liegen} jenseits der Grenze</translation>
    </message>
    <message>
      <source>linear</source>
      <translation>linear</translation>
    </message>
    <message>
      <source>main effect</source>
      <translation>Haupteffekt</translation>
    </message>
    <message>
      <source>material</source>
      <translation>Werkstoff</translation>
    </message>
    <message>
      <source>meshed from scratch, as asked with --full</source>
      <translation>vollständig neu vernetzt, wie mit --full verlangt</translation>
    </message>
    <message>
      <source>nearly done</source>
      <translation>fast fertig</translation>
    </message>
    <message>
      <source>new: {elements:count} {elements:element|elements}</source>
      <translation>neu: {elements:count} {elements:Element|Elemente}</translation>
    </message>
    <message>
      <source>no Dask scheduler answers at {address:text} ({why:messages})</source>
      <translation>unter {address:text} antwortet kein Verteiler von Dask ({why:messages})</translation>
    </message>
    <message>
      <source>no Python interpreter was found</source>
      <translation>kein Python wurde gefunden</translation>
    </message>
    <message>
      <source>no case keeps that</source>
      <translation>kein Fall hält das ein</translation>
    </message>
    <message>
      <source>no element of {mesh:text} is known to be kept: it was meshed from scratch, or brought back by undo or from a file. Edit the part first</source>
      <translation>von {mesh:text} ist kein Element als behalten bekannt: Das Netz wurde vollständig neu erzeugt oder kommt vom Rückgängigmachen oder aus einer Datei. Zuerst das Bauteil ändern</translation>
    </message>
    <message>
      <source>no support has a reaction</source>
      <translation>kein Lager hat eine Reaktionskraft</translation>
    </message>
    <message>
      <source>no support {support:text} has a reaction; there are {supports:messages}</source>
      <translation>kein Lager {support:text} hat eine Reaktionskraft; es gibt {supports:messages}</translation>
    </message>
    <message>
      <source>no whole number is between {low:number} and {high:number}, the bounds of {parameter:text}</source>
      <translation>zwischen {low:number} und {high:number}, den Grenzen von {parameter:text}, liegt keine ganze Zahl</translation>
    </message>
    <message>
      <source>nodes kept</source>
      <translation>Knoten behalten</translation>
    </message>
    <message>
      <source>none, {path:text} cannot be written</source>
      <translation>keines, {path:text} kann nicht geschrieben werden</translation>
    </message>
    <message>
      <source>not beaten</source>
      <translation>nicht übertroffen</translation>
    </message>
    <message>
      <source>not known yet</source>
      <translation>noch nicht bekannt</translation>
    </message>
    <message>
      <source>not solved</source>
      <translation>nicht gelöst</translation>
    </message>
    <message>
      <source>not solved yet</source>
      <translation>noch nicht gelöst</translation>
    </message>
    <message>
      <source>not solved: solving was cancelled</source>
      <translation>nicht gelöst: das Lösen wurde abgebrochen</translation>
    </message>
    <message>
      <source>nothing is varied: every parameter has one value only</source>
      <translation>nichts wird verändert: jeder Parameter hat nur einen Wert</translation>
    </message>
    <message>
      <source>nothing loads the part: add a force, a pressure or another load to the analysis</source>
      <translation>das Teil ist nicht belastet: der Analyse eine Kraft, einen Druck oder eine andere Last hinzufügen</translation>
    </message>
    <message>
      <source>of a case can be kept: {kinds:text}, not {kind:text}</source>
      <translation>von einem Fall lässt sich behalten: {kinds:text}, nicht {kind:text}</translation>
    </message>
    <message>
      <source>old results are carried over between meshes of solids only, not to {mesh:text}</source>
      <translation>alte Ergebnisse werden nur zwischen Netzen von Volumenkörpern übertragen, nicht auf {mesh:text}</translation>
    </message>
    <message>
      <source>opaque</source>
      <translation>unverstanden</translation>
    </message>
    <message>
      <source>out of date: the part was edited in another document</source>
      <translation>veraltet: das Bauteil wurde in einem anderen Dokument bearbeitet</translation>
    </message>
    <message>
      <source>own</source>
      <translation>eigene Form</translation>
    </message>
    <message>
      <source>parameter</source>
      <translation>Parameter</translation>
    </message>
    <message>
      <source>pattern</source>
      <translation>Muster</translation>
    </message>
    <message>
      <source>quadratic</source>
      <translation>quadratisch</translation>
    </message>
    <message>
      <source>reference</source>
      <translation>Bezug</translation>
    </message>
    <message>
      <source>response</source>
      <translation>Zielgröße</translation>
    </message>
    <message>
      <source>response {response:text} is not a number: {value:text}</source>
      <translation>die Zielgröße {response:text} ist keine Zahl: {value:text}</translation>
    </message>
    <message>
      <source>response {response:text}: {why:messages}</source>
      <translation>Zielgröße {response:text}: {why:messages}</translation>
    </message>
    <message>
      <source>running the cases of the study</source>
      <translation>Fälle der Studie laufen</translation>
    </message>
    <message>
      <source>saved {path:text}, but cannot write the report: {why:messages}</source>
      <translation>{path:text} ist gespeichert, aber der Bericht kann nicht geschrieben werden: {why:messages}</translation>
    </message>
    <message>
      <source>saving a copy of the document, from which all cases start</source>
      <translation>speichert eine Kopie des Dokuments, von der alle Fälle ausgehen</translation>
    </message>
    <message>
      <source>section</source>
      <translation>Querschnitt</translation>
    </message>
    <message>
      <source>segments</source>
      <translation>Balkenelemente</translation>
    </message>
    <message>
      <source>select faces, edges or vertices of {part:text}{foreign:messages}</source>
      <translation>Flächen, Kanten oder Eckpunkte von {part:text} auswählen{foreign:messages}</translation>
    </message>
    <message>
      <source>select solids, faces, edges or vertices of {part:text}{foreign:messages}</source>
      <translation>Volumenkörper, Flächen, Kanten oder Eckpunkte von {part:text} auswählen{foreign:messages}</translation>
    </message>
    <message>
      <source>several parts are selected, select one, or the container of those to mesh: {parts:text}</source>
      <translation>mehrere Bauteile sind ausgewählt; eines auswählen oder den Container derer, die zu vernetzen sind: {parts:text}</translation>
    </message>
    <message>
      <source>shape</source>
      <translation>Form</translation>
    </message>
    <message>
      <source>smallest angle %.1f deg, %.1f deg where the part's own angles do not force less; mean radius ratio %.3f</source>
      <translation>kleinster Winkel %.1f°, %.1f° wo nicht die Winkel des Teils selbst kleinere erzwingen; mittleres Radienverhältnis %.3f</translation>
    </message>
    <message>
      <source>smallest angle %.1f deg, as the part's own angles everywhere force; mean radius ratio %.3f</source>
      <translation>kleinster Winkel %.1f°, den die Winkel des Teils selbst überall erzwingen; mittleres Radienverhältnis %.3f</translation>
    </message>
    <message>
      <source>smallest principal stress</source>
      <translation>kleinste Hauptspannung</translation>
    </message>
    <message>
      <source>smallest temperature</source>
      <translation>kleinste Temperatur</translation>
    </message>
    <message>
      <source>solved as {solver:text} asks, not {others:text}</source>
      <translation>gelöst, wie {solver:text} es verlangt, nicht {others:text}</translation>
    </message>
    <message>
      <source>solved by CalculiX</source>
      <translation>mit CalculiX gelöst</translation>
    </message>
    <message>
      <source>solved live</source>
      <translation>mitlaufend gelöst</translation>
    </message>
    <message>
      <source>stress</source>
      <translation>Spannung</translation>
    </message>
    <message>
      <source>subtractive</source>
      <translation>subtraktiv</translation>
    </message>
    <message>
      <source>surface, left-out error</source>
      <translation>Fläche, Fehler an weggelassenen Fällen</translation>
    </message>
    <message>
      <source>temperature</source>
      <translation>Temperatur</translation>
    </message>
    <message>
      <source>tetrahedra</source>
      <translation>Tetraeder</translation>
    </message>
    <message>
      <source>the Dask scheduler {scheduler:text} is gone ({why:messages}); go on with `study resume`</source>
      <translation>der Verteiler {scheduler:text} von Dask ist weg ({why:messages}); mit `study resume` weitermachen</translation>
    </message>
    <message>
      <source>the Dask workers that had its base document are gone</source>
      <translation>die Arbeitsprozesse von Dask mit seinem Ausgangsdokument sind weg</translation>
    </message>
    <message>
      <source>the FEM mesh of another maker</source>
      <translation>das FEM-Netz eines anderen Vernetzers</translation>
    </message>
    <message>
      <source>the accuracy is a share between 0 and 1, such as 0.05, not {accuracy:text}</source>
      <translation>die Genauigkeit ist ein Anteil zwischen 0 und 1, etwa 0.05, nicht {accuracy:text}</translation>
    </message>
    <message>
      <source>the analysis gives no {what:messages}</source>
      <translation>die Analyse liefert keine Werte für: {what:messages}</translation>
    </message>
    <message>
      <source>the analysis {analysis:text} has another mesh than {mesh:text}</source>
      <translation>die Analyse {analysis:text} hat ein anderes Netz als {mesh:text}</translation>
    </message>
    <message>
      <source>the analysis {analysis:text} has several CalculiX solvers that may be meant, leave one of them in it: {solvers:text}</source>
      <translation>die Analyse {analysis:text} hat mehrere CalculiX-Löser, die gemeint sein können, einen davon in ihr lassen: {solvers:text}</translation>
    </message>
    <message>
      <source>the constraint</source>
      <translation>die Bedingung</translation>
    </message>
    <message>
      <source>the constraint {constraint:text} is not kept</source>
      <translation>die Bedingung {constraint:text} ist nicht eingehalten</translation>
    </message>
    <message>
      <source>the copy in {folder:text} is not whole</source>
      <translation>die Kopie in {folder:text} ist nicht vollständig</translation>
    </message>
    <message>
      <source>the cut leaves nothing of {mesh:text}; its nodes are from {low:point} to {high:point}</source>
      <translation>der Schnitt lässt von {mesh:text} nichts übrig; seine Knoten liegen zwischen {low:point} und {high:point}</translation>
    </message>
    <message>
      <source>the disk of {folder:text} is full ({why:messages}); every finished case is safe. Make room, then go on with `study resume`</source>
      <translation>die Platte mit {folder:text} ist voll ({why:messages}); jeder fertige Fall ist gesichert. Platz schaffen, dann mit `study resume` weitermachen</translation>
    </message>
    <message>
      <source>the document has several analyses, select one: {analyses:text}</source>
      <translation>das Dokument hat mehrere Analysen, eine auswählen: {analyses:text}</translation>
    </message>
    <message>
      <source>the document has several meshes, select one: {meshes:text}</source>
      <translation>das Dokument hat mehrere Netze, eines auswählen: {meshes:text}</translation>
    </message>
    <message>
      <source>the document has several results, name one with --result: {results:text}</source>
      <translation>das Dokument hat mehrere Ergebnisse, eines mit --result angeben: {results:text}</translation>
    </message>
    <message>
      <source>the document has several parts, select one, or the container of those to mesh: {parts:text}</source>
      <translation>das Dokument hat mehrere Bauteile; eines auswählen oder den Container derer, die zu vernetzen sind: {parts:text}</translation>
    </message>
    <message>
      <source>the document was closed</source>
      <translation>das Dokument wurde geschlossen</translation>
    </message>
    <message>
      <source>the document {document:text} has no analysis{name:text}; add one in FreeCAD's FEM workbench</source>
      <translation>das Dokument {document:text} hat keine Analyse{name:text}; eine in FreeCADs Arbeitsbereich FEM anlegen</translation>
    </message>
    <message>
      <source>the document {document:text} has no result{name:text} with values per node; solve first</source>
      <translation>das Dokument {document:text} hat kein Ergebnis{name:text} mit Werten an den Knoten; zuerst lösen</translation>
    </message>
    <message>
      <source>the goal</source>
      <translation>das Ziel</translation>
    </message>
    <message>
      <source>the grid of {parameters:count} {parameters:parameter|parameters} has more than {most:count} cases; take fewer levels, or sobol</source>
      <translation>das Gitter aus {parameters:count} {parameters:Parameter|Parametern} hat mehr als {most:count} Fälle; weniger Stufen nehmen, oder sobol</translation>
    </message>
    <message>
      <source>the limit</source>
      <translation>die Grenze</translation>
    </message>
    <message>
      <source>the limit {limit:text} has to compare two things by &lt;=, &lt;, &gt;= or &gt;</source>
      <translation>die Grenze {limit:text} muss zwei Dinge mit &lt;=, &lt;, &gt;= oder &gt; vergleichen</translation>
    </message>
    <message>
      <source>the limits of {measure:text} are two numbers that differ, not {limits:text}</source>
      <translation>die Grenzen von {measure:text} sind zwei verschiedene Zahlen, nicht {limits:text}</translation>
    </message>
    <message>
      <source>the live solver needs PETSc: {why:messages}</source>
      <translation>der mitlaufende Löser braucht PETSc: {why:messages}</translation>
    </message>
    <message>
      <source>the live solver needs one mesh of FeatureMesh in the analysis {analysis:text}: select its part, and Mesh a part, or drag its mesh there</source>
      <translation>der mitlaufende Löser braucht genau ein Netz von FeatureMesh in der Analyse {analysis:text}: das Bauteil auswählen und „Bauteil vernetzen“, oder sein Netz dorthin ziehen</translation>
    </message>
    <message>
      <source>the mass needs a {what:messages} for all of the part, and {count:count} {count:element has|elements have} none</source>
      <translation>für die Masse fehlt an {count:count} {count:Element|Elementen} des Bauteils: {what:messages}</translation>
    </message>
    <message>
      <source>the mass needs an analysis with a {what:messages}</source>
      <translation>für die Masse fehlt in der Analyse: {what:messages}</translation>
    </message>
    <message>
      <source>the mass of a beam with the section {section:text} of {member:text} is not known</source>
      <translation>die Masse eines Balkens mit dem Querschnitt {section:text} von {member:text} ist nicht bekannt</translation>
    </message>
    <message>
      <source>the material {material:text} has no Young's modulus or no Poisson's ratio that is a number: choose a card that has both, or type them, in its panel</source>
      <translation>der Werkstoff {material:text} hat keinen Elastizitätsmodul oder keine Querkontraktionszahl, die eine Zahl ist: in seinem Fenster eine Werkstoffkarte wählen, die beide hat, oder sie eintippen</translation>
    </message>
    <message>
      <source>the material {material:text} has no density; give it one, with its unit</source>
      <translation>der Werkstoff {material:text} hat keine Dichte; ihm eine geben, mit ihrer Einheit</translation>
    </message>
    <message>
      <source>the memory limit of a case is more than 0 GB, not {gigabytes:number}; leave it out where the whole machine may be used</source>
      <translation>die Speichergrenze eines Falls ist größer als 0 GB, nicht {gigabytes:number}; sie weglassen, wenn der ganze Rechner genutzt werden darf</translation>
    </message>
    <message>
      <source>the memory was not enough</source>
      <translation>der Speicher reichte nicht</translation>
    </message>
    <message>
      <source>the number of threads is a whole number, 0 for all that the machine has, not {threads:text}</source>
      <translation>die Anzahl der Threads ist eine ganze Zahl, 0 für alle, die der Rechner hat, nicht {threads:text}</translation>
    </message>
    <message>
      <source>the order of the elements is 1 or 2, not {order:count}</source>
      <translation>die Ordnung der Elemente ist 1 oder 2, nicht {order:count}</translation>
    </message>
    <message>
      <source>the parameter {parameter:text} needs a range of two numbers or a list of values</source>
      <translation>der Parameter {parameter:text} braucht einen Bereich aus zwei Zahlen oder eine Liste von Werten</translation>
    </message>
    <message>
      <source>the part has no solid that the point {point:point} could be in; ask at a face, edge or vertex</source>
      <translation>das Bauteil hat keinen Volumenkörper, in dem der Punkt {point:point} liegen könnte; an einer Fläche, einer Kante oder einem Eckpunkt fragen</translation>
    </message>
    <message>
      <source>the part has no {place:text}, where a response is asked for</source>
      <translation>das Bauteil hat kein {place:text}, wo nach einer Zielgröße gefragt ist</translation>
    </message>
    <message>
      <source>the part moved by {times:number} times its own size: it can move, since its supports and ties do not hold all of it, or a unit is wrong</source>
      <translation>das Bauteil hat sich um das {times:number}fache seiner Größe bewegt: es kann sich bewegen, weil seine Lager und Verbindungen nicht alles halten, oder eine Einheit ist falsch</translation>
    </message>
    <message>
      <source>the point {point:point}, where a response is asked for, is not in the part</source>
      <translation>der Punkt {point:point}, an dem nach einer Zielgröße gefragt ist, liegt nicht im Bauteil</translation>
    </message>
    <message>
      <source>the range of {name:text} has to rise, not {low:number}:{high:number}; write its low end first</source>
      <translation>der Bereich von {name:text} muss ansteigen, nicht {low:number}:{high:number}; das untere Ende zuerst schreiben</translation>
    </message>
    <message>
      <source>the response</source>
      <translation>die Zielgröße</translation>
    </message>
    <message>
      <source>the response {response:text} cannot have a percentile, or one outside of 0 to 100</source>
      <translation>die Zielgröße {response:text} kann kein Perzentil haben, oder keines außerhalb von 0 bis 100</translation>
    </message>
    <message>
      <source>the response {response:text} counts its modes from 1</source>
      <translation>die Zielgröße {response:text} zählt ihre Moden ab 1</translation>
    </message>
    <message>
      <source>the response {response:text} is of the whole part, not at {place:text}</source>
      <translation>die Zielgröße {response:text} gilt für das ganze Bauteil, nicht an {place:text}</translation>
    </message>
    <message>
      <source>the response {response:text} needs CalculiX; take solver = "ccx"</source>
      <translation>die Zielgröße {response:text} braucht CalculiX; solver = "ccx" nehmen</translation>
    </message>
    <message>
      <source>the response {response:text} needs a kind, an expression or a file</source>
      <translation>die Zielgröße {response:text} braucht eine Art, einen Ausdruck oder eine Datei</translation>
    </message>
    <message>
      <source>the response {response:text} needs a solid, and {part:text} has none; ask for its mass or area</source>
      <translation>die Zielgröße {response:text} braucht einen Volumenkörper, und {part:text} hat keinen; nach seiner Masse oder Fläche fragen</translation>
    </message>
    <message>
      <source>the response {response:text} needs an analysis of the kind {kinds:messages}, not {kind:text}</source>
      <translation>die Zielgröße {response:text} braucht eine Analyse der Art {kinds:messages}, nicht {kind:text}</translation>
    </message>
    <message>
      <source>the sampling csv needs a file of rows: --rows ROWS.csv (in a study's file rows = "ROWS.csv")</source>
      <translation>der Versuchsplan csv braucht eine Datei mit Zeilen: --rows ZEILEN.csv (in der Datei einer Studie rows = "ZEILEN.csv")</translation>
    </message>
    <message>
      <source>the sampling is one of {samplings:text}, not {sampling:text}</source>
      <translation>der Versuchsplan ist einer von {samplings:text}, nicht {sampling:text}</translation>
    </message>
    <message>
      <source>the sampling {sampling:text} is complete; add rows of a CSV file, or start a study with {others:messages}</source>
      <translation>der Versuchsplan {sampling:text} ist vollständig; Zeilen einer CSV-Datei hinzufügen, oder eine Studie mit {others:messages} beginnen</translation>
    </message>
    <message>
      <source>the sampling {sampling:text} needs a number of cases, such as --cases 32 (in a study's file cases = 32)</source>
      <translation>der Versuchsplan {sampling:text} braucht eine Anzahl von Fällen, etwa --cases 32 (in der Datei einer Studie cases = 32)</translation>
    </message>
    <message>
      <source>the saved mesh state is damaged ({why:messages})</source>
      <translation>der gespeicherte Netzzustand ist beschädigt ({why:messages})</translation>
    </message>
    <message>
      <source>the seed is 0 or larger, not {seed:count}</source>
      <translation>der Startwert ist 0 oder größer, nicht {seed:count}</translation>
    </message>
    <message>
      <source>the size has to be greater than 0 mm, not {size:number}</source>
      <translation>die Größe muss größer als 0 mm sein, nicht {size:number}</translation>
    </message>
    <message>
      <source>the solver is live or ccx, not {solver:text}</source>
      <translation>der Löser ist live oder ccx, nicht {solver:text}</translation>
    </message>
    <message>
      <source>the stresses are still off by about {percent:number} % in the mean of the energy, more than the {wanted:number} % that were asked for: beside sharp corners, and loads on points or edges, finer meshes gain little</source>
      <translation>die Spannungen sind im Mittel der Energie noch um etwa {percent:number} % falsch, mehr als die verlangten {wanted:number} %: neben scharfen Ecken und Lasten auf Punkten oder Kanten bringen feinere Netze wenig</translation>
    </message>
    <message>
      <source>the study has no response {response:text}; it has {responses:text}</source>
      <translation>die Studie hat keine Zielgröße {response:text}; sie hat {responses:text}</translation>
    </message>
    <message>
      <source>the study in {folder:text} has no finished case yet</source>
      <translation>die Studie in {folder:text} hat noch keinen fertigen Fall</translation>
    </message>
    <message>
      <source>the study in {folder:text} is being run already, by process {process:text}</source>
      <translation>die Studie in {folder:text} läuft schon, im Prozess {process:text}</translation>
    </message>
    <message>
      <source>the study's folder {path:text} cannot be made ({why:text}); save the document where you may write, the study is kept beside it</source>
      <translation>der Ordner der Studie {path:text} lässt sich nicht anlegen ({why:text}); das Dokument dort speichern, wo geschrieben werden darf, die Studie liegt daneben</translation>
    </message>
    <message>
      <source>the study's folder {path:text} is gone: bring it back, or run the study again</source>
      <translation>den Ordner {path:text} der Studie gibt es nicht mehr: ihn zurückholen oder die Studie neu starten</translation>
    </message>
    <message>
      <source>the time limit of a case is at most {most:number} s, not {seconds:number}</source>
      <translation>die Zeitgrenze eines Falls ist höchstens {most:number} s, nicht {seconds:number}</translation>
    </message>
    <message>
      <source>the time limit of a case is more than 0 s, not {seconds:number}</source>
      <translation>die Zeitgrenze eines Falls ist größer als 0 s, nicht {seconds:number}</translation>
    </message>
    <message>
      <source>the two parts look unrelated: they have no feature name in common; compare two states of one part</source>
      <translation>die beiden Bauteile haben wohl nichts miteinander zu tun: Kein Name eines Formelements kommt in beiden vor; zwei Stände eines Bauteils vergleichen</translation>
    </message>
    <message>
      <source>the values of {parameter:text} are numbers, or words, all of them</source>
      <translation>die Werte von {parameter:text} sind entweder alle Zahlen oder alle Wörter</translation>
    </message>
    <message>
      <source>there is no face, edge, vertex, point or feature {place:text}, where a response is asked for</source>
      <translation>es gibt keine Fläche, keine Kante, keinen Eckpunkt, keinen Punkt und kein Formelement {place:text}, wo nach einer Zielgröße gefragt ist</translation>
    </message>
    <message>
      <source>there is no file {path:text}</source>
      <translation>die Datei {path:text} gibt es nicht</translation>
    </message>
    <message>
      <source>there is no live result of {mesh:text} as it is; solve first</source>
      <translation>es gibt kein Live-Ergebnis von {mesh:text}, wie es jetzt ist; zuerst lösen</translation>
    </message>
    <message>
      <source>there is no response {kind:text}{near:messages}; there are {kinds:text}</source>
      <translation>es gibt keine Zielgröße {kind:text}{near:messages}; es gibt {kinds:text}</translation>
    </message>
    <message>
      <source>there is no {name:text}</source>
      <translation>{name:text} gibt es nicht</translation>
    </message>
    <message>
      <source>there was no room in {folder:text} for all of the saved mesh state; make room and open the document again</source>
      <translation>In {folder:text} war nicht für den ganzen gespeicherten Zustand des Netzes Platz; Platz schaffen und das Dokument noch einmal öffnen</translation>
    </message>
    <message>
      <source>thickness</source>
      <translation>Dicke</translation>
    </message>
    <message>
      <source>thin-plate spline</source>
      <translation>Plattenspline</translation>
    </message>
    <message>
      <source>time, s</source>
      <translation>Zeit, s</translation>
    </message>
    <message>
      <source>total index</source>
      <translation>Gesamtindex</translation>
    </message>
    <message>
      <source>transform</source>
      <translation>Transformation</translation>
    </message>
    <message>
      <source>triangles</source>
      <translation>Dreiecke</translation>
    </message>
    <message>
      <source>true or false</source>
      <translation>wahr oder falsch (true oder false)</translation>
    </message>
    <message>
      <source>two columns are named {name:text}; give one of them another name</source>
      <translation>zwei Spalten heißen {name:text}; einer davon einen anderen Namen geben</translation>
    </message>
    <message>
      <source>unknown</source>
      <translation>unbekannt</translation>
    </message>
    <message>
      <source>unpacked from the portable zip</source>
      <translation>aus dem portablen ZIP-Archiv entpackt</translation>
    </message>
    <message>
      <source>volume mm^3</source>
      <translation>Volumen mm^3</translation>
    </message>
    <message>
      <source>x {x:length}</source>
      <translation>x {x:length}</translation>
    </message>
    <message>
      <source>y {y:length}</source>
      <translation>y {y:length}</translation>
    </message>
    <message>
      <source>z {z:length}</source>
      <translation>z {z:length}</translation>
    </message>
    <message>
      <source>{analysis:text} has no mesh; mesh its part first, by Mesh a part or `featuremesh mesh`</source>
      <translation>{analysis:text} hat kein Netz; zuerst das Bauteil vernetzen, mit „Bauteil vernetzen“ oder `featuremesh mesh`</translation>
    </message>
    <message>
      <source>{anew:count} of {all:count} {all:element|elements} {anew:does|do} not fit the part and {anew:was|were} made anew: {reasons:messages}</source>
      <translation>{anew:count} von {all:count} {all:Element|Elementen} {anew:passt|passen} nicht zum Bauteil und {anew:wurde|wurden} neu gemacht: {reasons:messages}</translation>
    </message>
    <message>
      <source>{array:text} has {entries:count} {entries:entry|entries}, not {wanted:count}</source>
      <translation>{array:text} hat {entries:count} {entries:Eintrag|Einträge}, nicht {wanted:count}</translation>
    </message>
    <message>
      <source>{changed:count} {changed:feature|features} changed, {others:count} did not; faces: {faces:text}</source>
      <translation>{changed:count} {changed:Formelement hat|Formelemente haben} sich geändert, {others:count} nicht; Flächen: {faces:text}</translation>
    </message>
    <message>
      <source>{count:count} more are in the table that `study export` writes.</source>
      <translation>{count:count} weitere stehen in der Tabelle, die `study export` schreibt.</translation>
    </message>
    <message>
      <source>{count:count} objects have the label {label:text}, use a name: {names:text}</source>
      <translation>{count:count} Objekte haben die Bezeichnung {label:text}, einen Namen angeben: {names:text}</translation>
    </message>
    <message>
      <source>%s and %d more</source>
      <translation>%s und %d weitere</translation>
    </message>
    <message>
      <source>{count:count} of {all:count} {all:hole|holes}</source>
      <translation>{count:count} von {all:count} {all:Bohrung|Bohrungen}</translation>
    </message>
    <message>
      <source>{count:count} of {all:count} {all:piece|pieces}</source>
      <translation>{count:count} von {all:count} {all:Stück|Stücken}</translation>
    </message>
    <message>
      <source>{count:count} {count:element has an angle|elements have angles} below 10 degrees, the smallest is {angle:number} degrees, at {place:entities}: stresses are poor there. Mesh finer there, by a local size or a refinement zone, or take details out that are much smaller than the edge length.</source>
      <translation>{count:count} {count:Element hat einen Winkel|Elemente haben Winkel} unter 10 Grad, der kleinste ist {angle:number} Grad, bei {place:entities}: Spannungen dort sind ungenau. Dort mit einer lokalen Größe oder einer Verfeinerungszone feiner vernetzen oder Einzelheiten weglassen, die viel kleiner als die Kantenlänge sind.</translation>
    </message>
    <message>
      <source>{count:count} {count:hole|holes}</source>
      <translation>{count:count} {count:Bohrung|Bohrungen}</translation>
    </message>
    <message>
      <source>{count:count} {count:piece|pieces}</source>
      <translation>{count:count} {count:Stück|Stücke}</translation>
    </message>
    <message>
      <source>{document:text} is no open document</source>
      <translation>{document:text} ist kein offenes Dokument</translation>
    </message>
    <message>
      <source>{document:text} was changed since the study began; its cases are of the document as it was then (base.FCStd in its folder). `study resume {folder:text} --keep-base` goes on with that</source>
      <translation>{document:text} wurde geändert, seit die Studie begann; ihre Fälle gelten für das Dokument, wie es damals war (base.FCStd in ihrem Ordner). `study resume {folder:text} --keep-base` macht damit weiter</translation>
    </message>
    <message>
      <source>{document:text} was changed while its base mesh was made; start the study again</source>
      <translation>{document:text} wurde geändert, während sein Ausgangsnetz entstand; die Studie erneut starten</translation>
    </message>
    <message>
      <source>{done:count} of {all:count} {all:case|cases} done</source>
      <translation>{done:count} von {all:count} {all:Fall|Fällen} fertig</translation>
    </message>
    <message>
      <source>Many edges of the part ({edges:count}) lie within a plane, as in a solid that was made of a mesh (STL). Each is an edge of elements, too, which makes many of them small and thin. Part &gt; Create a copy &gt; Refine shape makes a copy without such edges: mesh that.</source>
      <translation>Viele Kanten des Bauteils ({edges:count}) liegen innerhalb einer Ebene, wie in einem Festkörper, der aus einem Netz (STL) gemacht wurde. Jede ist auch eine Kante von Elementen, wodurch viele davon klein und dünn werden. Part &gt; Kopie erstellen &gt; Form aufbereiten macht eine Kopie ohne solche Kanten: diese vernetzen.</translation>
    </message>
    <message>
      <source>{done:count} of {all:count} {all:case|cases} done, {lost:count} could not be made or solved; case {first:count}: {why:messages}</source>
      <translation>{done:count} von {all:count} {all:Fall|Fällen} fertig, {lost:count} nicht machbar oder nicht lösbar; Fall {first:count}: {why:messages}</translation>
    </message>
    <message>
      <source>{edge:entities} has no curve, so nothing says where its faces end. Rebuild the feature there, or bring the part in again from where it was made.</source>
      <translation>{edge:entities} hat keine Kurve; so sagt nichts, wo die Flächen dort enden. Das Formelement dort neu aufbauen oder das Teil von dort, wo es entstand, noch einmal einlesen.</translation>
    </message>
    <message>
      <source>{elements:count} 10-node {elements:tetrahedron|tetrahedra} would be folded near {place:entities}: the face bends too much within one element. Ask for a smaller size there, or for 4-node tetrahedra.</source>
      <translation>{elements:count} 10-Knoten-Tetraeder {elements:wäre|wären} bei {place:entities} gefaltet: Die Fläche krümmt sich innerhalb eines Elements zu stark. Dort eine kleinere Größe wählen, oder 4-Knoten-Tetraeder.</translation>
    </message>
    <message>
      <source>{elements:count} 6-node {elements:triangle|triangles} would be folded near {place:entities}: the face bends too much within one element. Ask for a smaller size there, or for 3-node triangles.</source>
      <translation>{elements:count} {elements:6-Knoten-Dreieck wäre|6-Knoten-Dreiecke wären} bei {place:entities} gefaltet: Die Fläche krümmt sich innerhalb eines Elements zu stark. Dort eine kleinere Größe wählen, oder 3-Knoten-Dreiecke.</translation>
    </message>
    <message>
      <source>{elements:count} {elements:element is|elements are} inverted, flat or folded</source>
      <translation>{elements:count} {elements:Element ist|Elemente sind} umgestülpt, flach oder gefaltet</translation>
    </message>
    <message>
      <source>{elements:count} {elements:element is|elements are} outside the part</source>
      <translation>{elements:count} {elements:Element liegt|Elemente liegen} außerhalb des Bauteils</translation>
    </message>
    <message>
      <source>{elements:count} {elements:element|elements} without a volume to speak of {elements:remains|remain} at {faces:entities} beside {edges:messages}; mesh finer there, or take out what is much smaller than the rest of the part</source>
      <translation>{elements:count} {elements:Element|Elemente} fast ohne Volumen {elements:bleibt|bleiben} bei {faces:entities} neben {edges:messages}; dort feiner vernetzen, oder weglassen, was viel kleiner als der Rest des Bauteils ist</translation>
    </message>
    <message>
      <source>{elements:count} {elements:element|elements} without a volume to speak of {elements:remains|remain} at {faces:entities}; mesh finer there, or take out what is much smaller than the rest of the part</source>
      <translation>{elements:count} {elements:Element|Elemente} fast ohne Volumen {elements:bleibt|bleiben} bei {faces:entities}; dort feiner vernetzen, oder weglassen, was viel kleiner als der Rest des Bauteils ist</translation>
    </message>
    <message>
      <source>{faces:entities} of {part:text} has no end, as a piece of a datum plane: set the Mode of the Boolean Fragments to CompSolid, or mesh Solids</source>
      <translation>{faces:entities} von {part:text} hat kein Ende, wie ein Stück einer Bezugsebene: bei den booleschen Fragmenten als Modus CompSolid wählen, oder nur Volumenkörper vernetzen</translation>
    </message>
    <message>
      <source>{feature:text}: its link to {object:text} leads to nothing</source>
      <translation>{feature:text}: die Verknüpfung mit {object:text} führt ins Leere</translation>
    </message>
    <message>
      <source>{format:text} would lose the beams of this mesh; export it as inp, vtu, vtk, msh, unv or med</source>
      <translation>{format:text} würde die Balken dieses Netzes verlieren; es als inp, vtu, vtk, msh, unv oder med exportieren</translation>
    </message>
    <message>
      <source>{format:text} would lose the shells of this mesh; export it as inp, vtu, vtk, msh, unv or med</source>
      <translation>{format:text} würde die Schalen dieses Netzes verlieren; es als inp, vtu, vtk, msh, unv oder med exportieren</translation>
    </message>
    <message>
      <source>{group:text} has nodes and no elements: {places:entities} is too small for them, or lies on another face; choose another face, or set Ignore below to off</source>
      <translation>{group:text} hat Knoten, aber keine Elemente: {places:entities} ist zu klein für sie oder liegt auf einer anderen Fläche; eine andere Fläche wählen oder Weglassen unter auf aus stellen</translation>
    </message>
    <message>
      <source>{key:text} of the response {response:text} cannot be {value:text}</source>
      <translation>{key:text} der Zielgröße {response:text} kann nicht {value:text} sein</translation>
    </message>
    <message>
      <source>{kind:messages}, {error:text} ({percent:text} % of the spread)</source>
      <translation>{kind:messages}, {error:text} ({percent:text} % der Spannweite)</translation>
    </message>
    <message>
      <source>{live:text} belongs to no analysis; drag it into one</source>
      <translation>{live:text} gehört zu keiner Analyse; es in eine ziehen</translation>
    </message>
    <message>
      <source>{member:text} did not arrive on the disk whole; is it full?</source>
      <translation>{member:text} kam nicht vollständig auf der Platte an; ist sie voll?</translation>
    </message>
    <message>
      <source>{mesh:text} and {analysis:text} are in two documents; an analysis is solved with a mesh of its own document</source>
      <translation>{mesh:text} und {analysis:text} sind in zwei Dokumenten; eine Analyse wird mit einem Netz ihres eigenen Dokuments gelöst</translation>
    </message>
    <message>
      <source>{mesh:text} has no mesh yet; recompute the document first</source>
      <translation>{mesh:text} hat noch kein Netz; zuerst das Dokument neu berechnen</translation>
    </message>
    <message>
      <source>{motion:messages} from {before:messages} to {after:messages}</source>
      <translation>{motion:messages} von {before:messages} nach {after:messages}</translation>
    </message>
    <message>
      <source>{name:text} {before:number} deg -&gt; {after:number} deg</source>
      <translation>{name:text} {before:number}° → {after:number}°</translation>
    </message>
    <message>
      <source>{nodes:count} {nodes:boundary node is|boundary nodes are} off the surface</source>
      <translation>{nodes:count} {nodes:Randknoten liegt|Randknoten liegen} abseits der Oberfläche</translation>
    </message>
    <message>
      <source>{nodes:count} {nodes:mid-side node was|mid-side nodes were} off the surface and {nodes:is|are} new, on it</source>
      <translation>{nodes:count} {nodes:Mittelknoten lag|Mittelknoten lagen} neben der Oberfläche und {nodes:ist|sind} neu, auf ihr</translation>
    </message>
    <message>
      <source>{nodes:count} {nodes:node|nodes}, {elements:count} {elements:element|elements} in {seconds:text} s</source>
      <translation>{nodes:count} Knoten, {elements:count} {elements:Element|Elemente} in {seconds:text} s</translation>
    </message>
    <message>
      <source>{object:text} acts along {lost:entities}, which is gone; open it and choose its direction again, the analysis cannot be solved without</source>
      <translation>{object:text} wirkt entlang {lost:entities}, das es nicht mehr gibt; öffnen und die Richtung neu wählen, sonst lässt sich die Analyse nicht lösen</translation>
    </message>
    <message>
      <source>{object:text} acts on {places:entities}, where the mesh has no elements: that is too small for them, or lies on another face; choose another face, or set Ignore below to off</source>
      <translation>{object:text} wirkt auf {places:entities}, wo das Netz keine Elemente hat, da es dafür zu klein ist oder auf einer anderen Fläche liegt; eine andere Fläche wählen, oder Weglassen unter auf aus stellen</translation>
    </message>
    <message>
      <source>{object:text} cannot be opened while a panel is open; close that first</source>
      <translation>{object:text} lässt sich nicht öffnen, solange ein Fenster offen ist; dieses erst schließen</translation>
    </message>
    <message>
      <source>{object:text} cannot be saved: that takes {needed:number} MB in the folder for temporary files, {folder:text}, where {room:number} MB can be written; make room and save again</source>
      <translation>{object:text} kann nicht gespeichert werden: Das braucht {needed:number} MB im Ordner für temporäre Dateien, {folder:text}, in den {room:number} MB geschrieben werden können; Platz schaffen und noch einmal speichern</translation>
    </message>
    <message>
      <source>{object:text} has no alias or cell {name:text}{near:messages}</source>
      <translation>{object:text} hat keinen Alias und keine Zelle {name:text}{near:messages}</translation>
    </message>
    <message>
      <source>{object:text} has no constraint or property {name:text}{near:messages}</source>
      <translation>{object:text} hat keine Randbedingung und keine Eigenschaft {name:text}{near:messages}</translation>
    </message>
    <message>
      <source>{object:text} has no property {name:text}{near:messages}</source>
      <translation>{object:text} hat keine Eigenschaft {name:text}{near:messages}</translation>
    </message>
    <message>
      <source>{object:text} is being edited; close its panel first</source>
      <translation>{object:text} wird gerade bearbeitet; zuerst dessen Fenster schließen</translation>
    </message>
    <message>
      <source>{object:text} is no live result</source>
      <translation>{object:text} ist kein mitlaufendes Ergebnis</translation>
    </message>
    <message>
      <source>{object:text} is no mesh of FeatureMesh</source>
      <translation>{object:text} ist kein Netz von FeatureMesh</translation>
    </message>
    <message>
      <source>{object:text} is no object of a document; give {wanted:messages}</source>
      <translation>{object:text} ist kein Objekt eines Dokuments; {wanted:messages} angeben</translation>
    </message>
    <message>
      <source>{object:text} is no refinement zone</source>
      <translation>{object:text} ist keine Verfeinerungszone</translation>
    </message>
    <message>
      <source>{object:text} refers to {where:entities}, which is not on the meshed part {part:text}: CalculiX got what FreeCAD found in the same place, and no edit is followed there; choose faces, edges or vertices of {part:text} instead</source>
      <translation>{object:text} bezieht sich auf {where:entities}, was nicht am vernetzten Teil {part:text} ist: CalculiX bekam, was FreeCAD am selben Ort fand, und Änderungen folgt es dort nicht; stattdessen Flächen, Kanten oder Punkte von {part:text} wählen</translation>
    </message>
    <message>
      <source>{object:text} shows the mesh of {mesh:text}; give that one</source>
      <translation>{object:text} zeigt das Netz von {mesh:text}; dieses angeben</translation>
    </message>
    <message>
      <source>{object:text}.{name:text} is computed ({content:text}), change what it depends on</source>
      <translation>{object:text}.{name:text} wird berechnet ({content:text}); ändern, wovon es abhängt</translation>
    </message>
    <message>
      <source>{object:text}.{name:text} is driven by the expression {expression:text}, change that instead</source>
      <translation>{object:text}.{name:text} wird durch den Ausdruck {expression:text} bestimmt; stattdessen diesen ändern</translation>
    </message>
    <message>
      <source>{object:text}.{name:text} is no number, switch or choice</source>
      <translation>{object:text}.{name:text} ist keine Zahl, kein Schalter und keine Auswahl</translation>
    </message>
    <message>
      <source>{object:text}.{name:text} is read-only</source>
      <translation>{object:text}.{name:text} ist schreibgeschützt</translation>
    </message>
    <message>
      <source>{object:text}: {features:count} {features:feature|features} in {pieces:count} {pieces:piece|pieces}, volume {volume:text} (FreeCAD: {other:text})</source>
      <translation>{object:text}: {features:count} {features:Formelement|Formelemente} in {pieces:count} {pieces:Stück|Stücken}, Volumen {volume:text} (FreeCAD: {other:text})</translation>
    </message>
    <message>
      <source>{object:text}: there again, and referred to as before: {now:entities}</source>
      <translation>{object:text}: wieder da, der Bezug ist wie vorher: {now:entities}</translation>
    </message>
    <message>
      <source>{one:entities} and {other:entities} touch each other where no edge joins them: the part has no thickness there, the smallest angle of an element is {angle:number} degrees, and results there are poor. Move one of the two, so that they cut each other or are apart.</source>
      <translation>{one:entities} und {other:entities} berühren einander, wo keine Kante sie verbindet: Das Teil hat dort keine Dicke, der kleinste Winkel eines Elements ist {angle:number} Grad, und Ergebnisse dort sind ungenau. Eine der beiden verschieben, sodass sie einander schneiden oder Abstand haben.</translation>
    </message>
    <message>
      <source>{one:text} and {other:text} overlap; parts that are joined may only touch</source>
      <translation>{one:text} und {other:text} überlappen sich; Bauteile, die verbunden werden, dürfen sich nur berühren</translation>
    </message>
    <message>
      <source>{mesh:text} cannot be renumbered: {why:messages}</source>
      <translation>{mesh:text} kann nicht neu nummeriert werden: {why:messages}</translation>
    </message>
    <message>
      <source>{analysis:text} has {mesh:text} already, and an analysis is solved with one mesh</source>
      <translation>{analysis:text} hat schon {mesh:text}, und eine Analyse wird mit einem Netz gelöst</translation>
    </message>
    <message>
      <source>{one:text} or {others:messages}</source>
      <translation>{one:text} oder {others:messages}</translation>
    </message>
    <message>
      <source>{parameter:text} needs two levels to {most:count}, not {levels:count}</source>
      <translation>{parameter:text} braucht zwei bis {most:count} Stufen, nicht {levels:count}</translation>
    </message>
    <message>
      <source>{part:text} consists of triangles; make a solid of it (Part: Create shape from mesh, Convert to solid) and mesh that</source>
      <translation>{part:text} besteht aus Dreiecken; machen Sie daraus einen Festkörper (Part: Form aus Netz erstellen, In Festkörper umwandeln) und vernetzen Sie den</translation>
    </message>
    <message>
      <source>{part:text} has a face without an end, that of a datum plane or a coordinate system; leave it out</source>
      <translation>{part:text} hat eine Fläche ohne Ende, die einer Bezugsebene oder eines Koordinatensystems; diese weglassen</translation>
    </message>
    <message>
      <source>{part:text} has a mesh already: {mesh:text}; delete one of the two</source>
      <translation>{part:text} hat schon ein Netz: {mesh:text}; eines von beiden löschen</translation>
    </message>
    <message>
      <source>{object:text} has no container, set its property Container</source>
      <translation>{object:text} hat keinen Container, seine Eigenschaft Container setzen</translation>
    </message>
    <message>
      <source>{format:text} has no form for a mesh of edges; export it as inp, vtu, vtk, msh, unv or med</source>
      <translation>{format:text} kann kein Netz aus Kanten enthalten; es als inp, vtu, vtk, msh, unv oder med exportieren</translation>
    </message>
    <message>
      <source>{mesh:text} is suppressed, and {analysis:text} has no other mesh</source>
      <translation>{mesh:text} ist unterdrückt, und {analysis:text} hat kein anderes Netz</translation>
    </message>
    <message>
      <source>{analysis:text} has no mesh of FeatureMesh to copy along</source>
      <translation>{analysis:text} hat kein Netz von FeatureMesh, das mitkopiert werden könnte</translation>
    </message>
    <message>
      <source>%s has no mesh; let it share %s (api.share_mesh), or give it one of its own</source>
      <translation>%s hat kein Netz; die Analyse %s mitbenutzen lassen (api.share_mesh), oder ihr ein eigenes geben</translation>
    </message>
    <message>
      <source>{part:text} has no shape to mesh</source>
      <translation>{part:text} hat keine Form, die vernetzt werden kann</translation>
    </message>
    <message>
      <source>{part:text} has no shape to mesh: {feature:text} leaves nothing of it</source>
      <translation>{part:text} hat keine Form, die vernetzt werden kann: {feature:text} lässt nichts davon übrig</translation>
    </message>
    <message>
      <source>{part:text} has no solid and no face any more: its edges are meshed, and loads and results are those of beams. Mend the part if it is to be more.</source>
      <translation>{part:text} hat weder Volumenkörper noch Flächen mehr: seine Kanten werden vernetzt, und Lasten und Ergebnisse sind die von Balken. Das Bauteil reparieren, wenn es mehr sein soll.</translation>
    </message>
    <message>
      <source>{part:text} has no solid any more: its faces are meshed, and loads and results are those of a shell. Mend the part if it is to be a solid.</source>
      <translation>{part:text} hat keinen Volumenkörper mehr: seine Flächen werden vernetzt, und Lasten und Ergebnisse sind die einer Schale. Das Bauteil reparieren, wenn es ein Volumenkörper sein soll.</translation>
    </message>
    <message>
      <source>{part:text} is a group of links, which has no shape; make a compound of it (Part: Compound) and mesh that</source>
      <translation>{part:text} ist eine Gruppe von Verknüpfungen und hat keine Form; daraus einen Verbund machen (Part: Verbund) und diesen vernetzen</translation>
    </message>
    <message>
      <source>{path:text} cannot be made a study's folder ({why:text}); name another --folder</source>
      <translation>{path:text} kann nicht zum Ordner einer Studie werden ({why:text}); einen anderen mit --folder angeben</translation>
    </message>
    <message>
      <source>{path:text} cannot be read: {why:messages}</source>
      <translation>{path:text} kann nicht gelesen werden: {why:messages}</translation>
    </message>
    <message>
      <source>{path:text} cannot be written: {why:messages}; every finished case is safe. Make room, then go on with `study resume`</source>
      <translation>{path:text} kann nicht geschrieben werden: {why:messages}; jeder fertige Fall ist gesichert. Platz schaffen, dann mit `study resume` weitermachen</translation>
    </message>
    <message>
      <source>{path:text} has no column {column:text}</source>
      <translation>{path:text} hat keine Spalte {column:text}</translation>
    </message>
    <message>
      <source>{path:text} has no rows</source>
      <translation>{path:text} hat keine Zeilen</translation>
    </message>
    <message>
      <source>{path:text} has no {key:text}; a study's file needs document, parameters and responses</source>
      <translation>{path:text} hat kein {key:text}; die Datei einer Studie braucht document, parameters und responses</translation>
    </message>
    <message>
      <source>{path:text} holds a study already: go on with `study resume`, extend it with `study add`, or name another --folder</source>
      <translation>in {path:text} ist schon eine Studie: mit `study resume` weitermachen, sie mit `study add` erweitern, oder einen anderen Ordner mit --folder angeben</translation>
    </message>
    <message>
      <source>{path:text} holds no study; begin one there with `study run ... --folder {folder:text}`</source>
      <translation>in {path:text} ist keine Studie; dort mit `study run ... --folder {folder:text}` eine beginnen</translation>
    </message>
    <message>
      <source>{path:text} is damaged: {member:text} in it cannot be read</source>
      <translation>{path:text} ist beschädigt: {member:text} darin kann nicht gelesen werden</translation>
    </message>
    <message>
      <source>{path:text} is damaged: {why:messages}</source>
      <translation>{path:text} ist beschädigt: {why:messages}</translation>
    </message>
    <message>
      <source>{path:text} is no study's database: {why:messages}</source>
      <translation>{path:text} ist nicht die Datenbank einer Studie: {why:messages}</translation>
    </message>
    <message>
      <source>{path:text} is not a FreeCAD document (or its end is cut off)</source>
      <translation>{path:text} ist kein Dokument von FreeCAD (oder sein Ende fehlt)</translation>
    </message>
    <message>
      <source>{path:text} is not a FreeCAD document: it has no Document.xml</source>
      <translation>{path:text} ist kein Dokument von FreeCAD: es hat keine Document.xml</translation>
    </message>
    <message>
      <source>{path:text} is not as the study made it; start the study anew in another folder</source>
      <translation>{path:text} ist nicht, wie die Studie es gemacht hat; die Studie in einem anderen Ordner neu beginnen</translation>
    </message>
    <message>
      <source>{path:text} is of a newer FeatureMesh (schema {schema:text}, this one reads {newest:count})</source>
      <translation>{path:text} ist von einem neueren FeatureMesh (Schema {schema:text}, dieses liest {newest:count})</translation>
    </message>
    <message>
      <source>{path:text} is the name of a {ending:text} file and would hold {format:text}; give it another name, or ask for {ending:text}</source>
      <translation>{path:text} ist der Name einer {ending:text}-Datei und enthielte {format:text}; einen anderen Namen angeben oder {ending:text} wählen</translation>
    </message>
    <message>
      <source>{path:text} was not saved as a whole; is the disk full? Make room before you save it again, or save it elsewhere: FreeCAD would overwrite the copy that it keeps of the document as it was before</source>
      <translation>{path:text} wurde nicht vollständig gespeichert; ist die Platte voll? Vor dem nächsten Speichern Platz schaffen oder woanders speichern: FreeCAD würde die Kopie überschreiben, die es vom Dokument behält, wie es vorher war</translation>
    </message>
    <message>
      <source>{path:text} was saved by another program meanwhile, which writing it would undo; do this again, or write another file with --out</source>
      <translation>{path:text} wurde inzwischen von einem anderen Programm gespeichert, was beim Schreiben verloren ginge; den Befehl wiederholen oder mit --out eine andere Datei schreiben</translation>
    </message>
    <message>
      <source>{path:text}, line {line:count}: {text:text} is no number for {parameter:text}</source>
      <translation>{path:text}, Zeile {line:count}: {text:text} ist keine Zahl für {parameter:text}</translation>
    </message>
    <message>
      <source>{path:text}: a parameter has no set = "OBJECT.PROPERTY"</source>
      <translation>{path:text}: einem Parameter fehlt set = "OBJEKT.EIGENSCHAFT"</translation>
    </message>
    <message>
      <source>{path:text}: a parameter is a table [[parameters]] with set = "OBJECT.PROPERTY", not {entry:text}</source>
      <translation>{path:text}: ein Parameter ist eine Tabelle [[parameters]] mit set = "OBJEKT.EIGENSCHAFT", nicht {entry:text}</translation>
    </message>
    <message>
      <source>{path:text}: the range of {parameter:text} is two numbers</source>
      <translation>{path:text}: der Bereich von {parameter:text} besteht aus zwei Zahlen</translation>
    </message>
    <message>
      <source>{pieces:messages} added {places:messages}</source>
      <translation>{pieces:messages} hinzugefügt {places:messages}</translation>
    </message>
    <message>
      <source>{pieces:messages} removed {places:messages}</source>
      <translation>{pieces:messages} entfernt {places:messages}</translation>
    </message>
    <message>
      <source>{pieces:messages} reshaped {places:messages}</source>
      <translation>{pieces:messages} umgeformt {places:messages}</translation>
    </message>
    <message>
      <source>{place:text}, where a response is asked for, has no face and no element of the part</source>
      <translation>{place:text}, wo nach einer Zielgröße gefragt ist, hat keine Fläche und kein Element des Bauteils</translation>
    </message>
    <message>
      <source>{place:text}, where a response is asked for, is gone</source>
      <translation>{place:text}, wo nach einer Zielgröße gefragt ist, gibt es nicht mehr</translation>
    </message>
    <message>
      <source>{pressure:text} presses on {face:entities}, which lies between two solids; choose an outer face</source>
      <translation>{pressure:text} drückt auf {face:entities}, die zwischen zwei Volumenkörpern liegt; eine Außenfläche wählen</translation>
    </message>
    <message>
      <source>{property:text} has to be 0 mm or more, not {value:number}</source>
      <translation>{property:text} muss 0 mm oder mehr sein, nicht {value:number}</translation>
    </message>
    <message>
      <source>{response:messages}: least {least:text} in case {case:count}, largest {largest:text} in case {other:count}</source>
      <translation>{response:messages}: kleinster Wert {least:text} in Fall {case:count}, größter Wert {largest:text} in Fall {other:count}</translation>
    </message>
    <message>
      <source>{result:text} has no mesh</source>
      <translation>{result:text} hat kein Netz</translation>
    </message>
    <message>
      <source>{result:text} has no values per node</source>
      <translation>{result:text} hat keine Werte an den Knoten</translation>
    </message>
    <message>
      <source>{result:text} has values for {values:count} {values:node|nodes}, its mesh {mesh:text} has {nodes:count}</source>
      <translation>{result:text} hat Werte für {values:count} Knoten, sein Netz {mesh:text} hat {nodes:count}</translation>
    </message>
    <message>
      <source>{result:text} is no result</source>
      <translation>{result:text} ist kein Ergebnis</translation>
    </message>
    <message>
      <source>{sampling:text}: {states:text}. Every case starts from one base mesh ({nodes:count} {nodes:node|nodes}, {elements:count} {elements:element|elements}); {solved:messages}.</source>
      <translation>{sampling:text}: {states:text}. Alle Fälle gehen von einem Ausgangsnetz aus ({nodes:count} Knoten, {elements:count} {elements:Element|Elemente}); {solved:messages}.</translation>
    </message>
    <message>
      <source>{script:text} ended with {code:text}</source>
      <translation>{script:text} endete mit {code:text}</translation>
    </message>
    <message>
      <source>{share:number} % of the elements have angles below 10 degrees, the smallest is {angle:number} degrees, at {place:entities}: stresses are poor there. Where walls are far thinner than the elements are long, ask for one or two elements across them (Across walls), or mesh a sheet as a shell; else mesh finer.</source>
      <translation>{share:number} % der Elemente haben Winkel unter 10 Grad, der kleinste ist {angle:number} Grad, an {place:entities}: Spannungen sind dort schlecht. Wo Wände viel dünner sind als die Elemente lang, ein oder zwei Elemente durch sie verlangen (In Wänden) oder ein Blech als Schale vernetzen; sonst feiner vernetzen.</translation>
    </message>
    <message>
      <source>{sides:count} {sides:side between faces follows|sides between faces follow} no edge</source>
      <translation>{sides:count} {sides:Seite zwischen Flächen folgt|Seiten zwischen Flächen folgen} keiner Kante</translation>
    </message>
    <message>
      <source>{sides:count} {sides:side|sides} of elements at {places:entities} {sides:is|are} straight, with {sides:its middle|their middles} up to {distance:length} off the part, because elements would be folded if {sides:it|they} followed it. FreeCAD does not find these nodes on the face, so a load on it lacks the elements there. Ask for another size there.</source>
      <translation>{sides:count} {sides:Seite|Seiten} von Elementen bei {places:entities} {sides:ist|sind} gerade, {sides:ihre Mitte|ihre Mitten} bis zu {distance:length} neben dem Bauteil, weil Elemente gefaltet würden, wenn {sides:sie ihm folgte|sie ihm folgten}. FreeCAD findet diese Knoten nicht auf der Fläche, so dass einer Last darauf die Elemente dort fehlen. Dort eine andere Größe wählen.</translation>
    </message>
    <message>
      <source>{place:entities} has no beam section; choose one for it</source>
      <translation>{place:entities} hat keinen Balkenquerschnitt; wählen Sie einen dafür</translation>
    </message>
    <message>
      <source>{place:entities} has no shell thickness; choose one for it</source>
      <translation>{place:entities} hat keine Schalendicke; wählen Sie eine dafür</translation>
    </message>
    <message>
      <source>{solid:entities} has no material; choose one for it</source>
      <translation>{solid:entities} hat kein Material; wählen Sie eines dafür</translation>
    </message>
    <message>
      <source>{solid:entities} has several materials: {materials:text}; take it out of the references of all but one</source>
      <translation>{solid:entities} hat mehrere Materialien: {materials:text}; nehmen Sie ihn aus den Verweisen aller außer einem</translation>
    </message>
    <message>
      <source>{solver:text} asks for an iterative solver, which ends too soon where points or edges hold the part or supports move it: displacements, stresses and reactions may be off by several per cent. Choose another MatrixSolverType.</source>
      <translation>{solver:text} verlangt einen iterativen Löser, der zu früh endet, wo Punkte oder Kanten das Bauteil halten oder Lager es bewegen: Verschiebungen, Spannungen und Reaktionskräfte können um mehrere Prozent abweichen. Einen anderen MatrixSolverType wählen.</translation>
    </message>
    <message>
      <source>{solver:text} only checks the mesh (Check Mesh), which gives no result; choose another type of analysis in its panel</source>
      <translation>{solver:text} prüft nur das Netz (Check Mesh), was kein Ergebnis gibt; in seinem Aufgabenfenster eine andere Art der Analyse wählen</translation>
    </message>
    <message>
      <source>{study:text} has no part</source>
      <translation>{study:text} hat kein Bauteil</translation>
    </message>
    <message>
      <source>{mesh:text} has no part to mesh, set its property {property:text}</source>
      <translation>{mesh:text} hat kein Bauteil, das vernetzt werden kann; die Eigenschaft {property:text} setzen</translation>
    </message>
    <message>
      <source>{container:text} has no part with a solid</source>
      <translation>{container:text} hat kein Bauteil mit einem Volumenkörper</translation>
    </message>
    <message>
      <source>{part:text} has no shape yet; recompute the document first</source>
      <translation>{part:text} hat noch keine Form; zuerst das Dokument neu berechnen</translation>
    </message>
    <message>
      <source>{object:text} has no solid{error:text}</source>
      <translation>{object:text} hat keinen Volumenkörper{error:text}</translation>
    </message>
    <message>
      <source>{object:text} has no tetrahedra; it has to be a volume mesh</source>
      <translation>{object:text} hat keine Tetraeder; es muss ein Volumennetz sein</translation>
    </message>
    <message>
      <source>{object:text} has other elements than 4-node or 10-node tetrahedra ({kind:messages} with {counts:text} nodes); only tetrahedra can be adopted</source>
      <translation>{object:text} hat andere Elemente als Tetraeder mit 4 oder 10 Knoten ({kind:messages} mit {counts:text} Knoten); nur Tetraeder können übernommen werden</translation>
    </message>
    <message>
      <source>%s has the mesh %s already.</source>
      <translation>%s hat schon das Netz %s.</translation>
    </message>
    <message>
      <source>%s in its place</source>
      <translation>%s an Ort und Stelle</translation>
    </message>
    <message>
      <source>%s is %s; update it before solving</source>
      <translation>%s ist %s; vor dem Lösen aktualisieren</translation>
    </message>
    <message>
      <source>{foreign:text} is FeatureMesh's own already</source>
      <translation>{foreign:text} gehört schon FeatureMesh</translation>
    </message>
    <message>
      <source>{object:text} is a group, name one of its objects: {members:text}</source>
      <translation>{object:text} ist eine Gruppe, eines ihrer Objekte angeben: {members:text}</translation>
    </message>
    <message>
      <source>{foreign:text} is no FEM mesh</source>
      <translation>{foreign:text} ist kein FEM-Netz</translation>
    </message>
    <message>
      <source>{analysis:text} is no analysis</source>
      <translation>{analysis:text} ist keine Analyse</translation>
    </message>
    <message>
      <source>{support:text} gives nodes another displacement than a support before it; let one of the two hold them</source>
      <translation>{support:text} gibt Knoten eine andere Verschiebung als ein Lager davor; nur eines der beiden dort halten lassen</translation>
    </message>
    <message>
      <source>{target:text} cannot be {value:text}, only one of: {known:text}</source>
      <translation>{target:text} kann nicht {value:text} sein, nur eines von: {known:text}</translation>
    </message>
    <message>
      <source>{target:text} has to be a whole number, not {value:text}</source>
      <translation>{target:text} muss eine ganze Zahl sein, nicht {value:text}</translation>
    </message>
    <message>
      <source>{target:text} is a reference dimension, it only measures</source>
      <translation>{target:text} ist ein Referenzmaß, es misst nur</translation>
    </message>
    <message>
      <source>{target:text} is a switch, it can be true or false, not {value:text}</source>
      <translation>{target:text} ist ein Schalter, er kann true oder false sein, nicht {value:text}</translation>
    </message>
    <message>
      <source>{target:text} is no number, switch or choice ({kind:text}), it cannot be set this way</source>
      <translation>{target:text} ist keine Zahl, kein Schalter und keine Auswahl ({kind:text}) und kann so nicht gesetzt werden</translation>
    </message>
    <message>
      <source>{these:messages} and {more:count} more</source>
      <translation>{these:messages} und {more:count} weitere</translation>
    </message>
    <message>
      <source>{tie:text} ties nothing: {faces:entities} are {gap:length} apart, and its tolerance is {tolerance:length}. Give it a tolerance that is larger than the gap</source>
      <translation>{tie:text} verbindet nichts: {faces:entities} sind {gap:length} voneinander entfernt, und die Toleranz ist {tolerance:length}. Geben Sie eine Toleranz an, die größer als der Spalt ist</translation>
    </message>
    <message>
      <source>{triangles:count} {triangles:boundary triangle lies|boundary triangles lie} on no face</source>
      <translation>{triangles:count} {triangles:Randdreieck liegt|Randdreiecke liegen} auf keiner Fläche</translation>
    </message>
    <message>
      <source>{triangles:count} {triangles:triangle has|triangles have} elements that overlap</source>
      <translation>{triangles:count} {triangles:Dreieck hat|Dreiecke haben} Elemente, die sich überlappen</translation>
    </message>
    <message>
      <source>{value:text} has the wrong unit for {target:text}</source>
      <translation>{value:text} hat die falsche Einheit für {target:text}</translation>
    </message>
    <message>
      <source>{value:text} is no length</source>
      <translation>{value:text} ist keine Länge</translation>
    </message>
    <message>
      <source>%s is not that of the part as it is, its last update failed: %s</source>
      <translation>%s ist nicht das Netz des Bauteils, wie es jetzt ist; die letzte Aktualisierung ist fehlgeschlagen: %s</translation>
    </message>
    <message>
      <source>%s presses on a shell beside a solid, which FreeCAD cannot write for CalculiX; use a force there</source>
      <translation>%s drückt auf eine Schale neben einem Volumenkörper, was FreeCAD für CalculiX nicht schreiben kann; dort eine Kraft verwenden</translation>
    </message>
    <message>
      <source>%s shows a mesh that was deleted; delete it, too, and give the analysis another mesh</source>
      <translation>%s zeigt ein Netz, das gelöscht wurde; es auch löschen und der Analyse ein anderes Netz geben</translation>
    </message>
    <message>
      <source>'{name:text}' is no face, edge, vertex or solid; write it as FreeCAD does, e.g. Face12.</source>
      <translation>„{name:text}“ ist keine Fläche, keine Kante, kein Eckpunkt und kein Volumenkörper; wie in FreeCAD zu schreiben, z. B. Face12.</translation>
    </message>
    <message>
      <source>10-node tetrahedra</source>
      <translation>10-Knoten-Tetraeder</translation>
    </message>
    <message>
      <source>10-node tetrahedron with a non-positive Jacobian: {elements:messages}</source>
      <translation>10-Knoten-Tetraeder mit nicht positiver Jacobi-Determinante: {elements:messages}</translation>
    </message>
    <message>
      <source>2-node segments</source>
      <translation>2-Knoten-Balkenelemente</translation>
    </message>
    <message>
      <source>3-node segments</source>
      <translation>3-Knoten-Balkenelemente</translation>
    </message>
    <message>
      <source>3-node triangles</source>
      <translation>3-Knoten-Dreiecke</translation>
    </message>
    <message>
      <source>4-node tetrahedra</source>
      <translation>4-Knoten-Tetraeder</translation>
    </message>
    <message>
      <source>4-node tetrahedra are too stiff in bending and show too little stress (here the stresses are off by about {percent:count} % in the mean of the energy); 10-node tetrahedra (Order: 2nd) are far closer on the same mesh</source>
      <translation>4-Knoten-Tetraeder sind bei Biegung zu steif und zeigen zu kleine Spannungen (hier liegen die Spannungen im Mittel der Energie um etwa {percent:count} % daneben); 10-Knoten-Tetraeder (Order: 2nd) sind auf demselben Netz weit genauer</translation>
    </message>
    <message>
      <source>4-node tetrahedra are too stiff in bending and show too little stress; 10-node tetrahedra (Order: 2nd) are far closer on the same mesh</source>
      <translation>4-Knoten-Tetraeder sind bei Biegung zu steif und zeigen zu kleine Spannungen; 10-Knoten-Tetraeder (Order: 2nd) sind auf demselben Netz weit genauer</translation>
    </message>
    <message>
      <source>6-node triangle that is folded: {triangles:messages}</source>
      <translation>gefaltetes 6-Knoten-Dreieck: {triangles:messages}</translation>
    </message>
    <message>
      <source>6-node triangles</source>
      <translation>6-Knoten-Dreiecke</translation>
    </message>
    <message>
      <source>; edges: %s</source>
      <translation>; Kanten: %s</translation>
    </message>
    <message>
      <source>&lt;b&gt;Show what was kept&lt;/b&gt; colours what stayed and what is new; &lt;b&gt;Show the quality&lt;/b&gt; finds the worst elements.</source>
      <translation>&lt;b&gt;Zeigen, was blieb&lt;/b&gt; färbt, was geblieben und was neu ist; &lt;b&gt;Qualität zeigen&lt;/b&gt; findet die schlechtesten Elemente.</translation>
    </message>
    <message>
      <source>A crash of the geometry kernel then ends that process only; FreeCAD and the document stay as they are</source>
      <translation>Ein Absturz des Geometriekerns beendet dann nur diesen Prozess; FreeCAD und das Dokument bleiben, wie sie sind</translation>
    </message>
    <message>
      <source>A double click on a case shows it: part, mesh and result. Undo takes it back.</source>
      <translation>Ein Doppelklick auf einen Fall zeigt ihn: Bauteil, Netz und Ergebnis. Rückgängig nimmt das zurück.</translation>
    </message>
    <message>
      <source>A material needs Young's modulus above 0 and Poisson's ratio from above -1 to below 0.5.</source>
      <translation>Ein Werkstoff braucht einen Elastizitätsmodul über 0 und eine Querkontraktionszahl von über -1 bis unter 0,5.</translation>
    </message>
    <message>
      <source>A mesh that follows your part</source>
      <translation>Ein Netz, das dem Bauteil folgt</translation>
    </message>
    <message>
      <source>A size of {size:length} would make about {millions:count} million elements; at most {most:count} million are made. Choose a larger size.</source>
      <translation>Eine Größe von {size:length} ergäbe etwa {millions:count} Millionen Elemente; höchstens {most:count} Millionen werden gemacht. Eine größere Größe wählen.</translation>
    </message>
    <message>
      <source>About FeatureMesh</source>
      <translation>Über FeatureMesh</translation>
    </message>
    <message>
      <source>Add another mesh</source>
      <translation>Weiteres Netz anlegen</translation>
    </message>
    <message>
      <source>Add at the selection</source>
      <translation>Am gewählten Ort hinzufügen</translation>
    </message>
    <message>
      <source>Add cases</source>
      <translation>Fälle hinzufügen</translation>
    </message>
    <message>
      <source>Analysis</source>
      <translation>Analyse</translation>
    </message>
    <message>
      <source>As it was</source>
      <translation>Wie es war</translation>
    </message>
    <message>
      <source>At once</source>
      <translation>Gleichzeitig</translation>
    </message>
    <message>
      <source>Box</source>
      <translation>Quader</translation>
    </message>
    <message>
      <source>By how much displacements are drawn larger than they are</source>
      <translation>Um wie viel größer die Verschiebungen gezeichnet werden, als sie sind</translation>
    </message>
    <message>
      <source>CalculiX (ccx) is not installed; on Debian its package is calculix-ccx</source>
      <translation>CalculiX (ccx) ist nicht installiert; in Debian heißt sein Paket calculix-ccx</translation>
    </message>
    <message>
      <source>CalculiX cannot solve {analysis:text}: {why:text}</source>
      <translation>CalculiX kann {analysis:text} nicht lösen: {why:text}</translation>
    </message>
    <message>
      <source>CalculiX gave no result for {analysis:text}</source>
      <translation>CalculiX lieferte kein Ergebnis für {analysis:text}</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Cancelled; the mesh is as it was.</source>
      <translation>Abgebrochen; das Netz ist, wie es war.</translation>
    </message>
    <message>
      <source>Case %d: %s</source>
      <translation>Fall %d: %s</translation>
    </message>
    <message>
      <source>Cases</source>
      <translation>Fälle</translation>
    </message>
    <message>
      <source>Check the shape there (Part: Check geometry), mesh from scratch, or try another size.</source>
      <translation>Die Form dort prüfen (Part: Geometrie prüfen), vollständig neu vernetzen oder eine andere Größe versuchen.</translation>
    </message>
    <message>
      <source>Colours</source>
      <translation>Farben</translation>
    </message>
    <message>
      <source>Colours up to</source>
      <translation>Farben bis</translation>
    </message>
    <message>
      <source>Copy for a bug report</source>
      <translation>Für einen Fehlerbericht kopieren</translation>
    </message>
    <message>
      <source>Cut open</source>
      <translation>Aufschneiden</translation>
    </message>
    <message>
      <source>Cylinder</source>
      <translation>Zylinder</translation>
    </message>
    <message>
      <source>Details below {below:length} cannot be ignored; at most those below half of the mesh size of {size:length} can be.</source>
      <translation>Einzelheiten unter {below:length} können nicht übergangen werden; höchstens solche unter der Hälfte der Elementgröße von {size:length}.</translation>
    </message>
    <message>
      <source>Distance</source>
      <translation>Abstand</translation>
    </message>
    <message>
      <source>Edges (beams)</source>
      <translation>Kanten (Balken)</translation>
    </message>
    <message>
      <source>Edit the part: move a hole, change a thickness. The mesh follows, and only around the edit; loads and supports stay where they are.</source>
      <translation>Das Bauteil ändern: eine Bohrung verschieben, eine Dicke anpassen. Das Netz folgt, und nur rund um die Änderung; Lasten und Lager bleiben, wo sie sind.</translation>
    </message>
    <message>
      <source>Element</source>
      <translation>Element</translation>
    </message>
    <message>
      <source>Elements along the diagonal</source>
      <translation>Elemente entlang der Diagonale</translation>
    </message>
    <message>
      <source>FEM meshes that are updated, not thrown away, when the part is edited</source>
      <translation>FEM-Netze, die bei Änderungen am Bauteil aktualisiert statt weggeworfen werden</translation>
    </message>
    <message>
      <source>Face%d: %s and %s, %.6g mm^2</source>
      <translation>Face%d: %s und %s, %.6g mm^2</translation>
    </message>
    <message>
      <source>Faces (shells)</source>
      <translation>Flächen (Schalen)</translation>
    </message>
    <message>
      <source>Faces far narrower than the size are meshed at the plain size, since shorter edges failed: {why:messages}</source>
      <translation>Flächen, die weit schmaler als die Größe sind, sind mit der einfachen Größe vernetzt, weil kürzere Kanten nicht gelangen: {why:messages}</translation>
    </message>
    <message>
      <source>Feature tree</source>
      <translation>Formelementbaum</translation>
    </message>
    <message>
      <source>FeatureMesh cannot start its worker process and runs inside FreeCAD: %s</source>
      <translation>FeatureMesh kann seinen Arbeitsprozess nicht starten und läuft in FreeCAD selbst: %s</translation>
    </message>
    <message>
      <source>FeatureMesh found several engines and uses the newest, %s in %s; the others: %s</source>
      <translation>FeatureMesh hat mehrere Rechenprogramme gefunden und nimmt das neueste, %s in %s; die anderen: %s</translation>
    </message>
    <message>
      <source>FeatureMesh needs numpy, which this FreeCAD has not; install it (Debian: python3-numpy) and start FreeCAD anew.</source>
      <translation>FeatureMesh braucht numpy, das dieses FreeCAD nicht hat; es installieren (Debian: python3-numpy) und FreeCAD neu starten.</translation>
    </message>
    <message>
      <source>FeatureMesh's compiled engine (featuremesh_engine) is not installed for Python %d.%d; the mesh is shown as it was saved.</source>
      <translation>Das Rechenprogramm von FeatureMesh (featuremesh_engine) ist für Python %d.%d nicht installiert; das Netz wird gezeigt, wie es gespeichert wurde.</translation>
    </message>
    <message>
      <source>FeatureMesh's engine %s in %s is too new for FeatureMesh %s; update FeatureMesh with Tools, Addon manager.</source>
      <translation>Das Rechenprogramm %s in %s ist zu neu für FeatureMesh %s; FeatureMesh mit Werkzeuge, Addon-Manager auf den neuesten Stand bringen.</translation>
    </message>
    <message>
      <source>FeatureMesh's engine %s in %s is too old for FeatureMesh %s. To install a newer one: %s</source>
      <translation>Das Rechenprogramm %s in %s ist zu alt für FeatureMesh %s. So wird ein neueres installiert: %s</translation>
    </message>
    <message>
      <source>FeatureMesh's engine in %s could not be loaded: %s. To install it anew: %s</source>
      <translation>Das Rechenprogramm von FeatureMesh in %s konnte nicht geladen werden: %s. So wird es neu installiert: %s</translation>
    </message>
    <message>
      <source>FeatureMesh's worker process %s while %s%s. FreeCAD and the document are as they were. %s</source>
      <translation>Der Arbeitsprozess von FeatureMesh %s; er war beim %s%s. FreeCAD und das Dokument sind, wie sie waren. %s</translation>
    </message>
    <message>
      <source>FeatureMesh: %s, %d %% (Escape cancels)</source>
      <translation>FeatureMesh: %s, %d %% (Escape bricht ab)</translation>
    </message>
    <message>
      <source>FreeCAD cannot recompute {object:text}: {error:text}</source>
      <translation>FreeCAD kann {object:text} nicht neu berechnen: {error:text}</translation>
    </message>
    <message>
      <source>FreeCAD could not compute {part:text}: {error:text}</source>
      <translation>FreeCAD konnte {part:text} nicht berechnen: {error:text}</translation>
    </message>
    <message>
      <source>FreeCAD could not write CalculiX's input for {analysis:text}; its report view says why</source>
      <translation>FreeCAD konnte die Eingabe von CalculiX für {analysis:text} nicht schreiben; sein Ausgabefenster sagt, warum</translation>
    </message>
    <message>
      <source>FreeCAD's program freecadcmd was not found; set FREECADCMD to it</source>
      <translation>FreeCADs Programm freecadcmd wurde nicht gefunden; FREECADCMD darauf setzen</translation>
    </message>
    <message>
      <source>From</source>
      <translation>Von</translation>
    </message>
    <message>
      <source>From scratch</source>
      <translation>Neu vernetzen</translation>
    </message>
    <message>
      <source>From the shape</source>
      <translation>Nach der Form</translation>
    </message>
    <message>
      <source>Go on</source>
      <translation>Weiter</translation>
    </message>
    <message>
      <source>Grows over</source>
      <translation>Wächst über</translation>
    </message>
    <message>
      <source>Growth</source>
      <translation>Wachstum</translation>
    </message>
    <message>
      <source>Height</source>
      <translation>Höhe</translation>
    </message>
    <message>
      <source>How many elements have which value of the measure</source>
      <translation>Wie viele Elemente welchen Wert des Maßes haben</translation>
    </message>
    <message>
      <source>Ignore below</source>
      <translation>Weglassen unter</translation>
    </message>
    <message>
      <source>Kept elements</source>
      <translation>Behaltene Elemente</translation>
    </message>
    <message>
      <source>Kept in %s</source>
      <translation>Behalten in %s</translation>
    </message>
    <message>
      <source>Kept nodes of {edge:entities} belong to an edge in the same place.</source>
      <translation>Behaltene Knoten von {edge:entities} gehören zu einer Kante am selben Ort.</translation>
    </message>
    <message>
      <source>Kind</source>
      <translation>Art</translation>
    </message>
    <message>
      <source>Leave it out</source>
      <translation>Weglassen</translation>
    </message>
    <message>
      <source>Length</source>
      <translation>Länge</translation>
    </message>
    <message>
      <source>Live result</source>
      <translation>Mitlaufendes Ergebnis</translation>
    </message>
    <message>
      <source>Live result: %s</source>
      <translation>Mitlaufendes Ergebnis: %s</translation>
    </message>
    <message>
      <source>Loads and displacements have to be finite numbers.</source>
      <translation>Lasten und Verschiebungen müssen endliche Zahlen sein.</translation>
    </message>
    <message>
      <source>Loads, supports and materials do not fit the mesh.</source>
      <translation>Lasten, Lager und Werkstoffe passen nicht zum Netz.</translation>
    </message>
    <message>
      <source>Mesh in a process of its own</source>
      <translation>In einem eigenen Prozess vernetzen</translation>
    </message>
    <message>
      <source>Mesh of</source>
      <translation>Vernetzt</translation>
    </message>
    <message>
      <source>Mesh of %s</source>
      <translation>Netz von %s</translation>
    </message>
    <message>
      <source>Mesh settings</source>
      <translation>Netzeinstellungen</translation>
    </message>
    <message>
      <source>Meshed finer than asked, because a face beside it would cross itself: {edges:entities}.</source>
      <translation>Feiner vernetzt als gewünscht, weil sich eine Fläche daneben selbst kreuzen würde: {edges:entities}.</translation>
    </message>
    <message>
      <source>New elements</source>
      <translation>Neue Elemente</translation>
    </message>
    <message>
      <source>New meshes</source>
      <translation>Neue Netze</translation>
    </message>
    <message>
      <source>No case is done yet.</source>
      <translation>Noch ist kein Fall fertig.</translation>
    </message>
    <message>
      <source>No element of the mesh fits the part: {reasons:messages}. Choose the object it was made of, or mesh the part anew.</source>
      <translation>Kein Element des Netzes passt zum Bauteil: {reasons:messages}. Das Objekt wählen, von dem es gemacht wurde, oder das Bauteil neu vernetzen.</translation>
    </message>
    <message>
      <source>Nodes kept as start positions</source>
      <translation>Als Startlage behaltene Knoten</translation>
    </message>
    <message>
      <source>Not meshed, because no face has them: {loose:entities}.</source>
      <translation>Nicht vernetzt, weil keine Fläche sie hat: {loose:entities}.</translation>
    </message>
    <message>
      <source>Not meshed, because no solid has them: {loose:entities}.</source>
      <translation>Nicht vernetzt, weil sie zu keinem Volumenkörper gehören: {loose:entities}.</translation>
    </message>
    <message>
      <source>Only meshes of solids can be adopted. Mesh the part's faces or edges anew.</source>
      <translation>Nur Netze von Volumenkörpern können übernommen werden. Die Flächen oder Kanten des Bauteils neu vernetzen.</translation>
    </message>
    <message>
      <source>Open a part, select its body and press &lt;b&gt;Mesh a part&lt;/b&gt;. Choose a size; the panel tells how many elements it gives. Press &lt;b&gt;OK&lt;/b&gt;.</source>
      <translation>Ein Bauteil öffnen, seinen Körper auswählen und &lt;b&gt;Bauteil vernetzen&lt;/b&gt; drücken. Eine Größe wählen; das Fenster sagt, wie viele Elemente sie ergibt. &lt;b&gt;OK&lt;/b&gt; drücken.</translation>
    </message>
    <message>
      <source>Open it</source>
      <translation>Öffnen</translation>
    </message>
    <message>
      <source>PETSc could not solve: numbers are out of range.</source>
      <translation>PETSc konnte nicht lösen: Zahlen liegen außerhalb des Bereichs.</translation>
    </message>
    <message>
      <source>PETSc could not solve: {why:text}</source>
      <translation>PETSc konnte nicht lösen: {why:text}</translation>
    </message>
    <message>
      <source>Parallel coordinates</source>
      <translation>Parallele Koordinaten</translation>
    </message>
    <message>
      <source>Part</source>
      <translation>Bauteil</translation>
    </message>
    <message>
      <source>Parts of %s</source>
      <translation>Bauteile von %s</translation>
    </message>
    <message>
      <source>Per circle</source>
      <translation>Je Kreis</translation>
    </message>
    <message>
      <source>Perhaps memory ran out: try a larger size.</source>
      <translation>Vielleicht ging der Speicher aus: eine größere Größe versuchen.</translation>
    </message>
    <message>
      <source>Plots need matplotlib (Debian: python3-matplotlib): %s</source>
      <translation>Diagramme brauchen matplotlib (Debian: python3-matplotlib): %s</translation>
    </message>
    <message>
      <source>Processor threads of a new mesh; the mesh is the same for any number</source>
      <translation>Prozessorkerne, die ein neues Netz rechnen; das Netz ist für jede Anzahl dasselbe</translation>
    </message>
    <message>
      <source>Quality of %s</source>
      <translation>Qualität von %s</translation>
    </message>
    <message>
      <source>Radius</source>
      <translation>Radius</translation>
    </message>
    <message>
      <source>Refinement zone</source>
      <translation>Verfeinerungszone</translation>
    </message>
    <message>
      <source>Report</source>
      <translation>Bericht</translation>
    </message>
    <message>
      <source>Results</source>
      <translation>Ergebnisse</translation>
    </message>
    <message>
      <source>Run</source>
      <translation>Starten</translation>
    </message>
    <message>
      <source>Save table</source>
      <translation>Tabelle speichern</translation>
    </message>
    <message>
      <source>Scale</source>
      <translation>Überhöhung</translation>
    </message>
    <message>
      <source>Scatter</source>
      <translation>Streudiagramm</translation>
    </message>
    <message>
      <source>Select a case in the table, or click a point of a plot.</source>
      <translation>Einen Fall in der Tabelle auswählen, oder einen Punkt eines Diagramms anklicken.</translation>
    </message>
    <message>
      <source>Select a face and press &lt;b&gt;Add a local size&lt;/b&gt; where the mesh shall be finer. All of this is in FEM's Mesh menu, too.</source>
      <translation>Eine Fläche auswählen und &lt;b&gt;Lokale Größe hinzufügen&lt;/b&gt; drücken, wo das Netz feiner werden soll. All das steht auch im Menü Netz von FEM.</translation>
    </message>
    <message>
      <source>Show case %d</source>
      <translation>Fall %d zeigen</translation>
    </message>
    <message>
      <source>Show the case</source>
      <translation>Fall zeigen</translation>
    </message>
    <message>
      <source>Show the part as it was</source>
      <translation>Das Bauteil zeigen, wie es war</translation>
    </message>
    <message>
      <source>Size</source>
      <translation>Größe</translation>
    </message>
    <message>
      <source>Size inside</source>
      <translation>Größe innen</translation>
    </message>
    <message>
      <source>Size outside</source>
      <translation>Größe außen</translation>
    </message>
    <message>
      <source>Smallest</source>
      <translation>Kleinste</translation>
    </message>
    <message>
      <source>Solids</source>
      <translation>Volumenkörper</translation>
    </message>
    <message>
      <source>Solve</source>
      <translation>Lösen</translation>
    </message>
    <message>
      <source>Solver</source>
      <translation>Löser</translation>
    </message>
    <message>
      <source>Sphere</source>
      <translation>Kugel</translation>
    </message>
    <message>
      <source>Status</source>
      <translation>Zustand</translation>
    </message>
    <message>
      <source>Stop</source>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>Study</source>
      <translation>Studie</translation>
    </message>
    <message>
      <source>Take what is selected</source>
      <translation>Auswahl übernehmen</translation>
    </message>
    <message>
      <source>The cases that are done do not differ yet.</source>
      <translation>Die fertigen Fälle unterscheiden sich noch nicht.</translation>
    </message>
    <message>
      <source>The document has no object named {object:text}. Name one of its objects.</source>
      <translation>Das Dokument hat kein Objekt namens {object:text}. Eines seiner Objekte nennen.</translation>
    </message>
    <message>
      <source>The document's shapes are missing.</source>
      <translation>Die Formen des Dokuments fehlen.</translation>
    </message>
    <message>
      <source>The geometry kernel failed while meshing: {why:text}. Try another size, or check the shape (Part: Check geometry).</source>
      <translation>Der Geometriekern ist beim Vernetzen gescheitert: {why:text}. Eine andere Größe versuchen, oder die Form prüfen (Part: Geometrie prüfen).</translation>
    </message>
    <message>
      <source>The growth rate is {growth:number}; it must be at least 1 (1.3 is usual).</source>
      <translation>Das Wachstum ist {growth:number}; es muss mindestens 1 sein (üblich ist 1.3).</translation>
    </message>
    <message>
      <source>The kept nodes of {edge:entities} are not in the order of the edge.</source>
      <translation>Die behaltenen Knoten von {edge:entities} liegen nicht in der Reihenfolge der Kante.</translation>
    </message>
    <message>
      <source>The kept segments of {edge:entities} do not follow the edge.</source>
      <translation>Die behaltenen Segmente von {edge:entities} folgen der Kante nicht.</translation>
    </message>
    <message>
      <source>The live solver does not converge on this mesh; solve with CalculiX, and look for very flat elements or materials of very different stiffness.</source>
      <translation>Der mitlaufende Löser konvergiert auf diesem Netz nicht; mit CalculiX lösen, und nach sehr flachen Elementen oder Werkstoffen sehr verschiedener Steifigkeit suchen.</translation>
    </message>
    <message>
      <source>The live solver needs PETSc: install Debian's package libpetsc-real-dev, and any command of ./featuremesh in a clone builds the solver with it ({why:text}).</source>
      <translation>Der mitlaufende Löser braucht PETSc: Debians Paket libpetsc-real-dev installieren, und jeder Befehl von ./featuremesh in einem Klon baut den Löser damit ({why:text}).</translation>
    </message>
    <message>
      <source>The local mesh size at {entity:entities} is {size:length}; it must be larger than zero.</source>
      <translation>Die lokale Elementgröße an {entity:entities} ist {size:length}; sie muss größer als null sein.</translation>
    </message>
    <message>
      <source>The local size at {entity:entities} is left out: the part has no such face, edge or vertex any more. Refer the refinement to another one.</source>
      <translation>Die lokale Größe bei {entity:entities} entfällt: Das Bauteil hat diese Fläche, Kante oder diesen Eckpunkt nicht mehr. Die Verfeinerung auf etwas anderes beziehen.</translation>
    </message>
    <message>
      <source>The mesh follows every recompute of the document</source>
      <translation>Das Netz folgt jeder Neuberechnung des Dokuments</translation>
    </message>
    <message>
      <source>The mesh has no elements.</source>
      <translation>Das Netz hat keine Elemente.</translation>
    </message>
    <message>
      <source>The mesh is finer than asked at {place:entities}, because 10-node tetrahedra of that size would be folded, or nearly so, by the curved face.</source>
      <translation>Das Netz ist bei {place:entities} feiner als verlangt, weil 10-Knoten-Tetraeder dieser Größe durch die gekrümmte Fläche ganz oder fast gefaltet würden.</translation>
    </message>
    <message>
      <source>The mesh is finer than asked at {place:entities}, because 6-node triangles of that size would be folded, or nearly so, by the curved face.</source>
      <translation>Das Netz ist bei {place:entities} feiner als verlangt, weil 6-Knoten-Dreiecke dieser Größe durch die gekrümmte Fläche ganz oder fast gefaltet würden.</translation>
    </message>
    <message>
      <source>The mesh is finer than asked at {place:entities}, because elements of that size cannot follow the part there.</source>
      <translation>Das Netz ist bei {place:entities} feiner als verlangt, weil Elemente dieser Größe der Form dort nicht folgen können.</translation>
    </message>
    <message>
      <source>The mesh is finer than asked where these faces are near each other: {pairs:messages}.</source>
      <translation>Das Netz ist feiner als gewünscht, wo diese Flächen nahe beieinander liegen: {pairs:messages}.</translation>
    </message>
    <message>
      <source>The mesh is in %s, which refers to %s.</source>
      <translation>Das Netz liegt in %s; diese Analyse bezieht sich auf %s.</translation>
    </message>
    <message>
      <source>The mesh is in no analysis, because none of %s is active: drag it into the one that it is for.</source>
      <translation>Das Netz liegt in keiner Analyse, weil keine von %s aktiv ist: Es in die ziehen, für die es gedacht ist.</translation>
    </message>
    <message>
      <source>The mesh is joined where these faces of one solid lie on one another: {faces:entities}.</source>
      <translation>Das Netz ist verbunden, wo diese Flächen eines Volumenkörpers aufeinanderliegen: {faces:entities}.</translation>
    </message>
    <message>
      <source>The mesh size is {size:length}; it must be larger than zero. The part is {part:extent}.</source>
      <translation>Die Elementgröße ist {size:length}; sie muss größer als null sein. Das Bauteil misst {part:extent}.</translation>
    </message>
    <message>
      <source>The mesh size of {size:length} is larger than the part, which is {part:extent}. Ask for a smaller size.</source>
      <translation>Die Elementgröße von {size:length} ist größer als das Bauteil, es misst {part:extent}. Eine kleinere Größe wählen.</translation>
    </message>
    <message>
      <source>The number of elements per circle is {asked:number}; it must not be negative (0 turns it off).</source>
      <translation>Die Zahl der Elemente je Kreis ist {asked:number}; sie darf nicht negativ sein (0 schaltet ab).</translation>
    </message>
    <message>
      <source>The old mesh has no elements to take values from.</source>
      <translation>Das alte Netz hat keine Elemente, von denen Werte zu nehmen wären.</translation>
    </message>
    <message>
      <source>The one in %s is for Python %s.</source>
      <translation>Das in %s ist für Python %s.</translation>
    </message>
    <message>
      <source>The part could not be filled: {why:text}. Try another size, or check the shape (Part: Check geometry).</source>
      <translation>Das Bauteil konnte nicht gefüllt werden: {why:text}. Eine andere Größe versuchen, oder die Form prüfen (Part: Geometrie prüfen).</translation>
    </message>
    <message>
      <source>The part has faces or edges beside its solids, and only meshes of solids can be adopted. Mesh the part anew, or adopt the mesh for the solids alone (Dimension: Solids).</source>
      <translation>Das Bauteil hat Flächen oder Kanten neben seinen Volumenkörpern, und nur Netze von Volumenkörpern können übernommen werden. Das Bauteil neu vernetzen, oder das Netz nur für die Volumenkörper übernehmen (Dimension: Solids).</translation>
    </message>
    <message>
      <source>The part is only {part:extent}, and points nearer than 1e-7 mm are one to FreeCAD's geometry: nodes could not be placed on its surface. Was it imported in another unit? Scale it up.</source>
      <translation>Das Bauteil misst nur {part:extent}, und Punkte, die näher als 1e-7 mm beieinander liegen, sind für FreeCADs Geometrie einer: Knoten ließen sich nicht auf seine Oberfläche legen. Wurde es in einer anderen Einheit importiert? Dann vergrößern.</translation>
    </message>
    <message>
      <source>The part is {thickness:length} thick at {faces:entities}: elements are smaller there than asked, so that {pieces:number} go round it.</source>
      <translation>Das Bauteil ist {thickness:length} dick an {faces:entities}: Die Elemente sind dort kleiner als verlangt, damit {pieces:number} herumpassen.</translation>
    </message>
    <message>
      <source>The refinement at {entity:entities} with a size of {size:length} would make about {millions:count} million elements; at most {most:count} million are made. Choose a larger size there.</source>
      <translation>Die Verfeinerung an {entity:entities} mit einer Größe von {size:length} ergäbe etwa {millions:count} Millionen Elemente; höchstens {most:count} Millionen werden gemacht. Dort eine größere Größe wählen.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} changes nothing: its inner size of {inner:length} is not below the mesh size of {size:length}.</source>
      <translation>Die Verfeinerung {zone:text} ändert nichts: ihre innere Größe von {inner:length} liegt nicht unter der Elementgröße von {size:length}.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} grows over {transition:length}; that must not be negative (0: as fast as Growth allows).</source>
      <translation>Die Verfeinerung {zone:text} wächst über {transition:length}; das darf nicht negativ sein (0: so schnell, wie Growth erlaubt).</translation>
    </message>
    <message>
      <source>The refinement {zone:text} grows to {outer:length} over {over:length}, not over {asked:length}: neighbouring elements may differ by a factor of {growth:number} at most (Growth).</source>
      <translation>Die Verfeinerung {zone:text} wächst erst auf einer Strecke von {over:length} auf {outer:length}, nicht schon auf {asked:length}: Benachbarte Elemente dürfen sich höchstens um den Faktor {growth:number} unterscheiden (Growth).</translation>
    </message>
    <message>
      <source>The refinement {zone:text} has a height of {height:length}; it must be larger than zero.</source>
      <translation>Die Verfeinerung {zone:text} hat eine Höhe von {height:length}; sie muss größer als null sein.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} has a length of {length:length}; it must be larger than zero.</source>
      <translation>Die Verfeinerung {zone:text} hat eine Länge von {length:length}; sie muss größer als null sein.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} has a radius of {radius:length}; it must be larger than zero.</source>
      <translation>Die Verfeinerung {zone:text} hat einen Radius von {radius:length}; er muss größer als null sein.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} has a width of {width:length}; it must be larger than zero.</source>
      <translation>Die Verfeinerung {zone:text} hat eine Breite von {width:length}; sie muss größer als null sein.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} has an inner size of {inner:length}; it must be larger than zero.</source>
      <translation>Die Verfeinerung {zone:text} hat eine innere Größe von {inner:length}; sie muss größer als null sein.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} has an outer size of {outer:length}; it must not be negative (0: the mesh size).</source>
      <translation>Die Verfeinerung {zone:text} hat eine äußere Größe von {outer:length}; sie darf nicht negativ sein (0: die Elementgröße).</translation>
    </message>
    <message>
      <source>The refinement {zone:text} has no size and is left out. Give it one, or suppress it.</source>
      <translation>Die Verfeinerung {zone:text} hat keine Größe und wird weggelassen. Ihr eine geben, oder sie unterdrücken.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} is coarser inside ({inner:length}) than outside ({outer:length}); exchange the two sizes.</source>
      <translation>Die Verfeinerung {zone:text} ist innen ({inner:length}) gröber als außen ({outer:length}); die beiden Größen vertauschen.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} is left out: the part has nothing of what it refers to. Refer it to a face, an edge or a vertex.</source>
      <translation>Die Verfeinerung {zone:text} wird weggelassen: das Bauteil hat nichts von dem, worauf sie sich bezieht. Sie auf eine Fläche, eine Kante oder einen Eckpunkt beziehen.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} is of a kind that is not understood and left out. Use a refinement zone instead.</source>
      <translation>Die Verfeinerung {zone:text} ist von einer Art, die nicht verstanden wird, und wird weggelassen. Stattdessen eine Verfeinerungszone nehmen.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} is suppressed and left out.</source>
      <translation>Die Verfeinerung {zone:text} ist unterdrückt und wird weggelassen.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} lies outside the part. Move it into the part, or suppress it.</source>
      <translation>Die Verfeinerung {zone:text} liegt außerhalb des Bauteils. Sie in das Bauteil verschieben, oder sie unterdrücken.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} reaches {reach:length}; that must not be negative.</source>
      <translation>Die Verfeinerung {zone:text} reicht {reach:length} weit; das darf nicht negativ sein.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} refers to nothing and is left out. Choose faces, edges or vertices for it, or suppress it.</source>
      <translation>Die Verfeinerung {zone:text} bezieht sich auf nichts und wird weggelassen. Flächen, Kanten oder Eckpunkte für sie wählen, oder sie unterdrücken.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} with a size of {size:length} would make about {millions:count} million elements; at most {most:count} million are made. Choose a larger size there.</source>
      <translation>Die Verfeinerung {zone:text} mit einer Größe von {size:length} ergäbe etwa {millions:count} Millionen Elemente; höchstens {most:count} Millionen werden gemacht. Dort eine größere Größe wählen.</translation>
    </message>
    <message>
      <source>The report is %s</source>
      <translation>Der Bericht ist %s</translation>
    </message>
    <message>
      <source>The saved mesh does not fit the part: {finding:messages}.</source>
      <translation>Das gespeicherte Netz passt nicht zum Bauteil: {finding:messages}.</translation>
    </message>
    <message>
      <source>The shape has no edge. Mesh an object with edges.</source>
      <translation>Die Form hat keine Kante. Ein Objekt mit Kanten vernetzen.</translation>
    </message>
    <message>
      <source>The shape has no face. Mesh an object with faces, or its edges.</source>
      <translation>Die Form hat keine Fläche. Ein Objekt mit Flächen vernetzen oder seine Kanten.</translation>
    </message>
    <message>
      <source>The shape has no solid. Mesh a body or a Part object whose result is a solid.</source>
      <translation>Die Form hat keinen Volumenkörper. Einen Körper oder ein Part-Objekt vernetzen, dessen Ergebnis ein Volumenkörper ist.</translation>
    </message>
    <message>
      <source>The shape is empty. Recompute the document and mesh an object that has a solid.</source>
      <translation>Die Form ist leer. Das Dokument neu berechnen und ein Objekt mit Volumenkörper vernetzen.</translation>
    </message>
    <message>
      <source>The shapes are cut short or damaged.</source>
      <translation>Die Formen sind abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
      <source>The shapes are damaged: the list of their places makes no sense.</source>
      <translation>Die Formen sind beschädigt: Die Liste ihrer Orte ergibt keinen Sinn.</translation>
    </message>
    <message>
      <source>The shapes are damaged: their sizes make no sense.</source>
      <translation>Die Formen sind beschädigt: Ihre Größen ergeben keinen Sinn.</translation>
    </message>
    <message>
      <source>The shapes are not in FreeCAD's binary form.</source>
      <translation>Die Formen haben nicht FreeCADs binäres Format.</translation>
    </message>
    <message>
      <source>The shapes cannot be read: {why:text}</source>
      <translation>Die Formen können nicht gelesen werden: {why:text}</translation>
    </message>
    <message>
      <source>The shell of {solid:entities} is open at {edge:entities}. Close the gap (Part: Check geometry, then sew or rebuild the feature there).</source>
      <translation>Die Hülle von {solid:entities} ist offen bei {edge:entities}. Die Lücke schließen (Part: Geometrie prüfen, dann das Formelement dort vernähen oder neu aufbauen).</translation>
    </message>
    <message>
      <source>The size of a new mesh is the diagonal of the part divided by this number</source>
      <translation>Die Größe eines neuen Netzes ist die Diagonale des Bauteils geteilt durch diese Zahl</translation>
    </message>
    <message>
      <source>The smallest angle of an element is {angle:number} degrees, at {place:entities}: results there are poor. Take details out that are much smaller than the edge length, or mesh finer there.</source>
      <translation>Der kleinste Winkel eines Elements ist {angle:number} Grad, bei {place:entities}: Ergebnisse dort sind ungenau. Einzelheiten weglassen, die viel kleiner als die Kantenlänge sind, oder dort feiner vernetzen.</translation>
    </message>
    <message>
      <source>The smallest mesh size is {smallest:length}; it must lie between zero and the mesh size of {size:length}.</source>
      <translation>Die kleinste Elementgröße ist {smallest:length}; sie muss zwischen null und der Elementgröße von {size:length} liegen.</translation>
    </message>
    <message>
      <source>The value at which the colours end</source>
      <translation>Der Wert, bei dem die Farben enden</translation>
    </message>
    <message>
      <source>The worst elements, click to see:</source>
      <translation>Die schlechtesten Elemente, zum Ansehen anklicken:</translation>
    </message>
    <message>
      <source>There are too few cases to tell what matters; add some.</source>
      <translation>Es sind zu wenige Fälle, um zu sagen, was wichtig ist; weitere hinzufügen.</translation>
    </message>
    <message>
      <source>There is not enough memory for this mesh. Choose a larger size.</source>
      <translation>Der Speicher reicht für dieses Netz nicht. Eine größere Größe wählen.</translation>
    </message>
    <message>
      <source>These are the elements of the last mesh: %s</source>
      <translation>Dies sind die Elemente des letzten Netzes: %s</translation>
    </message>
    <message>
      <source>These faces cross each other: {pairs:messages}. The shape intersects itself (Part: Check geometry), or is thinner there than any mesh of this size can follow; repair the feature, or ask for a smaller size on these faces.</source>
      <translation>Diese Flächen kreuzen einander: {pairs:messages}. Die Form durchdringt sich selbst (Part: Geometrie prüfen), oder sie ist dort dünner, als ein Netz dieser Größe folgen kann; das Formelement reparieren, oder auf diesen Flächen eine kleinere Größe wählen.</translation>
    </message>
    <message>
      <source>These faces touch or cross without sharing edges: {pairs:messages}. Each sheet has a mesh of its own, and no load passes between them. If that is not meant, join them (Part: Boolean Fragments).</source>
      <translation>Diese Flächen berühren oder schneiden sich, ohne Kanten zu teilen: {pairs:messages}. Jede Schale hat ein eigenes Netz, und zwischen ihnen wird keine Last übertragen. Wenn das nicht gewollt ist, sie verbinden (Part: Boolesche Fragmente).</translation>
    </message>
    <message>
      <source>These shells and beams lie inside a solid and share no nodes with it there: {places:messages}. No load passes between them. Divide the solid along them (Part: Boolean Fragments).</source>
      <translation>Diese Schalen und Balken liegen in einem Volumenkörper und haben dort keine Knoten mit ihm gemeinsam: {places:messages}. Zwischen ihnen wird keine Last übertragen. Den Volumenkörper an ihnen teilen (Part: Boolesche Fragmente).</translation>
    </message>
    <message>
      <source>Threads</source>
      <translation>Kerne</translation>
    </message>
    <message>
      <source>Throws the mesh away and meshes the whole part</source>
      <translation>Wirft das Netz weg und vernetzt das ganze Bauteil</translation>
    </message>
    <message>
      <source>Tick what is to vary. A click on a sketch, a feature or a face shows its dimensions.</source>
      <translation>Anhaken, was sich ändern soll. Ein Klick auf eine Skizze, ein Formelement oder eine Fläche zeigt deren Maße.</translation>
    </message>
    <message>
      <source>To install it: %s; in a clone any command of `./featuremesh` builds it.</source>
      <translation>So wird es installiert: %s; in einem Klon baut es jeder Befehl von `./featuremesh`.</translation>
    </message>
    <message>
      <source>Too narrow for elements of their own: {faces:entities}.</source>
      <translation>Zu schmal für eigene Elemente: {faces:entities}.</translation>
    </message>
    <message>
      <source>Too short for an element of their own: {edges:entities}.</source>
      <translation>Zu kurz für ein eigenes Element: {edges:entities}.</translation>
    </message>
    <message>
      <source>Tornado</source>
      <translation>Tornadodiagramm</translation>
    </message>
    <message>
      <source>Update automatically</source>
      <translation>Automatisch aktualisieren</translation>
    </message>
    <message>
      <source>Use 10-node tetrahedra</source>
      <translation>10-Knoten-Tetraeder nehmen</translation>
    </message>
    <message>
      <source>Welcome to FeatureMesh</source>
      <translation>Willkommen bei FeatureMesh</translation>
    </message>
    <message>
      <source>What changed</source>
      <translation>Was sich geändert hat</translation>
    </message>
    <message>
      <source>What each case is to tell:</source>
      <translation>Was jeder Fall sagen soll:</translation>
    </message>
    <message>
      <source>Width</source>
      <translation>Breite</translation>
    </message>
    <message>
      <source>Work</source>
      <translation>Arbeitsweise</translation>
    </message>
    <message>
      <source>Young's modulus of the material {material:text} is {young:number} MPa: check its unit</source>
      <translation>Der Elastizitätsmodul des Werkstoffs {material:text} ist {young:number} MPa: seine Einheit prüfen</translation>
    </message>
    <message>
      <source>a MED file keeps its mesh under the file's own name, which may have {most:count} characters at most; choose a shorter one than {name:text}</source>
      <translation>eine MED-Datei führt ihr Netz unter dem Namen der Datei, der höchstens {most:count} Zeichen haben darf; einen kürzeren als {name:text} wählen</translation>
    </message>
    <message>
      <source>a cut is x, y or z with =, &lt; or &gt; and a number, such as z=5, not {cut:text}</source>
      <translation>ein Schnitt ist x, y oder z mit =, &lt; oder &gt; und einer Zahl, etwa z=5, nicht {cut:text}</translation>
    </message>
    <message>
      <source>a kept triangle has a node (number {node:count}) that is not on the face</source>
      <translation>ein behaltenes Dreieck hat einen Knoten (Nummer {node:count}), der nicht auf der Fläche liegt</translation>
    </message>
    <message>
      <source>a kept triangle lies the wrong way round in it</source>
      <translation>ein behaltenes Dreieck liegt verkehrt herum in ihr</translation>
    </message>
    <message>
      <source>a length</source>
      <translation>einer Länge</translation>
    </message>
    <message>
      <source>a local size is for faces, edges or vertices; the size of a whole part is the mesh's own</source>
      <translation>eine lokale Größe ist für Flächen, Kanten oder Eckpunkte; die Größe für das ganze Bauteil ist die des Netzes</translation>
    </message>
    <message>
      <source>{solids:entities} can still {how:messages}: add a support. What shares no faces with the rest of the part needs one of its own</source>
      <translation>{solids:entities} kann sich noch {how:messages}: ein Lager hinzufügen. Was keine Flächen mit dem übrigen Bauteil teilt, braucht ein eigenes</translation>
    </message>
    <message>
      <source>a refinement zone is one of {kinds:text}, not {kind:text}</source>
      <translation>eine Verfeinerungszone ist eines von {kinds:text}, nicht {kind:text}</translation>
    </message>
    <message>
      <source>a size of {size:length} would make more than a million million elements; at most {most:count} million are made. Choose a larger size</source>
      <translation>eine Größe von {size:length} ergäbe mehr als eine Billion Elemente; höchstens {most:count} Millionen werden gemacht. Eine größere Größe wählen</translation>
    </message>
    <message>
      <source>a step of the meshing does not end; try another size, or check the shape for faces that cut or touch one another</source>
      <translation>ein Schritt des Vernetzens endet nicht; eine andere Größe versuchen, oder die Form auf Flächen prüfen, die einander schneiden oder berühren</translation>
    </message>
    <message>
      <source>a triangle came out the wrong way round</source>
      <translation>ein Dreieck ist verkehrt herum geraten</translation>
    </message>
    <message>
      <source>a triangle of the volume mesh belongs to more than two elements (near element {tet:count}); try a smaller size there</source>
      <translation>ein Dreieck des Volumennetzes gehört zu mehr als zwei Elementen (nahe Element {tet:count}); dort eine kleinere Größe versuchen</translation>
    </message>
    <message>
      <source>a zone of the kind {kind:text} has no {property:text}</source>
      <translation>eine Zone der Art {kind:text} hat keine Eigenschaft {property:text}</translation>
    </message>
    <message>
      <source>about %s elements</source>
      <translation>etwa %s Elemente</translation>
    </message>
    <message>
      <source>added</source>
      <translation>hinzugekommen</translation>
    </message>
    <message>
      <source>adopting a mesh of %s</source>
      <translation>Übernehmen eines Netzes von %s</translation>
    </message>
    <message>
      <source>all</source>
      <translation>alle</translation>
    </message>
    <message>
      <source>all nodes to fill between lie in one plane, at {place:entities}; mesh the part finer</source>
      <translation>alle Knoten, zwischen denen zu füllen ist, liegen in einer Ebene, bei {place:entities}; das Bauteil feiner vernetzen</translation>
    </message>
    <message>
      <source>and others</source>
      <translation>und andere</translation>
    </message>
    <message>
      <source>and {more:count} more</source>
      <translation>und {more:count} weitere</translation>
    </message>
    <message>
      <source>appeared</source>
      <translation>neu</translation>
    </message>
    <message>
      <source>area</source>
      <translation>Fläche</translation>
    </message>
    <message>
      <source>area %s mm^2</source>
      <translation>Flächeninhalt %s mm^2</translation>
    </message>
    <message>
      <source>around {solid:entities} {side:messages}</source>
      <translation>um {solid:entities} {side:messages}</translation>
    </message>
    <message>
      <source>array of wrong length: {arrays:messages}</source>
      <translation>Feld falscher Länge: {arrays:messages}</translation>
    </message>
    <message>
      <source>aspect ratio</source>
      <translation>Seitenverhältnis</translation>
    </message>
    <message>
      <source>assembling the stiffness matrix</source>
      <translation>Steifigkeitsmatrix aufstellen</translation>
    </message>
    <message>
      <source>at a side of {triangle:messages}</source>
      <translation>an einer Seite von {triangle:messages}</translation>
    </message>
    <message>
      <source>automatic</source>
      <translation>automatisch</translation>
    </message>
    <message>
      <source>bad</source>
      <translation>schlecht</translation>
    </message>
    <message>
      <source>became boundary</source>
      <translation>jetzt am Rand</translation>
    </message>
    <message>
      <source>became inner</source>
      <translation>jetzt im Inneren</translation>
    </message>
    <message>
      <source>border of two solids without a triangle: {elements:messages}</source>
      <translation>Grenze zweier Volumenkörper ohne Dreieck: {elements:messages}</translation>
    </message>
    <message>
      <source>boundary of the elements without a triangle: {elements:messages}</source>
      <translation>Rand der Elemente ohne Dreieck: {elements:messages}</translation>
    </message>
    <message>
      <source>by how much</source>
      <translation>um wie viel</translation>
    </message>
    <message>
      <source>cancelled</source>
      <translation>abgebrochen</translation>
    </message>
    <message>
      <source>cannot be made</source>
      <translation>nicht machbar</translation>
    </message>
    <message>
      <source>cannot export to {format:text}, only to {formats:text}</source>
      <translation>Ausgabe als {format:text} ist nicht möglich, nur als {formats:text}</translation>
    </message>
    <message>
      <source>case</source>
      <translation>Fall</translation>
    </message>
    <message>
      <source>change since the last result</source>
      <translation>Änderung seit zuletzt</translation>
    </message>
    <message>
      <source>checking the mesh</source>
      <translation>Netz prüfen</translation>
    </message>
    <message>
      <source>choosing what is kept</source>
      <translation>Auswählen, was bleibt</translation>
    </message>
    <message>
      <source>comparing two states of %s</source>
      <translation>Vergleichen zweier Stände von %s</translation>
    </message>
    <message>
      <source>comparing with the old part</source>
      <translation>Vergleichen mit dem alten Bauteil</translation>
    </message>
    <message>
      <source>coordinate is not a number, at node {nodes:messages}</source>
      <translation>eine Koordinate ist keine Zahl, bei Knoten {nodes:messages}</translation>
    </message>
    <message>
      <source>crashed (%s)</source>
      <translation>ist abgestürzt (%s)</translation>
    </message>
    <message>
      <source>curved (central composite)</source>
      <translation>gekrümmt (zentral zusammengesetzt)</translation>
    </message>
    <message>
      <source>curved, no corners (Box-Behnken)</source>
      <translation>gekrümmt, ohne Ecken (Box-Behnken)</translation>
    </message>
    <message>
      <source>cut differently</source>
      <translation>anders angeschnitten</translation>
    </message>
    <message>
      <source>cut through the elements</source>
      <translation>Elemente durchschneiden</translation>
    </message>
    <message>
      <source>depends on</source>
      <translation>hängt ab von</translation>
    </message>
    <message>
      <source>dimension, as it is</source>
      <translation>Maß und sein Wert</translation>
    </message>
    <message>
      <source>displacement</source>
      <translation>Verschiebung</translation>
    </message>
    <message>
      <source>done</source>
      <translation>fertig</translation>
    </message>
    <message>
      <source>edge length over wanted length</source>
      <translation>Kantenlänge zu gewünschter Länge</translation>
    </message>
    <message>
      <source>element number given twice: {numbers:messages}</source>
      <translation>Elementnummer zweimal vergeben: {numbers:messages}</translation>
    </message>
    <message>
      <source>element number out of range: {range:messages}</source>
      <translation>Elementnummern außerhalb des Bereichs: {range:messages}</translation>
    </message>
    <message>
      <source>element without positive volume: {elements:messages}</source>
      <translation>Element ohne positives Volumen: {elements:messages}</translation>
    </message>
    <message>
      <source>element {element:count} with {node:messages}</source>
      <translation>Element {element:count} mit {node:messages}</translation>
    </message>
    <message>
      <source>elements may not span thin walls any more</source>
      <translation>Elemente dürfen dünne Wände nicht mehr überspannen</translation>
    </message>
    <message>
      <source>ended</source>
      <translation>hat sich beendet</translation>
    </message>
    <message>
      <source>estimating the mesh of %s</source>
      <translation>Schätzen des Netzes von %s</translation>
    </message>
    <message>
      <source>evenly (Halton)</source>
      <translation>gleichmäßig (Halton)</translation>
    </message>
    <message>
      <source>evenly (Sobol)</source>
      <translation>gleichmäßig (Sobol)</translation>
    </message>
    <message>
      <source>evenly, at random (Latin hypercube)</source>
      <translation>gleichmäßig, zufällig (Latin Hypercube)</translation>
    </message>
    <message>
      <source>every combination (grid of 3)</source>
      <translation>jede Kombination (Gitter mit 3)</translation>
    </message>
    <message>
      <source>face, edge or solid out of range: {entries:messages}</source>
      <translation>es gibt die Fläche, die Kante oder den Volumenkörper nicht: {entries:messages}</translation>
    </message>
    <message>
      <source>failed</source>
      <translation>fehlgeschlagen</translation>
    </message>
    <message>
      <source>failed: %s</source>
      <translation>fehlgeschlagen: %s</translation>
    </message>
    <message>
      <source>feature</source>
      <translation>Formelement</translation>
    </message>
    <message>
      <source>filling the solid</source>
      <translation>Volumenkörper füllen</translation>
    </message>
    <message>
      <source>first buckling factor</source>
      <translation>erster Knickfaktor</translation>
    </message>
    <message>
      <source>first frequency</source>
      <translation>erste Eigenfrequenz</translation>
    </message>
    <message>
      <source>force on all supports</source>
      <translation>Kraft auf alle Lager</translation>
    </message>
    <message>
      <source>from : to</source>
      <translation>von : bis</translation>
    </message>
    <message>
      <source>full mesh: {why:messages}</source>
      <translation>vollständig neu vernetzt: {why:messages}</translation>
    </message>
    <message>
      <source>gap in a face: {sides:messages}</source>
      <translation>Lücke in einer Fläche: {sides:messages}</translation>
    </message>
    <message>
      <source>gap in an edge: {nodes:messages}</source>
      <translation>Lücke in einer Kante: {nodes:messages}</translation>
    </message>
    <message>
      <source>good</source>
      <translation>gut</translation>
    </message>
    <message>
      <source>handing over to FreeCAD</source>
      <translation>an FreeCAD übergeben</translation>
    </message>
    <message>
      <source>improving the elements</source>
      <translation>Elemente verbessern</translation>
    </message>
    <message>
      <source>intersecting the features</source>
      <translation>Formelemente verschneiden</translation>
    </message>
    <message>
      <source>its boundary is not closed at {edge:entities}</source>
      <translation>ihr Rand ist bei {edge:entities} nicht geschlossen</translation>
    </message>
    <message>
      <source>its own volume is the same, but other features now meet {faces:count} of its faces differently</source>
      <translation>sein Volumen ist gleich, aber andere Formelemente treffen {faces:count} seiner Flächen jetzt anders</translation>
    </message>
    <message>
      <source>its triangles do not cover it</source>
      <translation>ihre Dreiecke bedecken sie nicht</translation>
    </message>
    <message>
      <source>its triangles do not hang together</source>
      <translation>ihre Dreiecke hängen nicht zusammen</translation>
    </message>
    <message>
      <source>its volume does not add up with the part</source>
      <translation>sein Volumen geht mit dem Bauteil nicht auf</translation>
    </message>
    <message>
      <source>keep the other side</source>
      <translation>die andere Seite behalten</translation>
    </message>
    <message>
      <source>keeping all that fits failed: {why:messages}</source>
      <translation>alles Passende zu behalten gelang nicht: {why:messages}</translation>
    </message>
    <message>
      <source>keeping everything further than {margin:number} edge lengths from the change failed: {why:messages}</source>
      <translation>alles zu behalten, was weiter als {margin:number} Kantenlängen von der Änderung ist, gelang nicht: {why:messages}</translation>
    </message>
    <message>
      <source>keeping still less would take longer than meshing the part anew</source>
      <translation>noch weniger zu behalten würde länger dauern, als das Bauteil neu zu vernetzen</translation>
    </message>
    <message>
      <source>kept</source>
      <translation>geblieben</translation>
    </message>
    <message>
      <source>kept by the last update: %d %% of the nodes, %d %% of the elements</source>
      <translation>von der letzten Aktualisierung behalten: %d %% der Knoten, %d %% der Elemente</translation>
    </message>
    <message>
      <source>largest displacement</source>
      <translation>größte Verschiebung</translation>
    </message>
    <message>
      <source>largest principal stress</source>
      <translation>größte Hauptspannung</translation>
    </message>
    <message>
      <source>largest temperature</source>
      <translation>größte Temperatur</translation>
    </message>
    <message>
      <source>largest von Mises stress</source>
      <translation>größte Vergleichsspannung</translation>
    </message>
    <message>
      <source>largest: {value:text} on {place:text}, node {node:count} at {point:point}; displacements drawn {times:number} times</source>
      <translation>am größten: {value:text} auf {place:text}, Knoten {node:count} bei {point:point}; Verschiebungen {times:number}-fach überhöht gezeichnet</translation>
    </message>
    <message>
      <source>let the Addon Manager install %s, or type `%s`, or unpack FeatureMesh's portable zip into %s</source>
      <translation>den Addon-Manager %s installieren lassen, oder `%s` tippen, oder das portable ZIP-Archiv von FeatureMesh in %s entpacken</translation>
    </message>
    <message>
      <source>live</source>
      <translation>mitlaufend</translation>
    </message>
    <message>
      <source>making the mesh that all cases start from</source>
      <translation>das Netz entsteht, von dem alle Fälle ausgehen</translation>
    </message>
    <message>
      <source>mass</source>
      <translation>Masse</translation>
    </message>
    <message>
      <source>meshed from scratch: {why:messages}</source>
      <translation>vollständig neu vernetzt: {why:messages}</translation>
    </message>
    <message>
      <source>meshing %s</source>
      <translation>Vernetzen von %s</translation>
    </message>
    <message>
      <source>meshing the faces</source>
      <translation>Flächen vernetzen</translation>
    </message>
    <message>
      <source>message</source>
      <translation>Meldung</translation>
    </message>
    <message>
      <source>more than a million million</source>
      <translation>mehr als eine Billion</translation>
    </message>
    <message>
      <source>move along {directions:messages}</source>
      <translation>entlang {directions:messages} verschieben</translation>
    </message>
    <message>
      <source>moved</source>
      <translation>verschoben</translation>
    </message>
    <message>
      <source>moved by {shift:point}</source>
      <translation>um {shift:point} verschoben</translation>
    </message>
    <message>
      <source>new faces</source>
      <translation>neue Flächen</translation>
    </message>
    <message>
      <source>no element of the old mesh is clear of what changed</source>
      <translation>kein Element des alten Netzes liegt abseits dessen, was sich geändert hat</translation>
    </message>
    <message>
      <source>no longer suppressed</source>
      <translation>nicht mehr unterdrückt</translation>
    </message>
    <message>
      <source>node number given twice: {numbers:messages}</source>
      <translation>Knotennummer zweimal vergeben: {numbers:messages}</translation>
    </message>
    <message>
      <source>node number out of range: {range:messages}</source>
      <translation>Knotennummern außerhalb des Bereichs: {range:messages}</translation>
    </message>
    <message>
      <source>node out of range: {entries:messages}</source>
      <translation>es gibt den Knoten nicht: {entries:messages}</translation>
    </message>
    <message>
      <source>node {node:count} at {place:point}</source>
      <translation>Knoten {node:count} bei {place:point}</translation>
    </message>
    <message>
      <source>none</source>
      <translation>keine</translation>
    </message>
    <message>
      <source>not covered by the mesh: {faces:entities}</source>
      <translation>vom Netz nicht bedeckt: {faces:entities}</translation>
    </message>
    <message>
      <source>not followed by the mesh: {edges:entities}</source>
      <translation>das Netz folgt nicht: {edges:entities}</translation>
    </message>
    <message>
      <source>not meshed yet</source>
      <translation>noch nicht vernetzt</translation>
    </message>
    <message>
      <source>not run yet</source>
      <translation>noch nicht gelaufen</translation>
    </message>
    <message>
      <source>note: </source>
      <translation>Hinweis: </translation>
    </message>
    <message>
      <source>nothing could be kept</source>
      <translation>nichts konnte behalten werden</translation>
    </message>
    <message>
      <source>nothing is asked for: tick what each case is to tell</source>
      <translation>nach nichts ist gefragt: anhaken, was jeder Fall sagen soll</translation>
    </message>
    <message>
      <source>nothing is varied: tick a dimension and give it a range</source>
      <translation>nichts ändert sich: ein Maß anhaken und ihm einen Bereich geben</translation>
    </message>
    <message>
      <source>nothing yet: select faces, edges or vertices</source>
      <translation>noch nichts: Flächen, Kanten oder Eckpunkte auswählen</translation>
    </message>
    <message>
      <source>off</source>
      <translation>aus</translation>
    </message>
    <message>
      <source>old faces</source>
      <translation>alte Flächen</translation>
    </message>
    <message>
      <source>one at a time</source>
      <translation>eines nach dem anderen</translation>
    </message>
    <message>
      <source>one mid-side node for two sides: {nodes:messages}</source>
      <translation>ein Mittelknoten für zwei Seiten: {nodes:messages}</translation>
    </message>
    <message>
      <source>open surface {sides:messages}</source>
      <translation>offene Oberfläche {sides:messages}</translation>
    </message>
    <message>
      <source>order is neither 1 nor 2: {order:messages}</source>
      <translation>die Ordnung ist weder 1 noch 2: {order:messages}</translation>
    </message>
    <message>
      <source>other details are ignored</source>
      <translation>andere Einzelheiten werden übergangen</translation>
    </message>
    <message>
      <source>other faces</source>
      <translation>andere Flächen</translation>
    </message>
    <message>
      <source>out of date</source>
      <translation>veraltet</translation>
    </message>
    <message>
      <source>out of date: %s</source>
      <translation>veraltet: %s</translation>
    </message>
    <message>
      <source>out of date: solving</source>
      <translation>veraltet: wird gelöst</translation>
    </message>
    <message>
      <source>out of date: solving was cancelled</source>
      <translation>veraltet: das Lösen wurde abgebrochen</translation>
    </message>
    <message>
      <source>out of date: the last update was cancelled</source>
      <translation>veraltet: die letzte Aktualisierung wurde abgebrochen</translation>
    </message>
    <message>
      <source>out of date: the part or a setting was changed and not recomputed</source>
      <translation>veraltet: das Bauteil oder eine Einstellung wurde geändert und nicht neu berechnet</translation>
    </message>
    <message>
      <source>out of date: the part or a setting changed, update by hand or switch Automatic on</source>
      <translation>veraltet: das Bauteil oder eine Einstellung hat sich geändert; von Hand aktualisieren oder Automatic einschalten</translation>
    </message>
    <message>
      <source>out of date: the part, its mesh or the analysis changed</source>
      <translation>veraltet: Bauteil, Netz oder Analyse wurden geändert</translation>
    </message>
    <message>
      <source>preparing the solver</source>
      <translation>Löser vorbereiten</translation>
    </message>
    <message>
      <source>radius ratio</source>
      <translation>Radienverhältnis</translation>
    </message>
    <message>
      <source>reading the features of %s</source>
      <translation>Lesen der Formelemente von %s</translation>
    </message>
    <message>
      <source>reading the part</source>
      <translation>Bauteil lesen</translation>
    </message>
    <message>
      <source>reading the saved mesh of %s</source>
      <translation>Lesen des gespeicherten Netzes von %s</translation>
    </message>
    <message>
      <source>remark</source>
      <translation>Bemerkung</translation>
    </message>
    <message>
      <source>removed</source>
      <translation>entfernt</translation>
    </message>
    <message>
      <source>reshaped</source>
      <translation>umgeformt</translation>
    </message>
    <message>
      <source>role</source>
      <translation>Rolle</translation>
    </message>
    <message>
      <source>running</source>
      <translation>läuft</translation>
    </message>
    <message>
      <source>same</source>
      <translation>gleich</translation>
    </message>
    <message>
      <source>scaled Jacobian</source>
      <translation>skalierte Jacobi-Determinante</translation>
    </message>
    <message>
      <source>segment that is no triangle's side: {segments:messages}</source>
      <translation>Segment, das keine Seite eines Dreiecks ist: {segments:messages}</translation>
    </message>
    <message>
      <source>segment without length: {segments:messages}</source>
      <translation>Segment ohne Länge: {segments:messages}</translation>
    </message>
    <message>
      <source>segment {segment:count} on {edge:entities} with {node:messages}</source>
      <translation>Segment {segment:count} auf {edge:entities} mit {node:messages}</translation>
    </message>
    <message>
      <source>select faces, edges or vertices of {part:text}</source>
      <translation>Flächen, Kanten oder Eckpunkte von {part:text} auswählen</translation>
    </message>
    <message>
      <source>settings changed, not meshed yet</source>
      <translation>Einstellungen geändert, noch nicht vernetzt</translation>
    </message>
    <message>
      <source>skewness</source>
      <translation>Schiefe</translation>
    </message>
    <message>
      <source>smallest angle %.1f deg, mean radius ratio %.3f</source>
      <translation>kleinster Winkel %.1f°, mittleres Radienverhältnis %.3f</translation>
    </message>
    <message>
      <source>smallest dihedral angle</source>
      <translation>kleinster Flächenwinkel</translation>
    </message>
    <message>
      <source>solids are filled with 4-node tetrahedra; the mesh given has mid-side nodes</source>
      <translation>Volumenkörper werden mit 4-Knoten-Tetraedern gefüllt; das gegebene Netz hat Mittelknoten</translation>
    </message>
    <message>
      <source>solids, faces or edges are meshed that were not before</source>
      <translation>Volumenkörper, Flächen oder Kanten werden vernetzt, die es vorher nicht wurden</translation>
    </message>
    <message>
      <source>solved with CalculiX: {why:messages}</source>
      <translation>mit CalculiX gelöst: {why:messages}</translation>
    </message>
    <message>
      <source>solving</source>
      <translation>lösen</translation>
    </message>
    <message>
      <source>solving the statics of %s</source>
      <translation>Lösen der Statik von %s</translation>
    </message>
    <message>
      <source>starting</source>
      <translation>Starten</translation>
    </message>
    <message>
      <source>state</source>
      <translation>Zustand</translation>
    </message>
    <message>
      <source>stopped</source>
      <translation>angehalten</translation>
    </message>
    <message>
      <source>strain energy</source>
      <translation>Formänderungsenergie</translation>
    </message>
    <message>
      <source>studies run on Linux only</source>
      <translation>Studien laufen nur unter Linux</translation>
    </message>
    <message>
      <source>suppressed</source>
      <translation>unterdrückt</translation>
    </message>
    <message>
      <source>the analysis has no material: add one</source>
      <translation>die Analyse hat keinen Werkstoff: einen hinzufügen</translation>
    </message>
    <message>
      <source>the dimension is one of {dimensions:text}, not {dimension:text}</source>
      <translation>die Dimension ist eine von {dimensions:text}, nicht {dimension:text}</translation>
    </message>
    <message>
      <source>the document {document:text} has no mesh{of_part:messages}; make one with `featuremesh mesh`</source>
      <translation>das Dokument {document:text} hat kein Netz{of_part:messages}; eines anlegen (`featuremesh mesh`)</translation>
    </message>
    <message>
      <source>the document {document:text} has no part to mesh</source>
      <translation>das Dokument {document:text} hat kein Bauteil, das vernetzt werden kann</translation>
    </message>
    <message>
      <source>the document has no object {name:text}{near:messages}</source>
      <translation>das Dokument hat kein Objekt {name:text}{near:messages}</translation>
    </message>
    <message>
      <source>the document has several meshes, select the one to adopt: {meshes:text}</source>
      <translation>das Dokument hat mehrere Netze, das zu übernehmende auswählen: {meshes:text}</translation>
    </message>
    <message>
      <source>the document holds no mesh state</source>
      <translation>das Dokument enthält keinen Netzzustand</translation>
    </message>
    <message>
      <source>the element order changed</source>
      <translation>die Elementordnung wurde geändert</translation>
    </message>
    <message>
      <source>the file is not a FeatureMesh state</source>
      <translation>die Datei ist kein Zustand von FeatureMesh</translation>
    </message>
    <message>
      <source>the size changed</source>
      <translation>die Größe hat sich geändert</translation>
    </message>
    <message>
      <source>the inside</source>
      <translation>im Inneren</translation>
    </message>
    <message>
      <source>the kept elements overlap at node {node:count}; mesh the part from scratch</source>
      <translation>die behaltenen Elemente überlappen sich bei Knoten {node:count}; das Bauteil vollständig neu vernetzen</translation>
    </message>
    <message>
      <source>the live solver cannot tell which solid has which of the {materials:count} materials</source>
      <translation>der mitlaufende Löser kann nicht erkennen, welcher Volumenkörper welchen der {materials:count} Werkstoffe hat</translation>
    </message>
    <message>
      <source>the live solver does not know the amplitude of {member:text}</source>
      <translation>der mitlaufende Löser kennt die Amplitude von {member:text} nicht</translation>
    </message>
    <message>
      <source>the live solver does not know the formula of {member:text}</source>
      <translation>der mitlaufende Löser kennt die Formel von {member:text} nicht</translation>
    </message>
    <message>
      <source>only CalculiX knows {member:text} ({kind:text}), not the live solver</source>
      <translation>nur CalculiX kennt {member:text} ({kind:text}), der mitlaufende Löser nicht</translation>
    </message>
    <message>
      <source>the live solver knows forces on faces, on edges or on vertices, not {force:text}</source>
      <translation>der mitlaufende Löser kennt Kräfte auf Flächen, auf Kanten oder auf Eckpunkten, nicht {force:text}</translation>
    </message>
    <message>
      <source>the live solver knows linear statics only, and {solver:text} asks for {setting:text} = {value:text}</source>
      <translation>der mitlaufende Löser kennt nur lineare Statik, und {solver:text} verlangt {setting:text} = {value:text}</translation>
    </message>
    <message>
      <source>the live solver knows pressure on faces only, not {pressure:text}</source>
      <translation>der mitlaufende Löser kennt Druck nur auf Flächen, nicht {pressure:text}</translation>
    </message>
    <message>
      <source>the live solver knows solids only, not the fluid {material:text}</source>
      <translation>der mitlaufende Löser kennt nur feste Körper, nicht das Fluid {material:text}</translation>
    </message>
    <message>
      <source>the live solver knows solids only; {mesh:text} is of shells or beams, which CalculiX solves</source>
      <translation>der mitlaufende Löser kennt nur Volumenkörper; {mesh:text} ist aus Schalen oder Balken, die CalculiX löst</translation>
    </message>
    <message>
      <source>the live solver needs PETSc: install Debian's package libpetsc-real-dev, then any command of ./featuremesh in a clone builds the solver with it</source>
      <translation>der mitlaufende Löser braucht PETSc: Debians Paket libpetsc-real-dev installieren, dann baut jeder Befehl von ./featuremesh in einem Klon den Löser damit</translation>
    </message>
    <message>
      <source>the material {material:text} is nearly incompressible (Poisson's ratio {poisson:number}), for which these elements are too stiff</source>
      <translation>der Werkstoff {material:text} ist fast inkompressibel (Querkontraktionszahl {poisson:number}), wofür diese Elemente zu steif sind</translation>
    </message>
    <message>
      <source>the mesh falls into more pieces than the live solver looks at</source>
      <translation>das Netz zerfällt in mehr Stücke, als der mitlaufende Löser betrachtet</translation>
    </message>
    <message>
      <source>the mesh of a copy is one of {kinds:text}, not {kind:text}</source>
      <translation>das Netz einer Kopie ist eines von {kinds:text}, nicht {kind:text}</translation>
    </message>
    <message>
      <source>the mesh of edges has segments only, which have no shape to judge and nothing to colour</source>
      <translation>das Netz aus Kanten hat nur Balkenelemente, die keine Form haben, die man beurteilen oder einfärben könnte</translation>
    </message>
    <message>
      <source>the new mesh's state cannot be stored ({why:messages}), the old mesh stays; is the disk full?</source>
      <translation>der Zustand des neuen Netzes kann nicht gespeichert werden ({why:messages}), das alte Netz bleibt; ist die Platte voll?</translation>
    </message>
    <message>
      <source>the number of elements along the part has to be greater than 0, not {elements:text}</source>
      <translation>die Zahl der Elemente entlang des Bauteils muss größer als 0 sein, nicht {elements:text}</translation>
    </message>
    <message>
      <source>the object is gone: it was deleted, or its document was closed</source>
      <translation>das Objekt gibt es nicht mehr: es wurde gelöscht, oder sein Dokument wurde geschlossen</translation>
    </message>
    <message>
      <source>the order is 1 (4-node) or 2 (10-node), not {order:text}</source>
      <translation>die Ordnung ist 1 (4 Knoten) oder 2 (10 Knoten), nicht {order:text}</translation>
    </message>
    <message>
      <source>the outside</source>
      <translation>das Äußere</translation>
    </message>
    <message>
      <source>the part can still {how:messages}: add a support</source>
      <translation>das Bauteil kann sich noch {how:messages}: ein Lager hinzufügen</translation>
    </message>
    <message>
      <source>the picture could not be drawn: {why:messages}</source>
      <translation>das Bild konnte nicht gezeichnet werden: {why:messages}</translation>
    </message>
    <message>
      <source>the property QualityTarget of {mesh:text} has to lie between 0 and {highest:number} degrees, not {target:number}</source>
      <translation>die Eigenschaft QualityTarget von {mesh:text} muss zwischen 0 und {highest:number} Grad liegen, nicht {target:number}</translation>
    </message>
    <message>
      <source>the range of {target:text} has to be two numbers, such as 3 : 5</source>
      <translation>der Bereich von {target:text} muss aus zwei Zahlen bestehen, etwa 3 : 5</translation>
    </message>
    <message>
      <source>the range of {target:text} has to rise</source>
      <translation>der Bereich von {target:text} muss ansteigen</translation>
    </message>
    <message>
      <source>the refinement {refinement:text} refers to {place:text}, which is not on {part:text}; refer to faces of that one</source>
      <translation>die Verfeinerung {refinement:text} bezieht sich auf {place:text}, das nicht zu {part:text} gehört; sie auf dessen Flächen beziehen</translation>
    </message>
    <message>
      <source>the refinement {refinement:text} with {size:length} at {place:text} would make {many:messages} elements; {limit:messages}. Choose a larger size there</source>
      <translation>die Verfeinerung {refinement:text} mit {size:length} an {place:text} ergäbe {many:messages} Elemente; {limit:messages}. Dort eine größere Größe wählen</translation>
    </message>
    <message>
      <source>the resolution of the difference must be a positive length, not {resolution:length}</source>
      <translation>die Auflösung des Vergleichs muss eine positive Länge sein, nicht {resolution:length}</translation>
    </message>
    <message>
      <source>the same segment twice: {segments:messages}</source>
      <translation>dasselbe Segment zweimal: {segments:messages}</translation>
    </message>
    <message>
      <source>the same triangle twice: {triangles:messages}</source>
      <translation>dasselbe Dreieck zweimal: {triangles:messages}</translation>
    </message>
    <message>
      <source>the saved mesh state belongs to {other:text}, not to {part:text}</source>
      <translation>der gespeicherte Netzzustand gehört zu {other:text}, nicht zu {part:text}</translation>
    </message>
    <message>
      <source>the saved mesh state is from a newer FeatureMesh ({program:text}, schema {schema:count}; this one reads up to {newest:count})</source>
      <translation>der gespeicherte Netzzustand ist von einem neueren FeatureMesh ({program:text}, Schema {schema:count}; dieses liest bis {newest:count})</translation>
    </message>
    <message>
      <source>the shape touches itself: nodes of {faces:entities} lie in the same place, such as {place:point}; repair it there (Part: Check geometry)</source>
      <translation>die Form berührt sich selbst: Knoten von {faces:entities} liegen an derselben Stelle, etwa bei {place:point}; dort reparieren (Part: Geometrie prüfen)</translation>
    </message>
    <message>
      <source>the size {size:length} is larger than the part ({diagonal:length} across); try {better:length}</source>
      <translation>die Größe {size:length} ist größer als das Bauteil ({diagonal:length} Diagonale); Vorschlag: {better:length}</translation>
    </message>
    <message>
      <source>the solids of the final shape overlap by {overlap:volume}; fuse them or mesh them one by one</source>
      <translation>die Volumenkörper der endgültigen Form überlappen sich um {overlap:volume}; vereinigen oder einzeln vernetzen</translation>
    </message>
    <message>
      <source>the stresses of shells and beams are those in the middle of the thickness, where bending makes none; switch BeamShellResultOutput3D of {solver:text} on for those on the outside</source>
      <translation>die Spannungen von Schalen und Balken sind die in der Mitte der Dicke, in der Biegung keine bewirkt; für die außen BeamShellResultOutput3D von {solver:text} einschalten</translation>
    </message>
    <message>
      <source>the study's process ended; see %s</source>
      <translation>der Prozess der Studie ist beendet; siehe %s</translation>
    </message>
    <message>
      <source>the surface mesh does not close at {place:entities}; check the shape there, or try another size</source>
      <translation>das Oberflächennetz schließt sich nicht bei {place:entities}; dort die Form prüfen, oder eine andere Größe versuchen</translation>
    </message>
    <message>
      <source>the two states of the part cannot be compared ({why:text}); check the geometry of the new shape, or mesh it from scratch</source>
      <translation>die beiden Stände des Bauteils können nicht verglichen werden ({why:text}); die Geometrie der neuen Form prüfen, oder sie vollständig neu vernetzen</translation>
    </message>
    <message>
      <source>the volume mesh cannot be made to meet the triangles of {faces:entities}; mesh finer there, or check the shape for faces that cut or touch one another</source>
      <translation>das Volumennetz lässt sich nicht an die Dreiecke von {faces:entities} anschließen; dort feiner vernetzen, oder die Form auf Flächen prüfen, die einander schneiden oder berühren</translation>
    </message>
    <message>
      <source>there is no measure {measure:text}, only {measures:text}</source>
      <translation>es gibt kein Maß {measure:text}, nur {measures:text}</translation>
    </message>
    <message>
      <source>too long</source>
      <translation>zu lang</translation>
    </message>
    <message>
      <source>too short</source>
      <translation>zu kurz</translation>
    </message>
    <message>
      <source>treated as changed: {why:messages}</source>
      <translation>als geändert behandelt: {why:messages}</translation>
    </message>
    <message>
      <source>triangle in a mesh of edges: {triangles:messages}</source>
      <translation>Dreieck in einem Netz aus Kanten: {triangles:messages}</translation>
    </message>
    <message>
      <source>triangle shared by more than two elements: {elements:messages}</source>
      <translation>Dreieck an mehr als zwei Elementen: {elements:messages}</translation>
    </message>
    <message>
      <source>triangle without an element: {triangles:messages}</source>
      <translation>Dreieck ohne Element: {triangles:messages}</translation>
    </message>
    <message>
      <source>triangle without area: {triangles:messages}</source>
      <translation>Dreieck ohne Fläche: {triangles:messages}</translation>
    </message>
    <message>
      <source>triangle {triangle:count} on {face:entities} with {node:messages}</source>
      <translation>Dreieck {triangle:count} auf {face:entities} mit {node:messages}</translation>
    </message>
    <message>
      <source>triangles of a face overlap: {sides:messages}</source>
      <translation>Dreiecke einer Fläche überlappen sich: {sides:messages}</translation>
    </message>
    <message>
      <source>triangles of {faces:entities} near {place:point} cut one another; the shape may touch or cut itself there: repair it, or mesh finer there</source>
      <translation>Dreiecke von {faces:entities} nahe {place:point} schneiden einander; die Form berührt oder schneidet sich dort vielleicht selbst: sie dort reparieren oder feiner vernetzen</translation>
    </message>
    <message>
      <source>trimmed differently</source>
      <translation>anders beschnitten</translation>
    </message>
    <message>
      <source>turn about {axes:messages}</source>
      <translation>um {axes:messages} drehen</translation>
    </message>
    <message>
      <source>turned by {angle:number} deg about {axis:text}</source>
      <translation>gedreht um {angle:number} Grad um {axis:text}</translation>
    </message>
    <message>
      <source>turned by {angle:number} deg about {axis:text} and moved by {shift:point}</source>
      <translation>gedreht um {angle:number} Grad um {axis:text} und verschoben um {shift:point}</translation>
    </message>
    <message>
      <source>two elements overlap at a triangle: {elements:messages}</source>
      <translation>zwei Elemente überlappen sich an einem Dreieck: {elements:messages}</translation>
    </message>
    <message>
      <source>two kept triangles overlap</source>
      <translation>zwei behaltene Dreiecke überlappen sich</translation>
    </message>
    <message>
      <source>two mid-side nodes on one side: {nodes:messages}</source>
      <translation>zwei Mittelknoten auf einer Seite: {nodes:messages}</translation>
    </message>
    <message>
      <source>two nodes lie in the same place, at {place:point}; heal the shape there or mesh it finer</source>
      <translation>zwei Knoten liegen am selben Ort, bei {place:point}; dort die Form heilen, oder feiner vernetzen</translation>
    </message>
    <message>
      <source>type</source>
      <translation>Typ</translation>
    </message>
    <message>
      <source>up to date</source>
      <translation>aktuell</translation>
    </message>
    <message>
      <source>updating the mesh of %s</source>
      <translation>Aktualisieren des Netzes von %s</translation>
    </message>
    <message>
      <source>vanished</source>
      <translation>verschwunden</translation>
    </message>
    <message>
      <source>volume</source>
      <translation>Volumen</translation>
    </message>
    <message>
      <source>volume is wrong: {solids:messages}</source>
      <translation>das Volumen ist falsch: {solids:messages}</translation>
    </message>
    <message>
      <source>volume {before:volume} -&gt; {after:volume}</source>
      <translation>Volumen {before:volume} → {after:volume}</translation>
    </message>
    <message>
      <source>volumes</source>
      <translation>Volumen</translation>
    </message>
    <message>
      <source>von Mises stress</source>
      <translation>Vergleichsspannung</translation>
    </message>
    <message>
      <source>waiting</source>
      <translation>wartet</translation>
    </message>
    <message>
      <source>waiting for other work</source>
      <translation>Warten auf andere Arbeit</translation>
    </message>
    <message>
      <source>was ended from outside (%s)</source>
      <translation>wurde von außen beendet (%s)</translation>
    </message>
    <message>
      <source>was in error before ({error:text})</source>
      <translation>war vorher fehlerhaft ({error:text})</translation>
    </message>
    <message>
      <source>what changed could not be found: {why:messages}</source>
      <translation>was sich geändert hat, konnte nicht gefunden werden: {why:messages}</translation>
    </message>
    <message>
      <source>what happened</source>
      <translation>was geschah</translation>
    </message>
    <message>
      <source>working on %s</source>
      <translation>Arbeiten an %s</translation>
    </message>
    <message>
      <source>working out the stresses</source>
      <translation>Spannungen berechnen</translation>
    </message>
    <message>
      <source>wrong count of corner nodes: {count:messages}</source>
      <translation>falsche Anzahl an Eckknoten: {count:messages}</translation>
    </message>
    <message>
      <source>wrong solid at a triangle: {triangles:messages}</source>
      <translation>falscher Volumenkörper an einem Dreieck: {triangles:messages}</translation>
    </message>
    <message>
      <source>z88 has no 3-node triangles; mesh with 6-node triangles, or export it as inp, vtu, vtk, msh, unv or med</source>
      <translation>z88 kennt keine 3-Knoten-Dreiecke; mit 6-Knoten-Dreiecken vernetzen, oder es als inp, vtu, vtk, msh, unv oder med exportieren</translation>
    </message>
    <message>
      <source>{array:text} has {value:count} at place {place:count}</source>
      <translation>{array:text} hat {value:count} an Stelle {place:count}</translation>
    </message>
    <message>
      <source>{count:count} of {all:count}</source>
      <translation>{count:count} von {all:count}</translation>
    </message>
    <message>
      <source>{edge:entities} ({length:length} long)</source>
      <translation>{edge:entities} ({length:length} lang)</translation>
    </message>
    <message>
      <source>{edge:entities} and {other:entities} are in the same place but run differently. Check the feature that made them (Part: Check geometry).</source>
      <translation>{edge:entities} und {other:entities} liegen am selben Ort, verlaufen aber verschieden. Das Formelement prüfen, das sie erzeugt hat (Part: Geometrie prüfen).</translation>
    </message>
    <message>
      <source>{edge:entities} has no curve in the face's parameters</source>
      <translation>{edge:entities} hat keine Kurve in den Parametern der Fläche</translation>
    </message>
    <message>
      <source>{edge:entities} has no end points. Check the feature that made it (Part: Check geometry).</source>
      <translation>{edge:entities} hat keine Endpunkte. Das Formelement prüfen, das sie erzeugt hat (Part: Geometrie prüfen).</translation>
    </message>
    <message>
      <source>{edge:entities} lies on {other:entities} but does not begin and end there. Check the feature that made them (Part: Check geometry).</source>
      <translation>{edge:entities} liegt auf {other:entities}, beginnt und endet aber nicht dort. Das Formelement prüfen, das sie erzeugt hat (Part: Geometrie prüfen).</translation>
    </message>
    <message>
      <source>{face:entities} cannot be filled: {why:messages}.</source>
      <translation>{face:entities} kann nicht gefüllt werden: {why:messages}.</translation>
    </message>
    <message>
      <source>{face:entities} cannot be meshed: its boundary crosses or touches itself ({edges:entities}). Check the feature that made it (Part: Check geometry), or try a smaller size.</source>
      <translation>{face:entities} kann nicht vernetzt werden: Ihr Rand kreuzt oder berührt sich selbst ({edges:entities}). Das Formelement prüfen, das sie erzeugt hat (Part: Geometrie prüfen), oder eine kleinere Größe versuchen.</translation>
    </message>
    <message>
      <source>{face:entities} cannot be meshed: its boundary crosses or touches itself. Check the feature that made it (Part: Check geometry), or try a smaller size.</source>
      <translation>{face:entities} kann nicht vernetzt werden: Ihr Rand kreuzt oder berührt sich selbst. Das Formelement prüfen, das sie erzeugt hat (Part: Geometrie prüfen), oder eine kleinere Größe versuchen.</translation>
    </message>
    <message>
      <source>{face:entities} cannot be meshed: {why:messages}. Check the feature that made it (Part: Check geometry), or refine the shape.</source>
      <translation>{face:entities} kann nicht vernetzt werden: {why:messages}. Das Formelement prüfen, das sie erzeugt hat (Part: Geometrie prüfen), oder die Form verfeinern.</translation>
    </message>
    <message>
      <source>{face:entities} cannot be meshed: {why:messages}. Try a smaller size on this face, or check the feature that made it (Part: Check geometry).</source>
      <translation>{face:entities} kann nicht vernetzt werden: {why:messages}. Eine kleinere Größe auf dieser Fläche versuchen, oder das Formelement prüfen, das sie erzeugt hat (Part: Geometrie prüfen).</translation>
    </message>
    <message>
      <source>{feature:text}: FreeCAD says: {error:text}</source>
      <translation>{feature:text}: FreeCAD sagt: {error:text}</translation>
    </message>
    <message>
      <source>{feature:text}: has no solid, so its effect is unknown and it counts as changed</source>
      <translation>{feature:text}: hat keinen Volumenkörper, also ist die Wirkung unbekannt, und es gilt als geändert</translation>
    </message>
    <message>
      <source>{feature:text}: its operand {operand:text} has no solid and is left out</source>
      <translation>{feature:text}: der Operand {operand:text} hat keinen Volumenkörper und wird weggelassen</translation>
    </message>
    <message>
      <source>{feature:text}: what it adds and removes could not be told from the shapes before and after it; it is taken as one piece with all before it</source>
      <translation>{feature:text}: was es hinzufügt und wegnimmt, war aus den Formen davor und danach nicht zu erkennen; es wird mit allem davor als ein Stück genommen</translation>
    </message>
    <message>
      <source>{first:messages} and {last:messages}</source>
      <translation>{first:messages} und {last:messages}</translation>
    </message>
    <message>
      <source>{load:text} loads nothing</source>
      <translation>{load:text} belastet nichts</translation>
    </message>
    <message>
      <source>{low:count} to {high:count}, the next one is {next:count}</source>
      <translation>{low:count} bis {high:count}, die nächste ist {next:count}</translation>
    </message>
    <message>
      <source>{member:text} refers to another object than the meshed part {part:text}</source>
      <translation>{member:text} bezieht sich auf ein anderes Objekt als das vernetzte Bauteil {part:text}</translation>
    </message>
    <message>
      <source>{member:text} refers to nothing: choose faces, edges or vertices for it</source>
      <translation>{member:text} bezieht sich auf nichts: Flächen, Kanten oder Eckpunkte dafür wählen</translation>
    </message>
    <message>
      <source>{member:text} refers to {face:entities}, which has no nodes in the mesh: update the mesh, or choose another face</source>
      <translation>{member:text} bezieht sich auf {face:entities}, wo das Netz keine Knoten hat: das Netz aktualisieren oder eine andere Fläche wählen</translation>
    </message>
    <message>
      <source>{motions:count} different motions; only the first {carried:count} carry parts of the mesh</source>
      <translation>{motions:count} verschiedene Bewegungen; nur die ersten {carried:count} nehmen Teile des Netzes mit</translation>
    </message>
    <message>
      <source>{object:text} could not be followed from the last mesh, whose state is gone; check what it refers to</source>
      <translation>{object:text} konnte nicht vom letzten Netz her verfolgt werden, dessen Zustand fehlt; prüfen, worauf es sich bezieht</translation>
    </message>
    <message>
      <source>{object:text} has no edge. Recompute the document, and mesh an object with edges.</source>
      <translation>{object:text} hat keine Kante. Das Dokument neu berechnen und ein Objekt mit Kanten vernetzen.</translation>
    </message>
    <message>
      <source>{object:text} has no face. Recompute the document, and mesh an object with faces, or its edges.</source>
      <translation>{object:text} hat keine Fläche. Das Dokument neu berechnen und ein Objekt mit Flächen vernetzen oder seine Kanten.</translation>
    </message>
    <message>
      <source>{object:text} has no solid. Recompute the document, and mesh a body or a Part object whose result is a solid.</source>
      <translation>{object:text} hat keinen Volumenkörper. Das Dokument neu berechnen und einen Körper oder ein Part-Objekt vernetzen, dessen Ergebnis ein Volumenkörper ist.</translation>
    </message>
    <message>
      <source>{object:text} refers to {lost:entities}, which is gone; choose another edge, the analysis cannot be solved without</source>
      <translation>{object:text} bezieht sich auf {lost:entities}, das es nicht mehr gibt; eine andere Kante wählen, sonst lässt sich die Analyse nicht lösen</translation>
    </message>
    <message>
      <source>{object:text} refers to {lost:entities}, which is gone; choose another face, the analysis cannot be solved without</source>
      <translation>{object:text} bezieht sich auf {lost:entities}, das es nicht mehr gibt; eine andere Fläche wählen, sonst lässt sich die Analyse nicht lösen</translation>
    </message>
    <message>
      <source>{object:text} refers to {lost:entities}, which is gone; choose another solid, the analysis cannot be solved without</source>
      <translation>{object:text} bezieht sich auf {lost:entities}, das es nicht mehr gibt; einen anderen Volumenkörper wählen, sonst lässt sich die Analyse nicht lösen</translation>
    </message>
    <message>
      <source>{object:text} refers to {lost:entities}, which is gone; choose another vertex, the analysis cannot be solved without</source>
      <translation>{object:text} bezieht sich auf {lost:entities}, das es nicht mehr gibt; einen anderen Eckpunkt wählen, sonst lässt sich die Analyse nicht lösen</translation>
    </message>
    <message>
      <source>{object:text} refers to {lost:entities}, which is gone; it was taken out of the references</source>
      <translation>{object:text} bezieht sich auf {lost:entities}, das es nicht mehr gibt; es wurde aus den Referenzen genommen</translation>
    </message>
    <message>
      <source>{object:text} refers to {where:entities}, which is not on the meshed part {part:text} and has no nodes in its mesh; choose faces, edges or vertices of {part:text} instead</source>
      <translation>{object:text} bezieht sich auf {where:entities}, das nicht am vernetzten Bauteil {part:text} liegt und in dessen Netz keine Knoten hat; stattdessen Flächen, Kanten oder Eckpunkte von {part:text} wählen</translation>
    </message>
    <message>
      <source>{object:text}: {before:entities} is now {now:entities}, its reference was changed</source>
      <translation>{object:text}: {before:entities} ist jetzt {now:entities}, die Referenz wurde geändert</translation>
    </message>
    <message>
      <source>{object:text}: {before:entities} was split into {now:entities}, it is on all of them now</source>
      <translation>{object:text}: {before:entities} wurde in {now:entities} geteilt, es gilt jetzt auf allen</translation>
    </message>
    <message>
      <source>{object:text}: of {before:entities} it is not on {within:entities}, which lies between two solids now</source>
      <translation>{object:text}: von {before:entities} gilt es nicht auf {within:entities}, das jetzt zwischen zwei Volumenkörpern liegt</translation>
    </message>
    <message>
      <source>{object:text}: {one:entities} has become one with {others:entities}, it is on all of that now</source>
      <translation>{object:text}: {one:entities} ist mit {others:entities} eins geworden, es gilt jetzt auf dem Ganzen</translation>
    </message>
    <message>
      <source>{one:entities} and itself</source>
      <translation>{one:entities} und sich selbst</translation>
    </message>
    <message>
      <source>{one:entities} and itself near {place:point}</source>
      <translation>{one:entities} und sich selbst nahe {place:point}</translation>
    </message>
    <message>
      <source>{one:entities} and {other:entities}</source>
      <translation>{one:entities} und {other:entities}</translation>
    </message>
    <message>
      <source>{one:entities} and {other:entities} ({distance:length} apart)</source>
      <translation>{one:entities} und {other:entities} ({distance:length} voneinander)</translation>
    </message>
    <message>
      <source>{one:entities} and {other:entities} near {place:point}</source>
      <translation>{one:entities} und {other:entities} nahe {place:point}</translation>
    </message>
    <message>
      <source>{one:entities} in {other:entities}</source>
      <translation>{one:entities} in {other:entities}</translation>
    </message>
    <message>
      <source>{one:messages} and {other:messages}</source>
      <translation>{one:messages} und {other:messages}</translation>
    </message>
    <message>
      <source>{solid:entities} has no positive volume. Its faces point inwards or cross each other; check the feature that made it (Part: Check geometry).</source>
      <translation>{solid:entities} hat kein positives Volumen. Seine Flächen zeigen nach innen oder kreuzen einander; das Formelement prüfen, das ihn erzeugt hat (Part: Geometrie prüfen).</translation>
    </message>
    <message>
      <source>{solid:entities} has {elements:volume} of elements, not {wanted:volume}</source>
      <translation>{solid:entities} hat {elements:volume} an Elementen, nicht {wanted:volume}</translation>
    </message>
    <message>
      <source>{triangle:messages} has {solid:messages} before it, not {wanted:messages}</source>
      <translation>{triangle:messages} hat {solid:messages} vor sich, nicht {wanted:messages}</translation>
    </message>
    <message>
      <source>{triangle:messages} has {solid:messages} behind it, not {wanted:messages}</source>
      <translation>{triangle:messages} hat {solid:messages} hinter sich, nicht {wanted:messages}</translation>
    </message>
    <message>
      <source>{value:text} is no number for {target:text}</source>
      <translation>{value:text} ist keine Zahl für {target:text}</translation>
    </message>
    <message>
      <source>{value:text} is no unit for {target:text}</source>
      <translation>{value:text} ist keine Einheit für {target:text}</translation>
    </message>
    <message>
      <source>{values:count} {values:value does|values do} not fit the {nodes:count} {nodes:node|nodes} of the old mesh.</source>
      <translation>{values:count} {values:Wert passt|Werte passen} nicht zu den {nodes:count} Knoten des alten Netzes.</translation>
    </message>
    <message>
      <source>{version:text} with OCCT {occt:text}</source>
      <translation>{version:text} mit OCCT {occt:text}</translation>
    </message>
    <message>
      <source>{version:text}, numpy {numpy:messages}</source>
      <translation>{version:text}, numpy {numpy:messages}</translation>
    </message>
    <message>
      <source>{version:text}, protocol {protocol:count}, {came:messages}, in {folder:text}, runs {where:messages}</source>
      <translation>{version:text}, Protokoll {protocol:count}, {came:messages}, in {folder:text}, läuft {where:messages}</translation>
    </message>
    <message>
      <source>{version:text}, {came:messages}, in {folder:text}</source>
      <translation>{version:text}, {came:messages}, in {folder:text}</translation>
    </message>
    <message>
      <source>{weight:text} has no direction; give it one</source>
      <translation>{weight:text} hat keine Richtung; ihm eine geben</translation>
    </message>
    <message>
      <source>{weight:text} needs the density of every material; give each of them one, with its unit</source>
      <translation>{weight:text} braucht die Dichte jedes Werkstoffs; jedem eine geben, mit ihrer Einheit</translation>
    </message>
    <message>
      <source>{what:messages} (percentile {percent:number})</source>
      <translation>{what:messages} (Perzentil {percent:number})</translation>
    </message>
    <message>
      <source>{what:messages} at {place:text}</source>
      <translation>{what:messages} an {place:text}</translation>
    </message>
    <message>
      <source>{what:messages} {text:text} cannot be evaluated: {why:messages}; it may use {names:text}</source>
      <translation>{what:messages} {text:text} kann nicht ausgewertet werden: {why:messages}; erlaubt sind {names:text}</translation>
    </message>
    <message>
      <source>{what:messages} {text:text} cannot be read: {why:text}</source>
      <translation>{what:messages} {text:text} kann nicht gelesen werden: {why:text}</translation>
    </message>
    <message>
      <source>{where:text}: there is no {key:text}; known are {known:text}</source>
      <translation>{where:text}: {key:text} gibt es nicht; es gibt {known:text}</translation>
    </message>
    <message>
      <source>{where:text}: {key:text} is {kind:messages}, not {value:text}</source>
      <translation>{where:text}: {key:text} ist {kind:messages}, nicht {value:text}</translation>
    </message>
    <message>
      <source>{why:messages}; the mesh is that of {part:text} as it was before</source>
      <translation>{why:messages}; das Netz ist das von {part:text}, wie es davor war</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_About</name>
    <message>
      <source>About FeatureMesh</source>
      <translation>Über FeatureMesh</translation>
    </message>
    <message>
      <source>Shows versions, where things are installed and where the log is, to be copied into a bug report</source>
      <translation>Zeigt Versionen, wo alles installiert ist und wo das Protokoll liegt, zum Kopieren in einen Fehlerbericht</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_AddGroup</name>
    <message>
      <source>Add a mesh group</source>
      <translation>Netzgruppe hinzufügen</translation>
    </message>
    <message>
      <source>Makes a named set of nodes and elements of the selected solids, faces, edges or vertices, to be changed in FEM's panel of mesh groups</source>
      <translation>Macht aus den ausgewählten Volumenkörpern, Flächen, Kanten oder Eckpunkten eine benannte Gruppe von Knoten und Elementen, die sich in FEMs Fenster für Netzgruppen ändern lässt</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_AddLocalSize</name>
    <message>
      <source>Add a local size</source>
      <translation>Lokale Größe hinzufügen</translation>
    </message>
    <message>
      <source>Gives the selected faces, edges or vertices half the mesh size, to be changed in FEM's refinement panel</source>
      <translation>Gibt den ausgewählten Flächen, Kanten oder Eckpunkten die halbe Elementgröße, änderbar im Fenster der FEM-Netzverfeinerung</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_AddSizeZone</name>
    <message>
      <source>Add a refinement zone</source>
      <translation>Verfeinerungszone hinzufügen</translation>
    </message>
    <message>
      <source>Makes elements smaller in a box, a sphere or a cylinder, or near the selected faces, edges or vertices</source>
      <translation>Macht Elemente in einem Quader, einer Kugel oder einem Zylinder kleiner, oder nahe den ausgewählten Flächen, Kanten oder Eckpunkten</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_Adopt</name>
    <message>
      <source>Adopt a mesh</source>
      <translation>Netz übernehmen</translation>
    </message>
    <message>
      <source>Turns the selected mesh of Gmsh, Netgen or another maker (or the only one) into one that follows the part</source>
      <translation>Macht aus dem ausgewählten (oder einzigen) Netz von Gmsh, Netgen oder anderen eines, das dem Bauteil folgt</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_Compare</name>
    <message>
      <source>Compare with a document</source>
      <translation>Mit einem Dokument vergleichen</translation>
    </message>
    <message>
      <source>Tells feature by feature what changed between a saved document and the selected part</source>
      <translation>Sagt Formelement für Formelement, was sich zwischen einem gespeicherten Dokument und dem ausgewählten Bauteil geändert hat</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_Export</name>
    <message>
      <source>Export the mesh</source>
      <translation>Netz exportieren</translation>
    </message>
    <message>
      <source>Writes the mesh with its groups as VTK, Abaqus, NASTRAN, Gmsh, UNV, MED or Z88, or its surface as STL</source>
      <translation>Schreibt das Netz mit seinen Gruppen als VTK, Abaqus, NASTRAN, Gmsh, UNV, MED oder Z88, oder seine Oberfläche als STL</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_LiveResult</name>
    <message>
      <source>Live result</source>
      <translation>Mitlaufendes Ergebnis</translation>
    </message>
    <message>
      <source>Solves the analysis after each recompute and shows stresses and displacements in colours</source>
      <translation>Löst die Analyse nach jeder Neuberechnung und zeigt Spannungen und Verschiebungen in Farben</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_MeshPart</name>
    <message>
      <source>Adds a mesh that follows the selected part (or the only one), or all parts of the selected container, and opens its settings</source>
      <translation>Fügt ein Netz hinzu, das dem ausgewählten Bauteil (oder dem einzigen) oder allen Bauteilen des ausgewählten Containers folgt, und öffnet seine Einstellungen</translation>
    </message>
    <message>
      <source>Mesh a part</source>
      <translation>Bauteil vernetzen</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_ShowKept</name>
    <message>
      <source>Colours the elements: those the last update kept, and new ones</source>
      <translation>Färbt die Elemente: was die letzte Aktualisierung behalten hat und was neu ist</translation>
    </message>
    <message>
      <source>Show what was kept</source>
      <translation>Zeigen, was blieb</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_ShowQuality</name>
    <message>
      <source>Colours the elements by their smallest angle, with a histogram and the worst elements</source>
      <translation>Färbt die Elemente nach ihrem kleinsten Winkel, mit Histogramm und den schlechtesten Elementen</translation>
    </message>
    <message>
      <source>Show the quality</source>
      <translation>Qualität zeigen</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_ShowTree</name>
    <message>
      <source>Lists the features of the selected part as the mesher understands them</source>
      <translation>Listet die Formelemente des ausgewählten Bauteils, wie der Vernetzer sie versteht</translation>
    </message>
    <message>
      <source>Show the feature tree</source>
      <translation>Formelementbaum zeigen</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_Study</name>
    <message>
      <source>Parameter study</source>
      <translation>Parameterstudie</translation>
    </message>
    <message>
      <source>Varies dimensions of the part, meshes and solves each variant, and shows what matters</source>
      <translation>Ändert Maße des Bauteils, vernetzt und löst jede Variante und zeigt, was wichtig ist</translation>
    </message>
  </context>
  <context>
    <name>FeatureMesh_UpdateNow</name>
    <message>
      <source>Brings the mesh up to date with its part, only where the part changed</source>
      <translation>Bringt das Netz auf den Stand des Bauteils, nur wo sich das Bauteil geändert hat</translation>
    </message>
    <message>
      <source>Update the mesh</source>
      <translation>Netz aktualisieren</translation>
    </message>
  </context>
</TS>

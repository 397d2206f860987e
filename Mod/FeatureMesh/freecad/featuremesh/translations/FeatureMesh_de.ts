<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>App::Property</name>
    <message>
      <source>1st: 4-node tetrahedra; 2nd: 10-node tetrahedra with their mid-side nodes on the surface</source>
      <translation>1st: Tetraeder mit 4 Knoten; 2nd: Tetraeder mit 10 Knoten, deren Kantenmittelknoten auf der Oberfläche liegen</translation>
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
      <translation>Fälle zugleich; 0: so viele wie Prozessoren</translation>
    </message>
    <message>
      <source>Edge length to which it grows outside; 0: the size of the mesh</source>
      <translation>Kantenlänge, bis zu der sie außen wächst; 0: die Größe des Netzes</translation>
    </message>
    <message>
      <source>Edges along a full circle of any curved face or edge; 0: sizes do not follow curvature</source>
      <translation>Kanten auf einem vollen Kreis jeder gekrümmten Fläche oder Kante; 0: die Größe folgt der Krümmung nicht</translation>
    </message>
    <message>
      <source>Edges, steps and strips of faces smaller than this get no elements of their own; 0: those below a thousandth of Size where the part cannot be meshed with them; negative: none</source>
      <translation>Kanten, Absätze und Flächenstreifen, die kleiner sind, bekommen keine eigenen Elemente; 0: solche unter einem Tausendstel von Size, wo das Teil mit ihnen nicht vernetzt werden kann; negativ: keine</translation>
    </message>
    <message>
      <source>Elements across thin walls and slots; 0: sizes do not follow thickness</source>
      <translation>Elemente quer durch dünne Wände und Schlitze; 0: die Größe folgt der Dicke nicht</translation>
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
      <translation>Flächen, Kanten und Ecken, von denen aus der Abstand gemessen wird</translation>
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
      <source>Height of the box or the cylinder, along its z axis</source>
      <translation>Höhe des Quaders oder des Zylinders, entlang seiner z-Achse</translation>
    </message>
    <message>
      <source>How far from the references the inner size reaches</source>
      <translation>Wie weit von den Referenzen die innere Größe reicht</translation>
    </message>
    <message>
      <source>How the cases are chosen</source>
      <translation>Wie die Fälle gewählt werden</translation>
    </message>
    <message>
      <source>Largest displacement, mm</source>
      <translation>Größte Verschiebung, mm</translation>
    </message>
    <message>
      <source>Largest von Mises stress, MPa</source>
      <translation>Größte Vergleichsspannung nach von Mises, MPa</translation>
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
      <translation>Anzahl der Fälle, wo die Auswahl jede Anzahl zulässt</translation>
    </message>
    <message>
      <source>Over how much it grows to the outer size; 0: as fast as the mesh's Growth allows</source>
      <translation>Über welche Strecke sie zur äußeren Größe wächst; 0: so schnell, wie Growth des Netzes es zulässt</translation>
    </message>
    <message>
      <source>Parts that lie on one another share faces, and the mesh its nodes there</source>
      <translation>Teile, die aufeinander liegen, teilen sich Flächen, und das Netz dort seine Knoten</translation>
    </message>
    <message>
      <source>Processor threads to use; 0: all. The mesh is the same for any number</source>
      <translation>Zu nutzende Prozessor-Threads; 0: alle. Das Netz ist für jede Anzahl dasselbe</translation>
    </message>
    <message>
      <source>Processor threads to use; 0: all. The result is the same for any number</source>
      <translation>Prozessorfäden; 0: alle. Das Ergebnis ist für jede Zahl dasselbe</translation>
    </message>
    <message>
      <source>Radius of the sphere or the cylinder</source>
      <translation>Radius der Kugel oder des Zylinders</translation>
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
      <translation>Kleinster Winkel in Grad, auf den hin neue Elemente verbessert werden; unter 30 geht es schneller, über 35 wird selten erreicht</translation>
    </message>
    <message>
      <source>Smallest edge length that curvature, thin gaps and growth may ask for; 0: a tenth of Size</source>
      <translation>Kleinste Kantenlänge, die Krümmung, dünne Stellen und Wachstum verlangen dürfen; 0: ein Zehntel von Size</translation>
    </message>
    <message>
      <source>Solve whenever the document was recomputed</source>
      <translation>Nach jeder Neuberechnung des Dokuments lösen</translation>
    </message>
    <message>
      <source>Solves the cases; automatic: live where that is enough</source>
      <translation>Löst die Fälle; automatic: live, wo das reicht</translation>
    </message>
    <message>
      <source>The analysis that is solved for each case</source>
      <translation>Die Analyse, die für jeden Fall gelöst wird</translation>
    </message>
    <message>
      <source>The container whose parts these are, or the link that is shown</source>
      <translation>Der Container, dessen Teile dies sind, oder die Verknüpfung, die gezeigt wird</translation>
    </message>
    <message>
      <source>The faces that joined parts share</source>
      <translation>Die Flächen, die verbundene Teile sich teilen</translation>
    </message>
    <message>
      <source>The part that is varied</source>
      <translation>Das Teil, das verändert wird</translation>
    </message>
    <message>
      <source>The parts, in the order of the solids of the shape</source>
      <translation>Die Teile, in der Reihenfolge der Volumenkörper der Form</translation>
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
      <translation>Was vernetzt wird: Solids: Körper mit Tetraedern; Faces: Flächen mit Dreiecken (Schalen); Edges: Kanten mit Balkenelementen; From shape: Körper und was neben ihnen ist, sonst Flächen, sonst Kanten</translation>
    </message>
    <message>
      <source>What is varied, such as Fillet.Radius=2:6</source>
      <translation>Was verändert wird, etwa Fillet.Radius=2:6</translation>
    </message>
    <message>
      <source>What loads, supports, materials and refinements referred to, as JSON</source>
      <translation>Worauf sich Lasten, Lager, Materialien und Verfeinerungen bezogen, als JSON</translation>
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
      <source>Whether the mesh fits the part, and if not, why</source>
      <translation>Ob das Netz zum Bauteil passt, und wenn nicht, warum</translation>
    </message>
    <message>
      <source>Whether the result is that of the part as it is, and if not, why</source>
      <translation>Ob das Ergebnis zum Bauteil gehört, wie es ist, und wenn nicht, warum</translation>
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
      <source> of %s</source>
      <translation> von %s</translation>
    </message>
    <message>
      <source>%d features changed, %d did not; faces: %s</source>
      <translation>%d Features haben sich geändert, %d nicht; Flächen: %s</translation>
    </message>
    <message>
      <source>%d nodes, %d elements in %.2f s</source>
      <translation>%d Knoten, %d Elemente in %.2f s</translation>
    </message>
    <message>
      <source>%d objects have the label %s, use a name: %s</source>
      <translation>%d Objekte haben die Bezeichnung %s, bitte einen Namen angeben: %s</translation>
    </message>
    <message>
      <source>%d of %d cases done</source>
      <translation>%d von %d Fällen fertig</translation>
    </message>
    <message>
      <source>%s and %d more</source>
      <translation>%s und %d weitere</translation>
    </message>
    <message>
      <source>%s and %s overlap; parts that are joined may only touch</source>
      <translation>%s und %s überlappen sich; Teile, die verbunden werden, dürfen sich nur berühren</translation>
    </message>
    <message>
      <source>%s at %s</source>
      <translation>%s an %s</translation>
    </message>
    <message>
      <source>%s belongs to no analysis</source>
      <translation>%s gehört zu keiner Analyse</translation>
    </message>
    <message>
      <source>%s cannot be renumbered: %s</source>
      <translation>%s kann nicht neu nummeriert werden: %s</translation>
    </message>
    <message>
      <source>%s cannot be solved: %s</source>
      <translation>%s kann nicht gelöst werden: %s</translation>
    </message>
    <message>
      <source>%s has %s already, and an analysis is solved with one mesh</source>
      <translation>%s hat schon %s, und eine Analyse wird mit einem Netz gelöst</translation>
    </message>
    <message>
      <source>%s has a mesh already: %s; delete one of the two</source>
      <translation>%s hat schon ein Netz: %s; bitte eines von beiden löschen</translation>
    </message>
    <message>
      <source>%s has no container, set its property Container</source>
      <translation>%s hat keinen Container, setzen Sie seine Eigenschaft Container</translation>
    </message>
    <message>
      <source>%s has no form for a mesh of edges; export it as inp, vtu, vtk, msh, unv or med</source>
      <translation>%s kann kein Netz aus Kanten enthalten; exportieren Sie es als inp, vtu, vtk, msh, unv oder med</translation>
    </message>
    <message>
      <source>%s has no mesh of FeatureMesh to copy along</source>
      <translation>%s hat kein Netz von FeatureMesh, das mitkopiert werden könnte</translation>
    </message>
    <message>
      <source>%s has no mesh yet</source>
      <translation>%s hat noch kein Netz</translation>
    </message>
    <message>
      <source>%s has no mesh; let it share %s (api.share_mesh), or give it one of its own</source>
      <translation>%s hat kein Netz; lassen Sie die Analyse %s mitbenutzen (api.share_mesh), oder geben Sie ihr ein eigenes</translation>
    </message>
    <message>
      <source>%s has no part</source>
      <translation>%s hat kein Teil</translation>
    </message>
    <message>
      <source>%s has no part to mesh, set its property %s</source>
      <translation>%s hat kein Bauteil, das vernetzt werden kann; bitte die Eigenschaft %s setzen</translation>
    </message>
    <message>
      <source>%s has no part with a solid</source>
      <translation>%s hat kein Teil mit einem Volumenkörper</translation>
    </message>
    <message>
      <source>%s has no shape to mesh</source>
      <translation>%s hat keine Form, die vernetzt werden kann</translation>
    </message>
    <message>
      <source>%s has no shape yet; recompute the document first</source>
      <translation>%s hat noch keine Form; berechnen Sie zuerst das Dokument neu</translation>
    </message>
    <message>
      <source>%s has no solid%s</source>
      <translation>%s hat keinen Festkörper%s</translation>
    </message>
    <message>
      <source>%s has no tetrahedra; it has to be a volume mesh</source>
      <translation>%s hat keine Tetraeder; es muss ein Volumennetz sein</translation>
    </message>
    <message>
      <source>%s has other elements than 4-node or 10-node tetrahedra (%s with %s nodes); only tetrahedra can be adopted</source>
      <translation>%s hat andere Elemente als Tetraeder mit 4 oder 10 Knoten (%s mit %s Knoten); nur Tetraeder können übernommen werden</translation>
    </message>
    <message>
      <source>%s has the mesh %s already.</source>
      <translation>%s hat schon das Netz %s.</translation>
    </message>
    <message>
      <source>%s in its place</source>
      <translation>%s an ihrem Ort</translation>
    </message>
    <message>
      <source>%s is %s; update it before solving</source>
      <translation>%s ist %s; vor dem Lösen aktualisieren</translation>
    </message>
    <message>
      <source>%s is FeatureMesh's own already</source>
      <translation>%s gehört schon FeatureMesh</translation>
    </message>
    <message>
      <source>%s is a group, name one of its objects: %s</source>
      <translation>%s ist eine Gruppe, bitte eines ihrer Objekte angeben: %s</translation>
    </message>
    <message>
      <source>%s is no FEM mesh</source>
      <translation>%s ist kein FEM-Netz</translation>
    </message>
    <message>
      <source>%s is no analysis</source>
      <translation>%s ist keine Analyse</translation>
    </message>
    <message>
      <source>%s is no length</source>
      <translation>%s ist keine Länge</translation>
    </message>
    <message>
      <source>%s is no object of a document; give a body, or a Part object with a solid</source>
      <translation>%s ist kein Objekt eines Dokuments; geben Sie einen Körper oder ein Part-Objekt mit einem Volumenkörper an</translation>
    </message>
    <message>
      <source>%s is not that of the part as it is, its last update failed: %s</source>
      <translation>%s ist nicht das Netz des Bauteils, wie es jetzt ist; die letzte Aktualisierung ist fehlgeschlagen: %s</translation>
    </message>
    <message>
      <source>%s presses on a shell beside a solid, which FreeCAD cannot write for CalculiX; use a force there</source>
      <translation>%s drückt auf eine Schale neben einem Körper, was FreeCAD für CalculiX nicht schreiben kann; verwenden Sie dort eine Kraft</translation>
    </message>
    <message>
      <source>%s shows a mesh that was deleted; delete it, too, and give the analysis another mesh</source>
      <translation>%s zeigt ein Netz, das gelöscht wurde; löschen Sie es auch und geben Sie der Analyse ein anderes Netz</translation>
    </message>
    <message>
      <source>%s was not updated since the document was opened, all its elements are as they were</source>
      <translation>%s wurde seit dem Öffnen des Dokuments nicht aktualisiert, alle Elemente sind, wie sie waren</translation>
    </message>
    <message>
      <source>%s would lose the beams of this mesh; export it as inp, vtu, vtk, msh, unv or med</source>
      <translation>%s würde die Balken dieses Netzes verlieren; exportieren Sie als inp, vtu, vtk, msh, unv oder med</translation>
    </message>
    <message>
      <source>%s would lose the shells of this mesh; export it as inp, vtu, vtk, msh, unv or med</source>
      <translation>%s würde die Schalen dieses Netzes verlieren; exportieren Sie als inp, vtu, vtk, msh, unv oder med</translation>
    </message>
    <message>
      <source>%s: %d features in %d pieces, volume %.10g mm^3 (FreeCAD: %.10g mm^3)</source>
      <translation>%s: %d Features in %d Stücken, Volumen %.10g mm^3 (FreeCAD: %.10g mm^3)</translation>
    </message>
    <message>
      <source>'{name:text}' is no face, edge, vertex or solid; write it as FreeCAD does, e.g. Face12.</source>
      <translation>„{name:text}“ ist keine Fläche, keine Kante, kein Punkt und kein Volumenkörper; wie in FreeCAD zu schreiben, z. B. Face12.</translation>
    </message>
    <message>
      <source>, about %d min left</source>
      <translation>, noch etwa %d min</translation>
    </message>
    <message>
      <source>, about %d s left</source>
      <translation>, noch etwa %d s</translation>
    </message>
    <message>
      <source>, not of %s</source>
      <translation>, nicht von %s</translation>
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
      <translation>Tetraeder mit 4 Knoten sind bei Biegung zu steif und zeigen zu kleine Spannungen (hier liegen die Spannungen im Mittel der Energie um etwa {percent:count} % daneben); Tetraeder mit 10 Knoten (Order: 2nd) sind auf demselben Netz weit genauer</translation>
    </message>
    <message>
      <source>4-node tetrahedra are too stiff in bending and show too little stress; 10-node tetrahedra (Order: 2nd) are far closer on the same mesh</source>
      <translation>Tetraeder mit 4 Knoten sind bei Biegung zu steif und zeigen zu kleine Spannungen; Tetraeder mit 10 Knoten (Order: 2nd) sind auf demselben Netz weit genauer</translation>
    </message>
    <message>
      <source>6-node triangle that is folded: {triangles:messages}</source>
      <translation>gefaltetes Dreieck mit 6 Knoten: {triangles:messages}</translation>
    </message>
    <message>
      <source>6-node triangles</source>
      <translation>6-Knoten-Dreiecke</translation>
    </message>
    <message>
      <source>: %s leaves nothing of it</source>
      <translation>: %s lässt nichts davon übrig</translation>
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
      <translation>Ein Doppelklick auf einen Fall zeigt ihn: Teil, Netz und Ergebnis. Rückgängig nimmt das zurück.</translation>
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
      <source>A part of the mesh has no material.</source>
      <translation>Ein Teil des Netzes hat keinen Werkstoff.</translation>
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
      <source>Across gaps</source>
      <translation>In Wänden</translation>
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
      <source>An adopted mesh keeps its element order.</source>
      <translation>Ein übernommenes Netz behält seine Elementordnung.</translation>
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
      <translation>Zugleich</translation>
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
      <source>CalculiX (ccx) is not installed</source>
      <translation>CalculiX (ccx) ist nicht installiert</translation>
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
      <source>CalculiX could not solve %s: %s</source>
      <translation>CalculiX konnte %s nicht lösen: %s</translation>
    </message>
    <message>
      <source>CalculiX failed: {why:text}</source>
      <translation>CalculiX ist gescheitert: {why:text}</translation>
    </message>
    <message>
      <source>CalculiX gave no result for %s</source>
      <translation>CalculiX ergab kein Ergebnis für %s</translation>
    </message>
    <message>
      <source>CalculiX gave no result for {analysis:text}</source>
      <translation>CalculiX ergab kein Ergebnis für {analysis:text}</translation>
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
      <translation>Bitte die Form dort prüfen (Part: Geometrie prüfen), von Grund auf vernetzen oder eine andere Größe versuchen.</translation>
    </message>
    <message>
      <source>Chosen</source>
      <translation>Auswahl</translation>
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
      <translation>Einzelheiten unter {below:length} können nicht übergangen werden; höchstens solche unter der Hälfte der Netzgröße von {size:length}.</translation>
    </message>
    <message>
      <source>Details of the part far smaller than the elements force an angle below 2 degrees on {elements:count} elements: {details:messages}. Results there are poor. Take them out of the features that make them (points of a sketch that nearly coincide, a step as shallow), or mesh finer there.</source>
      <translation>Einzelheiten des Bauteils, die viel kleiner als die Elemente sind, erzwingen einen Winkel unter 2 Grad an {elements:count} Elementen: {details:messages}. Ergebnisse dort sind ungenau. Sie aus den Formelementen entfernen, die sie erzeugen (Skizzenpunkte, die fast zusammenfallen, eine ebenso flache Stufe), oder dort feiner vernetzen.</translation>
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
      <translation>Feature-Baum</translation>
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
      <translation>FeatureMesh braucht numpy, das dieses FreeCAD nicht hat; bitte installieren (Debian: python3-numpy) und FreeCAD neu starten.</translation>
    </message>
    <message>
      <source>FeatureMesh's compiled engine (featuremesh_engine) is not installed for Python %d.%d; the mesh is shown as it was saved.</source>
      <translation>Das Rechenprogramm von FeatureMesh (featuremesh_engine) ist für Python %d.%d nicht installiert; das Netz wird gezeigt, wie es gespeichert wurde.</translation>
    </message>
    <message>
      <source>FeatureMesh's engine %s in %s is too new for FeatureMesh %s; update FeatureMesh with Tools, Addon manager.</source>
      <translation>Das Rechenprogramm %s in %s ist zu neu für FeatureMesh %s; bringen Sie FeatureMesh mit Werkzeuge, Addon-Manager auf den neuesten Stand.</translation>
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
      <source>FreeCAD cannot recompute %s: %s</source>
      <translation>FreeCAD kann %s nicht neu berechnen: %s</translation>
    </message>
    <message>
      <source>FreeCAD could not compute %s: %s</source>
      <translation>FreeCAD konnte %s nicht berechnen: %s</translation>
    </message>
    <message>
      <source>FreeCAD could not write CalculiX's input for {analysis:text}; its report view says why</source>
      <translation>FreeCAD konnte die Eingabe von CalculiX für {analysis:text} nicht schreiben; sein Ausgabefenster sagt, warum</translation>
    </message>
    <message>
      <source>FreeCAD's program freecadcmd was not found; set FREECADCMD to it</source>
      <translation>FreeCADs Programm freecadcmd wurde nicht gefunden; setzen Sie FREECADCMD darauf</translation>
    </message>
    <message>
      <source>From</source>
      <translation>Von</translation>
    </message>
    <message>
      <source>From scratch</source>
      <translation>Von Grund auf</translation>
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
      <source>In the place of another vertex within a millionth of the part, with which they share a node: {vertices:entities}.</source>
      <translation>An der Stelle eines anderen Punktes, auf ein Millionstel des Bauteils genau, mit dem sie einen Knoten teilen: {vertices:entities}.</translation>
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
      <source>Kept nodes of {edge:entities} belong to an edge in the same place. Mesh the part from scratch.</source>
      <translation>Behaltene Knoten von {edge:entities} gehören zu einer Kante am selben Ort. Das Teil von Grund auf vernetzen.</translation>
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
      <source>Nearer to another vertex than {distance:length}, so that they share its node: {vertices:entities}.</source>
      <translation>Näher als {distance:length} an einer anderen Ecke, sodass sie deren Knoten haben: {vertices:entities}.</translation>
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
      <translation>Nicht vernetzt, weil sie zu keinem Körper gehören: {loose:entities}.</translation>
    </message>
    <message>
      <source>Only meshes of solids can be adopted. Mesh the part's faces or edges anew.</source>
      <translation>Nur Netze von Volumenkörpern können übernommen werden. Die Flächen oder Kanten des Teils neu vernetzen.</translation>
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
      <translation>Teile von %s</translation>
    </message>
    <message>
      <source>Per circle</source>
      <translation>Je Kreis</translation>
    </message>
    <message>
      <source>Perhaps memory ran out: try a larger size.</source>
      <translation>Vielleicht ging der Speicher aus: bitte eine größere Elementgröße versuchen.</translation>
    </message>
    <message>
      <source>Plots need matplotlib (Debian: python3-matplotlib): %s</source>
      <translation>Diagramme brauchen matplotlib (Debian: python3-matplotlib): %s</translation>
    </message>
    <message>
      <source>Processor threads of a new mesh; the mesh is the same for any number</source>
      <translation>Prozessor-Threads eines neuen Netzes; das Netz ist für jede Anzahl dasselbe</translation>
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
      <translation>Wählen Sie einen Fall in der Tabelle, oder klicken Sie auf einen Punkt eines Diagramms.</translation>
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
      <translation>Das Teil zeigen, wie es war</translation>
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
      <translation>Körper</translation>
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
      <translation>Der Geometriekern versagte beim Vernetzen: {why:text}. Eine andere Größe versuchen, oder die Form prüfen (Part: Geometrie prüfen).</translation>
    </message>
    <message>
      <source>The geometry kernel failed: {why:text}</source>
      <translation>Der Geometriekern ist gescheitert: {why:text}</translation>
    </message>
    <message>
      <source>The growth rate is {growth:number}; it must be at least 1 (1.3 is usual).</source>
      <translation>Das Wachstum ist {growth:number}; es muss mindestens 1 sein (üblich ist 1.3).</translation>
    </message>
    <message>
      <source>The kept nodes of {edge:entities} are not in the order of the edge. Mesh the part from scratch.</source>
      <translation>Die behaltenen Knoten von {edge:entities} liegen nicht in der Reihenfolge der Kante. Das Teil von Grund auf vernetzen.</translation>
    </message>
    <message>
      <source>The kept segments of {edge:entities} do not follow the edge. Mesh the part from scratch.</source>
      <translation>Die behaltenen Segmente von {edge:entities} folgen der Kante nicht. Das Teil von Grund auf vernetzen.</translation>
    </message>
    <message>
      <source>The live solver does not converge on this mesh; solve with CalculiX, and look for very flat elements or materials of very different stiffness.</source>
      <translation>Der Live-Löser konvergiert auf diesem Netz nicht; mit CalculiX lösen, und nach sehr flachen Elementen oder Werkstoffen sehr verschiedener Steifigkeit suchen.</translation>
    </message>
    <message>
      <source>The live solver needs PETSc: install Debian's package libpetsc-real-dev, and any command of ./featuremesh in a clone builds the solver with it ({why:text}).</source>
      <translation>Der Live-Löser braucht PETSc: Debians Paket libpetsc-real-dev installieren, und jeder Befehl von ./featuremesh in einem Klon baut den Löser damit ({why:text}).</translation>
    </message>
    <message>
      <source>The local mesh size at {entity:entities} is {size:length}; it must be larger than zero.</source>
      <translation>Die lokale Netzgröße an {entity:entities} ist {size:length}; sie muss größer als null sein.</translation>
    </message>
    <message>
      <source>The local size at {entity:entities} is left out: the part has no such face, edge or vertex any more. Refer the refinement to another one.</source>
      <translation>Die lokale Größe bei {entity:entities} entfällt: Das Bauteil hat diese Fläche, Kante oder diesen Punkt nicht mehr. Die Verfeinerung auf etwas anderes beziehen.</translation>
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
      <translation>Das Netz ist bei {place:entities} feiner als verlangt, weil 10-Knoten-Tetraeder dieser Größe durch die gekrümmte Fläche ganz oder fast umklappen würden.</translation>
    </message>
    <message>
      <source>The mesh is finer than asked at {place:entities}, because 6-node triangles of that size would be folded, or nearly so, by the curved face.</source>
      <translation>Das Netz ist bei {place:entities} feiner als verlangt, weil Dreiecke dieser Größe mit 6 Knoten durch die gekrümmte Fläche gefaltet wären oder fast.</translation>
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
      <translation>Das Netz liegt in keiner Analyse, weil keine von %s aktiv ist: Ziehen Sie es in die, für die es gedacht ist.</translation>
    </message>
    <message>
      <source>The mesh is in no analysis: %s has %s already, and an analysis is solved with one mesh.</source>
      <translation>Das Netz liegt in keiner Analyse: %s hat schon %s, und eine Analyse wird mit einem Netz gerechnet.</translation>
    </message>
    <message>
      <source>The mesh is not valid: {finding:messages} (and {more:count} more).</source>
      <translation>Das Netz ist nicht gültig: {finding:messages} (und {more:count} weitere).</translation>
    </message>
    <message>
      <source>The mesh is joined where these faces of one solid lie on one another: {faces:entities}.</source>
      <translation>Das Netz ist verbunden, wo diese Flächen eines Körpers aufeinanderliegen: {faces:entities}.</translation>
    </message>
    <message>
      <source>The mesh is not valid: {finding:messages}.</source>
      <translation>Das Netz ist nicht gültig: {finding:messages}.</translation>
    </message>
    <message>
      <source>The mesh is not valid: {triangles:count} surface triangles are turned over, the first on {face:entities} at {place:point}. The face bends too much there for this size; ask for a smaller size on it.</source>
      <translation>Das Netz ist nicht gültig: {triangles:count} Dreiecke der Oberfläche sind umgeklappt, das erste auf {face:entities} bei {place:point}. Die Fläche krümmt sich dort zu stark für diese Größe; auf ihr eine kleinere verlangen.</translation>
    </message>
    <message>
      <source>The mesh is too fine for the live solver, whose matrix would have more than 2 billion entries.</source>
      <translation>Das Netz ist zu fein für den Live-Löser, dessen Matrix mehr als 2 Milliarden Einträge hätte.</translation>
    </message>
    <message>
      <source>The mesh size is {size:length}; it must be larger than zero. The part is {part:extent}.</source>
      <translation>Die Netzgröße ist {size:length}; sie muss größer als null sein. Das Bauteil misst {part:extent}.</translation>
    </message>
    <message>
      <source>The mesh size of {size:length} is larger than the part, which is {part:extent}. Ask for a smaller size.</source>
      <translation>Die Netzgröße von {size:length} ist größer als das Bauteil, es misst {part:extent}. Eine kleinere Größe wählen.</translation>
    </message>
    <message>
      <source>The number of elements across gaps is {asked:number}; it must not be negative (0 turns it off).</source>
      <translation>Die Zahl der Elemente in Wänden ist {asked:number}; sie darf nicht negativ sein (0 schaltet ab).</translation>
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
      <translation>Das Teil hat Flächen oder Kanten neben seinen Körpern, und nur Netze von Körpern können übernommen werden. Vernetzen Sie das Teil neu, oder übernehmen Sie das Netz nur für die Körper (Dimension: Solids).</translation>
    </message>
    <message>
      <source>The part is only {part:extent}, and points nearer than 1e-7 mm are one to FreeCAD's geometry: nodes could not be placed on its surface. Was it imported in another unit? Scale it up.</source>
      <translation>Das Teil misst nur {part:extent}, und Punkte, die näher als 1e-7 mm beieinander liegen, sind für FreeCADs Geometrie einer: Knoten ließen sich nicht auf seine Oberfläche legen. Wurde es in einer anderen Einheit importiert? Dann vergrößern.</translation>
    </message>
    <message>
      <source>The part is {thickness:length} thick at {faces:entities}: elements are smaller there than asked, so that {pieces:number} go round it.</source>
      <translation>Das Teil ist {thickness:length} dick an {faces:entities}: Die Elemente sind dort kleiner als verlangt, damit {pieces:number} herumpassen.</translation>
    </message>
    <message>
      <source>The refinement at {entity:entities} with a size of {size:length} would make about {millions:count} million elements; at most {most:count} million are made. Choose a larger size there.</source>
      <translation>Die Verfeinerung an {entity:entities} mit einer Größe von {size:length} ergäbe etwa {millions:count} Millionen Elemente; höchstens {most:count} Millionen werden gemacht. Wählen Sie dort eine größere Größe.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} changes nothing: its inner size of {inner:length} is not below the mesh size of {size:length}.</source>
      <translation>Die Verfeinerung {zone:text} ändert nichts: ihre innere Größe von {inner:length} liegt nicht unter der Netzgröße von {size:length}.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} grows over {transition:length}; that must not be negative (0: as fast as Growth allows).</source>
      <translation>Die Verfeinerung {zone:text} wächst über {transition:length}; das darf nicht negativ sein (0: so schnell, wie Growth erlaubt).</translation>
    </message>
    <message>
      <source>The refinement {zone:text} grows to {outer:length} over {over:length}, not over {asked:length}: neighbouring elements may differ by a factor of {growth:number} at most (Growth).</source>
      <translation>Die Verfeinerung {zone:text} wächst auf {outer:length} über {over:length}, nicht über {asked:length}: benachbarte Elemente dürfen sich höchstens um den Faktor {growth:number} unterscheiden (Growth).</translation>
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
      <translation>Die Verfeinerung {zone:text} hat eine äußere Größe von {outer:length}; sie darf nicht negativ sein (0: die Netzgröße).</translation>
    </message>
    <message>
      <source>The refinement {zone:text} has no size and is left out. Give it one, or suppress it.</source>
      <translation>Die Verfeinerung {zone:text} hat keine Größe und wird weggelassen. Geben Sie ihr eine, oder unterdrücken Sie sie.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} is coarser inside ({inner:length}) than outside ({outer:length}); exchange the two sizes.</source>
      <translation>Die Verfeinerung {zone:text} ist innen ({inner:length}) gröber als außen ({outer:length}); vertauschen Sie die beiden Größen.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} is left out: the part has nothing of what it refers to. Refer it to a face, an edge or a vertex.</source>
      <translation>Die Verfeinerung {zone:text} wird weggelassen: das Teil hat nichts von dem, worauf sie verweist. Lassen Sie sie auf eine Fläche, eine Kante oder eine Ecke verweisen.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} is of a kind that is not understood and left out. Use a refinement zone instead.</source>
      <translation>Die Verfeinerung {zone:text} ist von einer Art, die nicht verstanden wird, und wird weggelassen. Nehmen Sie stattdessen eine Verfeinerungszone.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} is suppressed and left out.</source>
      <translation>Die Verfeinerung {zone:text} ist unterdrückt und wird weggelassen.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} lies outside the part. Move it into the part, or suppress it.</source>
      <translation>Die Verfeinerung {zone:text} liegt außerhalb des Teils. Verschieben Sie sie in das Teil, oder unterdrücken Sie sie.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} reaches {reach:length}; that must not be negative.</source>
      <translation>Die Verfeinerung {zone:text} reicht {reach:length} weit; das darf nicht negativ sein.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} refers to nothing and is left out. Choose faces, edges or vertices for it, or suppress it.</source>
      <translation>Die Verfeinerung {zone:text} verweist auf nichts und wird weggelassen. Wählen Sie Flächen, Kanten oder Ecken für sie, oder unterdrücken Sie sie.</translation>
    </message>
    <message>
      <source>The refinement {zone:text} with a size of {size:length} would make about {millions:count} million elements; at most {most:count} million are made. Choose a larger size there.</source>
      <translation>Die Verfeinerung {zone:text} mit einer Größe von {size:length} ergäbe etwa {millions:count} Millionen Elemente; höchstens {most:count} Millionen werden gemacht. Wählen Sie dort eine größere Größe.</translation>
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
      <translation>Die kleinste Netzgröße ist {smallest:length}; sie muss zwischen null und der Netzgröße von {size:length} liegen.</translation>
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
      <translation>Es sind zu wenige Fälle, um zu sagen, was wichtig ist; fügen Sie welche hinzu.</translation>
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
      <translation>Diese Flächen berühren oder schneiden sich, ohne Kanten zu teilen: {pairs:messages}. Jede Schale hat ein eigenes Netz, und zwischen ihnen wird keine Last übertragen. Ist das nicht gemeint, verbinden Sie sie (Part: Boolesche Fragmente).</translation>
    </message>
    <message>
      <source>These shells and beams lie inside a solid and share no nodes with it there: {places:messages}. No load passes between them. Divide the solid along them (Part: Boolean Fragments).</source>
      <translation>Diese Schalen und Balken liegen in einem Körper und haben dort keine Knoten mit ihm gemeinsam: {places:messages}. Zwischen ihnen wird keine Last übertragen. Teilen Sie den Körper an ihnen (Part: Boolesche Fragmente).</translation>
    </message>
    <message>
      <source>These solids touch or overlap without sharing faces: {solids:messages} ({faces:messages}). Each has a mesh of its own: no load passes between them but by ties and contacts, and where they overlap the material counts twice. If that is not meant, fuse them or join them (Part: Boolean Fragments).</source>
      <translation>Diese Körper berühren oder überlappen sich, ohne Flächen zu teilen: {solids:messages} ({faces:messages}). Jeder hat ein eigenes Netz: Zwischen ihnen geht außer durch Verbindungen (Tie) und Kontakte keine Last über, und wo sie sich überlappen, zählt das Material doppelt. Wenn das nicht gemeint ist, vereinigen oder verbinden (Part: Boolesche Fragmente).</translation>
    </message>
    <message>
      <source>Threads</source>
      <translation>Threads</translation>
    </message>
    <message>
      <source>Throws the mesh away and meshes the whole part</source>
      <translation>Wirft das Netz weg und vernetzt das ganze Bauteil</translation>
    </message>
    <message>
      <source>Tick what is to vary. A click on a sketch, a feature or a face shows its dimensions.</source>
      <translation>Haken Sie an, was sich ändern soll. Ein Klick auf eine Skizze, ein Feature oder eine Fläche zeigt deren Maße.</translation>
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
      <translation>Tornado</translation>
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
      <source>a MED file keeps its mesh under the file's own name, which may have %d characters at most; choose a shorter one than %s</source>
      <translation>eine MED-Datei führt ihr Netz unter dem Namen der Datei, der höchstens %d Zeichen haben darf; wählen Sie einen kürzeren als %s</translation>
    </message>
    <message>
      <source>a cut is x, y or z with =, &lt; or &gt; and a number, such as z=5, not %s</source>
      <translation>ein Schnitt ist x, y oder z mit =, &lt; oder &gt; und einer Zahl, etwa z=5, nicht %s</translation>
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
      <translation>eine lokale Größe ist für Flächen, Kanten oder Punkte; die Größe für das ganze Bauteil ist die des Netzes</translation>
    </message>
    <message>
      <source>a piece of the part that hangs on it by an edge, a vertex or not at all can still {how:messages}: add a support</source>
      <translation>ein Stück des Bauteils, das nur mit einer Kante, einer Ecke oder gar nicht an ihm hängt, kann sich noch {how:messages}: ein Lager hinzufügen</translation>
    </message>
    <message>
      <source>a refinement zone is one of %s, not %s</source>
      <translation>eine Verfeinerungszone ist eines von %s, nicht %s</translation>
    </message>
    <message>
      <source>a size of %g mm would make more than a million million elements; at most %d million are made. Choose a larger size</source>
      <translation>eine Größe von %g mm ergäbe mehr als eine Billion Elemente; höchstens %d Millionen werden gemacht. Wählen Sie eine größere Größe</translation>
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
      <source>a zone of the kind %s has no %s</source>
      <translation>eine Zone der Art %s hat kein %s</translation>
    </message>
    <message>
      <source>about %d million</source>
      <translation>etwa %d Millionen</translation>
    </message>
    <message>
      <source>about %s elements</source>
      <translation>etwa %s Elemente</translation>
    </message>
    <message>
      <source>active: %d nodes kept as start positions, free to move</source>
      <translation>aktiv: %d Knoten als Startlage behalten, beweglich</translation>
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
      <translation>alle Knoten, zwischen denen zu füllen ist, liegen in einer Ebene, bei {place:entities}; das Teil feiner vernetzen</translation>
    </message>
    <message>
      <source>and %d more, see the property Report</source>
      <translation>und %d weitere, siehe die Eigenschaft Report</translation>
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
      <source>around one face or edge at most %d million are made</source>
      <translation>um eine Fläche oder Kante werden höchstens %d Millionen gemacht</translation>
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
      <source>at most %d million are made</source>
      <translation>höchstens %d Millionen werden gemacht</translation>
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
      <translation>Grenze zweier Festkörper ohne Dreieck: {elements:messages}</translation>
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
      <source>cannot export to %s, only to %s</source>
      <translation>Ausgabe als %s ist nicht möglich, nur als %s</translation>
    </message>
    <message>
      <source>cannot read %s: %s</source>
      <translation>%s kann nicht gelesen werden: %s</translation>
    </message>
    <message>
      <source>cannot write %s: %s</source>
      <translation>%s kann nicht geschrieben werden: %s</translation>
    </message>
    <message>
      <source>case</source>
      <translation>Fall</translation>
    </message>
    <message>
      <source>change since the last result</source>
      <translation>Änderung zum letzten Mal</translation>
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
      <translation>Maß, wie es ist</translation>
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
      <translation>hat geendet</translation>
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
      <translation>es gibt die Fläche, die Kante oder den Festkörper nicht: {entries:messages}</translation>
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
      <translation>Feature</translation>
    </message>
    <message>
      <source>filling the solid</source>
      <translation>Festkörper füllen</translation>
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
      <translation>ganz neu vernetzt: {why:messages}</translation>
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
      <translation>Features verschneiden</translation>
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
      <translation>sein Volumen geht mit dem Teil nicht auf</translation>
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
      <translation>noch weniger zu behalten würde länger dauern, als das Teil neu zu vernetzen</translation>
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
      <source>kept: %d elements (%.1f %%)</source>
      <translation>behalten: %d Elemente (%.1f %%)</translation>
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
      <translation>größte Spannung (von Mises)</translation>
    </message>
    <message>
      <source>largest: %.4g %s on %s, node %d at (%.4g, %.4g, %.4g) mm; displacements drawn %g times</source>
      <translation>am größten: %.4g %s auf %s, Knoten %d bei (%.4g, %.4g, %.4g) mm; Verschiebungen %g-fach gezeichnet</translation>
    </message>
    <message>
      <source>least %s, mean %s, greatest %s;
%d of %d elements are beyond the limit</source>
      <translation>kleinster %s, Mittel %s, größter %s;
%d von %d Elementen liegen jenseits der Grenze</translation>
    </message>
    <message>
      <source>let the Addon Manager install %s, or type `%s`, or unpack FeatureMesh's portable zip into %s</source>
      <translation>lassen Sie den Addon-Manager %s installieren, oder tippen Sie `%s`, oder entpacken Sie das portable Zip von FeatureMesh in %s</translation>
    </message>
    <message>
      <source>live</source>
      <translation>live</translation>
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
      <translation>von Grund auf vernetzt: {why:messages}</translation>
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
      <source>new: %d elements</source>
      <translation>neu: %d Elemente</translation>
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
      <translation>nichts ist gefragt: haken Sie an, was jeder Fall sagen soll</translation>
    </message>
    <message>
      <source>nothing is varied: tick a dimension and give it a range</source>
      <translation>nichts ändert sich: haken Sie ein Maß an und geben Sie ihm einen Bereich</translation>
    </message>
    <message>
      <source>nothing yet: select faces, edges or vertices</source>
      <translation>noch nichts: wählen Sie Flächen, Kanten oder Ecken aus</translation>
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
      <translation>Lesen der Features von %s</translation>
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
      <source>select faces, edges or vertices of %s</source>
      <translation>wählen Sie Flächen, Kanten oder Ecken von %s</translation>
    </message>
    <message>
      <source>select faces, edges or vertices of %s%s</source>
      <translation>bitte Flächen, Kanten oder Punkte von %s auswählen%s</translation>
    </message>
    <message>
      <source>select solids, faces, edges or vertices of %s%s</source>
      <translation>bitte Körper, Flächen, Kanten oder Punkte von %s auswählen%s</translation>
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
      <translation>kleinster Winkel %.1f Grad, mittleres Radienverhältnis %.3f</translation>
    </message>
    <message>
      <source>smallest dihedral angle</source>
      <translation>kleinster Flächenwinkel</translation>
    </message>
    <message>
      <source>solids are filled with 4-node tetrahedra; the mesh given has mid-side nodes</source>
      <translation>Volumenkörper werden mit 4-Knoten-Tetraedern gefüllt; das gegebene Netz hat Seitenmittenknoten</translation>
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
      <source>taken from</source>
      <translation>entnommen aus</translation>
    </message>
    <message>
      <source>the analysis has no material: add one</source>
      <translation>die Analyse hat keinen Werkstoff: einen hinzufügen</translation>
    </message>
    <message>
      <source>the analysis {analysis:text} has no solver: add a CalculiX solver</source>
      <translation>die Analyse {analysis:text} hat keinen Löser: einen CalculiX-Löser hinzufügen</translation>
    </message>
    <message>
      <source>the analysis {analysis:text} has several solvers: leave one CalculiX solver in it</source>
      <translation>die Analyse {analysis:text} hat mehrere Löser: nur einen CalculiX-Löser darin lassen</translation>
    </message>
    <message>
      <source>the dimension is one of %s, not %s</source>
      <translation>die Dimension ist eine von %s, nicht %s</translation>
    </message>
    <message>
      <source>the document %s has no mesh%s; make one with `featuremesh mesh`</source>
      <translation>das Dokument %s hat kein Netz%s; bitte eines anlegen (`featuremesh mesh`)</translation>
    </message>
    <message>
      <source>the document %s has no solid to mesh</source>
      <translation>das Dokument %s hat keinen Festkörper, der vernetzt werden kann</translation>
    </message>
    <message>
      <source>the document has no object %s%s</source>
      <translation>das Dokument hat kein Objekt %s%s</translation>
    </message>
    <message>
      <source>the document has several meshes, select one or name it with --object: %s</source>
      <translation>das Dokument hat mehrere Netze, bitte eines auswählen oder mit --object angeben: %s</translation>
    </message>
    <message>
      <source>the document has several meshes, select the one to adopt: %s</source>
      <translation>das Dokument hat mehrere Netze, bitte das zu übernehmende auswählen: %s</translation>
    </message>
    <message>
      <source>the document has several solids, select one or name it with --object: %s</source>
      <translation>das Dokument hat mehrere Festkörper, bitte einen auswählen oder mit --object angeben: %s</translation>
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
      <source>the global size changed by more than 1.2 times</source>
      <translation>die globale Größe hat sich um mehr als das 1,2-Fache geändert</translation>
    </message>
    <message>
      <source>the inside</source>
      <translation>im Inneren</translation>
    </message>
    <message>
      <source>the kept elements overlap at node {node:count}; mesh the part from scratch</source>
      <translation>die behaltenen Elemente überlappen sich bei Knoten {node:count}; das Teil von Grund auf vernetzen</translation>
    </message>
    <message>
      <source>the live solver cannot tell which solid has which of the {materials:count} materials</source>
      <translation>der Live-Löser kann nicht erkennen, welcher Volumenkörper welchen der {materials:count} Werkstoffe hat</translation>
    </message>
    <message>
      <source>the live solver does not know the amplitude of {member:text}</source>
      <translation>der Live-Löser kennt die Amplitude von {member:text} nicht</translation>
    </message>
    <message>
      <source>the live solver does not know the formula of {member:text}</source>
      <translation>der Live-Löser kennt die Formel von {member:text} nicht</translation>
    </message>
    <message>
      <source>the live solver does not know {member:text} ({kind:text})</source>
      <translation>der Live-Löser kennt {member:text} ({kind:text}) nicht</translation>
    </message>
    <message>
      <source>the live solver knows forces on faces, on edges or on vertices, not {force:text}</source>
      <translation>der Live-Löser kennt Kräfte auf Flächen, auf Kanten oder auf Ecken, nicht {force:text}</translation>
    </message>
    <message>
      <source>the live solver knows linear statics only, and {solver:text} asks for {setting:text} = {value:text}</source>
      <translation>der Live-Löser kennt nur lineare Statik, und {solver:text} verlangt {setting:text} = {value:text}</translation>
    </message>
    <message>
      <source>the live solver knows pressure on faces only, not {pressure:text}</source>
      <translation>der Live-Löser kennt Druck nur auf Flächen, nicht {pressure:text}</translation>
    </message>
    <message>
      <source>the live solver knows solids only, not the fluid {material:text}</source>
      <translation>der Live-Löser kennt nur Festkörper, nicht die Flüssigkeit {material:text}</translation>
    </message>
    <message>
      <source>the live solver knows solids only; {mesh:text} is of shells or beams, which CalculiX solves</source>
      <translation>der Live-Löser kennt nur Volumenkörper; {mesh:text} ist aus Schalen oder Balken, die CalculiX löst</translation>
    </message>
    <message>
      <source>the live solver needs PETSc: install Debian's package libpetsc-real-dev, then any command of ./featuremesh in a clone builds the solver with it</source>
      <translation>der Live-Löser braucht PETSc: Debians Paket libpetsc-real-dev installieren, dann baut jeder Befehl von ./featuremesh in einem Klon den Löser damit</translation>
    </message>
    <message>
      <source>the live solver needs one mesh of FeatureMesh in the analysis {analysis:text}</source>
      <translation>der Live-Löser braucht genau ein Netz von FeatureMesh in der Analyse {analysis:text}</translation>
    </message>
    <message>
      <source>the material {material:text} has no readable Young's modulus or Poisson's ratio ({why:text})</source>
      <translation>der Werkstoff {material:text} hat keinen lesbaren Elastizitätsmodul oder keine lesbare Querkontraktionszahl ({why:text})</translation>
    </message>
    <message>
      <source>the material {material:text} is nearly incompressible (Poisson's ratio {poisson:number}), for which these elements are too stiff</source>
      <translation>der Werkstoff {material:text} ist fast inkompressibel (Querkontraktionszahl {poisson:number}), wofür diese Elemente zu steif sind</translation>
    </message>
    <message>
      <source>the mesh falls into more pieces than the live solver looks at</source>
      <translation>das Netz zerfällt in mehr Stücke, als der Live-Löser betrachtet</translation>
    </message>
    <message>
      <source>the mesh of a copy is one of %s, not %s</source>
      <translation>das Netz einer Kopie ist eines von %s, nicht %s</translation>
    </message>
    <message>
      <source>the mesh of edges has segments only, which have no shape to judge and nothing to colour</source>
      <translation>das Netz aus Kanten hat nur Balkenelemente, die keine Form haben, die man beurteilen oder einfärben könnte</translation>
    </message>
    <message>
      <source>the new mesh's state cannot be stored (%s), the old mesh stays; is the disk full?</source>
      <translation>der Zustand des neuen Netzes kann nicht gespeichert werden (%s), das alte Netz bleibt; ist die Platte voll?</translation>
    </message>
    <message>
      <source>the number of elements along the part has to be greater than 0, not %s</source>
      <translation>die Zahl der Elemente entlang des Bauteils muss größer als 0 sein, nicht %s</translation>
    </message>
    <message>
      <source>the object is gone: it was deleted, or its document was closed</source>
      <translation>das Objekt gibt es nicht mehr: es wurde gelöscht, oder sein Dokument wurde geschlossen</translation>
    </message>
    <message>
      <source>the order is 1 (4-node) or 2 (10-node), not %s</source>
      <translation>die Ordnung ist 1 (4 Knoten) oder 2 (10 Knoten), nicht %s</translation>
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
      <source>the picture could not be drawn: %s</source>
      <translation>das Bild konnte nicht gezeichnet werden: %s</translation>
    </message>
    <message>
      <source>the property QualityTarget of %s has to lie between 0 and %g degrees, not %g</source>
      <translation>die Eigenschaft QualityTarget von %s muss zwischen 0 und %g Grad liegen, nicht %g</translation>
    </message>
    <message>
      <source>the range of %s has to be two numbers, such as 3 : 5</source>
      <translation>der Bereich von %s muss aus zwei Zahlen bestehen, etwa 3 : 5</translation>
    </message>
    <message>
      <source>the range of %s has to rise</source>
      <translation>der Bereich von %s muss steigen</translation>
    </message>
    <message>
      <source>the refinement %s refers to %s, which is not on %s; refer to faces of that one</source>
      <translation>die Verfeinerung %s verweist auf %s, das nicht zu %s gehört; bitte auf dessen Flächen verweisen</translation>
    </message>
    <message>
      <source>the refinement %s with %g mm at %s would make %s elements; %s. Choose a larger size there</source>
      <translation>die Verfeinerung %s mit %g mm an %s ergäbe %s Elemente; %s. Wählen Sie dort eine größere Größe</translation>
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
      <source>the saved mesh state is damaged ({why:text})</source>
      <translation>der gespeicherte Netzzustand ist beschädigt ({why:text})</translation>
    </message>
    <message>
      <source>the saved mesh state is from a newer FeatureMesh ({program:text}, schema {schema:count}; this one reads up to {newest:count})</source>
      <translation>der gespeicherte Netzzustand ist von einem neueren FeatureMesh ({program:text}, Schema {schema:count}; dieses liest bis {newest:count})</translation>
    </message>
    <message>
      <source>the settings of %s cannot be opened; close the open panel first</source>
      <translation>Die Einstellungen von %s lassen sich nicht öffnen; schließen Sie erst das offene Fenster</translation>
    </message>
    <message>
      <source>the shape touches itself: nodes of {faces:entities} lie in the same place, such as {place:point}; repair it there (Part: Check geometry)</source>
      <translation>die Form berührt sich selbst: Knoten von {faces:entities} liegen an derselben Stelle, etwa bei {place:point}; dort reparieren (Part: Geometrie prüfen)</translation>
    </message>
    <message>
      <source>the size %g mm is larger than the part (%g mm across); try %g mm</source>
      <translation>die Größe %g mm ist größer als das Bauteil (%g mm Diagonale); Vorschlag: %g mm</translation>
    </message>
    <message>
      <source>the size has to be greater than 0 mm, not %g</source>
      <translation>die Größe muss größer als 0 mm sein, nicht %g</translation>
    </message>
    <message>
      <source>the solids of the final shape overlap by {overlap:volume}; fuse them or mesh them one by one</source>
      <translation>Die Körper der endgültigen Form überlappen sich um {overlap:volume}; vereinigen oder einzeln vernetzen</translation>
    </message>
    <message>
      <source>the stresses of shells and beams are those in the middle of the thickness, where bending makes none; switch BeamShellResultOutput3D of {solver:text} on for those on the outside</source>
      <translation>die Spannungen von Schalen und Balken sind die in der Mitte der Dicke, wo Biegung keine macht; für die außen BeamShellResultOutput3D von {solver:text} einschalten</translation>
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
      <source>the two limits of %s have to differ</source>
      <translation>die beiden Grenzen von %s müssen verschieden sein</translation>
    </message>
    <message>
      <source>the two parts look unrelated: they have no feature name in common</source>
      <translation>die beiden Bauteile haben nichts miteinander zu tun: kein Name eines Formelements ist gemeinsam</translation>
    </message>
    <message>
      <source>the two states of the part cannot be compared ({why:text}); check the geometry of the new shape, or mesh it from scratch</source>
      <translation>die beiden Zustände des Teils können nicht verglichen werden ({why:text}); die Geometrie der neuen Form prüfen, oder sie von Grund auf vernetzen</translation>
    </message>
    <message>
      <source>the volume mesh cannot be made to meet the triangles of {faces:entities}; mesh finer there, or check the shape for faces that cut or touch one another</source>
      <translation>das Volumennetz lässt sich nicht an die Dreiecke von {faces:entities} anschließen; dort feiner vernetzen, oder die Form auf Flächen prüfen, die einander schneiden oder berühren</translation>
    </message>
    <message>
      <source>there is no measure %s, only %s</source>
      <translation>es gibt kein Maß %s, nur %s</translation>
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
      <translation>Spannung (von Mises)</translation>
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
      <translation>Spannungen ausrechnen</translation>
    </message>
    <message>
      <source>wrong count of corner nodes: {count:messages}</source>
      <translation>falsche Anzahl an Eckknoten: {count:messages}</translation>
    </message>
    <message>
      <source>wrong solid at a triangle: {triangles:messages}</source>
      <translation>falscher Festkörper an einem Dreieck: {triangles:messages}</translation>
    </message>
    <message>
      <source>z88 has no 3-node triangles; mesh with 6-node triangles, or export it as inp, vtu, vtk, msh, unv or med</source>
      <translation>z88 kennt keine Dreiecke mit 3 Knoten; vernetzen Sie mit Dreiecken mit 6 Knoten oder exportieren Sie als inp, vtu, vtk, msh, unv oder med</translation>
    </message>
    <message>
      <source>{anew:count} of {all:count} elements do not fit the part and were made anew: {reasons:messages}</source>
      <translation>{anew:count} von {all:count} Elementen passen nicht zum Bauteil und wurden neu gemacht: {reasons:messages}</translation>
    </message>
    <message>
      <source>{array:text} has {entries:count} entries, not {wanted:count}</source>
      <translation>{array:text} hat {entries:count} Einträge, nicht {wanted:count}</translation>
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
      <source>{elements:count} 10-node tetrahedra would be folded near {place:entities}: the face bends too much within one element. Ask for a smaller size there, or for 4-node tetrahedra.</source>
      <translation>{elements:count} Tetraeder mit 10 Knoten wären gefaltet, bei {place:entities}: die Fläche biegt sich innerhalb eines Elements zu stark. Dort eine kleinere Größe wählen, oder Tetraeder mit 4 Knoten.</translation>
    </message>
    <message>
      <source>{elements:count} 6-node triangles would be folded near {place:entities}: the face bends too much within one element. Ask for a smaller size there, or for 3-node triangles.</source>
      <translation>{elements:count} Dreiecke mit 6 Knoten wären bei {place:entities} gefaltet: Die Fläche biegt sich innerhalb eines Elements zu stark. Verlangen Sie dort eine kleinere Größe oder Dreiecke mit 3 Knoten.</translation>
    </message>
    <message>
      <source>{elements:count} elements are inverted, flat or folded</source>
      <translation>{elements:count} Elemente sind umgestülpt, flach oder gefaltet</translation>
    </message>
    <message>
      <source>{elements:count} elements are outside the part</source>
      <translation>{elements:count} Elemente liegen außerhalb des Teils</translation>
    </message>
    <message>
      <source>{elements:count} elements without a volume to speak of remain at {faces:entities} beside {edges:messages}; mesh finer there, or take out what is much smaller than the rest of the part</source>
      <translation>{elements:count} Elemente ohne nennenswertes Volumen bleiben bei {faces:entities} neben {edges:messages}; dort feiner vernetzen, oder herausnehmen, was viel kleiner als das übrige Teil ist</translation>
    </message>
    <message>
      <source>{elements:count} elements without a volume to speak of remain at {faces:entities}; mesh finer there, or take out what is much smaller than the rest of the part</source>
      <translation>{elements:count} Elemente fast ohne Volumen bleiben bei {faces:entities}; dort feiner vernetzen, oder weglassen, was viel kleiner als der Rest des Bauteils ist</translation>
    </message>
    <message>
      <source>{face:entities} cannot be filled: {why:messages}. Mesh the part from scratch.</source>
      <translation>{face:entities} kann nicht gefüllt werden: {why:messages}. Das Bauteil von Grund auf vernetzen.</translation>
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
      <source>{feature:text}: its link to {object:text} dangles</source>
      <translation>{feature:text}: der Verweis auf {object:text} führt ins Leere</translation>
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
      <translation>{member:text} bezieht sich auf nichts: Flächen, Kanten oder Ecken dafür wählen</translation>
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
      <source>{nodes:count} boundary nodes are off the surface</source>
      <translation>{nodes:count} Randknoten liegen abseits der Oberfläche</translation>
    </message>
    <message>
      <source>{nodes:count} mid-side nodes were off the surface and are new, on it</source>
      <translation>{nodes:count} Mittelknoten lagen neben der Oberfläche und sind neu, auf ihr</translation>
    </message>
    <message>
      <source>{object:text} could not be followed from the last mesh, whose state is gone; check what it refers to</source>
      <translation>{object:text} konnte nicht vom letzten Netz her verfolgt werden, dessen Zustand fehlt; prüfen Sie, worauf es sich bezieht</translation>
    </message>
    <message>
      <source>{object:text} has no edge. Recompute the document, and mesh an object with edges.</source>
      <translation>{object:text} hat keine Kante. Berechnen Sie das Dokument neu und vernetzen Sie ein Objekt mit Kanten.</translation>
    </message>
    <message>
      <source>{object:text} has no face. Recompute the document, and mesh an object with faces, or its edges.</source>
      <translation>{object:text} hat keine Fläche. Berechnen Sie das Dokument neu und vernetzen Sie ein Objekt mit Flächen oder seine Kanten.</translation>
    </message>
    <message>
      <source>{object:text} has no solid. Recompute the document, and mesh a body or a Part object whose result is a solid.</source>
      <translation>{object:text} hat keinen Volumenkörper. Das Dokument neu berechnen und einen Körper oder ein Part-Objekt vernetzen, dessen Ergebnis ein Volumenkörper ist.</translation>
    </message>
    <message>
      <source>{object:text} refers to {lost:entities}, which is gone; choose another edge, the analysis cannot be solved without</source>
      <translation>{object:text} bezieht sich auf {lost:entities}, das es nicht mehr gibt; wählen Sie eine andere Kante, ohne lässt sich die Analyse nicht rechnen</translation>
    </message>
    <message>
      <source>{object:text} refers to {lost:entities}, which is gone; choose another face, the analysis cannot be solved without</source>
      <translation>{object:text} bezieht sich auf {lost:entities}, das es nicht mehr gibt; wählen Sie eine andere Fläche, ohne lässt sich die Analyse nicht rechnen</translation>
    </message>
    <message>
      <source>{object:text} refers to {lost:entities}, which is gone; choose another solid, the analysis cannot be solved without</source>
      <translation>{object:text} bezieht sich auf {lost:entities}, das es nicht mehr gibt; wählen Sie einen anderen Körper, ohne lässt sich die Analyse nicht rechnen</translation>
    </message>
    <message>
      <source>{object:text} refers to {lost:entities}, which is gone; choose another vertex, the analysis cannot be solved without</source>
      <translation>{object:text} bezieht sich auf {lost:entities}, das es nicht mehr gibt; wählen Sie einen anderen Punkt, ohne lässt sich die Analyse nicht rechnen</translation>
    </message>
    <message>
      <source>{object:text} refers to {lost:entities}, which is gone; it was taken out of the references</source>
      <translation>{object:text} bezieht sich auf {lost:entities}, das es nicht mehr gibt; es wurde aus den Referenzen genommen</translation>
    </message>
    <message>
      <source>{object:text} refers to {where:entities}, which is not on the meshed part {part:text} and has no nodes in its mesh; choose faces, edges or vertices of {part:text} instead</source>
      <translation>{object:text} bezieht sich auf {where:entities}, das nicht am vernetzten Teil {part:text} liegt und in dessen Netz keine Knoten hat; stattdessen Flächen, Kanten oder Punkte von {part:text} wählen</translation>
    </message>
    <message>
      <source>{object:text}: {before:entities} is now {now:entities}, its reference was changed</source>
      <translation>{object:text}: {before:entities} ist jetzt {now:entities}, der Verweis wurde geändert</translation>
    </message>
    <message>
      <source>{object:text}: {before:entities} was split into {now:entities}, it is on all of them now</source>
      <translation>{object:text}: {before:entities} wurde in {now:entities} geteilt, es gilt jetzt auf allen</translation>
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
      <source>{pressure:text} presses on {face:entities}, which lies between two solids</source>
      <translation>{pressure:text} drückt auf {face:entities}, die zwischen zwei Volumenkörpern liegt</translation>
    </message>
    <message>
      <source>{sides:count} sides between faces follow no edge</source>
      <translation>{sides:count} Seiten zwischen Flächen folgen keiner Kante</translation>
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
      <source>{support:text} gives nodes another displacement than a support before it</source>
      <translation>{support:text} gibt Knoten eine andere Verschiebung als ein Lager davor</translation>
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
      <source>{triangles:count} boundary triangles lie on no face</source>
      <translation>{triangles:count} Randdreiecke liegen auf keiner Fläche</translation>
    </message>
    <message>
      <source>{triangles:count} triangles have elements that overlap</source>
      <translation>{triangles:count} Dreiecke haben Elemente, die sich überlappen</translation>
    </message>
    <message>
      <source>{values:count} values do not fit the {nodes:count} nodes of the old mesh.</source>
      <translation>{values:count} Werte passen nicht zu den {nodes:count} Knoten des alten Netzes.</translation>
    </message>
    <message>
      <source>{weight:text} has no direction</source>
      <translation>{weight:text} hat keine Richtung</translation>
    </message>
    <message>
      <source>{weight:text} needs the density of every material</source>
      <translation>{weight:text} braucht die Dichte jedes Werkstoffs</translation>
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
      <translation>Macht aus den ausgewählten Körpern, Flächen, Kanten oder Punkten eine benannte Gruppe von Knoten und Elementen, die sich in FEMs Fenster für Netzgruppen ändern lässt</translation>
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
      <translation>Gibt den ausgewählten Flächen, Kanten oder Punkten die halbe Netzgröße, änderbar im Fenster der FEM-Netzverfeinerung</translation>
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
      <translation>Macht Elemente in einem Quader, einer Kugel oder einem Zylinder kleiner, oder nahe den ausgewählten Flächen, Kanten oder Ecken</translation>
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
      <translation>Sagt Feature für Feature, was sich zwischen einem gespeicherten Dokument und dem ausgewählten Bauteil geändert hat</translation>
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
      <translation>Fügt ein Netz hinzu, das dem ausgewählten Teil (oder dem einzigen) oder allen Teilen des ausgewählten Containers folgt, und öffnet seine Einstellungen</translation>
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
      <translation>Listet die Features des ausgewählten Bauteils, wie der Vernetzer sie versteht</translation>
    </message>
    <message>
      <source>Show the feature tree</source>
      <translation>Feature-Baum zeigen</translation>
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
      <translation>Ändert Maße des Teils, vernetzt und löst jede Variante und zeigt, was wichtig ist</translation>
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

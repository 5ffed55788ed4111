<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>App::Property</name>
    <message>
      <source>1 / √(points per mm²) of what remains, where the cloud is denser</source>
      <translation>1 / √(Punkte je mm²) dessen, was bleibt, wo die Punktwolke dichter ist</translation>
    </message>
    <message>
      <source>A place near one of the edges</source>
      <translation>Eine Stelle nahe einer der Kanten</translation>
    </message>
    <message>
      <source>A place on the face between the network's edges</source>
      <translation>Eine Stelle auf der Fläche zwischen den Kanten des Netzes</translation>
    </message>
    <message>
      <source>A place on the face, beside that edge</source>
      <translation>Eine Stelle auf der Fläche, neben dieser Kante</translation>
    </message>
    <message>
      <source>A point on each edge that is kept all the same</source>
      <translation>Ein Punkt auf jeder Kante, die trotzdem behalten wird</translation>
    </message>
    <message>
      <source>A point on each edge that is left out by hand</source>
      <translation>Ein Punkt auf jeder Kante, die von Hand weggelassen wird</translation>
    </message>
    <message>
      <source>A point on each of the edges, in any order</source>
      <translation>Ein Punkt auf jeder der Kanten, in beliebiger Reihenfolge</translation>
    </message>
    <message>
      <source>A surface or any other shape with faces</source>
      <translation>Eine Fläche oder eine beliebige andere Form mit Flächen</translation>
    </message>
    <message>
      <source>Add this to the document's coordinates to get those of the cloud's source</source>
      <translation>Zu den Koordinaten des Dokuments addiert, ergibt dies die der Quelle der Punktwolke</translation>
    </message>
    <message>
      <source>Add this to the document's coordinates to get those of the file; a cloud far from the origin would lose its precision otherwise</source>
      <translation>Zu den Koordinaten des Dokuments addiert, ergibt dies die der Datei; eine Punktwolke fern vom Ursprung verlöre sonst ihre Genauigkeit</translation>
    </message>
    <message>
      <source>Always 0: the points lie on the part's surface</source>
      <translation>Immer 0: Die Punkte liegen auf der Oberfläche des Teils</translation>
    </message>
    <message>
      <source>Amplitude that was used</source>
      <translation>Verwendete Amplitude</translation>
    </message>
    <message>
      <source>Angle between the two sides at the edge points, rad</source>
      <translation>Winkel zwischen den beiden Seiten an den Kantenpunkten, rad</translation>
    </message>
    <message>
      <source>Another rail: the profile runs from rail to rail</source>
      <translation>Eine andere Leitkurve: Das Profil reicht von Leitkurve zu Leitkurve</translation>
    </message>
    <message>
      <source>Approach that was used</source>
      <translation>Verwendete Antastrichtung</translation>
    </message>
    <message>
      <source>ChordHeight that was used</source>
      <translation>Verwendete Sehnenhöhe</translation>
    </message>
    <message>
      <source>Cloud or segment the surface is fitted to</source>
      <translation>Punktwolke oder Segment, an das die Fläche angepasst wird</translation>
    </message>
    <message>
      <source>Cloud or segment the sweep is fitted to, or nothing</source>
      <translation>Punktwolke oder Segment, an das der Sweep angepasst wird, oder nichts</translation>
    </message>
    <message>
      <source>CloudPitch that was used</source>
      <translation>Verwendeter Punktabstand der Punktwolke</translation>
    </message>
    <message>
      <source>Compensation that was used</source>
      <translation>Verwendete Tasterkorrektur</translation>
    </message>
    <message>
      <source>Control points in u; 0: as many as Tolerance asks for</source>
      <translation>Kontrollpunkte in u; 0: so viele, wie Tolerance verlangt</translation>
    </message>
    <message>
      <source>Control points in v; 0: as many as Tolerance asks for</source>
      <translation>Kontrollpunkte in v; 0: so viele, wie Tolerance verlangt</translation>
    </message>
    <message>
      <source>Control points of each fitted profile</source>
      <translation>Kontrollpunkte jedes angepassten Profils</translation>
    </message>
    <message>
      <source>Control points of each fitted rail</source>
      <translation>Kontrollpunkte jeder angepassten Leitkurve</translation>
    </message>
    <message>
      <source>Covariance across the edge as (aa, ab, bb), mm²; axes n1 + n2 and n1 - n2</source>
      <translation>Kovarianz quer zur Kante als (aa, ab, bb), mm²; Achsen n1 + n2 und n1 - n2</translation>
    </message>
    <message>
      <source>Curves from the first rail to the second, in order</source>
      <translation>Kurven von der ersten Leitkurve zur zweiten, der Reihe nach</translation>
    </message>
    <message>
      <source>Degree in u</source>
      <translation>Grad in u</translation>
    </message>
    <message>
      <source>Degree in v</source>
      <translation>Grad in v</translation>
    </message>
    <message>
      <source>Degree of a line section, 1 to 3; 0: automatic</source>
      <translation>Grad eines Linienschnitts, 1 bis 3; 0: automatisch</translation>
    </message>
    <message>
      <source>Degree that was used</source>
      <translation>Verwendeter Grad</translation>
    </message>
    <message>
      <source>Deviation of the strongest colours</source>
      <translation>Abweichung der kräftigsten Farben</translation>
    </message>
    <message>
      <source>Deviation of the strongest colours; 0: 99.5 % of all deviations are below</source>
      <translation>Abweichung der kräftigsten Farben; 0: 99,5 % aller Abweichungen liegen darunter</translation>
    </message>
    <message>
      <source>Direction of the first scan line, across the edge; (0, 0, 0): At is a click near the edge</source>
      <translation>Richtung der ersten Abtastlinie, quer zur Kante; (0, 0, 0): At ist ein Klick nahe der Kante</translation>
    </message>
    <message>
      <source>Direction of the gate line, across the edge; (0, 0, 0): the gate is a point</source>
      <translation>Richtung der Ziellinie, quer zur Kante; (0, 0, 0): Das Ziel ist ein Punkt</translation>
    </message>
    <message>
      <source>Direction of the walk along the edge; used with Across</source>
      <translation>Richtung des Wegs entlang der Kante; gilt zusammen mit Across</translation>
    </message>
    <message>
      <source>Direction the probe came along; (0, 0, 0): not known</source>
      <translation>Richtung, in der der Taster kam; (0, 0, 0): nicht bekannt</translation>
    </message>
    <message>
      <source>Direction the probe came along; (0, 0, 0): that of the cloud</source>
      <translation>Richtung, in der der Taster kam; (0, 0, 0): die der Punktwolke</translation>
    </message>
    <message>
      <source>Direction the probe came along; the air lies against it. (0, 0, 0): not known</source>
      <translation>Richtung, in der der Taster kam; die Luft liegt ihr entgegen. (0, 0, 0): nicht bekannt</translation>
    </message>
    <message>
      <source>Distance of the edge points; 0: automatic</source>
      <translation>Abstand der Kantenpunkte; 0: automatisch</translation>
    </message>
    <message>
      <source>Distance of the points on a probed scan line; 0: automatic</source>
      <translation>Abstand der Punkte auf einer Abtastlinie; 0: automatisch</translation>
    </message>
    <message>
      <source>Edge points of all edges, document coordinates</source>
      <translation>Kantenpunkte aller Kanten, Koordinaten des Dokuments</translation>
    </message>
    <message>
      <source>Edge points, document coordinates</source>
      <translation>Kantenpunkte, Koordinaten des Dokuments</translation>
    </message>
    <message>
      <source>EdgePitch that was used</source>
      <translation>Verwendeter Abstand der Kantenpunkte</translation>
    </message>
    <message>
      <source>Edges at which surfaces end where no other is</source>
      <translation>Kanten, an denen Flächen enden, wo keine andere ist</translation>
    </message>
    <message>
      <source>Edges known worse than that are left out; 0: none</source>
      <translation>Kanten, die ungenauer bekannt sind, werden weggelassen; 0: keine</translation>
    </message>
    <message>
      <source>False where the point rests on its neighbours: a gap, or too little of a side is smooth</source>
      <translation>Falsch, wo der Punkt auf seinen Nachbarn beruht: eine Lücke, oder zu wenig einer Seite ist glatt</translation>
    </message>
    <message>
      <source>File the cloud was read from</source>
      <translation>Datei, aus der die Punktwolke gelesen wurde</translation>
    </message>
    <message>
      <source>From its beginning to its end</source>
      <translation>Von seinem Anfang bis zu seinem Ende</translation>
    </message>
    <message>
      <source>How a probed scan finds the direction of the edge</source>
      <translation>Wie eine linienweise Abtastung die Richtung der Kante findet</translation>
    </message>
    <message>
      <source>How a probed scan places its next scan line</source>
      <translation>Wie eine linienweise Abtastung ihre nächste Linie legt</translation>
    </message>
    <message>
      <source>How a probed scan takes off the probe radius</source>
      <translation>Wie eine linienweise Abtastung den Tasterradius abzieht</translation>
    </message>
    <message>
      <source>How a profile changes: blend moves and blends it, rotate turns it with the rails, better is the one that explains the cloud better (rotate without a cloud)</source>
      <translation>Wie sich ein Profil ändert: blend bewegt und überblendet es, rotate dreht es mit den Leitkurven, better ist, was die Punktwolke besser erklärt (ohne Punktwolke rotate)</translation>
    </message>
    <message>
      <source>How edge points are found: patch uses all the points on both sides, probe touches the cloud line by line like a measuring machine</source>
      <translation>Wie Kantenpunkte gefunden werden: patch verwendet alle Punkte beider Seiten, probe tastet die Punktwolke Linie für Linie ab wie eine Messmaschine</translation>
    </message>
    <message>
      <source>How far a profile may end beside its rail</source>
      <translation>Wie weit ein Profil neben seiner Leitkurve enden darf</translation>
    </message>
    <message>
      <source>How far from the rail the section goes; 0: automatic</source>
      <translation>Wie weit der Schnitt von der Leitkurve reicht; 0: automatisch</translation>
    </message>
    <message>
      <source>How far the edges' own vertices are from each corner, mm</source>
      <translation>Wie weit die eigenen Endpunkte der Kanten von jeder Ecke entfernt sind, mm</translation>
    </message>
    <message>
      <source>How the probe radius was taken off each edge point</source>
      <translation>Wie der Tasterradius von jedem Kantenpunkt abgezogen wurde</translation>
    </message>
    <message>
      <source>How the profile is kept from turning</source>
      <translation>Wie das Profil am Verdrehen gehindert wird</translation>
    </message>
    <message>
      <source>How the scan lines of a probed scan follow each other</source>
      <translation>Wie die Linien einer linienweisen Abtastung aufeinander folgen</translation>
    </message>
    <message>
      <source>Inputs the result belongs to</source>
      <translation>Eingaben, zu denen das Ergebnis gehört</translation>
    </message>
    <message>
      <source>Largest absolute deviation</source>
      <translation>Größte absolute Abweichung</translation>
    </message>
    <message>
      <source>Largest absolute deviation of a point from the profile</source>
      <translation>Größte absolute Abweichung eines Punkts vom Profil</translation>
    </message>
    <message>
      <source>Largest absolute deviation of a point from the surface</source>
      <translation>Größte absolute Abweichung eines Punkts von der Fläche</translation>
    </message>
    <message>
      <source>Largest deviation of the chord between two edge points; 0: automatic</source>
      <translation>Größte Abweichung der Sehne zwischen zwei Kantenpunkten; 0: automatisch</translation>
    </message>
    <message>
      <source>Largest standard deviation of an edge point</source>
      <translation>Größte Standardabweichung eines Kantenpunkts</translation>
    </message>
    <message>
      <source>Least turn between the two sides of an edge</source>
      <translation>Kleinster Knick zwischen den beiden Seiten einer Kante</translation>
    </message>
    <message>
      <source>Least turn between the two sides of an edge; 0: automatic</source>
      <translation>Kleinster Knick zwischen den beiden Seiten einer Kante; 0: automatisch</translation>
    </message>
    <message>
      <source>Least turn between two sides; 0: automatic</source>
      <translation>Kleinster Knick zwischen zwei Seiten; 0: automatisch</translation>
    </message>
    <message>
      <source>Length of a scan line along the surface, half on each side; 0: automatic</source>
      <translation>Länge einer Abtastlinie entlang der Oberfläche, zur Hälfte auf jeder Seite; 0: automatisch</translation>
    </message>
    <message>
      <source>Length of all curves</source>
      <translation>Länge aller Kurven</translation>
    </message>
    <message>
      <source>Length of all edges</source>
      <translation>Länge aller Kanten</translation>
    </message>
    <message>
      <source>Length of the edge</source>
      <translation>Länge der Kante</translation>
    </message>
    <message>
      <source>LinePitch that was used</source>
      <translation>Verwendeter Abstand der Punkte einer Linie</translation>
    </message>
    <message>
      <source>Mean absolute deviation</source>
      <translation>Mittlere absolute Abweichung</translation>
    </message>
    <message>
      <source>Mean absolute deviation of the points from the profile</source>
      <translation>Mittlere absolute Abweichung der Punkte vom Profil</translation>
    </message>
    <message>
      <source>Mean absolute deviation of the points from the surface</source>
      <translation>Mittlere absolute Abweichung der Punkte von der Fläche</translation>
    </message>
    <message>
      <source>Mean angle between the two sides</source>
      <translation>Mittlerer Winkel zwischen den beiden Seiten</translation>
    </message>
    <message>
      <source>Mean deviation, signed</source>
      <translation>Mittlere Abweichung mit Vorzeichen</translation>
    </message>
    <message>
      <source>Mean standard deviation of the edge points</source>
      <translation>Mittlere Standardabweichung der Kantenpunkte</translation>
    </message>
    <message>
      <source>Median angle between the two sides of each edge, degrees</source>
      <translation>Median des Winkels zwischen den beiden Seiten jeder Kante, Grad</translation>
    </message>
    <message>
      <source>Median radius of the rounding; 0: none is measurable</source>
      <translation>Median des Radius der Verrundung; 0: keine ist messbar</translation>
    </message>
    <message>
      <source>Median standard deviation of each edge, mm</source>
      <translation>Median der Standardabweichung jeder Kante, mm</translation>
    </message>
    <message>
      <source>Number of corners in which edges meet</source>
      <translation>Anzahl der Ecken, in denen Kanten zusammentreffen</translation>
    </message>
    <message>
      <source>Number of curves</source>
      <translation>Anzahl der Kurven</translation>
    </message>
    <message>
      <source>Number of edge points</source>
      <translation>Anzahl der Kantenpunkte</translation>
    </message>
    <message>
      <source>Number of edges</source>
      <translation>Anzahl der Kanten</translation>
    </message>
    <message>
      <source>Number of faces</source>
      <translation>Anzahl der Flächen</translation>
    </message>
    <message>
      <source>Number of points</source>
      <translation>Anzahl der Punkte</translation>
    </message>
    <message>
      <source>Number of points beyond the surface's rim, left out</source>
      <translation>Anzahl der Punkte jenseits des Flächenrands, die weggelassen wurden</translation>
    </message>
    <message>
      <source>Number of points of the section</source>
      <translation>Anzahl der Punkte des Schnitts</translation>
    </message>
    <message>
      <source>Number of points that were measured</source>
      <translation>Anzahl der gemessenen Punkte</translation>
    </message>
    <message>
      <source>Number of points the surface was fitted to; 0: to none</source>
      <translation>Anzahl der Punkte, an die die Fläche angepasst wurde; 0: an keine</translation>
    </message>
    <message>
      <source>Numbers of points in equal steps from -Limit to Limit</source>
      <translation>Anzahlen der Punkte in gleichen Schritten von -Limit bis Limit</translation>
    </message>
    <message>
      <source>Of all edges</source>
      <translation>Aller Kanten</translation>
    </message>
    <message>
      <source>Of all faces</source>
      <translation>Aller Flächen</translation>
    </message>
    <message>
      <source>Of an edge; 0: eight times the cloud's pitch</source>
      <translation>Einer Kante; 0: das Achtfache des Punktabstands</translation>
    </message>
    <message>
      <source>Of each edge: the corners it ends in, or why it ends</source>
      <translation>Jeder Kante: die Ecken, in denen sie endet, oder warum sie endet</translation>
    </message>
    <message>
      <source>Of each point</source>
      <translation>Jedes Punkts</translation>
    </message>
    <message>
      <source>Of each point, mm, positive on the normal's side</source>
      <translation>Jedes Punkts, mm, positiv auf der Seite der Normalen</translation>
    </message>
    <message>
      <source>Of the curves from both surfaces</source>
      <translation>Der Kurven von beiden Flächen</translation>
    </message>
    <message>
      <source>Of the slab of points; 0: automatic</source>
      <translation>Der Scheibe von Punkten; 0: automatisch</translation>
    </message>
    <message>
      <source>Of the surface from the base surface, at most</source>
      <translation>Der Oberfläche von der Grundfläche, höchstens</translation>
    </message>
    <message>
      <source>Of the surface from the exact sweep, without a cloud</source>
      <translation>Der Fläche vom exakten Sweep, ohne Punktwolke</translation>
    </message>
    <message>
      <source>One or two curves along which profiles move</source>
      <translation>Eine oder zwei Kurven, an denen Profile entlanglaufen</translation>
    </message>
    <message>
      <source>One point for each pitch² of surface</source>
      <translation>Ein Punkt je Punktabstand² Oberfläche</translation>
    </message>
    <message>
      <source>Over which side: at the first (0) or last (1) parameter in u or v</source>
      <translation>Über welche Seite: am ersten (0) oder letzten (1) Parameter in u oder v</translation>
    </message>
    <message>
      <source>Parameter range of the extension, as a share of that of the surface</source>
      <translation>Parameterbereich der Verlängerung als Anteil desjenigen der Fläche</translation>
    </message>
    <message>
      <source>Pattern that was used</source>
      <translation>Verwendetes Muster</translation>
    </message>
    <message>
      <source>Pitch that tells a gap from surface in a probed scan; 0: automatic</source>
      <translation>Punktabstand, der bei linienweiser Abtastung Lücken von Oberfläche unterscheidet; 0: automatisch</translation>
    </message>
    <message>
      <source>Points farther from the shape are left out; 0: none is</source>
      <translation>Punkte, die weiter von der Form weg sind, werden weggelassen; 0: keine</translation>
    </message>
    <message>
      <source>Points of a whole cloud nearer than this to the base surface belong to it; all of a segment do</source>
      <translation>Punkte einer ganzen Punktwolke, die der Grundfläche näher sind, gehören dazu; von einem Segment alle</translation>
    </message>
    <message>
      <source>Points of a whole cloud nearer than this to the sweep belong to it; all of a segment do</source>
      <translation>Punkte einer ganzen Punktwolke, die dem Sweep näher sind, gehören dazu; von einem Segment alle</translation>
    </message>
    <message>
      <source>Points of the source that were left out because they hold nan or inf</source>
      <translation>Punkte der Quelle, die weggelassen wurden, weil sie nan oder inf enthalten</translation>
    </message>
    <message>
      <source>Prehit distance of the measuring machine; 0: automatic</source>
      <translation>Antastabstand der Messmaschine; 0: automatisch</translation>
    </message>
    <message>
      <source>PrehitDistance that was used</source>
      <translation>Verwendeter Antastabstand</translation>
    </message>
    <message>
      <source>ProbeRadius that was used</source>
      <translation>Verwendeter Tasterradius</translation>
    </message>
    <message>
      <source>Radius of an arc; 0: it is none</source>
      <translation>Radius eines Bogens; 0: Es ist keiner</translation>
    </message>
    <message>
      <source>Radius of the ball whose centres the cloud holds. Without OwnProbeRadius it is the cloud's and cannot be edited here: set it at the cloud, or set OwnProbeRadius</source>
      <translation>Radius der Kugel, deren Mittelpunkte die Punktwolke enthält. Ohne OwnProbeRadius ist es der der Punktwolke und lässt sich hier nicht ändern: dort ändern, oder OwnProbeRadius setzen</translation>
    </message>
    <message>
      <source>Radius of the ball whose centres the cloud holds; 0: the points lie on the surface</source>
      <translation>Radius der Kugel, deren Mittelpunkte die Punktwolke enthält; 0: Die Punkte liegen auf der Oberfläche</translation>
    </message>
    <message>
      <source>Radius of the ball whose centres the points are</source>
      <translation>Radius der Kugel, deren Mittelpunkte die Punkte sind</translation>
    </message>
    <message>
      <source>Radius of the rounding at the edge points, mm, or nan</source>
      <translation>Radius der Verrundung an den Kantenpunkten, mm, oder nan</translation>
    </message>
    <message>
      <source>Rims and edges nearer to each other than this are one</source>
      <translation>Ränder und Kanten, die einander näher sind, gelten als eins</translation>
    </message>
    <message>
      <source>Root mean square deviation</source>
      <translation>Quadratischer Mittelwert der Abweichung</translation>
    </message>
    <message>
      <source>Root mean square deviation of the points</source>
      <translation>Quadratischer Mittelwert der Abweichung der Punkte</translation>
    </message>
    <message>
      <source>Scanning tolerance of a probed line section; 0: automatic</source>
      <translation>Toleranz eines Linienschnitts bei linienweiser Abtastung; 0: automatisch</translation>
    </message>
    <message>
      <source>Search distance of the measuring machine; 0: automatic</source>
      <translation>Suchabstand der Messmaschine; 0: automatisch</translation>
    </message>
    <message>
      <source>SearchDistance that was used</source>
      <translation>Verwendeter Suchabstand</translation>
    </message>
    <message>
      <source>Shading of the points</source>
      <translation>Schattierung der Punkte</translation>
    </message>
    <message>
      <source>Share of the surface's area where there are points enough</source>
      <translation>Anteil des Flächeninhalts, wo es genug Punkte gibt</translation>
    </message>
    <message>
      <source>Show colour bar and histogram</source>
      <translation>Farbskala und Histogramm zeigen</translation>
    </message>
    <message>
      <source>Show each edge point in the colour of its sigma, from blue (well known) to yellow</source>
      <translation>Jeden Kantenpunkt in der Farbe seines Sigmas zeigen, von Blau (gut bekannt) bis Gelb</translation>
    </message>
    <message>
      <source>Show where across the edge each of its points was measured</source>
      <translation>Zeigen, wo quer zur Kante jeder ihrer Punkte gemessen wurde</translation>
    </message>
    <message>
      <source>Standard deviation of the edge points, mm</source>
      <translation>Standardabweichung der Kantenpunkte, mm</translation>
    </message>
    <message>
      <source>Standard deviation of the points along the normal</source>
      <translation>Standardabweichung der Punkte entlang der Normalen</translation>
    </message>
    <message>
      <source>Standard deviation of the radii, mm, or nan</source>
      <translation>Standardabweichung der Radien, mm, oder nan</translation>
    </message>
    <message>
      <source>Steering that was used</source>
      <translation>Verwendete Lenkung</translation>
    </message>
    <message>
      <source>Surface near the points, or a network of edges</source>
      <translation>Fläche nahe den Punkten, oder ein Kantennetz</translation>
    </message>
    <message>
      <source>Surface near the points; it gives the fit its rim</source>
      <translation>Fläche nahe den Punkten; sie gibt der angepassten ihren Rand</translation>
    </message>
    <message>
      <source>Surfaces that reach beyond where they meet</source>
      <translation>Flächen, die über ihre Schnittlinien hinausreichen</translation>
    </message>
    <message>
      <source>Tangent that was used</source>
      <translation>Verwendete Tangente</translation>
    </message>
    <message>
      <source>The cloud of centres of a ball</source>
      <translation>Die Punktwolke aus Mittelpunkten einer Kugel</translation>
    </message>
    <message>
      <source>The cloud of which this is a part</source>
      <translation>Die Punktwolke, von der dies ein Teil ist</translation>
    </message>
    <message>
      <source>The cloud that is cut</source>
      <translation>Die Punktwolke, die geschnitten wird</translation>
    </message>
    <message>
      <source>The cloud that is scanned</source>
      <translation>Die Punktwolke, die abgetastet wird</translation>
    </message>
    <message>
      <source>The cloud whose edges are sought</source>
      <translation>Die Punktwolke, deren Kanten gesucht werden</translation>
    </message>
    <message>
      <source>The cloud whose points are measured</source>
      <translation>Die Punktwolke, deren Punkte gemessen werden</translation>
    </message>
    <message>
      <source>The edge across which it is cut</source>
      <translation>Die Kante, quer zu der geschnitten wird</translation>
    </message>
    <message>
      <source>The model of the surface</source>
      <translation>Das Modell der Fläche</translation>
    </message>
    <message>
      <source>The part that is scanned: any object with faces</source>
      <translation>Das Teil, das gescannt wird: ein beliebiges Objekt mit Flächen</translation>
    </message>
    <message>
      <source>The point cloud, a Points object, that is scanned</source>
      <translation>Die Punktwolke, ein Points-Objekt, die abgetastet wird</translation>
    </message>
    <message>
      <source>The profile that is moved: one object</source>
      <translation>Das Profil, das bewegt wird: ein Objekt</translation>
    </message>
    <message>
      <source>The rail: an object and the names of its edges</source>
      <translation>Die Leitkurve: ein Objekt und die Namen seiner Kanten</translation>
    </message>
    <message>
      <source>The same seed gives the same cloud</source>
      <translation>Derselbe Startwert gibt dieselbe Punktwolke</translation>
    </message>
    <message>
      <source>The search ends when it has found so many; 0: all</source>
      <translation>Die Suche endet, wenn sie so viele gefunden hat; 0: alle</translation>
    </message>
    <message>
      <source>The surface that is extended: one face</source>
      <translation>Die Fläche, die verlängert wird: eine einzelne</translation>
    </message>
    <message>
      <source>Tolerance that was used</source>
      <translation>Verwendete Toleranz</translation>
    </message>
    <message>
      <source>Unit normals of the first side at the edge points</source>
      <translation>Einheitsnormalen der ersten Seite an den Kantenpunkten</translation>
    </message>
    <message>
      <source>Unit normals of the second side at the edge points</source>
      <translation>Einheitsnormalen der zweiten Seite an den Kantenpunkten</translation>
    </message>
    <message>
      <source>Unit tangents at the edge points</source>
      <translation>Einheitstangenten an den Kantenpunkten</translation>
    </message>
    <message>
      <source>Version of these properties</source>
      <translation>Version dieser Eigenschaften</translation>
    </message>
    <message>
      <source>What happened, and what to try</source>
      <translation>Was geschah, und was man versuchen kann</translation>
    </message>
    <message>
      <source>What holds the edges, such as an edge network</source>
      <translation>Was die Kanten enthält, etwa ein Kantennetz</translation>
    </message>
    <message>
      <source>What is fitted to the points</source>
      <translation>Was an die Punkte angepasst wird</translation>
    </message>
    <message>
      <source>What meets it</source>
      <translation>Was sie trifft</translation>
    </message>
    <message>
      <source>What the sweep is besides: ruled, extrusion, revolution, pipe</source>
      <translation>Was der Sweep außerdem ist: Regelfläche, Extrusion, Rotation, Rohr</translation>
    </message>
    <message>
      <source>What was fitted: line, arc or spline</source>
      <translation>Was angepasst wurde: Gerade, Bogen oder Spline</translation>
    </message>
    <message>
      <source>Where edges meet</source>
      <translation>Wo Kanten zusammentreffen</translation>
    </message>
    <message>
      <source>Where the scan begins: a point near the edge, or, with Across and Along, the first point of the first scan line (document coordinates)</source>
      <translation>Wo die Abtastung beginnt: ein Punkt nahe der Kante oder, mit Across und Along, der erste Punkt der ersten Abtastlinie (Koordinaten des Dokuments)</translation>
    </message>
    <message>
      <source>Where the scan ends: a point, or, with GateAcross, the first end of a gate line</source>
      <translation>Wo die Abtastung endet: ein Punkt oder, mit GateAcross, das erste Ende einer Ziellinie</translation>
    </message>
    <message>
      <source>Where: share of the rail's length, 0 to 1</source>
      <translation>Wo: Anteil an der Länge der Leitkurve, 0 bis 1</translation>
    </message>
    <message>
      <source>Whether Tau is given; else it is chosen</source>
      <translation>Ob Tau gegeben ist; sonst wird es gewählt</translation>
    </message>
    <message>
      <source>Whether a closed profile gives a solid</source>
      <translation>Ob ein geschlossenes Profil einen Körper ergibt</translation>
    </message>
    <message>
      <source>Whether a closed shell becomes a solid</source>
      <translation>Ob eine geschlossene Schale ein Körper wird</translation>
    </message>
    <message>
      <source>Whether an extrusion or revolution, as Kinds says, is made as a surface of this kind</source>
      <translation>Ob eine Extrusion oder ein Rotationskörper, wie Kinds sagt, als Fläche dieser Art erzeugt wird</translation>
    </message>
    <message>
      <source>Whether it ends where it begins</source>
      <translation>Ob er dort endet, wo er beginnt</translation>
    </message>
    <message>
      <source>Whether material fills the smaller wedge: yes, no or unknown</source>
      <translation>Ob Material den kleineren Keil füllt: yes (ja), no (nein) oder unknown (unbekannt)</translation>
    </message>
    <message>
      <source>Whether rails that go on beyond the outer profiles by more than LargestGap end where these do</source>
      <translation>Ob Leitkurven, die um mehr als LargestGap über die äußeren Profile hinausgehen, bei diesen enden</translation>
    </message>
    <message>
      <source>Whether the edge comes back to its start</source>
      <translation>Ob die Kante zu ihrem Anfang zurückkehrt</translation>
    </message>
    <message>
      <source>Whether the scan ends at Gate; else where the edge ends</source>
      <translation>Ob die Abtastung am Ziel (Gate) endet; sonst dort, wo die Kante endet</translation>
    </message>
    <message>
      <source>Whether the shell has no rim</source>
      <translation>Ob die Schale keinen Rand hat</translation>
    </message>
    <message>
      <source>Whether this edge has a ProbeRadius of its own; else that of the cloud counts</source>
      <translation>Ob diese Kante einen eigenen Tasterradius hat; sonst gilt der der Punktwolke</translation>
    </message>
    <message>
      <source>Which edge each of them belongs to, from 1</source>
      <translation>Zu welcher Kante jeder von ihnen gehört, ab 1</translation>
    </message>
    <message>
      <source>Why each automatic value was chosen</source>
      <translation>Warum jeder automatische Wert gewählt wurde</translation>
    </message>
    <message>
      <source>Why the edge ends, at its start and at its end</source>
      <translation>Warum die Kante endet, an ihrem Anfang und an ihrem Ende</translation>
    </message>
    <message>
      <source>Why the first edge begins and the last one ends</source>
      <translation>Warum die erste Kante beginnt und die letzte endet</translation>
    </message>
    <message>
      <source>Without a base: four edges round the surface; without these the plane, cylinder, cone, sphere or quadric that the cloud's points lie on is the base</source>
      <translation>Ohne Grundfläche: vier Kanten rings um die Fläche; ohne diese ist die Ebene, der Zylinder, der Kegel, die Kugel oder die Quadrik, auf der die Punkte der Punktwolke liegen, die Grundfläche</translation>
    </message>
    <message>
      <source>Without numbers of control points: largest distance of a point from the surface at which no more are added; 0: the points' scatter decides</source>
      <translation>Ohne Anzahlen von Kontrollpunkten: größter Abstand eines Punkts von der Fläche, bei dem keine mehr hinzukommen; 0: Die Streuung der Punkte entscheidet</translation>
    </message>
    <message>
      <source>τ of the extension: how its weights go on</source>
      <translation>τ der Verlängerung: wie ihre Gewichte weitergehen</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan</name>
    <message>
      <source>&amp;Move near the origin</source>
      <translation>&amp;Nahe an den Ursprung rücken</translation>
    </message>
    <message>
      <source>&amp;Noise:</source>
      <translation>&amp;Rauschen:</translation>
    </message>
    <message>
      <source>&amp;Part:</source>
      <translation>&amp;Teil:</translation>
    </message>
    <message>
      <source>&amp;Pitch:</source>
      <translation>&amp;Punktabstand:</translation>
    </message>
    <message>
      <source>&amp;Probe radius:</source>
      <translation>Taster&amp;radius:</translation>
    </message>
    <message>
      <source>&amp;Unit of the file:</source>
      <translation>&amp;Einheit der Datei:</translation>
    </message>
    <message>
      <source>, rounding {radius}</source>
      <translation>, Verrundung {radius}</translation>
    </message>
    <message>
      <source>1 (line)</source>
      <translation>1 (Gerade)</translation>
    </message>
    <message>
      <source>1 of 2: click near an edge of the face.</source>
      <translation>1 von 2: Nahe einer Kante der Fläche klicken.</translation>
    </message>
    <message>
      <source>1 of 3: click beside the edge, where the first scan line begins.</source>
      <translation>1 von 3: Neben die Kante klicken, wo die erste Abtastlinie beginnt.</translation>
    </message>
    <message>
      <source>2 (quadratic)</source>
      <translation>2 (quadratisch)</translation>
    </message>
    <message>
      <source>2 of 2: click on the face, beside that edge.</source>
      <translation>2 von 2: Auf die Fläche klicken, neben dieser Kante.</translation>
    </message>
    <message>
      <source>2 of 3: click across the edge, where that line leads.</source>
      <translation>2 von 3: Jenseits der Kante klicken, wohin diese Linie führt.</translation>
    </message>
    <message>
      <source>3 (cubic)</source>
      <translation>3 (kubisch)</translation>
    </message>
    <message>
      <source>3 + 2 clicks: start and gate</source>
      <translation>3 + 2 Klicks: Start und Ziel</translation>
    </message>
    <message>
      <source>3 of 3: click along the edge, where the walk goes.</source>
      <translation>3 von 3: Weiter vorn an der Kante klicken, wohin der Weg führt.</translation>
    </message>
    <message>
      <source>A cloud of a part whose edges are known exactly: to try EdgeScan, and to see what a scan with another pitch or noise would give.</source>
      <translation>Eine Punktwolke eines Teils, dessen Kanten genau bekannt sind: um EdgeScan auszuprobieren und um zu sehen, was ein Scan mit anderem Punktabstand oder Rauschen ergäbe.</translation>
    </message>
    <message>
      <source>All clouds of this document are hidden. Select one in the tree, or show it.</source>
      <translation>Alle Punktwolken dieses Dokuments sind ausgeblendet. Eine im Baum auswählen oder einblenden.</translation>
    </message>
    <message>
      <source>All files</source>
      <translation>Alle Dateien</translation>
    </message>
    <message>
      <source>All points (patch)</source>
      <translation>Alle Punkte (patch)</translation>
    </message>
    <message>
      <source>All points on both sides are the most accurate; line by line touches the cloud as a measuring machine touches a part</source>
      <translation>Alle Punkte beider Seiten sind am genauesten; Linie für Linie tastet die Punktwolke ab wie eine Messmaschine ein Teil</translation>
    </message>
    <message>
      <source>All {whole} points are shown.</source>
      <translation>Alle {whole} Punkte werden angezeigt.</translation>
    </message>
    <message>
      <source>Amplitude</source>
      <translation>Amplitude</translation>
    </message>
    <message>
      <source>Angle</source>
      <translation>Winkel</translation>
    </message>
    <message>
      <source>Approach</source>
      <translation>Antastrichtung</translation>
    </message>
    <message>
      <source>Blue: well known. Yellow: the least known points of this edge</source>
      <translation>Blau: genau bekannt. Gelb: die am wenigsten genau bekannten Punkte dieser Kante</translation>
    </message>
    <message>
      <source>Bring a 3D view to the front, then start again.</source>
      <translation>Eine 3D-Ansicht nach vorn holen, dann erneut beginnen.</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Change what you like; OK keeps it. A click on the cloud scans another edge.</source>
      <translation>Beliebig ändern; OK behält es. Ein Klick auf die Punktwolke tastet eine andere Kante ab.</translation>
    </message>
    <message>
      <source>Chord height</source>
      <translation>Sehnenhöhe</translation>
    </message>
    <message>
      <source>Click near the edge where the scan is to end. OK keeps all of it.</source>
      <translation>Nahe der Kante klicken, wo die Abtastung enden soll. OK behält sie ganz.</translation>
    </message>
    <message>
      <source>Click on an edge to drop or keep it. OK keeps those in orange.</source>
      <translation>Klicken Sie auf eine Kante, um sie wegzulassen oder zu behalten. OK behält die orangefarbenen.</translation>
    </message>
    <message>
      <source>Click on the cloud near a rim of the pipe: the edge is followed both ways until it ends. Then OK keeps it; Undo takes it away again.</source>
      <translation>Nahe einem Rand der Rinne auf die Punktwolke klicken: Die Kante wird in beide Richtungen verfolgt, bis sie endet. OK behält sie; Rückgängig nimmt sie wieder weg.</translation>
    </message>
    <message>
      <source>Click on the cloud, near the edge you want to scan.</source>
      <translation>Auf die Punktwolke klicken, nahe der Kante, die abgetastet werden soll.</translation>
    </message>
    <message>
      <source>Click on the cloud, near the edge you want, where the scan begins.</source>
      <translation>Auf die Punktwolke klicken, nahe der gewünschten Kante, wo die Abtastung beginnt.</translation>
    </message>
    <message>
      <source>Click on the cloud, near the edge you want.</source>
      <translation>Auf die Punktwolke klicken, nahe der gewünschten Kante.</translation>
    </message>
    <message>
      <source>Click on the face whose points you want, between the edges.</source>
      <translation>Klicken Sie auf die Fläche zwischen den Kanten, deren Punkte Sie möchten.</translation>
    </message>
    <message>
      <source>Click to see the section there. Arrows: along the edge</source>
      <translation>Klicken zeigt den Schnitt dort. Pfeiltasten: entlang der Kante</translation>
    </message>
    <message>
      <source>Close the guide</source>
      <translation>Anleitung schließen</translation>
    </message>
    <message>
      <source>Cloud files do not say in which unit their numbers are.</source>
      <translation>Dateien von Punktwolken sagen nicht, in welcher Einheit ihre Zahlen sind.</translation>
    </message>
    <message>
      <source>Cloud pitch</source>
      <translation>Punktabstand</translation>
    </message>
    <message>
      <source>Colour by sigma</source>
      <translation>Nach Sigma färben</translation>
    </message>
    <message>
      <source>Compensate cloud</source>
      <translation>Punktwolke korrigieren</translation>
    </message>
    <message>
      <source>Compensation</source>
      <translation>Tasterkorrektur</translation>
    </message>
    <message>
      <source>Computing. Cancel gives it up.</source>
      <translation>Es wird gerechnet. Abbrechen gibt es auf.</translation>
    </message>
    <message>
      <source>Core box of the case study</source>
      <translation>Kernkasten der Fallstudie</translation>
    </message>
    <message>
      <source>Core box, a small piece</source>
      <translation>Kernkasten, ein kleines Stück</translation>
    </message>
    <message>
      <source>Cross-section of the edge</source>
      <translation>Querschnitt der Kante</translation>
    </message>
    <message>
      <source>Degree</source>
      <translation>Grad</translation>
    </message>
    <message>
      <source>Degree of a line section</source>
      <translation>Grad eines Linienschnitts</translation>
    </message>
    <message>
      <source>Direction the probe came along; the air lies against it</source>
      <translation>Richtung, in der der Taster kam; die Luft liegt ihr entgegen</translation>
    </message>
    <message>
      <source>Distance of the cloud's points, which tells a gap from surface</source>
      <translation>Abstand der Punkte der Punktwolke; er unterscheidet Lücken von Oberfläche</translation>
    </message>
    <message>
      <source>Distance of the edge points</source>
      <translation>Abstand der Kantenpunkte</translation>
    </message>
    <message>
      <source>Distance of the points on a scan line</source>
      <translation>Abstand der Punkte auf einer Abtastlinie</translation>
    </message>
    <message>
      <source>Edge of {length}, turn {turn}, sigma {sigma}</source>
      <translation>Kante von {length}, Knick {turn}, Sigma {sigma}</translation>
    </message>
    <message>
      <source>Edge pitch</source>
      <translation>Kantenpunktabstand</translation>
    </message>
    <message>
      <source>Edge point</source>
      <translation>Kantenpunkt</translation>
    </message>
    <message>
      <source>Edge points with sigma</source>
      <translation>Kantenpunkte mit Sigma</translation>
    </message>
    <message>
      <source>Edge {number}</source>
      <translation>Kante {number}</translation>
    </message>
    <message>
      <source>EdgeScan needs the Python package {package}, which is not installed. Install it (on Debian: apt install python3-{package}) and start FreeCAD again.</source>
      <translation>EdgeScan braucht das Python-Paket {package}, das nicht installiert ist. Installieren (unter Debian: apt install python3-{package}) und FreeCAD neu starten.</translation>
    </message>
    <message>
      <source>Edges and surfaces</source>
      <translation>Kanten und Flächen</translation>
    </message>
    <message>
      <source>Edges known worse are left out: the median of sigma along them counts</source>
      <translation>Weniger genau bekannte Kanten werden weggelassen: es zählt der Median von Sigma entlang der Kante</translation>
    </message>
    <message>
      <source>Edges of {count} objects are selected. Select edges of one network in the 3D view, the others with Ctrl held.</source>
      <translation>Kanten von {count} Objekten sind ausgewählt. Wählen Sie Kanten eines Netzes in der 3D-Ansicht, die weiteren mit gedrückter Strg-Taste.</translation>
    </message>
    <message>
      <source>Edges whose sides turn less are left out: 90° at the edge of a box</source>
      <translation>Kanten, deren Seiten weniger abknicken, werden weggelassen: 90° an der Kante eines Quaders</translation>
    </message>
    <message>
      <source>Edit network of edges</source>
      <translation>Kantennetz bearbeiten</translation>
    </message>
    <message>
      <source>Edit scanned edge</source>
      <translation>Abgetastete Kante bearbeiten</translation>
    </message>
    <message>
      <source>Edit the scan</source>
      <translation>Abtastung bearbeiten</translation>
    </message>
    <message>
      <source>End the scan and keep the edge as far as it is known</source>
      <translation>Die Abtastung beenden und die Kante behalten, soweit sie bekannt ist</translation>
    </message>
    <message>
      <source>End the search and keep the edges found so far</source>
      <translation>Die Suche beenden und die bisher gefundenen Kanten behalten</translation>
    </message>
    <message>
      <source>Error to expect</source>
      <translation>Zu erwartender Fehler</translation>
    </message>
    <message>
      <source>Export</source>
      <translation>Exportieren</translation>
    </message>
    <message>
      <source>Finish or cancel the open task panel first.</source>
      <translation>Zuerst das offene Aufgabenfenster abschließen oder abbrechen.</translation>
    </message>
    <message>
      <source>Forget clicks</source>
      <translation>Klicks vergessen</translation>
    </message>
    <message>
      <source>Forget clicks ({count})</source>
      <translation>Klicks vergessen ({count})</translation>
    </message>
    <message>
      <source>Gate, 1 of 2: click beside the edge on the same side. OK needs no gate.</source>
      <translation>Ziel, 1 von 2: Auf derselben Seite neben die Kante klicken. OK geht auch ohne Ziel.</translation>
    </message>
    <message>
      <source>Gate, 2 of 2: click across the edge.</source>
      <translation>Ziel, 2 von 2: Jenseits der Kante klicken.</translation>
    </message>
    <message>
      <source>Go along the edge</source>
      <translation>Die Kante entlanggehen</translation>
    </message>
    <message>
      <source>Group of edges</source>
      <translation>Gruppe von Kanten</translation>
    </message>
    <message>
      <source>Hide the points before and behind the section that is looked at</source>
      <translation>Die Punkte vor und hinter dem betrachteten Schnitt ausblenden</translation>
    </message>
    <message>
      <source>Hold Ctrl for clicks.</source>
      <translation>Zum Klicken Strg gedrückt halten.</translation>
    </message>
    <message>
      <source>How far the measuring machine goes on looking for the surface</source>
      <translation>Wie weit die Messmaschine nach der Oberfläche weitersucht</translation>
    </message>
    <message>
      <source>How the direction of the edge is found</source>
      <translation>Wie die Richtung der Kante gefunden wird</translation>
    </message>
    <message>
      <source>How the next scan line is placed</source>
      <translation>Wie die nächste Abtastlinie gelegt wird</translation>
    </message>
    <message>
      <source>How the probe radius is taken off</source>
      <translation>Wie der Tasterradius abgezogen wird</translation>
    </message>
    <message>
      <source>How the scan lines follow each other</source>
      <translation>Wie die Abtastlinien aufeinander folgen</translation>
    </message>
    <message>
      <source>Import cloud</source>
      <translation>Punktwolke importieren</translation>
    </message>
    <message>
      <source>Inches</source>
      <translation>Zoll</translation>
    </message>
    <message>
      <source>Keep edges</source>
      <translation>Kanten behalten</translation>
    </message>
    <message>
      <source>Kept as far as it was scanned: a gate ends it there now.</source>
      <translation>Behalten, soweit abgetastet: Ein Ziel beendet die Kante jetzt dort.</translation>
    </message>
    <message>
      <source>Kept. Click to drop it.</source>
      <translation>Behalten. Ein Klick lässt sie weg.</translation>
    </message>
    <message>
      <source>Largest deviation of the chord between two edge points from the edge</source>
      <translation>Größte Abweichung der Sehne zwischen zwei Kantenpunkten von der Kante</translation>
    </message>
    <message>
      <source>Left out. Click to keep it.</source>
      <translation>Weggelassen. Ein Klick behält sie.</translation>
    </message>
    <message>
      <source>Length</source>
      <translation>Länge</translation>
    </message>
    <message>
      <source>Length from</source>
      <translation>Länge ab</translation>
    </message>
    <message>
      <source>Length of a scan line along the surface, half of it on each side</source>
      <translation>Länge einer Abtastlinie entlang der Oberfläche, zur Hälfte auf jeder Seite</translation>
    </message>
    <message>
      <source>Let length, turn and sigma alone decide again</source>
      <translation>Wieder allein Länge, Knick und Sigma entscheiden lassen</translation>
    </message>
    <message>
      <source>Line by line (probe)</source>
      <translation>Linie für Linie (probe)</translation>
    </message>
    <message>
      <source>Line pitch</source>
      <translation>Linienpunktabstand</translation>
    </message>
    <message>
      <source>Look along the edge</source>
      <translation>Entlang der Kante blicken</translation>
    </message>
    <message>
      <source>Looking for
the edge …</source>
      <translation>Die Kante
wird gesucht …</translation>
    </message>
    <message>
      <source>Make every parameter automatic again</source>
      <translation>Alle Parameter wieder automatisch bestimmen</translation>
    </message>
    <message>
      <source>Mean sigma</source>
      <translation>Mittleres Sigma</translation>
    </message>
    <message>
      <source>Metres</source>
      <translation>Meter</translation>
    </message>
    <message>
      <source>Millimetres</source>
      <translation>Millimeter</translation>
    </message>
    <message>
      <source>No point cloud can be seen; show one in the tree.</source>
      <translation>Es ist keine Punktwolke zu sehen; im Baum eine einblenden.</translation>
    </message>
    <message>
      <source>Noise level</source>
      <translation>Rauschen</translation>
    </message>
    <message>
      <source>None of these edges can be scanned by itself.</source>
      <translation>Keine dieser Kanten lässt sich für sich allein abtasten.</translation>
    </message>
    <message>
      <source>Nothing with a shape is selected or shown. Select scanned edges or surfaces.</source>
      <translation>Nichts, was eine Form hat, ist ausgewählt oder eingeblendet. Abgetastete Kanten oder Flächen auswählen.</translation>
    </message>
    <message>
      <source>OK keeps this edge. Click elsewhere to scan another one instead.</source>
      <translation>OK behält diese Kante. Anderswo klicken, um stattdessen eine andere abzutasten.</translation>
    </message>
    <message>
      <source>OK keeps this. Click elsewhere to begin again.</source>
      <translation>OK behält dies. Anderswo klicken, um neu zu beginnen.</translation>
    </message>
    <message>
      <source>OK makes</source>
      <translation>OK erzeugt</translation>
    </message>
    <message>
      <source>OK scans this edge with these parameters, line by line. Click elsewhere to measure there instead.</source>
      <translation>OK tastet diese Kante mit diesen Parametern Linie für Linie ab. Anderswo klicken, um stattdessen dort zu messen.</translation>
    </message>
    <message>
      <source>Of the cloud's points, in pixels; own: as elsewhere</source>
      <translation>Der Punkte der Punktwolke, in Pixeln; eigene: wie sonst auch</translation>
    </message>
    <message>
      <source>On average: sigma {sigma}, angle {angle}</source>
      <translation>Im Mittel: Sigma {sigma}, Winkel {angle}</translation>
    </message>
    <message>
      <source>One click: the whole edge</source>
      <translation>Ein Klick: die ganze Kante</translation>
    </message>
    <message>
      <source>One network</source>
      <translation>Ein Netz</translation>
    </message>
    <message>
      <source>One object whose edges share their corners, or one for each edge that can be edited by itself</source>
      <translation>Ein Objekt, dessen Kanten sich ihre Ecken teilen, oder eines je Kante, das für sich bearbeitet werden kann</translation>
    </message>
    <message>
      <source>One point for each pitch² of surface.</source>
      <translation>Ein Punkt je Punktabstand² Oberfläche.</translation>
    </message>
    <message>
      <source>One point stays for each pitch² of surface.</source>
      <translation>Ein Punkt je Punktabstand² Oberfläche bleibt.</translation>
    </message>
    <message>
      <source>Only points at the section</source>
      <translation>Nur Punkte am Schnitt</translation>
    </message>
    <message>
      <source>Open a 3D view of this document first.</source>
      <translation>Zuerst eine 3D-Ansicht dieses Dokuments öffnen.</translation>
    </message>
    <message>
      <source>Open a document first, or import a cloud.</source>
      <translation>Zuerst ein Dokument öffnen oder eine Punktwolke importieren.</translation>
    </message>
    <message>
      <source>P&amp;itch:</source>
      <translation>P&amp;unktabstand:</translation>
    </message>
    <message>
      <source>Parameters</source>
      <translation>Parameter</translation>
    </message>
    <message>
      <source>Pattern</source>
      <translation>Muster</translation>
    </message>
    <message>
      <source>Picture with histogram</source>
      <translation>Bild mit Histogramm</translation>
    </message>
    <message>
      <source>Point clouds</source>
      <translation>Punktwolken</translation>
    </message>
    <message>
      <source>Point size</source>
      <translation>Punktgröße</translation>
    </message>
    <message>
      <source>Prehit distance</source>
      <translation>Antastabstand</translation>
    </message>
    <message>
      <source>Probe &amp;radius:</source>
      <translation>Taster&amp;radius:</translation>
    </message>
    <message>
      <source>Probe radius</source>
      <translation>Tasterradius</translation>
    </message>
    <message>
      <source>Radius of a ball that rolls over the part; the points are its centres. 0: the points lie on the part.</source>
      <translation>Radius einer Kugel, die über das Teil rollt; die Punkte sind ihre Mittelpunkte. 0: Die Punkte liegen auf dem Teil.</translation>
    </message>
    <message>
      <source>Radius of the ball whose centres the cloud holds; 0: surface points</source>
      <translation>Radius der Kugel, deren Mittelpunkte die Punktwolke enthält; 0: Oberflächenpunkte</translation>
    </message>
    <message>
      <source>Radius of the ball, when the file holds the centres of a probing ball; 0: the points lie on the part.</source>
      <translation>Radius der Kugel, wenn die Datei die Mittelpunkte einer Tastkugel enthält; 0: Die Punkte liegen auf dem Teil.</translation>
    </message>
    <message>
      <source>Reading {name}…</source>
      <translation>{name} wird gelesen…</translation>
    </message>
    <message>
      <source>Recommend parameters</source>
      <translation>Parameter empfehlen</translation>
    </message>
    <message>
      <source>Report</source>
      <translation>Bericht</translation>
    </message>
    <message>
      <source>Reset</source>
      <translation>Zurücksetzen</translation>
    </message>
    <message>
      <source>Rounding</source>
      <translation>Verrundung</translation>
    </message>
    <message>
      <source>Rounding radius</source>
      <translation>Verrundungsradius</translation>
    </message>
    <message>
      <source>Rows with nan or inf that are left out: {count}.</source>
      <translation>Ausgelassene Zeilen mit nan oder inf: {count}.</translation>
    </message>
    <message>
      <source>Save deviations</source>
      <translation>Abweichungen speichern</translation>
    </message>
    <message>
      <source>Save deviations…</source>
      <translation>Abweichungen speichern…</translation>
    </message>
    <message>
      <source>Scan all edges</source>
      <translation>Alle Kanten abtasten</translation>
    </message>
    <message>
      <source>Scan boundary</source>
      <translation>Umrandung abtasten</translation>
    </message>
    <message>
      <source>Scan edge</source>
      <translation>Kante abtasten</translation>
    </message>
    <message>
      <source>Scan lines</source>
      <translation>Abtastlinien</translation>
    </message>
    <message>
      <source>Scanning tolerance of a line section</source>
      <translation>Abtasttoleranz eines Linienschnitts</translation>
    </message>
    <message>
      <source>Search again</source>
      <translation>Noch einmal suchen</translation>
    </message>
    <message>
      <source>Search distance</source>
      <translation>Suchabstand</translation>
    </message>
    <message>
      <source>Search the whole cloud, also for what is still missing</source>
      <translation>Die ganze Punktwolke absuchen, auch nach dem, was noch fehlt</translation>
    </message>
    <message>
      <source>Section</source>
      <translation>Schnitt</translation>
    </message>
    <message>
      <source>Shorter edges are left out; 0: shorter than eight times the cloud's pitch</source>
      <translation>Kürzere Kanten werden weggelassen; 0: kürzer als der achtfache Punktabstand der Punktwolke</translation>
    </message>
    <message>
      <source>Show scan lines</source>
      <translation>Abtastlinien anzeigen</translation>
    </message>
    <message>
      <source>Show where across the edge each point was measured</source>
      <translation>Zeigen, wo quer zur Kante jeder Punkt gemessen wurde</translation>
    </message>
    <message>
      <source>Sigma</source>
      <translation>Sigma</translation>
    </message>
    <message>
      <source>Sigma is the standard deviation of an edge point across the edge: about two of three lie within it. A good edge's is well below the distance of the points.</source>
      <translation>Sigma ist die Standardabweichung eines Kantenpunkts quer zur Kante: etwa zwei von drei liegen innerhalb. Bei einer guten Kante ist es deutlich kleiner als der Abstand der Punkte.</translation>
    </message>
    <message>
      <source>Sigma up to</source>
      <translation>Sigma bis</translation>
    </message>
    <message>
      <source>Sigma, angle and rounding along the edge</source>
      <translation>Sigma, Winkel und Verrundung entlang der Kante</translation>
    </message>
    <message>
      <source>Sigma, angle and rounding along the edge are shown here.</source>
      <translation>Hier erscheinen Sigma, Winkel und Verrundung entlang der Kante.</translation>
    </message>
    <message>
      <source>Simulated cloud</source>
      <translation>Simulierte Punktwolke</translation>
    </message>
    <message>
      <source>Size:</source>
      <translation>Größe:</translation>
    </message>
    <message>
      <source>Standard deviation of the points along the normal.</source>
      <translation>Standardabweichung der Punkte entlang der Normalen.</translation>
    </message>
    <message>
      <source>Steering</source>
      <translation>Lenkung</translation>
    </message>
    <message>
      <source>Step {number} of 3</source>
      <translation>Schritt {number} von 3</translation>
    </message>
    <message>
      <source>Stop here</source>
      <translation>Hier anhalten</translation>
    </message>
    <message>
      <source>Stopped before an edge was found.</source>
      <translation>Angehalten, bevor eine Kante gefunden wurde.</translation>
    </message>
    <message>
      <source>Stopped before there was enough of the edge to keep.</source>
      <translation>Angehalten, bevor genug von der Kante da war, um sie zu behalten.</translation>
    </message>
    <message>
      <source>Stopped: OK keeps the edges found so far.</source>
      <translation>Angehalten: OK behält die bisher gefundenen Kanten.</translation>
    </message>
    <message>
      <source>Stopping…</source>
      <translation>Wird abgebrochen…</translation>
    </message>
    <message>
      <source>Table</source>
      <translation>Tabelle</translation>
    </message>
    <message>
      <source>Tangent</source>
      <translation>Tangente</translation>
    </message>
    <message>
      <source>That is an edge: a native curve in the tree. Its properties say how exact it is and why it ends. Scan the other rim, too; Cross-section then finds the pipe's profile between them. With your own scan, begin with Import cloud.</source>
      <translation>Das ist eine Kante: eine FreeCAD-eigene Kurve im Baum. Ihre Eigenschaften sagen, wie genau sie ist und warum sie endet. Auch den anderen Rand abtasten; Querschnitt findet dann das Profil der Rinne zwischen beiden. Mit einem eigenen Scan mit Punktwolke importieren beginnen.</translation>
    </message>
    <message>
      <source>That is very large. Is the file in millimetres?</source>
      <translation>Das ist sehr groß. Ist die Datei in Millimetern?</translation>
    </message>
    <message>
      <source>That is very small. Is the file in metres?</source>
      <translation>Das ist sehr klein. Ist die Datei in Metern?</translation>
    </message>
    <message>
      <source>That is {label}, no point cloud.</source>
      <translation>Das ist {label}, keine Punktwolke.</translation>
    </message>
    <message>
      <source>The boundary is closed.</source>
      <translation>Die Umrandung ist geschlossen.</translation>
    </message>
    <message>
      <source>The calculation broke off ({kind}: {error}).</source>
      <translation>Die Berechnung brach ab ({kind}: {error}).</translation>
    </message>
    <message>
      <source>The cloud has changed.</source>
      <translation>Die Punktwolke hat sich geändert.</translation>
    </message>
    <message>
      <source>The cloud is being prepared; your click will be answered.</source>
      <translation>Die Punktwolke wird vorbereitet; der Klick wird danach beantwortet.</translation>
    </message>
    <message>
      <source>The cloud is searched. Click on an edge to drop it.</source>
      <translation>Die Punktwolke wird abgesucht. Ein Klick auf eine Kante lässt sie weg.</translation>
    </message>
    <message>
      <source>The cloud of {label} is gone. Choose another one in its property Cloud, or undo the deletion.</source>
      <translation>Die Punktwolke von {label} gibt es nicht mehr. Wählen Sie eine andere in der Eigenschaft Cloud, oder machen Sie das Löschen rückgängig.</translation>
    </message>
    <message>
      <source>The cloud was deleted.</source>
      <translation>Die Punktwolke wurde gelöscht.</translation>
    </message>
    <message>
      <source>The cloud was deleted. Undo that, or press Cancel.</source>
      <translation>Die Punktwolke wurde gelöscht. Machen Sie das rückgängig, oder brechen Sie ab.</translation>
    </message>
    <message>
      <source>The edge is being followed.</source>
      <translation>Die Kante wird verfolgt.</translation>
    </message>
    <message>
      <source>The face has {count} of the {whole} points.</source>
      <translation>Die Fläche hat {count} der {whole} Punkte.</translation>
    </message>
    <message>
      <source>The points lie {distance} from the origin, where a document cannot keep them exactly. Moved, they are exact; the cloud's property Origin holds the way back, and exports use it.</source>
      <translation>Die Punkte liegen {distance} vom Ursprung entfernt, wo ein Dokument sie nicht genau halten kann. Näher gerückt sind sie genau; die Eigenschaft Origin der Punktwolke enthält den Weg zurück, und Exporte verwenden ihn.</translation>
    </message>
    <message>
      <source>The section across the edge is shown here.</source>
      <translation>Hier erscheint der Schnitt quer zur Kante.</translation>
    </message>
    <message>
      <source>There is no edge.</source>
      <translation>Dort ist keine Kante.</translation>
    </message>
    <message>
      <source>There is no point of a visible cloud there.</source>
      <translation>Dort ist kein Punkt einer sichtbaren Punktwolke.</translation>
    </message>
    <message>
      <source>These edges are not those of {label}.</source>
      <translation>Diese Kanten sind nicht die von {label}.</translation>
    </message>
    <message>
      <source>Thin cloud</source>
      <translation>Punktwolke ausdünnen</translation>
    </message>
    <message>
      <source>This cloud was scanned by a ball probe, with gaps and noise. Start the command Scan edge: here, in the toolbar, or in the menu EdgeScan.</source>
      <translation>Diese Punktwolke wurde mit einer Tastkugel gemessen, mit Lücken und Rauschen. Den Befehl Kante abtasten starten: hier, in der Werkzeugleiste oder im Menü EdgeScan.</translation>
    </message>
    <message>
      <source>This document has no edge or surface yet. Scan an edge first.</source>
      <translation>Dieses Dokument hat noch keine Kante oder Fläche. Zuerst eine Kante abtasten.</translation>
    </message>
    <message>
      <source>This document has no point cloud. Import one first (EdgeScan → Import cloud).</source>
      <translation>Dieses Dokument hat keine Punktwolke. Zuerst eine importieren (EdgeScan → Punktwolke importieren).</translation>
    </message>
    <message>
      <source>This document shows no point cloud. Import one (EdgeScan → Import cloud), or make a hidden one visible.</source>
      <translation>Dieses Dokument zeigt keine Punktwolke. Eine importieren (EdgeScan → Punktwolke importieren) oder eine ausgeblendete einblenden.</translation>
    </message>
    <message>
      <source>This document shows {count} clouds. Select the one you mean.</source>
      <translation>Dieses Dokument zeigt {count} Punktwolken. Die gemeinte auswählen.</translation>
    </message>
    <message>
      <source>Tick a parameter to set it yourself.</source>
      <translation>Einen Parameter ankreuzen, um ihn selbst zu setzen.</translation>
    </message>
    <message>
      <source>Tolerance</source>
      <translation>Toleranz</translation>
    </message>
    <message>
      <source>Try it</source>
      <translation>Ausprobieren</translation>
    </message>
    <message>
      <source>Turn from</source>
      <translation>Knick ab</translation>
    </message>
    <message>
      <source>Turn the view so that the section is seen as it is drawn</source>
      <translation>Die Ansicht so drehen, dass der Schnitt wie gezeichnet zu sehen ist</translation>
    </message>
    <message>
      <source>Two clicks: edge and gate</source>
      <translation>Zwei Klicks: Kante und Ziel</translation>
    </message>
    <message>
      <source>View</source>
      <translation>Ansicht</translation>
    </message>
    <message>
      <source>Web page</source>
      <translation>Webseite</translation>
    </message>
    <message>
      <source>What your clicks stand for</source>
      <translation>Was die Klicks bedeuten</translation>
    </message>
    <message>
      <source>Wheel: zoom. Drag: move. Double click: show all. Arrows: along</source>
      <translation>Rad: zoomen. Ziehen: verschieben. Doppelklick: alles zeigen. Pfeiltasten: entlang der Kante</translation>
    </message>
    <message>
      <source>Where the measuring machine begins to move slowly</source>
      <translation>Wo die Messmaschine beginnt, langsam zu fahren</translation>
    </message>
    <message>
      <source>along +x</source>
      <translation>entlang +x</translation>
    </message>
    <message>
      <source>along +y</source>
      <translation>entlang +y</translation>
    </message>
    <message>
      <source>along -x</source>
      <translation>entlang -x</translation>
    </message>
    <message>
      <source>along -y</source>
      <translation>entlang -y</translation>
    </message>
    <message>
      <source>along the edge</source>
      <translation>entlang der Kante</translation>
    </message>
    <message>
      <source>angle {angle}</source>
      <translation>Winkel {angle}</translation>
    </message>
    <message>
      <source>chosen with the first click</source>
      <translation>wird mit dem ersten Klick gewählt</translation>
    </message>
    <message>
      <source>curvature</source>
      <translation>Krümmung</translation>
    </message>
    <message>
      <source>curve</source>
      <translation>Kurve</translation>
    </message>
    <message>
      <source>deviation, {unit}</source>
      <translation>Abweichung, {unit}</translation>
    </message>
    <message>
      <source>down, -z</source>
      <translation>nach unten, -z</translation>
    </message>
    <message>
      <source>fitted sides</source>
      <translation>angepasste Seiten</translation>
    </message>
    <message>
      <source>interpolation</source>
      <translation>Interpolation</translation>
    </message>
    <message>
      <source>intersection</source>
      <translation>Schnittpunkt</translation>
    </message>
    <message>
      <source>intersection, as printed</source>
      <translation>Schnittpunkt, wie gedruckt</translation>
    </message>
    <message>
      <source>no rounding measurable</source>
      <translation>keine Verrundung messbar</translation>
    </message>
    <message>
      <source>none</source>
      <translation>keine</translation>
    </message>
    <message>
      <source>none measurable</source>
      <translation>keine messbar</translation>
    </message>
    <message>
      <source>not used</source>
      <translation>nicht verwendet</translation>
    </message>
    <message>
      <source>of no side</source>
      <translation>keiner Seite</translation>
    </message>
    <message>
      <source>own</source>
      <translation>eigene</translation>
    </message>
    <message>
      <source>planes</source>
      <translation>Ebenen</translation>
    </message>
    <message>
      <source>point</source>
      <translation>Punkt</translation>
    </message>
    <message>
      <source>points</source>
      <translation>Punkte</translation>
    </message>
    <message>
      <source>polynomials</source>
      <translation>Polynome</translation>
    </message>
    <message>
      <source>probe</source>
      <translation>Taster</translation>
    </message>
    <message>
      <source>rests on its neighbours</source>
      <translation>beruht auf seinen Nachbarn</translation>
    </message>
    <message>
      <source>rounding</source>
      <translation>Verrundung</translation>
    </message>
    <message>
      <source>rounding {radius} ± {sigma} {unit}</source>
      <translation>Verrundung {radius} ± {sigma} {unit}</translation>
    </message>
    <message>
      <source>set by you</source>
      <translation>selbst gesetzt</translation>
    </message>
    <message>
      <source>sigma {length}</source>
      <translation>Sigma {length}</translation>
    </message>
    <message>
      <source>square</source>
      <translation>rechtwinklig</translation>
    </message>
    <message>
      <source>surface</source>
      <translation>Oberfläche</translation>
    </message>
    <message>
      <source>tangent</source>
      <translation>Tangente</translation>
    </message>
    <message>
      <source>up, +z</source>
      <translation>nach oben, +z</translation>
    </message>
    <message>
      <source>zigzag</source>
      <translation>Zickzack</translation>
    </message>
    <message>
      <source>{across} across, {out} out</source>
      <translation>{across} quer, {out} nach außen</translation>
    </message>
    <message>
      <source>{clouds} clouds and {edges} edges are selected. Select two or three objects: one cloud, the edge to cut across, and another edge if there is one.</source>
      <translation>{clouds} Punktwolken und {edges} Kanten sind ausgewählt. Zwei oder drei Objekte auswählen: eine Punktwolke, die Kante, quer zu der geschnitten wird, und eine weitere Kante, wenn es sie gibt.</translation>
    </message>
    <message>
      <source>{clouds} clouds and {surfaces} surfaces are selected. Select two objects: one cloud and one surface.</source>
      <translation>{clouds} Punktwolken und {surfaces} Flächen sind ausgewählt. Zwei Objekte auswählen: eine Punktwolke und eine Fläche.</translation>
    </message>
    <message>
      <source>{clouds} clouds, {surfaces} surfaces and {edges} edges are selected. Select one cloud, and with it one surface, or four edges, or nothing else.</source>
      <translation>{clouds} Punktwolken, {surfaces} Flächen und {edges} Kanten sind ausgewählt. Eine Punktwolke auswählen, und dazu eine Fläche oder vier Kanten oder nichts weiter.</translation>
    </message>
    <message>
      <source>{count} clouds are selected. Select one of them.</source>
      <translation>{count} Punktwolken sind ausgewählt. Eine davon auswählen.</translation>
    </message>
    <message>
      <source>{count} edge points
{length}</source>
      <translation>{count} Kantenpunkte
{length}</translation>
    </message>
    <message>
      <source>{count} edges</source>
      <translation>{count} Kanten</translation>
    </message>
    <message>
      <source>{count} objects with a shape are selected. Select two or more edges or sections, in the order the skin goes through them.</source>
      <translation>{count} Objekte mit einer Form sind ausgewählt. Zwei oder mehr Kanten oder Schnitte auswählen, in der Reihenfolge, in der die Haut durch sie geht.</translation>
    </message>
    <message>
      <source>{count} objects with a shape are selected. Select two: the profile (a sketch, wire or edge), then the scanned edge to sweep it along.</source>
      <translation>{count} Objekte mit einer Form sind ausgewählt. Zwei auswählen: das Profil (eine Skizze, ein Kantenzug oder eine Kante), dann die abgetastete Kante, an der es entlanglaufen soll.</translation>
    </message>
    <message>
      <source>{count} surfaces are selected. Select one, not two or none, to extend it.</source>
      <translation>{count} Flächen sind ausgewählt. Zum Verlängern genau eine auswählen, nicht zwei oder keine.</translation>
    </message>
    <message>
      <source>{count} surfaces are selected. Select two that meet.</source>
      <translation>{count} Flächen sind ausgewählt. Zwei auswählen, die sich treffen.</translation>
    </message>
    <message>
      <source>{curves} curves and {clouds} clouds are selected. Select two rails, two or more profiles in order, and the cloud if there is one; or one rail that is a scanned edge, and its profiles.</source>
      <translation>{curves} Kurven und {clouds} Punktwolken sind ausgewählt. Zwei Leitkurven, zwei oder mehr Profile der Reihe nach und die Punktwolke auswählen, wenn es sie gibt; oder eine Leitkurve, die eine abgetastete Kante ist, und ihre Profile.</translation>
    </message>
    <message>
      <source>{edges} edges and no surface are selected. Select the surfaces of a shell, and the edges at which they end.</source>
      <translation>{edges} Kanten und keine Fläche sind ausgewählt. Die Flächen einer Schale auswählen, und die Kanten, an denen sie enden.</translation>
    </message>
    <message>
      <source>{kept} of {found} edges are kept, {length} in all.</source>
      <translation>{kept} von {found} Kanten werden behalten, zusammen {length}.</translation>
    </message>
    <message>
      <source>{label} could not be computed: {reason}</source>
      <translation>{label} konnte nicht berechnet werden: {reason}</translation>
    </message>
    <message>
      <source>{label} has {count} points. A pitch twice that of the cloud keeps a quarter of them. Edges are found best in the full cloud.</source>
      <translation>{label} hat {count} Punkte. Der doppelte Punktabstand behält ein Viertel davon. Kanten werden am besten in der vollen Punktwolke gefunden.</translation>
    </message>
    <message>
      <source>{label} is selected, which is no point cloud. Select one cloud.</source>
      <translation>{label} ist ausgewählt, aber keine Punktwolke. Eine Punktwolke auswählen.</translation>
    </message>
    <message>
      <source>{names}: {count} points.</source>
      <translation>{names}: {count} Punkte.</translation>
    </message>
    <message>
      <source>{number} of {count}</source>
      <translation>{number} von {count}</translation>
    </message>
    <message>
      <source>{shown} of {whole} points are shown; all of them are computed with.</source>
      <translation>{shown} von {whole} Punkten werden angezeigt; gerechnet wird mit allen.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScanPreferences</name>
    <message>
      <source>&amp;Move clouds that lie far away near the origin</source>
      <translation>Punktwolken, die weit weg liegen, &amp;nahe an den Ursprung rücken</translation>
    </message>
    <message>
      <source>&amp;Point size:</source>
      <translation>&amp;Punktgröße:</translation>
    </message>
    <message>
      <source>&amp;Shade imported clouds</source>
      <translation>Importierte Punktwolken &amp;schattieren</translation>
    </message>
    <message>
      <source>&amp;Unit of the files:</source>
      <translation>&amp;Einheit der Dateien:</translation>
    </message>
    <message>
      <source>A document keeps points with seven digits: of a cloud kilometres away, tenths of a millimetre would be lost.</source>
      <translation>Ein Dokument hält Punkte mit sieben Stellen: Von einer kilometerweit entfernten Punktwolke gingen Zehntelmillimeter verloren.</translation>
    </message>
    <message>
      <source>Cloud files do not say in which unit they are. The import dialog begins with this one.</source>
      <translation>Dateien von Punktwolken sagen nicht, in welcher Einheit sie sind. Der Importdialog beginnt mit dieser.</translation>
    </message>
    <message>
      <source>General</source>
      <translation>Allgemein</translation>
    </message>
    <message>
      <source>How clouds look</source>
      <translation>Aussehen von Punktwolken</translation>
    </message>
    <message>
      <source>Importing clouds</source>
      <translation>Punktwolken importieren</translation>
    </message>
    <message>
      <source>Inches</source>
      <translation>Zoll</translation>
    </message>
    <message>
      <source>Metres</source>
      <translation>Meter</translation>
    </message>
    <message>
      <source>Millimetres</source>
      <translation>Millimeter</translation>
    </message>
    <message>
      <source>Of new clouds, in pixels. Each cloud can be changed in its view properties.</source>
      <translation>Neuer Punktwolken, in Pixeln. Jede Punktwolke lässt sich in ihren Ansichtseigenschaften ändern.</translation>
    </message>
    <message>
      <source>Points get greys as if light fell on the surface they lie on. Clouds of more than 500 000 points stay as they are.</source>
      <translation>Punkte bekommen Grautöne, als fiele Licht auf die Oberfläche, auf der sie liegen. Punktwolken mit mehr als 500 000 Punkten bleiben, wie sie sind.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_CloudSection</name>
    <message>
      <source>Cross-section</source>
      <translation>Querschnitt</translation>
    </message>
    <message>
      <source>Cut a cloud across an edge and fit a line, arc or spline. Select the cloud and the edge, and another edge to which the profile leads.</source>
      <translation>Eine Punktwolke quer zu einer Kante schneiden und Gerade, Bogen oder Spline anpassen. Die Punktwolke und die Kante auswählen, und eine weitere Kante, zu der das Profil führt.</translation>
    </message>
    <message>
      <source>Select a cloud and one or two edges</source>
      <translation>Eine Punktwolke und eine oder zwei Kanten auswählen</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_CloudSegment</name>
    <message>
      <source>Segment cloud</source>
      <translation>Punktwolke segmentieren</translation>
    </message>
    <message>
      <source>Select a cloud and a surface, or a network of edges</source>
      <translation>Punktwolke und Fläche wählen, oder ein Kantennetz</translation>
    </message>
    <message>
      <source>Take the points near a surface, or of one face between edges, as a cloud of their own. Select the cloud and the surface; or a network of edges, then click on the face.</source>
      <translation>Die Punkte nahe einer Fläche, oder die einer Fläche zwischen Kanten, als eigene Punktwolke nehmen. Wählen Sie die Punktwolke und die Fläche; oder ein Kantennetz, und klicken Sie dann auf die Fläche.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_CompensateCloud</name>
    <message>
      <source>Compensate cloud</source>
      <translation>Punktwolke korrigieren</translation>
    </message>
    <message>
      <source>Move the centres of a probing ball onto the part they touched. Select a cloud whose ProbeRadius is set.</source>
      <translation>Die Mittelpunkte einer Tastkugel auf das Teil rücken, das sie berührte. Eine Punktwolke auswählen, deren ProbeRadius gesetzt ist.</translation>
    </message>
    <message>
      <source>Select a cloud of probe centres</source>
      <translation>Eine Punktwolke aus Tastermittelpunkten auswählen</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_DeviationMap</name>
    <message>
      <source>Deviation map</source>
      <translation>Abweichungskarte</translation>
    </message>
    <message>
      <source>Select a cloud, and a surface or part</source>
      <translation>Eine Punktwolke und eine Fläche oder ein Teil auswählen</translation>
    </message>
    <message>
      <source>Show in colours how far a cloud is from a surface or part. Select the cloud and the surface or part.</source>
      <translation>In Farben zeigen, wie weit eine Punktwolke von einer Fläche oder einem Teil entfernt ist. Die Punktwolke und die Fläche oder das Teil auswählen.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_EdgeWire</name>
    <message>
      <source>Join edges that follow each other to a wire, for sweeps, lofts and sketches. Select the edges of a network in the 3D view, the others with Ctrl held.</source>
      <translation>Aufeinander folgende Kanten zu einem Linienzug verbinden, für Sweeps, Lofts und Skizzen. Wählen Sie die Kanten eines Netzes in der 3D-Ansicht, die weiteren mit gedrückter Strg-Taste.</translation>
    </message>
    <message>
      <source>Select edges of a network, from corner to corner</source>
      <translation>Kanten eines Netzes wählen, von Ecke zu Ecke</translation>
    </message>
    <message>
      <source>Wire of edges</source>
      <translation>Linienzug aus Kanten</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_Export</name>
    <message>
      <source>Export…</source>
      <translation>Exportieren…</translation>
    </message>
    <message>
      <source>Select edges or surfaces, or nothing for all</source>
      <translation>Kanten oder Flächen auswählen, oder nichts für alle</translation>
    </message>
    <message>
      <source>Write edges and surfaces as STEP, or edge points with their sigma as CSV, in the coordinates of the scan. Select what to write, or nothing for everything shown.</source>
      <translation>Kanten und Flächen als STEP schreiben, oder Kantenpunkte mit ihrem Sigma als CSV, in den Koordinaten des Scans. Auswählen, was geschrieben werden soll, oder nichts für alles Eingeblendete.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ExtendSurface</name>
    <message>
      <source>Extend surface</source>
      <translation>Fläche verlängern</translation>
    </message>
    <message>
      <source>Make a surface longer over one of its sides. Select the surface; choose the side in its properties.</source>
      <translation>Eine Fläche über eine ihrer Seiten hinaus verlängern. Die Fläche auswählen; die Seite in ihren Eigenschaften wählen.</translation>
    </message>
    <message>
      <source>Select one surface</source>
      <translation>Eine Fläche auswählen</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_FittedSurface</name>
    <message>
      <source>Fit a surface to a cloud near another surface, between four edges, or round the plane, cylinder, cone or sphere that the cloud lies on. Select the cloud, and the surface or the four edges.</source>
      <translation>Eine Fläche an eine Punktwolke anpassen: nahe einer anderen Fläche, zwischen vier Kanten, oder an der Ebene, dem Zylinder, dem Kegel oder der Kugel, auf der die Punktwolke liegt. Die Punktwolke auswählen, und die Fläche oder die vier Kanten.</translation>
    </message>
    <message>
      <source>Fit surface</source>
      <translation>Fläche anpassen</translation>
    </message>
    <message>
      <source>Select a cloud, and a surface near it or four edges</source>
      <translation>Eine Punktwolke und eine Fläche nahe ihr oder vier Kanten auswählen</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ImportCloud</name>
    <message>
      <source>Choose one or more cloud files</source>
      <translation>Eine oder mehrere Dateien mit Punktwolken wählen</translation>
    </message>
    <message>
      <source>Import cloud…</source>
      <translation>Punktwolke importieren…</translation>
    </message>
    <message>
      <source>Import point clouds from files (xyz, txt, asc, csv, ply, pcd, e57, stl, obj). Nothing needs to be selected.</source>
      <translation>Punktwolken aus Dateien importieren (xyz, txt, asc, csv, ply, pcd, e57, stl, obj). Nichts muss ausgewählt sein.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_IntersectSurfaces</name>
    <message>
      <source>Find all curves in which two surfaces meet. Select two of them.</source>
      <translation>Alle Kurven finden, in denen sich zwei Flächen treffen. Zwei Flächen auswählen.</translation>
    </message>
    <message>
      <source>Intersect surfaces</source>
      <translation>Flächen schneiden</translation>
    </message>
    <message>
      <source>Select two surfaces</source>
      <translation>Zwei Flächen auswählen</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_Loft</name>
    <message>
      <source>Loft through edges</source>
      <translation>Loft durch Kanten</translation>
    </message>
    <message>
      <source>Make a skin through edges or sections. Select two or more of them, in order.</source>
      <translation>Eine Haut durch Kanten oder Schnitte legen. Zwei oder mehr davon auswählen, der Reihe nach.</translation>
    </message>
    <message>
      <source>Select two or more edges or sections, in order</source>
      <translation>Zwei oder mehr Kanten oder Schnitte auswählen, der Reihe nach</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_RecommendParameters</name>
    <message>
      <source>Click near an edge</source>
      <translation>Nahe einer Kante klicken</translation>
    </message>
    <message>
      <source>Measure the cloud near an edge and say how to scan it, why, and which error to expect. Click near the edge; nothing needs to be selected before.</source>
      <translation>Die Punktwolke nahe einer Kante messen und sagen, wie man diese abtastet, warum, und welcher Fehler zu erwarten ist. Nahe der Kante klicken; vorher muss nichts ausgewählt sein.</translation>
    </message>
    <message>
      <source>Recommend parameters</source>
      <translation>Parameter empfehlen</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_Report</name>
    <message>
      <source>Report…</source>
      <translation>Bericht…</translation>
    </message>
    <message>
      <source>Write one page about this document: clouds, edges, surfaces, their figures and pictures. Nothing needs to be selected.</source>
      <translation>Eine Seite über dieses Dokument schreiben: Punktwolken, Kanten, Flächen, ihre Zahlen und Bilder. Nichts muss ausgewählt sein.</translation>
    </message>
    <message>
      <source>Writes a page about this document</source>
      <translation>Schreibt eine Seite über dieses Dokument</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ScanAllEdges</name>
    <message>
      <source>Find all edges of a cloud and where they meet, and choose which to keep. Select the cloud; when only one is shown nothing needs to be selected.</source>
      <translation>Alle Kanten einer Punktwolke finden und wo sie sich treffen, und wählen, welche bleiben. Wählen Sie die Punktwolke aus; wenn nur eine zu sehen ist, muss nichts ausgewählt werden.</translation>
    </message>
    <message>
      <source>Scan all edges</source>
      <translation>Alle Kanten abtasten</translation>
    </message>
    <message>
      <source>Select a cloud, unless only one is shown</source>
      <translation>Eine Punktwolke wählen, außer wenn nur eine zu sehen ist</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ScanBoundary</name>
    <message>
      <source>Click near an edge, then on the face</source>
      <translation>Nahe einer Kante klicken, dann auf die Fläche</translation>
    </message>
    <message>
      <source>Scan all edges round one face. Click near one of its edges, then on the face; nothing needs to be selected before.</source>
      <translation>Alle Kanten um eine Fläche abtasten. Nahe einer ihrer Kanten klicken, dann auf die Fläche; vorher muss nichts ausgewählt sein.</translation>
    </message>
    <message>
      <source>Scan boundary</source>
      <translation>Umrandung abtasten</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ScanEdge</name>
    <message>
      <source>Click on a cloud, near an edge</source>
      <translation>Auf eine Punktwolke klicken, nahe einer Kante</translation>
    </message>
    <message>
      <source>Click on a visible cloud, near an edge: the edge is followed both ways until it ends. Nothing needs to be selected before.</source>
      <translation>Auf eine sichtbare Punktwolke klicken, nahe einer Kante: Die Kante wird in beide Richtungen verfolgt, bis sie endet. Vorher muss nichts ausgewählt sein.</translation>
    </message>
    <message>
      <source>Scan edge</source>
      <translation>Kante abtasten</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_SimulatedCloud</name>
    <message>
      <source>Scan a part without a scanner, with the pitch, noise and probe you choose. Select an object with faces, or nothing to scan the core box of the case study.</source>
      <translation>Ein Teil ohne Scanner scannen, mit Punktabstand, Rauschen und Taster nach Wahl. Ein Objekt mit Flächen auswählen, oder nichts, um den Kernkasten der Fallstudie zu scannen.</translation>
    </message>
    <message>
      <source>Select a part, or nothing</source>
      <translation>Ein Teil auswählen, oder nichts</translation>
    </message>
    <message>
      <source>Simulated cloud…</source>
      <translation>Simulierte Punktwolke…</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_Sweep</name>
    <message>
      <source>Select a profile, then an edge</source>
      <translation>Ein Profil auswählen, dann eine Kante</translation>
    </message>
    <message>
      <source>Sweep a profile along an edge. Select the profile (a sketch, wire or edge), then the scanned edge.</source>
      <translation>Ein Profil an einer Kante entlang bewegen. Das Profil auswählen (eine Skizze, einen Kantenzug oder eine Kante), dann die abgetastete Kante.</translation>
    </message>
    <message>
      <source>Sweep along edge</source>
      <translation>Sweep entlang einer Kante</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_SweptSurface</name>
    <message>
      <source>Select one or two rails, profiles in order, and a cloud</source>
      <translation>Eine oder zwei Leitkurven, Profile der Reihe nach und eine Punktwolke auswählen</translation>
    </message>
    <message>
      <source>Sweep profiles along one or two rails, fitted to a cloud. Select the rails, then the profiles in order, and a cloud when there is one.</source>
      <translation>Profile an einer oder zwei Leitkurven entlang bewegen, angepasst an eine Punktwolke. Die Leitkurven auswählen, dann die Profile der Reihe nach, und eine Punktwolke, wenn es sie gibt.</translation>
    </message>
    <message>
      <source>Swept surface</source>
      <translation>Sweep-Fläche</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ThinCloud</name>
    <message>
      <source>Keep fewer points, evenly spread over the surface. Select a cloud.</source>
      <translation>Weniger Punkte behalten, gleichmäßig über die Oberfläche verteilt. Eine Punktwolke auswählen.</translation>
    </message>
    <message>
      <source>Select a cloud</source>
      <translation>Eine Punktwolke auswählen</translation>
    </message>
    <message>
      <source>Thin cloud…</source>
      <translation>Punktwolke ausdünnen…</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_TrimmedShell</name>
    <message>
      <source>Select surfaces, and the edges at which they end</source>
      <translation>Flächen auswählen, und die Kanten, an denen sie enden</translation>
    </message>
    <message>
      <source>Trim and sew surfaces</source>
      <translation>Flächen trimmen und vernähen</translation>
    </message>
    <message>
      <source>Trim surfaces where they meet, drop what sticks out, and sew the rest into a shell. Select the surfaces, and the edges at which they end.</source>
      <translation>Flächen trimmen, wo sie sich treffen, Überstehendes weglassen und den Rest zu einer Schale vernähen. Die Flächen auswählen, und die Kanten, an denen sie enden.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_TryIt</name>
    <message>
      <source>Open the simulated scan of a core box and find its first edge in three steps. Nothing needs to be selected.</source>
      <translation>Den simulierten Scan eines Kernkastens öffnen und in drei Schritten seine erste Kante finden. Nichts muss ausgewählt sein.</translation>
    </message>
    <message>
      <source>Opens an example with a short guide</source>
      <translation>Öffnet ein Beispiel mit einer kurzen Anleitung</translation>
    </message>
    <message>
      <source>Try it</source>
      <translation>Ausprobieren</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <source>EdgeScan clouds</source>
      <translation>EdgeScan: Punktwolken</translation>
    </message>
    <message>
      <source>EdgeScan edges</source>
      <translation>EdgeScan: Kanten</translation>
    </message>
    <message>
      <source>EdgeScan results</source>
      <translation>EdgeScan: Ergebnisse</translation>
    </message>
    <message>
      <source>EdgeScan surfaces</source>
      <translation>EdgeScan: Flächen</translation>
    </message>
    <message>
      <source>EdgeScan sweeps</source>
      <translation>EdgeScan: Sweeps</translation>
    </message>
  </context>
</TS>

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
  <context>
    <name>App::Property</name>
    <message>
      <source>1 / √(points per mm²) of what remains, where the cloud is denser</source>
      <translation>1 / √(points par mm²) de ce qui reste, là où le nuage est plus dense</translation>
    </message>
    <message>
      <source>A place near one of the edges</source>
      <translation>Un endroit près de l'une des arêtes</translation>
    </message>
    <message>
      <source>A place on the face between the network's edges</source>
      <translation>Un endroit sur la face entre les arêtes du réseau</translation>
    </message>
    <message>
      <source>A place on the face, beside that edge</source>
      <translation>Un endroit sur la face, à côté de cette arête</translation>
    </message>
    <message>
      <source>A point on each edge that is kept all the same</source>
      <translation>Un point sur chaque arête gardée malgré tout</translation>
    </message>
    <message>
      <source>A point on each edge that is left out by hand</source>
      <translation>Un point sur chaque arête écartée à la main</translation>
    </message>
    <message>
      <source>A point on each of the edges, in any order</source>
      <translation>Un point sur chacune des arêtes, dans un ordre quelconque</translation>
    </message>
    <message>
      <source>A surface or any other shape with faces</source>
      <translation>Une surface ou toute autre forme ayant des faces</translation>
    </message>
    <message>
      <source>Add this to the document's coordinates to get those of the cloud's source</source>
      <translation>À ajouter aux coordonnées du document pour obtenir celles de la source du nuage</translation>
    </message>
    <message>
      <source>Add this to the document's coordinates to get those of the file; a cloud far from the origin would lose its precision otherwise</source>
      <translation>À ajouter aux coordonnées du document pour obtenir celles du fichier ; sinon un nuage loin de l'origine perdrait sa précision</translation>
    </message>
    <message>
      <source>Always 0: the points lie on the part's surface</source>
      <translation>Toujours 0 : les points sont sur la surface de la pièce</translation>
    </message>
    <message>
      <source>Amplitude that was used</source>
      <translation>Amplitude utilisée</translation>
    </message>
    <message>
      <source>Angle between the two sides at the edge points, rad</source>
      <translation>Angle entre les deux côtés aux points de l'arête, rad</translation>
    </message>
    <message>
      <source>Another rail: the profile runs from rail to rail</source>
      <translation>Un autre rail : le profil va de rail à rail</translation>
    </message>
    <message>
      <source>Approach that was used</source>
      <translation>Direction d'approche utilisée</translation>
    </message>
    <message>
      <source>ChordHeight that was used</source>
      <translation>Flèche utilisée</translation>
    </message>
    <message>
      <source>Cloud or segment the surface is fitted to</source>
      <translation>Nuage ou segment auquel la surface est ajustée</translation>
    </message>
    <message>
      <source>Cloud or segment the sweep is fitted to, or nothing</source>
      <translation>Nuage ou segment auquel le balayage est ajusté, ou rien</translation>
    </message>
    <message>
      <source>CloudPitch that was used</source>
      <translation>Pas du nuage utilisé</translation>
    </message>
    <message>
      <source>Compensation that was used</source>
      <translation>Compensation utilisée</translation>
    </message>
    <message>
      <source>Control points in u; 0: as many as Tolerance asks for</source>
      <translation>Points de contrôle en u ; 0 : autant que Tolerance l'exige</translation>
    </message>
    <message>
      <source>Control points in v; 0: as many as Tolerance asks for</source>
      <translation>Points de contrôle en v ; 0 : autant que Tolerance l'exige</translation>
    </message>
    <message>
      <source>Control points of each fitted profile</source>
      <translation>Points de contrôle de chaque profil ajusté</translation>
    </message>
    <message>
      <source>Control points of each fitted rail</source>
      <translation>Points de contrôle de chaque rail ajusté</translation>
    </message>
    <message>
      <source>Covariance across the edge as (aa, ab, bb), mm²; axes n1 + n2 and n1 - n2</source>
      <translation>Covariance en travers de l'arête, (aa, ab, bb), mm² ; axes n1 + n2 et n1 - n2</translation>
    </message>
    <message>
      <source>Curves from the first rail to the second, in order</source>
      <translation>Courbes du premier rail au second, dans l'ordre</translation>
    </message>
    <message>
      <source>Degree in u</source>
      <translation>Degré en u</translation>
    </message>
    <message>
      <source>Degree in v</source>
      <translation>Degré en v</translation>
    </message>
    <message>
      <source>Degree of a line section, 1 to 3; 0: automatic</source>
      <translation>Degré d'une section de ligne, 1 à 3 ; 0 : automatique</translation>
    </message>
    <message>
      <source>Degree that was used</source>
      <translation>Degré utilisé</translation>
    </message>
    <message>
      <source>Deviation of the strongest colours</source>
      <translation>Écart des couleurs les plus fortes</translation>
    </message>
    <message>
      <source>Deviation of the strongest colours; 0: 99.5 % of all deviations are below</source>
      <translation>Écart des couleurs les plus fortes ; 0 : 99,5 % des écarts sont inférieurs</translation>
    </message>
    <message>
      <source>Direction of the first scan line, across the edge; (0, 0, 0): At is a click near the edge</source>
      <translation>Direction de la première ligne de palpage, en travers de l'arête ; (0, 0, 0) : At est un clic près de l'arête</translation>
    </message>
    <message>
      <source>Direction of the gate line, across the edge; (0, 0, 0): the gate is a point</source>
      <translation>Direction de la ligne d'arrivée, en travers de l'arête ; (0, 0, 0) : l'arrivée est un point</translation>
    </message>
    <message>
      <source>Direction of the walk along the edge; used with Across</source>
      <translation>Direction du parcours le long de l'arête ; utilisée avec Across</translation>
    </message>
    <message>
      <source>Direction the probe came along; (0, 0, 0): not known</source>
      <translation>Direction d'arrivée du palpeur ; (0, 0, 0) : inconnue</translation>
    </message>
    <message>
      <source>Direction the probe came along; (0, 0, 0): that of the cloud</source>
      <translation>Direction d'arrivée du palpeur ; (0, 0, 0) : celle du nuage</translation>
    </message>
    <message>
      <source>Direction the probe came along; the air lies against it. (0, 0, 0): not known</source>
      <translation>Direction d'arrivée du palpeur ; l'air est du côté opposé. (0, 0, 0) : inconnue</translation>
    </message>
    <message>
      <source>Distance of the edge points; 0: automatic</source>
      <translation>Distance entre les points de l'arête ; 0 : automatique</translation>
    </message>
    <message>
      <source>Distance of the points on a probed scan line; 0: automatic</source>
      <translation>Distance entre les points d'une ligne de palpage ; 0 : automatique</translation>
    </message>
    <message>
      <source>Edge points of all edges, document coordinates</source>
      <translation>Points de toutes les arêtes, coordonnées du document</translation>
    </message>
    <message>
      <source>Edge points, document coordinates</source>
      <translation>Points de l'arête, coordonnées du document</translation>
    </message>
    <message>
      <source>EdgePitch that was used</source>
      <translation>Pas utilisé le long de l'arête</translation>
    </message>
    <message>
      <source>Edges at which surfaces end where no other is</source>
      <translation>Arêtes où finissent les surfaces là où il n'y en a pas d'autre</translation>
    </message>
    <message>
      <source>Edges known worse than that are left out; 0: none</source>
      <translation>Les arêtes connues moins précisément sont laissées de côté ; 0 : aucune</translation>
    </message>
    <message>
      <source>False where the point rests on its neighbours: a gap, or too little of a side is smooth</source>
      <translation>Faux là où le point repose sur ses voisins : un trou, ou trop peu d'un côté est lisse</translation>
    </message>
    <message>
      <source>File the cloud was read from</source>
      <translation>Fichier d'où le nuage a été lu</translation>
    </message>
    <message>
      <source>From its beginning to its end</source>
      <translation>De son début à sa fin</translation>
    </message>
    <message>
      <source>How a probed scan finds the direction of the edge</source>
      <translation>Comment un palpage ligne par ligne trouve la direction de l'arête</translation>
    </message>
    <message>
      <source>How a probed scan places its next scan line</source>
      <translation>Comment un palpage ligne par ligne place la ligne suivante</translation>
    </message>
    <message>
      <source>How a probed scan takes off the probe radius</source>
      <translation>Comment un palpage ligne par ligne retire le rayon du palpeur</translation>
    </message>
    <message>
      <source>How a profile changes: blend moves and blends it, rotate turns it with the rails, better is the one that explains the cloud better (rotate without a cloud)</source>
      <translation>Comment un profil change : blend le déplace et le mélange, rotate le tourne avec les rails, better est celui qui explique mieux le nuage (rotate sans nuage)</translation>
    </message>
    <message>
      <source>How edge points are found: patch uses all the points on both sides, probe touches the cloud line by line like a measuring machine</source>
      <translation>Comment les points de l'arête sont trouvés : patch utilise tous les points des deux côtés, probe palpe le nuage ligne par ligne comme une machine à mesurer</translation>
    </message>
    <message>
      <source>How far a profile may end beside its rail</source>
      <translation>À quelle distance de son rail un profil peut finir</translation>
    </message>
    <message>
      <source>How far from the rail the section goes; 0: automatic</source>
      <translation>Jusqu'où la section s'éloigne du rail ; 0 : automatique</translation>
    </message>
    <message>
      <source>How far the edges' own vertices are from each corner, mm</source>
      <translation>Distance entre chaque coin et les sommets propres des arêtes, en mm</translation>
    </message>
    <message>
      <source>How the probe radius was taken off each edge point</source>
      <translation>Comment le rayon du palpeur a été retiré à chaque point de l'arête</translation>
    </message>
    <message>
      <source>How the profile is kept from turning</source>
      <translation>Comment le profil est empêché de tourner</translation>
    </message>
    <message>
      <source>How the scan lines of a probed scan follow each other</source>
      <translation>Comment se suivent les lignes d'un palpage ligne par ligne</translation>
    </message>
    <message>
      <source>Inputs the result belongs to</source>
      <translation>Entrées auxquelles le résultat appartient</translation>
    </message>
    <message>
      <source>Largest absolute deviation</source>
      <translation>Plus grand écart absolu</translation>
    </message>
    <message>
      <source>Largest absolute deviation of a point from the profile</source>
      <translation>Plus grand écart absolu d'un point au profil</translation>
    </message>
    <message>
      <source>Largest absolute deviation of a point from the surface</source>
      <translation>Plus grand écart absolu d'un point à la surface</translation>
    </message>
    <message>
      <source>Largest deviation of the chord between two edge points; 0: automatic</source>
      <translation>Plus grand écart de la corde entre deux points de l'arête ; 0 : automatique</translation>
    </message>
    <message>
      <source>Largest standard deviation of an edge point</source>
      <translation>Plus grand écart-type d'un point de l'arête</translation>
    </message>
    <message>
      <source>Least turn between the two sides of an edge</source>
      <translation>Plus petit changement de direction entre les deux côtés d'une arête</translation>
    </message>
    <message>
      <source>Least turn between the two sides of an edge; 0: automatic</source>
      <translation>Plus petit changement de direction entre les deux côtés d'une arête ; 0 : automatique</translation>
    </message>
    <message>
      <source>Least turn between two sides; 0: automatic</source>
      <translation>Plus petit changement de direction entre deux côtés ; 0 : automatique</translation>
    </message>
    <message>
      <source>Length of a scan line along the surface, half on each side; 0: automatic</source>
      <translation>Longueur d'une ligne de palpage le long de la surface, moitié de chaque côté ; 0 : automatique</translation>
    </message>
    <message>
      <source>Length of all curves</source>
      <translation>Longueur de toutes les courbes</translation>
    </message>
    <message>
      <source>Length of all edges</source>
      <translation>Longueur de toutes les arêtes</translation>
    </message>
    <message>
      <source>Length of the edge</source>
      <translation>Longueur de l'arête</translation>
    </message>
    <message>
      <source>LinePitch that was used</source>
      <translation>Pas utilisé sur une ligne</translation>
    </message>
    <message>
      <source>Mean absolute deviation</source>
      <translation>Écart absolu moyen</translation>
    </message>
    <message>
      <source>Mean absolute deviation of the points from the profile</source>
      <translation>Écart absolu moyen des points au profil</translation>
    </message>
    <message>
      <source>Mean absolute deviation of the points from the surface</source>
      <translation>Écart absolu moyen des points à la surface</translation>
    </message>
    <message>
      <source>Mean angle between the two sides</source>
      <translation>Angle moyen entre les deux côtés</translation>
    </message>
    <message>
      <source>Mean deviation, signed</source>
      <translation>Écart moyen, avec son signe</translation>
    </message>
    <message>
      <source>Mean standard deviation of the edge points</source>
      <translation>Écart-type moyen des points de l'arête</translation>
    </message>
    <message>
      <source>Median angle between the two sides of each edge, degrees</source>
      <translation>Angle médian entre les deux côtés de chaque arête, en degrés</translation>
    </message>
    <message>
      <source>Median radius of the rounding; 0: none is measurable</source>
      <translation>Rayon médian de l'arrondi ; 0 : aucun n'est mesurable</translation>
    </message>
    <message>
      <source>Median standard deviation of each edge, mm</source>
      <translation>Écart-type médian de chaque arête, en mm</translation>
    </message>
    <message>
      <source>Number of corners in which edges meet</source>
      <translation>Nombre de coins où des arêtes se rejoignent</translation>
    </message>
    <message>
      <source>Number of curves</source>
      <translation>Nombre de courbes</translation>
    </message>
    <message>
      <source>Number of edge points</source>
      <translation>Nombre de points de l'arête</translation>
    </message>
    <message>
      <source>Number of edges</source>
      <translation>Nombre d'arêtes</translation>
    </message>
    <message>
      <source>Number of faces</source>
      <translation>Nombre de faces</translation>
    </message>
    <message>
      <source>Number of points</source>
      <translation>Nombre de points</translation>
    </message>
    <message>
      <source>Number of points beyond the surface's rim, left out</source>
      <translation>Nombre de points au-delà du bord de la surface, laissés de côté</translation>
    </message>
    <message>
      <source>Number of points of the section</source>
      <translation>Nombre de points de la section</translation>
    </message>
    <message>
      <source>Number of points that were measured</source>
      <translation>Nombre de points mesurés</translation>
    </message>
    <message>
      <source>Number of points the surface was fitted to; 0: to none</source>
      <translation>Nombre de points auxquels la surface a été ajustée ; 0 : aucun</translation>
    </message>
    <message>
      <source>Numbers of points in equal steps from -Limit to Limit</source>
      <translation>Nombres de points par pas égaux de -Limit à Limit</translation>
    </message>
    <message>
      <source>Of all edges</source>
      <translation>De toutes les arêtes</translation>
    </message>
    <message>
      <source>Of all faces</source>
      <translation>De toutes les faces</translation>
    </message>
    <message>
      <source>Of an edge; 0: eight times the cloud's pitch</source>
      <translation>D'une arête ; 0 : huit fois le pas du nuage</translation>
    </message>
    <message>
      <source>Of each edge: the corners it ends in, or why it ends</source>
      <translation>De chaque arête : les coins où elle finit, ou pourquoi elle finit</translation>
    </message>
    <message>
      <source>Of each point</source>
      <translation>De chaque point</translation>
    </message>
    <message>
      <source>Of each point, mm, positive on the normal's side</source>
      <translation>De chaque point, mm, positif du côté de la normale</translation>
    </message>
    <message>
      <source>Of the curves from both surfaces</source>
      <translation>Des courbes aux deux surfaces</translation>
    </message>
    <message>
      <source>Of the slab of points; 0: automatic</source>
      <translation>De la tranche de points ; 0 : automatique</translation>
    </message>
    <message>
      <source>Of the surface from the base surface, at most</source>
      <translation>De la surface à la surface de base, au plus</translation>
    </message>
    <message>
      <source>Of the surface from the exact sweep, without a cloud</source>
      <translation>De la surface au balayage exact, sans nuage</translation>
    </message>
    <message>
      <source>One or two curves along which profiles move</source>
      <translation>Une ou deux courbes le long desquelles les profils se déplacent</translation>
    </message>
    <message>
      <source>One point for each pitch² of surface</source>
      <translation>Un point par pas² de surface</translation>
    </message>
    <message>
      <source>Over which side: at the first (0) or last (1) parameter in u or v</source>
      <translation>Par quel côté : au premier (0) ou au dernier (1) paramètre en u ou v</translation>
    </message>
    <message>
      <source>Parameter range of the extension, as a share of that of the surface</source>
      <translation>Domaine de paramètre du prolongement, en part de celui de la surface</translation>
    </message>
    <message>
      <source>Pattern that was used</source>
      <translation>Motif utilisé</translation>
    </message>
    <message>
      <source>Pitch that tells a gap from surface in a probed scan; 0: automatic</source>
      <translation>Pas qui distingue un trou de la surface dans un palpage ligne par ligne ; 0 : automatique</translation>
    </message>
    <message>
      <source>Points farther from the shape are left out; 0: none is</source>
      <translation>Les points plus éloignés de la forme sont laissés de côté ; 0 : aucun</translation>
    </message>
    <message>
      <source>Points of a whole cloud nearer than this to the base surface belong to it; all of a segment do</source>
      <translation>Les points d'un nuage entier plus proches que cela de la surface de base en font partie ; d'un segment, tous</translation>
    </message>
    <message>
      <source>Points of a whole cloud nearer than this to the sweep belong to it; all of a segment do</source>
      <translation>Les points d'un nuage entier plus proches que cela du balayage en font partie ; d'un segment, tous</translation>
    </message>
    <message>
      <source>Points of the source that were left out because they hold nan or inf</source>
      <translation>Points de la source laissés de côté parce qu'ils contiennent nan ou inf</translation>
    </message>
    <message>
      <source>Prehit distance of the measuring machine; 0: automatic</source>
      <translation>Distance d'approche de la machine à mesurer ; 0 : automatique</translation>
    </message>
    <message>
      <source>PrehitDistance that was used</source>
      <translation>Distance d'approche utilisée</translation>
    </message>
    <message>
      <source>ProbeRadius that was used</source>
      <translation>Rayon du palpeur utilisé</translation>
    </message>
    <message>
      <source>Radius of an arc; 0: it is none</source>
      <translation>Rayon d'un arc ; 0 : ce n'en est pas un</translation>
    </message>
    <message>
      <source>Radius of the ball whose centres the cloud holds. Without OwnProbeRadius it is the cloud's and cannot be edited here: set it at the cloud, or set OwnProbeRadius</source>
      <translation>Rayon de la bille dont le nuage contient les centres. Sans OwnProbeRadius c'est celui du nuage, qui ne se change pas ici : le changer au nuage, ou cocher OwnProbeRadius</translation>
    </message>
    <message>
      <source>Radius of the ball whose centres the cloud holds; 0: the points lie on the surface</source>
      <translation>Rayon de la bille dont le nuage contient les centres ; 0 : les points sont sur la surface</translation>
    </message>
    <message>
      <source>Radius of the ball whose centres the points are</source>
      <translation>Rayon de la bille dont les points sont les centres</translation>
    </message>
    <message>
      <source>Radius of the rounding at the edge points, mm, or nan</source>
      <translation>Rayon de l'arrondi aux points de l'arête, mm, ou nan</translation>
    </message>
    <message>
      <source>Rims and edges nearer to each other than this are one</source>
      <translation>Les bords et arêtes plus proches que cela les uns des autres ne font qu'un</translation>
    </message>
    <message>
      <source>Root mean square deviation</source>
      <translation>Écart quadratique moyen</translation>
    </message>
    <message>
      <source>Root mean square deviation of the points</source>
      <translation>Écart quadratique moyen des points</translation>
    </message>
    <message>
      <source>Scanning tolerance of a probed line section; 0: automatic</source>
      <translation>Tolérance d'une section de ligne dans un palpage ligne par ligne ; 0 : automatique</translation>
    </message>
    <message>
      <source>Search distance of the measuring machine; 0: automatic</source>
      <translation>Distance de recherche de la machine à mesurer ; 0 : automatique</translation>
    </message>
    <message>
      <source>SearchDistance that was used</source>
      <translation>Distance de recherche utilisée</translation>
    </message>
    <message>
      <source>Shading of the points</source>
      <translation>Ombrage des points</translation>
    </message>
    <message>
      <source>Share of the surface's area where there are points enough</source>
      <translation>Part de l'aire de la surface où il y a assez de points</translation>
    </message>
    <message>
      <source>Show colour bar and histogram</source>
      <translation>Montrer l'échelle de couleurs et l'histogramme</translation>
    </message>
    <message>
      <source>Show each edge point in the colour of its sigma, from blue (well known) to yellow</source>
      <translation>Afficher chaque point d'arête dans la couleur de son sigma, du bleu (bien connu) au jaune</translation>
    </message>
    <message>
      <source>Show where across the edge each of its points was measured</source>
      <translation>Afficher où, en travers de l'arête, chacun de ses points a été mesuré</translation>
    </message>
    <message>
      <source>Standard deviation of the edge points, mm</source>
      <translation>Écart-type des points de l'arête, mm</translation>
    </message>
    <message>
      <source>Standard deviation of the points along the normal</source>
      <translation>Écart-type des points le long de la normale</translation>
    </message>
    <message>
      <source>Standard deviation of the radii, mm, or nan</source>
      <translation>Écart-type des rayons, mm, ou nan</translation>
    </message>
    <message>
      <source>Steering that was used</source>
      <translation>Guidage utilisé</translation>
    </message>
    <message>
      <source>Surface near the points, or a network of edges</source>
      <translation>Surface proche des points, ou un réseau d'arêtes</translation>
    </message>
    <message>
      <source>Surface near the points; it gives the fit its rim</source>
      <translation>Surface près des points ; elle donne son bord à la surface ajustée</translation>
    </message>
    <message>
      <source>Surfaces that reach beyond where they meet</source>
      <translation>Surfaces qui s'étendent au-delà de leurs intersections</translation>
    </message>
    <message>
      <source>Tangent that was used</source>
      <translation>Tangente utilisée</translation>
    </message>
    <message>
      <source>The cloud of centres of a ball</source>
      <translation>Le nuage des centres d'une bille</translation>
    </message>
    <message>
      <source>The cloud of which this is a part</source>
      <translation>Le nuage dont ceci est une partie</translation>
    </message>
    <message>
      <source>The cloud that is cut</source>
      <translation>Le nuage qui est coupé</translation>
    </message>
    <message>
      <source>The cloud that is scanned</source>
      <translation>Le nuage qui est palpé</translation>
    </message>
    <message>
      <source>The cloud whose edges are sought</source>
      <translation>Le nuage dont on cherche les arêtes</translation>
    </message>
    <message>
      <source>The cloud whose points are measured</source>
      <translation>Le nuage dont les points sont mesurés</translation>
    </message>
    <message>
      <source>The edge across which it is cut</source>
      <translation>L'arête en travers de laquelle il est coupé</translation>
    </message>
    <message>
      <source>The model of the surface</source>
      <translation>Le modèle de la surface</translation>
    </message>
    <message>
      <source>The part that is scanned: any object with faces</source>
      <translation>La pièce qui est scannée : tout objet ayant des faces</translation>
    </message>
    <message>
      <source>The point cloud, a Points object, that is scanned</source>
      <translation>Le nuage de points, un objet Points, qui est palpé</translation>
    </message>
    <message>
      <source>The profile that is moved: one object</source>
      <translation>Le profil qui est déplacé : un objet</translation>
    </message>
    <message>
      <source>The rail: an object and the names of its edges</source>
      <translation>Le rail : un objet et les noms de ses arêtes</translation>
    </message>
    <message>
      <source>The same seed gives the same cloud</source>
      <translation>La même graine donne le même nuage</translation>
    </message>
    <message>
      <source>The search ends when it has found so many; 0: all</source>
      <translation>La recherche s'arrête quand elle en a trouvé autant ; 0 : toutes</translation>
    </message>
    <message>
      <source>The surface that is extended: one face</source>
      <translation>La surface qui est prolongée : une seule face</translation>
    </message>
    <message>
      <source>Tolerance that was used</source>
      <translation>Tolérance utilisée</translation>
    </message>
    <message>
      <source>Unit normals of the first side at the edge points</source>
      <translation>Normales unitaires du premier côté aux points de l'arête</translation>
    </message>
    <message>
      <source>Unit normals of the second side at the edge points</source>
      <translation>Normales unitaires du second côté aux points de l'arête</translation>
    </message>
    <message>
      <source>Unit tangents at the edge points</source>
      <translation>Tangentes unitaires aux points de l'arête</translation>
    </message>
    <message>
      <source>Version of these properties</source>
      <translation>Version de ces propriétés</translation>
    </message>
    <message>
      <source>What happened, and what to try</source>
      <translation>Ce qui s'est passé, et ce qu'on peut essayer</translation>
    </message>
    <message>
      <source>What holds the edges, such as an edge network</source>
      <translation>Ce qui contient les arêtes, par exemple un réseau d'arêtes</translation>
    </message>
    <message>
      <source>What is fitted to the points</source>
      <translation>Ce qui est ajusté aux points</translation>
    </message>
    <message>
      <source>What meets it</source>
      <translation>Ce qu'elle rencontre</translation>
    </message>
    <message>
      <source>What the sweep is besides: ruled, extrusion, revolution, pipe</source>
      <translation>Ce que le balayage est aussi : réglé, extrusion, révolution, tube</translation>
    </message>
    <message>
      <source>What was fitted: line, arc or spline</source>
      <translation>Ce qui a été ajusté : droite, arc ou spline</translation>
    </message>
    <message>
      <source>Where edges meet</source>
      <translation>Où des arêtes se rejoignent</translation>
    </message>
    <message>
      <source>Where the scan begins: a point near the edge, or, with Across and Along, the first point of the first scan line (document coordinates)</source>
      <translation>Où le palpage commence : un point près de l'arête ou, avec Across et Along, le premier point de la première ligne (coordonnées du document)</translation>
    </message>
    <message>
      <source>Where the scan ends: a point, or, with GateAcross, the first end of a gate line</source>
      <translation>Où le palpage finit : un point ou, avec GateAcross, la première extrémité d'une ligne d'arrivée</translation>
    </message>
    <message>
      <source>Where: share of the rail's length, 0 to 1</source>
      <translation>Où : part de la longueur du rail, de 0 à 1</translation>
    </message>
    <message>
      <source>Whether Tau is given; else it is chosen</source>
      <translation>Si Tau est donné ; sinon il est choisi</translation>
    </message>
    <message>
      <source>Whether a closed profile gives a solid</source>
      <translation>Si un profil fermé donne un solide</translation>
    </message>
    <message>
      <source>Whether a closed shell becomes a solid</source>
      <translation>Si une coque fermée devient un solide</translation>
    </message>
    <message>
      <source>Whether an extrusion or revolution, as Kinds says, is made as a surface of this kind</source>
      <translation>Si une extrusion ou une révolution, selon Kinds, est faite comme surface de ce genre</translation>
    </message>
    <message>
      <source>Whether it ends where it begins</source>
      <translation>S'il se termine là où il commence</translation>
    </message>
    <message>
      <source>Whether material fills the smaller wedge: yes, no or unknown</source>
      <translation>Si la matière remplit le plus petit coin : yes (oui), no (non) ou unknown (inconnu)</translation>
    </message>
    <message>
      <source>Whether rails that go on beyond the outer profiles by more than LargestGap end where these do</source>
      <translation>Si les rails qui dépassent les profils extérieurs de plus de LargestGap finissent avec ceux-ci</translation>
    </message>
    <message>
      <source>Whether the edge comes back to its start</source>
      <translation>Si l'arête revient à son début</translation>
    </message>
    <message>
      <source>Whether the scan ends at Gate; else where the edge ends</source>
      <translation>Si le palpage finit à l'arrivée (Gate) ; sinon là où l'arête finit</translation>
    </message>
    <message>
      <source>Whether the shell has no rim</source>
      <translation>Si la coque n'a pas de bord</translation>
    </message>
    <message>
      <source>Whether this edge has a ProbeRadius of its own; else that of the cloud counts</source>
      <translation>Si cette arête a son propre rayon de palpeur ; sinon celui du nuage compte</translation>
    </message>
    <message>
      <source>Which edge each of them belongs to, from 1</source>
      <translation>À quelle arête chacun d'eux appartient, à partir de 1</translation>
    </message>
    <message>
      <source>Why each automatic value was chosen</source>
      <translation>Pourquoi chaque valeur automatique a été choisie</translation>
    </message>
    <message>
      <source>Why the edge ends, at its start and at its end</source>
      <translation>Pourquoi l'arête s'arrête, à son début et à sa fin</translation>
    </message>
    <message>
      <source>Why the first edge begins and the last one ends</source>
      <translation>Pourquoi la première arête commence et la dernière finit</translation>
    </message>
    <message>
      <source>Without a base: four edges round the surface; without these the plane, cylinder, cone, sphere or quadric that the cloud's points lie on is the base</source>
      <translation>Sans surface de base : quatre arêtes autour de la surface ; sans celles-ci, la base est le plan, le cylindre, le cône, la sphère ou la quadrique sur laquelle sont les points du nuage</translation>
    </message>
    <message>
      <source>Without numbers of control points: largest distance of a point from the surface at which no more are added; 0: the points' scatter decides</source>
      <translation>Sans nombres de points de contrôle : plus grande distance d'un point à la surface à laquelle on n'en ajoute plus ; 0 : la dispersion des points décide</translation>
    </message>
    <message>
      <source>τ of the extension: how its weights go on</source>
      <translation>τ du prolongement : comment ses poids continuent</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan</name>
    <message>
      <source>&amp;Move near the origin</source>
      <translation>&amp;Rapprocher de l'origine</translation>
    </message>
    <message>
      <source>&amp;Noise:</source>
      <translation>&amp;Bruit :</translation>
    </message>
    <message>
      <source>&amp;Part:</source>
      <translation>&amp;Pièce :</translation>
    </message>
    <message>
      <source>&amp;Pitch:</source>
      <translation>&amp;Pas :</translation>
    </message>
    <message>
      <source>&amp;Probe radius:</source>
      <translation>&amp;Rayon du palpeur :</translation>
    </message>
    <message>
      <source>&amp;Unit of the file:</source>
      <translation>&amp;Unité du fichier :</translation>
    </message>
    <message>
      <source>, rounding {radius}</source>
      <translation>, arrondi {radius}</translation>
    </message>
    <message>
      <source>1 (line)</source>
      <translation>1 (droite)</translation>
    </message>
    <message>
      <source>1 of 2: click near an edge of the face.</source>
      <translation>1 sur 2 : cliquez près d'une arête de la face.</translation>
    </message>
    <message>
      <source>1 of 3: click beside the edge, where the first scan line begins.</source>
      <translation>1 sur 3 : cliquez à côté de l'arête, où commence la première ligne de palpage.</translation>
    </message>
    <message>
      <source>2 (quadratic)</source>
      <translation>2 (quadratique)</translation>
    </message>
    <message>
      <source>2 of 2: click on the face, beside that edge.</source>
      <translation>2 sur 2 : cliquez sur la face, à côté de cette arête.</translation>
    </message>
    <message>
      <source>2 of 3: click across the edge, where that line leads.</source>
      <translation>2 sur 3 : cliquez de l'autre côté de l'arête, où mène cette ligne.</translation>
    </message>
    <message>
      <source>3 (cubic)</source>
      <translation>3 (cubique)</translation>
    </message>
    <message>
      <source>3 + 2 clicks: start and gate</source>
      <translation>3 + 2 clics : départ et arrivée</translation>
    </message>
    <message>
      <source>3 of 3: click along the edge, where the walk goes.</source>
      <translation>3 sur 3 : cliquez plus loin le long de l'arête, où va le parcours.</translation>
    </message>
    <message>
      <source>A cloud of a part whose edges are known exactly: to try EdgeScan, and to see what a scan with another pitch or noise would give.</source>
      <translation>Un nuage d'une pièce dont les arêtes sont connues exactement : pour essayer EdgeScan, et pour voir ce que donnerait un scan avec un autre pas ou un autre bruit.</translation>
    </message>
    <message>
      <source>All clouds of this document are hidden. Select one in the tree, or show it.</source>
      <translation>Tous les nuages de ce document sont masqués. Sélectionnez-en un dans l'arborescence, ou affichez-le.</translation>
    </message>
    <message>
      <source>All files</source>
      <translation>Tous les fichiers</translation>
    </message>
    <message>
      <source>All points (patch)</source>
      <translation>Tous les points (patch)</translation>
    </message>
    <message>
      <source>All points on both sides are the most accurate; line by line touches the cloud as a measuring machine touches a part</source>
      <translation>Tous les points des deux côtés sont le plus exact ; ligne par ligne palpe le nuage comme une machine à mesurer palpe une pièce</translation>
    </message>
    <message>
      <source>All {whole} points are shown.</source>
      <translation>Tous les {whole} points sont affichés.</translation>
    </message>
    <message>
      <source>Amplitude</source>
      <translation>Amplitude</translation>
    </message>
    <message>
      <source>Angle</source>
      <translation>Angle</translation>
    </message>
    <message>
      <source>Approach</source>
      <translation>Approche</translation>
    </message>
    <message>
      <source>Blue: well known. Yellow: the least known points of this edge</source>
      <translation>Bleu : bien connus. Jaune : les points les moins bien connus de cette arête</translation>
    </message>
    <message>
      <source>Bring a 3D view to the front, then start again.</source>
      <translation>Mettez une vue 3D au premier plan, puis recommencez.</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>Annuler</translation>
    </message>
    <message>
      <source>Change what you like; OK keeps it. A click on the cloud scans another edge.</source>
      <translation>Changez ce que vous voulez ; OK le garde. Un clic sur le nuage palpe une autre arête.</translation>
    </message>
    <message>
      <source>Chord height</source>
      <translation>Flèche</translation>
    </message>
    <message>
      <source>Click near the edge where the scan is to end. OK keeps all of it.</source>
      <translation>Cliquez près de l'arête, où le palpage doit finir. OK la garde en entier.</translation>
    </message>
    <message>
      <source>Click on an edge to drop or keep it. OK keeps those in orange.</source>
      <translation>Cliquez sur une arête pour l'écarter ou la garder. OK garde celles en orange.</translation>
    </message>
    <message>
      <source>Click on the cloud near a rim of the pipe: the edge is followed both ways until it ends. Then OK keeps it; Undo takes it away again.</source>
      <translation>Cliquez sur le nuage près d'un bord de la gorge : l'arête est suivie dans les deux sens jusqu'à sa fin. OK la garde ; Annuler la retire.</translation>
    </message>
    <message>
      <source>Click on the cloud, near the edge you want to scan.</source>
      <translation>Cliquez sur le nuage, près de l'arête à palper.</translation>
    </message>
    <message>
      <source>Click on the cloud, near the edge you want, where the scan begins.</source>
      <translation>Cliquez sur le nuage, près de l'arête voulue, où le palpage commence.</translation>
    </message>
    <message>
      <source>Click on the cloud, near the edge you want.</source>
      <translation>Cliquez sur le nuage, près de l'arête voulue.</translation>
    </message>
    <message>
      <source>Click on the face whose points you want, between the edges.</source>
      <translation>Cliquez sur la face, entre les arêtes, dont vous voulez les points.</translation>
    </message>
    <message>
      <source>Click to see the section there. Arrows: along the edge</source>
      <translation>Un clic montre la section à cet endroit. Flèches : le long de l'arête</translation>
    </message>
    <message>
      <source>Close the guide</source>
      <translation>Fermer le guide</translation>
    </message>
    <message>
      <source>Cloud files do not say in which unit their numbers are.</source>
      <translation>Les fichiers de nuages ne disent pas dans quelle unité sont leurs nombres.</translation>
    </message>
    <message>
      <source>Cloud pitch</source>
      <translation>Pas du nuage</translation>
    </message>
    <message>
      <source>Colour by sigma</source>
      <translation>Colorer selon sigma</translation>
    </message>
    <message>
      <source>Compensate cloud</source>
      <translation>Compenser le nuage</translation>
    </message>
    <message>
      <source>Compensation</source>
      <translation>Compensation</translation>
    </message>
    <message>
      <source>Computing. Cancel gives it up.</source>
      <translation>Calcul en cours. Annuler l'abandonne.</translation>
    </message>
    <message>
      <source>Core box of the case study</source>
      <translation>Boîte à noyau de l'étude de cas</translation>
    </message>
    <message>
      <source>Core box, a small piece</source>
      <translation>Boîte à noyau, un petit morceau</translation>
    </message>
    <message>
      <source>Cross-section of the edge</source>
      <translation>Section transversale de l'arête</translation>
    </message>
    <message>
      <source>Degree</source>
      <translation>Degré</translation>
    </message>
    <message>
      <source>Degree of a line section</source>
      <translation>Degré d'une section de ligne</translation>
    </message>
    <message>
      <source>Direction the probe came along; the air lies against it</source>
      <translation>Direction d'arrivée du palpeur ; l'air est du côté opposé</translation>
    </message>
    <message>
      <source>Distance of the cloud's points, which tells a gap from surface</source>
      <translation>Distance entre les points du nuage, qui distingue un trou de la surface</translation>
    </message>
    <message>
      <source>Distance of the edge points</source>
      <translation>Distance entre les points de l'arête</translation>
    </message>
    <message>
      <source>Distance of the points on a scan line</source>
      <translation>Distance entre les points d'une ligne de palpage</translation>
    </message>
    <message>
      <source>Edge of {length}, turn {turn}, sigma {sigma}</source>
      <translation>Arête de {length}, angle de pli {turn}, sigma {sigma}</translation>
    </message>
    <message>
      <source>Edge pitch</source>
      <translation>Pas d'arête</translation>
    </message>
    <message>
      <source>Edge point</source>
      <translation>Point d'arête</translation>
    </message>
    <message>
      <source>Edge points with sigma</source>
      <translation>Points d'arête avec sigma</translation>
    </message>
    <message>
      <source>Edge {number}</source>
      <translation>Arête {number}</translation>
    </message>
    <message>
      <source>EdgeScan needs the Python package {package}, which is not installed. Install it (on Debian: apt install python3-{package}) and start FreeCAD again.</source>
      <translation>EdgeScan a besoin du paquet Python {package}, qui n'est pas installé. Installez-le (sous Debian : apt install python3-{package}) et redémarrez FreeCAD.</translation>
    </message>
    <message>
      <source>Edges and surfaces</source>
      <translation>Arêtes et surfaces</translation>
    </message>
    <message>
      <source>Edges known worse are left out: the median of sigma along them counts</source>
      <translation>Les arêtes moins bien connues sont écartées : c'est la médiane de sigma le long de l'arête qui compte</translation>
    </message>
    <message>
      <source>Edges of {count} objects are selected. Select edges of one network in the 3D view, the others with Ctrl held.</source>
      <translation>Des arêtes de {count} objets sont sélectionnées. Sélectionnez des arêtes d'un seul réseau dans la vue 3D, les suivantes avec Ctrl enfoncé.</translation>
    </message>
    <message>
      <source>Edges whose sides turn less are left out: 90° at the edge of a box</source>
      <translation>Les arêtes dont les côtés tournent moins sont écartées : 90° à l'arête d'une boîte</translation>
    </message>
    <message>
      <source>Edit network of edges</source>
      <translation>Modifier le réseau d'arêtes</translation>
    </message>
    <message>
      <source>Edit scanned edge</source>
      <translation>Modifier l'arête palpée</translation>
    </message>
    <message>
      <source>Edit the scan</source>
      <translation>Modifier le palpage</translation>
    </message>
    <message>
      <source>End the scan and keep the edge as far as it is known</source>
      <translation>Finir le palpage et garder l'arête telle qu'elle est connue jusqu'ici</translation>
    </message>
    <message>
      <source>End the search and keep the edges found so far</source>
      <translation>Arrêter la recherche et garder les arêtes trouvées jusqu'ici</translation>
    </message>
    <message>
      <source>Error to expect</source>
      <translation>Erreur à attendre</translation>
    </message>
    <message>
      <source>Export</source>
      <translation>Exporter</translation>
    </message>
    <message>
      <source>Finish or cancel the open task panel first.</source>
      <translation>Terminez ou annulez d'abord le panneau de tâches ouvert.</translation>
    </message>
    <message>
      <source>Forget clicks</source>
      <translation>Oublier les clics</translation>
    </message>
    <message>
      <source>Forget clicks ({count})</source>
      <translation>Oublier les clics ({count})</translation>
    </message>
    <message>
      <source>Gate, 1 of 2: click beside the edge on the same side. OK needs no gate.</source>
      <translation>Arrivée, 1 sur 2 : cliquez à côté de l'arête, du même côté. OK se passe d'arrivée.</translation>
    </message>
    <message>
      <source>Gate, 2 of 2: click across the edge.</source>
      <translation>Arrivée, 2 sur 2 : cliquez de l'autre côté de l'arête.</translation>
    </message>
    <message>
      <source>Go along the edge</source>
      <translation>Parcourir l'arête</translation>
    </message>
    <message>
      <source>Group of edges</source>
      <translation>Groupe d'arêtes</translation>
    </message>
    <message>
      <source>Hide the points before and behind the section that is looked at</source>
      <translation>Masquer les points devant et derrière la section regardée</translation>
    </message>
    <message>
      <source>Hold Ctrl for clicks.</source>
      <translation>Maintenez Ctrl en cliquant.</translation>
    </message>
    <message>
      <source>How far the measuring machine goes on looking for the surface</source>
      <translation>Jusqu'où la machine à mesurer continue à chercher la surface</translation>
    </message>
    <message>
      <source>How the direction of the edge is found</source>
      <translation>Comment la direction de l'arête est trouvée</translation>
    </message>
    <message>
      <source>How the next scan line is placed</source>
      <translation>Comment la ligne de palpage suivante est placée</translation>
    </message>
    <message>
      <source>How the probe radius is taken off</source>
      <translation>Comment le rayon du palpeur est retiré</translation>
    </message>
    <message>
      <source>How the scan lines follow each other</source>
      <translation>Comment se suivent les lignes de palpage</translation>
    </message>
    <message>
      <source>Import cloud</source>
      <translation>Importer un nuage</translation>
    </message>
    <message>
      <source>Inches</source>
      <translation>Pouces</translation>
    </message>
    <message>
      <source>Keep edges</source>
      <translation>Garder les arêtes</translation>
    </message>
    <message>
      <source>Kept as far as it was scanned: a gate ends it there now.</source>
      <translation>Gardée jusqu'où elle a été palpée : une arrivée y termine désormais l'arête.</translation>
    </message>
    <message>
      <source>Kept. Click to drop it.</source>
      <translation>Gardée. Un clic l'écarte.</translation>
    </message>
    <message>
      <source>Largest deviation of the chord between two edge points from the edge</source>
      <translation>Plus grand écart entre l'arête et la corde joignant deux de ses points</translation>
    </message>
    <message>
      <source>Left out. Click to keep it.</source>
      <translation>Écartée. Un clic la garde.</translation>
    </message>
    <message>
      <source>Length</source>
      <translation>Longueur</translation>
    </message>
    <message>
      <source>Length from</source>
      <translation>Longueur dès</translation>
    </message>
    <message>
      <source>Length of a scan line along the surface, half of it on each side</source>
      <translation>Longueur d'une ligne de palpage le long de la surface, moitié de chaque côté</translation>
    </message>
    <message>
      <source>Let length, turn and sigma alone decide again</source>
      <translation>Laisser de nouveau décider la longueur, l'angle et sigma seuls</translation>
    </message>
    <message>
      <source>Line by line (probe)</source>
      <translation>Ligne par ligne (probe)</translation>
    </message>
    <message>
      <source>Line pitch</source>
      <translation>Pas de ligne</translation>
    </message>
    <message>
      <source>Look along the edge</source>
      <translation>Regarder le long de l'arête</translation>
    </message>
    <message>
      <source>Looking for
the edge …</source>
      <translation>Recherche de
l'arête …</translation>
    </message>
    <message>
      <source>Make every parameter automatic again</source>
      <translation>Rendre tous les paramètres automatiques</translation>
    </message>
    <message>
      <source>Mean sigma</source>
      <translation>Sigma moyen</translation>
    </message>
    <message>
      <source>Metres</source>
      <translation>Mètres</translation>
    </message>
    <message>
      <source>Millimetres</source>
      <translation>Millimètres</translation>
    </message>
    <message>
      <source>No point cloud can be seen; show one in the tree.</source>
      <translation>Aucun nuage de points n'est visible ; affichez-en un dans l'arborescence.</translation>
    </message>
    <message>
      <source>Noise level</source>
      <translation>Niveau de bruit</translation>
    </message>
    <message>
      <source>None of these edges can be scanned by itself.</source>
      <translation>Aucune de ces arêtes ne peut être palpée seule.</translation>
    </message>
    <message>
      <source>Nothing with a shape is selected or shown. Select scanned edges or surfaces.</source>
      <translation>Rien qui ait une forme n'est sélectionné ou affiché. Sélectionnez des arêtes palpées ou des surfaces.</translation>
    </message>
    <message>
      <source>OK keeps this edge. Click elsewhere to scan another one instead.</source>
      <translation>OK garde cette arête. Cliquez ailleurs pour en palper une autre à la place.</translation>
    </message>
    <message>
      <source>OK keeps this. Click elsewhere to begin again.</source>
      <translation>OK garde ceci. Cliquez ailleurs pour recommencer.</translation>
    </message>
    <message>
      <source>OK makes</source>
      <translation>OK crée</translation>
    </message>
    <message>
      <source>OK scans this edge with these parameters, line by line. Click elsewhere to measure there instead.</source>
      <translation>OK palpe cette arête avec ces paramètres, ligne par ligne. Cliquez ailleurs pour mesurer là.</translation>
    </message>
    <message>
      <source>Of the cloud's points, in pixels; own: as elsewhere</source>
      <translation>Des points du nuage, en pixels ; propre : comme ailleurs</translation>
    </message>
    <message>
      <source>On average: sigma {sigma}, angle {angle}</source>
      <translation>En moyenne : sigma {sigma}, angle {angle}</translation>
    </message>
    <message>
      <source>One click: the whole edge</source>
      <translation>Un clic : toute l'arête</translation>
    </message>
    <message>
      <source>One network</source>
      <translation>Un réseau</translation>
    </message>
    <message>
      <source>One object whose edges share their corners, or one for each edge that can be edited by itself</source>
      <translation>Un objet dont les arêtes partagent leurs coins, ou un par arête, modifiable séparément</translation>
    </message>
    <message>
      <source>One point for each pitch² of surface.</source>
      <translation>Un point par pas² de surface.</translation>
    </message>
    <message>
      <source>One point stays for each pitch² of surface.</source>
      <translation>Un point reste par pas² de surface.</translation>
    </message>
    <message>
      <source>Only points at the section</source>
      <translation>Seuls les points de la section</translation>
    </message>
    <message>
      <source>Open a 3D view of this document first.</source>
      <translation>Ouvrez d'abord une vue 3D de ce document.</translation>
    </message>
    <message>
      <source>Open a document first, or import a cloud.</source>
      <translation>Ouvrez d'abord un document, ou importez un nuage.</translation>
    </message>
    <message>
      <source>P&amp;itch:</source>
      <translation>P&amp;as :</translation>
    </message>
    <message>
      <source>Parameters</source>
      <translation>Paramètres</translation>
    </message>
    <message>
      <source>Pattern</source>
      <translation>Motif</translation>
    </message>
    <message>
      <source>Picture with histogram</source>
      <translation>Image avec histogramme</translation>
    </message>
    <message>
      <source>Point clouds</source>
      <translation>Nuages de points</translation>
    </message>
    <message>
      <source>Point size</source>
      <translation>Taille des points</translation>
    </message>
    <message>
      <source>Prehit distance</source>
      <translation>Distance d'approche</translation>
    </message>
    <message>
      <source>Probe &amp;radius:</source>
      <translation>&amp;Rayon du palpeur :</translation>
    </message>
    <message>
      <source>Probe radius</source>
      <translation>Rayon du palpeur</translation>
    </message>
    <message>
      <source>Radius of a ball that rolls over the part; the points are its centres. 0: the points lie on the part.</source>
      <translation>Rayon d'une bille qui roule sur la pièce ; les points sont ses centres. 0 : les points sont sur la pièce.</translation>
    </message>
    <message>
      <source>Radius of the ball whose centres the cloud holds; 0: surface points</source>
      <translation>Rayon de la bille dont le nuage contient les centres ; 0 : points de la surface</translation>
    </message>
    <message>
      <source>Radius of the ball, when the file holds the centres of a probing ball; 0: the points lie on the part.</source>
      <translation>Rayon de la bille, quand le fichier contient les centres d'une bille de palpeur ; 0 : les points sont sur la pièce.</translation>
    </message>
    <message>
      <source>Reading {name}…</source>
      <translation>Lecture de {name}…</translation>
    </message>
    <message>
      <source>Recommend parameters</source>
      <translation>Recommander des paramètres</translation>
    </message>
    <message>
      <source>Report</source>
      <translation>Rapport</translation>
    </message>
    <message>
      <source>Reset</source>
      <translation>Réinitialiser</translation>
    </message>
    <message>
      <source>Rounding</source>
      <translation>Arrondi</translation>
    </message>
    <message>
      <source>Rounding radius</source>
      <translation>Rayon de l'arrondi</translation>
    </message>
    <message>
      <source>Rows with nan or inf that are left out: {count}.</source>
      <translation>Lignes omises, avec nan ou inf : {count}.</translation>
    </message>
    <message>
      <source>Save deviations</source>
      <translation>Enregistrer les écarts</translation>
    </message>
    <message>
      <source>Save deviations…</source>
      <translation>Enregistrer les écarts…</translation>
    </message>
    <message>
      <source>Scan all edges</source>
      <translation>Palper toutes les arêtes</translation>
    </message>
    <message>
      <source>Scan boundary</source>
      <translation>Palper un contour</translation>
    </message>
    <message>
      <source>Scan edge</source>
      <translation>Palper une arête</translation>
    </message>
    <message>
      <source>Scan lines</source>
      <translation>Lignes de palpage</translation>
    </message>
    <message>
      <source>Scanning tolerance of a line section</source>
      <translation>Tolérance de palpage d'une section de ligne</translation>
    </message>
    <message>
      <source>Search again</source>
      <translation>Chercher à nouveau</translation>
    </message>
    <message>
      <source>Search distance</source>
      <translation>Distance de recherche</translation>
    </message>
    <message>
      <source>Search the whole cloud, also for what is still missing</source>
      <translation>Chercher dans tout le nuage, aussi ce qui manque encore</translation>
    </message>
    <message>
      <source>Section</source>
      <translation>Section</translation>
    </message>
    <message>
      <source>Shorter edges are left out; 0: shorter than eight times the cloud's pitch</source>
      <translation>Les arêtes plus courtes sont écartées ; 0 : plus courtes que huit fois le pas du nuage</translation>
    </message>
    <message>
      <source>Show scan lines</source>
      <translation>Afficher les lignes de palpage</translation>
    </message>
    <message>
      <source>Show where across the edge each point was measured</source>
      <translation>Montrer où, en travers de l'arête, chaque point a été mesuré</translation>
    </message>
    <message>
      <source>Sigma</source>
      <translation>Sigma</translation>
    </message>
    <message>
      <source>Sigma is the standard deviation of an edge point across the edge: about two of three lie within it. A good edge's is well below the distance of the points.</source>
      <translation>Sigma est l'écart type d'un point d'arête en travers de l'arête : environ deux sur trois s'y trouvent. Celui d'une bonne arête est nettement inférieur à la distance des points.</translation>
    </message>
    <message>
      <source>Sigma up to</source>
      <translation>Sigma jusqu'à</translation>
    </message>
    <message>
      <source>Sigma, angle and rounding along the edge</source>
      <translation>Sigma, angle et arrondi le long de l'arête</translation>
    </message>
    <message>
      <source>Sigma, angle and rounding along the edge are shown here.</source>
      <translation>Sigma, angle et arrondi le long de l'arête s'affichent ici.</translation>
    </message>
    <message>
      <source>Simulated cloud</source>
      <translation>Nuage simulé</translation>
    </message>
    <message>
      <source>Size:</source>
      <translation>Taille :</translation>
    </message>
    <message>
      <source>Standard deviation of the points along the normal.</source>
      <translation>Écart-type des points le long de la normale.</translation>
    </message>
    <message>
      <source>Steering</source>
      <translation>Guidage</translation>
    </message>
    <message>
      <source>Step {number} of 3</source>
      <translation>Étape {number} sur 3</translation>
    </message>
    <message>
      <source>Stop here</source>
      <translation>Arrêter ici</translation>
    </message>
    <message>
      <source>Stopped before an edge was found.</source>
      <translation>Arrêté avant qu'une arête soit trouvée.</translation>
    </message>
    <message>
      <source>Stopped before there was enough of the edge to keep.</source>
      <translation>Arrêté avant qu'il y ait assez de l'arête pour la garder.</translation>
    </message>
    <message>
      <source>Stopped: OK keeps the edges found so far.</source>
      <translation>Arrêté : OK garde les arêtes trouvées jusqu'ici.</translation>
    </message>
    <message>
      <source>Stopping…</source>
      <translation>Arrêt en cours…</translation>
    </message>
    <message>
      <source>Table</source>
      <translation>Tableau</translation>
    </message>
    <message>
      <source>Tangent</source>
      <translation>Tangente</translation>
    </message>
    <message>
      <source>That is an edge: a native curve in the tree. Its properties say how exact it is and why it ends. Scan the other rim, too; Cross-section then finds the pipe's profile between them. With your own scan, begin with Import cloud.</source>
      <translation>Voilà une arête : une courbe native dans l'arborescence. Ses propriétés disent sa précision et pourquoi elle s'arrête. Palpez aussi l'autre bord ; Section transversale trouve alors le profil de la gorge entre les deux. Avec votre propre scan, commencez par Importer un nuage.</translation>
    </message>
    <message>
      <source>That is very large. Is the file in millimetres?</source>
      <translation>C'est très grand. Le fichier est-il en millimètres ?</translation>
    </message>
    <message>
      <source>That is very small. Is the file in metres?</source>
      <translation>C'est très petit. Le fichier est-il en mètres ?</translation>
    </message>
    <message>
      <source>That is {label}, no point cloud.</source>
      <translation>C'est {label}, pas un nuage de points.</translation>
    </message>
    <message>
      <source>The boundary is closed.</source>
      <translation>Le contour est fermé.</translation>
    </message>
    <message>
      <source>The calculation broke off ({kind}: {error}).</source>
      <translation>Le calcul s'est interrompu ({kind} : {error}).</translation>
    </message>
    <message>
      <source>The cloud has changed.</source>
      <translation>Le nuage a changé.</translation>
    </message>
    <message>
      <source>The cloud is being prepared; your click will be answered.</source>
      <translation>Le nuage est en préparation ; votre clic sera pris en compte ensuite.</translation>
    </message>
    <message>
      <source>The cloud is searched. Click on an edge to drop it.</source>
      <translation>Le nuage est parcouru. Cliquez sur une arête pour l'écarter.</translation>
    </message>
    <message>
      <source>The cloud of {label} is gone. Choose another one in its property Cloud, or undo the deletion.</source>
      <translation>Le nuage de {label} n'existe plus. Choisissez-en un autre dans la propriété Cloud, ou annulez la suppression.</translation>
    </message>
    <message>
      <source>The cloud was deleted.</source>
      <translation>Le nuage a été supprimé.</translation>
    </message>
    <message>
      <source>The cloud was deleted. Undo that, or press Cancel.</source>
      <translation>Le nuage a été supprimé. Annulez cela, ou cliquez sur Annuler.</translation>
    </message>
    <message>
      <source>The edge is being followed.</source>
      <translation>L'arête est en train d'être suivie.</translation>
    </message>
    <message>
      <source>The face has {count} of the {whole} points.</source>
      <translation>La face a {count} des {whole} points.</translation>
    </message>
    <message>
      <source>The points lie {distance} from the origin, where a document cannot keep them exactly. Moved, they are exact; the cloud's property Origin holds the way back, and exports use it.</source>
      <translation>Les points sont à {distance} de l'origine, où un document ne peut pas les garder exactement. Rapprochés, ils sont exacts ; la propriété Origin du nuage contient le chemin du retour, et les exports l'utilisent.</translation>
    </message>
    <message>
      <source>The section across the edge is shown here.</source>
      <translation>La section en travers de l'arête s'affiche ici.</translation>
    </message>
    <message>
      <source>There is no edge.</source>
      <translation>Il n'y a pas d'arête à cet endroit.</translation>
    </message>
    <message>
      <source>There is no point of a visible cloud there.</source>
      <translation>Il n'y a là aucun point d'un nuage visible.</translation>
    </message>
    <message>
      <source>These edges are not those of {label}.</source>
      <translation>Ces arêtes ne sont pas celles de {label}.</translation>
    </message>
    <message>
      <source>Thin cloud</source>
      <translation>Éclaircir le nuage</translation>
    </message>
    <message>
      <source>This cloud was scanned by a ball probe, with gaps and noise. Start the command Scan edge: here, in the toolbar, or in the menu EdgeScan.</source>
      <translation>Ce nuage a été mesuré par une bille de palpeur, avec des trous et du bruit. Lancez la commande Palper une arête : ici, dans la barre d'outils ou dans le menu EdgeScan.</translation>
    </message>
    <message>
      <source>This document has no edge or surface yet. Scan an edge first.</source>
      <translation>Ce document n'a encore ni arête ni surface. Palpez d'abord une arête.</translation>
    </message>
    <message>
      <source>This document has no point cloud. Import one first (EdgeScan → Import cloud).</source>
      <translation>Ce document n'a pas de nuage de points. Importez-en d'abord un (EdgeScan → Importer un nuage).</translation>
    </message>
    <message>
      <source>This document shows no point cloud. Import one (EdgeScan → Import cloud), or make a hidden one visible.</source>
      <translation>Ce document ne montre aucun nuage de points. Importez-en un (EdgeScan → Importer un nuage), ou affichez un nuage masqué.</translation>
    </message>
    <message>
      <source>This document shows {count} clouds. Select the one you mean.</source>
      <translation>Ce document montre {count} nuages. Sélectionnez celui que vous voulez.</translation>
    </message>
    <message>
      <source>Tick a parameter to set it yourself.</source>
      <translation>Cochez un paramètre pour le fixer vous-même.</translation>
    </message>
    <message>
      <source>Tolerance</source>
      <translation>Tolérance</translation>
    </message>
    <message>
      <source>Try it</source>
      <translation>Essayer</translation>
    </message>
    <message>
      <source>Turn from</source>
      <translation>Pli dès</translation>
    </message>
    <message>
      <source>Turn the view so that the section is seen as it is drawn</source>
      <translation>Tourner la vue pour voir la section comme elle est dessinée</translation>
    </message>
    <message>
      <source>Two clicks: edge and gate</source>
      <translation>Deux clics : arête et arrivée</translation>
    </message>
    <message>
      <source>View</source>
      <translation>Vue</translation>
    </message>
    <message>
      <source>Web page</source>
      <translation>Page web</translation>
    </message>
    <message>
      <source>What your clicks stand for</source>
      <translation>Ce que signifient vos clics</translation>
    </message>
    <message>
      <source>Wheel: zoom. Drag: move. Double click: show all. Arrows: along</source>
      <translation>Molette : zoom. Glisser : déplacer. Double clic : tout voir. Flèches : le long de l'arête</translation>
    </message>
    <message>
      <source>Where the measuring machine begins to move slowly</source>
      <translation>Où la machine à mesurer commence à avancer lentement</translation>
    </message>
    <message>
      <source>along +x</source>
      <translation>selon +x</translation>
    </message>
    <message>
      <source>along +y</source>
      <translation>selon +y</translation>
    </message>
    <message>
      <source>along -x</source>
      <translation>selon -x</translation>
    </message>
    <message>
      <source>along -y</source>
      <translation>selon -y</translation>
    </message>
    <message>
      <source>along the edge</source>
      <translation>le long de l'arête</translation>
    </message>
    <message>
      <source>angle {angle}</source>
      <translation>angle {angle}</translation>
    </message>
    <message>
      <source>chosen with the first click</source>
      <translation>choisi au premier clic</translation>
    </message>
    <message>
      <source>curvature</source>
      <translation>courbure</translation>
    </message>
    <message>
      <source>curve</source>
      <translation>courbe</translation>
    </message>
    <message>
      <source>deviation, {unit}</source>
      <translation>écart, {unit}</translation>
    </message>
    <message>
      <source>down, -z</source>
      <translation>vers le bas, -z</translation>
    </message>
    <message>
      <source>fitted sides</source>
      <translation>côtés ajustés</translation>
    </message>
    <message>
      <source>interpolation</source>
      <translation>interpolation</translation>
    </message>
    <message>
      <source>intersection</source>
      <translation>intersection</translation>
    </message>
    <message>
      <source>intersection, as printed</source>
      <translation>intersection, telle qu'imprimée</translation>
    </message>
    <message>
      <source>no rounding measurable</source>
      <translation>aucun arrondi mesurable</translation>
    </message>
    <message>
      <source>none</source>
      <translation>aucun</translation>
    </message>
    <message>
      <source>none measurable</source>
      <translation>aucun mesurable</translation>
    </message>
    <message>
      <source>not used</source>
      <translation>non utilisé</translation>
    </message>
    <message>
      <source>of no side</source>
      <translation>d'aucun côté</translation>
    </message>
    <message>
      <source>own</source>
      <translation>propre</translation>
    </message>
    <message>
      <source>planes</source>
      <translation>plans</translation>
    </message>
    <message>
      <source>point</source>
      <translation>point</translation>
    </message>
    <message>
      <source>points</source>
      <translation>points</translation>
    </message>
    <message>
      <source>polynomials</source>
      <translation>polynômes</translation>
    </message>
    <message>
      <source>probe</source>
      <translation>palpeur</translation>
    </message>
    <message>
      <source>rests on its neighbours</source>
      <translation>repose sur ses voisins</translation>
    </message>
    <message>
      <source>rounding</source>
      <translation>arrondi</translation>
    </message>
    <message>
      <source>rounding {radius} ± {sigma} {unit}</source>
      <translation>arrondi {radius} ± {sigma} {unit}</translation>
    </message>
    <message>
      <source>set by you</source>
      <translation>fixé par vous</translation>
    </message>
    <message>
      <source>sigma {length}</source>
      <translation>sigma {length}</translation>
    </message>
    <message>
      <source>square</source>
      <translation>créneaux</translation>
    </message>
    <message>
      <source>surface</source>
      <translation>surface</translation>
    </message>
    <message>
      <source>tangent</source>
      <translation>tangente</translation>
    </message>
    <message>
      <source>up, +z</source>
      <translation>vers le haut, +z</translation>
    </message>
    <message>
      <source>zigzag</source>
      <translation>zigzag</translation>
    </message>
    <message>
      <source>{across} across, {out} out</source>
      <translation>{across} en travers, {out} vers l'extérieur</translation>
    </message>
    <message>
      <source>{clouds} clouds and {edges} edges are selected. Select two or three objects: one cloud, the edge to cut across, and another edge if there is one.</source>
      <translation>{clouds} nuages et {edges} arêtes sont sélectionnés. Sélectionnez deux ou trois objets : un nuage, l'arête en travers de laquelle couper, et une autre arête s'il y en a une.</translation>
    </message>
    <message>
      <source>{clouds} clouds and {surfaces} surfaces are selected. Select two objects: one cloud and one surface.</source>
      <translation>{clouds} nuages et {surfaces} surfaces sont sélectionnés. Sélectionnez deux objets : un nuage et une surface.</translation>
    </message>
    <message>
      <source>{clouds} clouds, {surfaces} surfaces and {edges} edges are selected. Select one cloud, and with it one surface, or four edges, or nothing else.</source>
      <translation>{clouds} nuages, {surfaces} surfaces et {edges} arêtes sont sélectionnés. Sélectionnez un nuage, et avec lui une surface, ou quatre arêtes, ou rien d'autre.</translation>
    </message>
    <message>
      <source>{count} clouds are selected. Select one of them.</source>
      <translation>{count} nuages sont sélectionnés. Sélectionnez-en un.</translation>
    </message>
    <message>
      <source>{count} edge points
{length}</source>
      <translation>{count} points d'arête
{length}</translation>
    </message>
    <message>
      <source>{count} edges</source>
      <translation>{count} arêtes</translation>
    </message>
    <message>
      <source>{count} objects with a shape are selected. Select two or more edges or sections, in the order the skin goes through them.</source>
      <translation>{count} objets ayant une forme sont sélectionnés. Sélectionnez deux arêtes ou sections ou plus, dans l'ordre où la peau les traverse.</translation>
    </message>
    <message>
      <source>{count} objects with a shape are selected. Select two: the profile (a sketch, wire or edge), then the scanned edge to sweep it along.</source>
      <translation>{count} objets ayant une forme sont sélectionnés. Sélectionnez-en deux : le profil (une esquisse, un fil ou une arête), puis l'arête palpée le long de laquelle le balayer.</translation>
    </message>
    <message>
      <source>{count} surfaces are selected. Select one, not two or none, to extend it.</source>
      <translation>{count} surfaces sont sélectionnées. Sélectionnez-en une, ni deux ni aucune, pour la prolonger.</translation>
    </message>
    <message>
      <source>{count} surfaces are selected. Select two that meet.</source>
      <translation>{count} surfaces sont sélectionnées. Sélectionnez-en deux qui se rencontrent.</translation>
    </message>
    <message>
      <source>{curves} curves and {clouds} clouds are selected. Select two rails, two or more profiles in order, and the cloud if there is one; or one rail that is a scanned edge, and its profiles.</source>
      <translation>{curves} courbes et {clouds} nuages sont sélectionnés. Sélectionnez deux rails, deux profils ou plus dans l'ordre, et le nuage s'il y en a un ; ou un rail qui est une arête palpée, et ses profils.</translation>
    </message>
    <message>
      <source>{edges} edges and no surface are selected. Select the surfaces of a shell, and the edges at which they end.</source>
      <translation>{edges} arêtes sont sélectionnées, mais aucune surface. Sélectionnez les surfaces d'une coque, et les arêtes où elles finissent.</translation>
    </message>
    <message>
      <source>{kept} of {found} edges are kept, {length} in all.</source>
      <translation>{kept} arêtes sur {found} sont gardées, {length} en tout.</translation>
    </message>
    <message>
      <source>{label} could not be computed: {reason}</source>
      <translation>{label} n'a pas pu être calculé : {reason}</translation>
    </message>
    <message>
      <source>{label} has {count} points. A pitch twice that of the cloud keeps a quarter of them. Edges are found best in the full cloud.</source>
      <translation>{label} a {count} points. Un pas double de celui du nuage en garde un quart. Les arêtes se trouvent le mieux dans le nuage entier.</translation>
    </message>
    <message>
      <source>{label} is selected, which is no point cloud. Select one cloud.</source>
      <translation>{label} est sélectionné, qui n'est pas un nuage de points. Sélectionnez un nuage.</translation>
    </message>
    <message>
      <source>{names}: {count} points.</source>
      <translation>{names} : {count} points.</translation>
    </message>
    <message>
      <source>{number} of {count}</source>
      <translation>{number} sur {count}</translation>
    </message>
    <message>
      <source>{shown} of {whole} points are shown; all of them are computed with.</source>
      <translation>{shown} points sur {whole} sont affichés ; le calcul les prend tous.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScanPreferences</name>
    <message>
      <source>&amp;Move clouds that lie far away near the origin</source>
      <translation>&amp;Rapprocher de l'origine les nuages qui en sont loin</translation>
    </message>
    <message>
      <source>&amp;Point size:</source>
      <translation>&amp;Taille des points :</translation>
    </message>
    <message>
      <source>&amp;Shade imported clouds</source>
      <translation>&amp;Ombrer les nuages importés</translation>
    </message>
    <message>
      <source>&amp;Unit of the files:</source>
      <translation>&amp;Unité des fichiers :</translation>
    </message>
    <message>
      <source>A document keeps points with seven digits: of a cloud kilometres away, tenths of a millimetre would be lost.</source>
      <translation>Un document garde les points avec sept chiffres : d'un nuage à des kilomètres, des dixièmes de millimètre seraient perdus.</translation>
    </message>
    <message>
      <source>Cloud files do not say in which unit they are. The import dialog begins with this one.</source>
      <translation>Les fichiers de nuages ne disent pas dans quelle unité ils sont. Le dialogue d'import commence par celle-ci.</translation>
    </message>
    <message>
      <source>General</source>
      <translation>Général</translation>
    </message>
    <message>
      <source>How clouds look</source>
      <translation>Aspect des nuages</translation>
    </message>
    <message>
      <source>Importing clouds</source>
      <translation>Import de nuages</translation>
    </message>
    <message>
      <source>Inches</source>
      <translation>Pouces</translation>
    </message>
    <message>
      <source>Metres</source>
      <translation>Mètres</translation>
    </message>
    <message>
      <source>Millimetres</source>
      <translation>Millimètres</translation>
    </message>
    <message>
      <source>Of new clouds, in pixels. Each cloud can be changed in its view properties.</source>
      <translation>Des nouveaux nuages, en pixels. Chaque nuage peut être changé dans ses propriétés de vue.</translation>
    </message>
    <message>
      <source>Points get greys as if light fell on the surface they lie on. Clouds of more than 500 000 points stay as they are.</source>
      <translation>Les points reçoivent des gris comme si la lumière tombait sur la surface où ils sont. Les nuages de plus de 500 000 points restent tels quels.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_CloudSection</name>
    <message>
      <source>Cross-section</source>
      <translation>Section transversale</translation>
    </message>
    <message>
      <source>Cut a cloud across an edge and fit a line, arc or spline. Select the cloud and the edge, and another edge to which the profile leads.</source>
      <translation>Couper un nuage en travers d'une arête et y ajuster une droite, un arc ou une spline. Sélectionnez le nuage et l'arête, et une autre arête à laquelle mène le profil.</translation>
    </message>
    <message>
      <source>Select a cloud and one or two edges</source>
      <translation>Sélectionnez un nuage et une ou deux arêtes</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_CloudSegment</name>
    <message>
      <source>Segment cloud</source>
      <translation>Segmenter le nuage</translation>
    </message>
    <message>
      <source>Select a cloud and a surface, or a network of edges</source>
      <translation>Sélectionner un nuage et une surface, ou un réseau d'arêtes</translation>
    </message>
    <message>
      <source>Take the points near a surface, or of one face between edges, as a cloud of their own. Select the cloud and the surface; or a network of edges, then click on the face.</source>
      <translation>Prendre les points proches d'une surface, ou d'une face entre arêtes, comme nuage à part. Sélectionnez le nuage et la surface ; ou un réseau d'arêtes, puis cliquez sur la face.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_CompensateCloud</name>
    <message>
      <source>Compensate cloud</source>
      <translation>Compenser le nuage</translation>
    </message>
    <message>
      <source>Move the centres of a probing ball onto the part they touched. Select a cloud whose ProbeRadius is set.</source>
      <translation>Ramener les centres d'une bille de palpeur sur la pièce qu'elle a touchée. Sélectionnez un nuage dont ProbeRadius est donné.</translation>
    </message>
    <message>
      <source>Select a cloud of probe centres</source>
      <translation>Sélectionnez un nuage de centres de palpeur</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_DeviationMap</name>
    <message>
      <source>Deviation map</source>
      <translation>Carte des écarts</translation>
    </message>
    <message>
      <source>Select a cloud, and a surface or part</source>
      <translation>Sélectionnez un nuage, et une surface ou une pièce</translation>
    </message>
    <message>
      <source>Show in colours how far a cloud is from a surface or part. Select the cloud and the surface or part.</source>
      <translation>Montrer en couleurs la distance d'un nuage à une surface ou à une pièce. Sélectionnez le nuage et la surface ou la pièce.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_EdgeWire</name>
    <message>
      <source>Join edges that follow each other to a wire, for sweeps, lofts and sketches. Select the edges of a network in the 3D view, the others with Ctrl held.</source>
      <translation>Joindre des arêtes qui se suivent en un fil, pour balayages, lissages et esquisses. Sélectionnez les arêtes d'un réseau dans la vue 3D, les suivantes avec Ctrl enfoncé.</translation>
    </message>
    <message>
      <source>Select edges of a network, from corner to corner</source>
      <translation>Sélectionner des arêtes d'un réseau, de coin en coin</translation>
    </message>
    <message>
      <source>Wire of edges</source>
      <translation>Fil d'arêtes</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_Export</name>
    <message>
      <source>Export…</source>
      <translation>Exporter…</translation>
    </message>
    <message>
      <source>Select edges or surfaces, or nothing for all</source>
      <translation>Sélectionnez des arêtes ou des surfaces, ou rien pour tout</translation>
    </message>
    <message>
      <source>Write edges and surfaces as STEP, or edge points with their sigma as CSV, in the coordinates of the scan. Select what to write, or nothing for everything shown.</source>
      <translation>Écrire arêtes et surfaces en STEP, ou les points d'arête avec leur sigma en CSV, dans les coordonnées du scan. Sélectionnez ce qui doit être écrit, ou rien pour tout ce qui est affiché.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ExtendSurface</name>
    <message>
      <source>Extend surface</source>
      <translation>Prolonger une surface</translation>
    </message>
    <message>
      <source>Make a surface longer over one of its sides. Select the surface; choose the side in its properties.</source>
      <translation>Prolonger une surface au-delà d'un de ses côtés. Sélectionnez la surface ; choisissez le côté dans ses propriétés.</translation>
    </message>
    <message>
      <source>Select one surface</source>
      <translation>Sélectionnez une surface</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_FittedSurface</name>
    <message>
      <source>Fit a surface to a cloud near another surface, between four edges, or round the plane, cylinder, cone or sphere that the cloud lies on. Select the cloud, and the surface or the four edges.</source>
      <translation>Ajuster une surface à un nuage : près d'une autre surface, entre quatre arêtes, ou autour du plan, du cylindre, du cône ou de la sphère sur lequel est le nuage. Sélectionnez le nuage, et la surface ou les quatre arêtes.</translation>
    </message>
    <message>
      <source>Fit surface</source>
      <translation>Ajuster une surface</translation>
    </message>
    <message>
      <source>Select a cloud, and a surface near it or four edges</source>
      <translation>Sélectionnez un nuage, et une surface proche ou quatre arêtes</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ImportCloud</name>
    <message>
      <source>Choose one or more cloud files</source>
      <translation>Choisissez un ou plusieurs fichiers de nuages</translation>
    </message>
    <message>
      <source>Import cloud…</source>
      <translation>Importer un nuage…</translation>
    </message>
    <message>
      <source>Import point clouds from files (xyz, txt, asc, csv, ply, pcd, e57, stl, obj). Nothing needs to be selected.</source>
      <translation>Importer des nuages de points depuis des fichiers (xyz, txt, asc, csv, ply, pcd, e57, stl, obj). Rien n'a besoin d'être sélectionné.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_IntersectSurfaces</name>
    <message>
      <source>Find all curves in which two surfaces meet. Select two of them.</source>
      <translation>Trouver toutes les courbes où deux surfaces se rencontrent. Sélectionnez-en deux.</translation>
    </message>
    <message>
      <source>Intersect surfaces</source>
      <translation>Couper deux surfaces</translation>
    </message>
    <message>
      <source>Select two surfaces</source>
      <translation>Sélectionnez deux surfaces</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_Loft</name>
    <message>
      <source>Loft through edges</source>
      <translation>Lissage par des arêtes</translation>
    </message>
    <message>
      <source>Make a skin through edges or sections. Select two or more of them, in order.</source>
      <translation>Faire une peau à travers des arêtes ou des sections. Sélectionnez-en deux ou plus, dans l'ordre.</translation>
    </message>
    <message>
      <source>Select two or more edges or sections, in order</source>
      <translation>Sélectionnez deux arêtes ou sections ou plus, dans l'ordre</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_RecommendParameters</name>
    <message>
      <source>Click near an edge</source>
      <translation>Cliquez près d'une arête</translation>
    </message>
    <message>
      <source>Measure the cloud near an edge and say how to scan it, why, and which error to expect. Click near the edge; nothing needs to be selected before.</source>
      <translation>Mesurer le nuage près d'une arête et dire comment la palper, pourquoi, et quelle erreur attendre. Cliquez près de l'arête ; rien n'a besoin d'être sélectionné avant.</translation>
    </message>
    <message>
      <source>Recommend parameters</source>
      <translation>Recommander des paramètres</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_Report</name>
    <message>
      <source>Report…</source>
      <translation>Rapport…</translation>
    </message>
    <message>
      <source>Write one page about this document: clouds, edges, surfaces, their figures and pictures. Nothing needs to be selected.</source>
      <translation>Écrire une page sur ce document : nuages, arêtes, surfaces, leurs chiffres et des images. Rien n'a besoin d'être sélectionné.</translation>
    </message>
    <message>
      <source>Writes a page about this document</source>
      <translation>Écrit une page sur ce document</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ScanAllEdges</name>
    <message>
      <source>Find all edges of a cloud and where they meet, and choose which to keep. Select the cloud; when only one is shown nothing needs to be selected.</source>
      <translation>Trouver toutes les arêtes d'un nuage et leurs rencontres, et choisir celles à garder. Sélectionnez le nuage ; si un seul est visible, rien n'est à sélectionner.</translation>
    </message>
    <message>
      <source>Scan all edges</source>
      <translation>Palper toutes les arêtes</translation>
    </message>
    <message>
      <source>Select a cloud, unless only one is shown</source>
      <translation>Sélectionner un nuage, sauf si un seul est visible</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ScanBoundary</name>
    <message>
      <source>Click near an edge, then on the face</source>
      <translation>Cliquez près d'une arête, puis sur la face</translation>
    </message>
    <message>
      <source>Scan all edges round one face. Click near one of its edges, then on the face; nothing needs to be selected before.</source>
      <translation>Palper toutes les arêtes autour d'une face. Cliquez près de l'une d'elles, puis sur la face ; rien n'a besoin d'être sélectionné avant.</translation>
    </message>
    <message>
      <source>Scan boundary</source>
      <translation>Palper un contour</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ScanEdge</name>
    <message>
      <source>Click on a cloud, near an edge</source>
      <translation>Cliquez sur un nuage, près d'une arête</translation>
    </message>
    <message>
      <source>Click on a visible cloud, near an edge: the edge is followed both ways until it ends. Nothing needs to be selected before.</source>
      <translation>Cliquez sur un nuage visible, près d'une arête : l'arête est suivie dans les deux sens jusqu'à sa fin. Rien n'a besoin d'être sélectionné avant.</translation>
    </message>
    <message>
      <source>Scan edge</source>
      <translation>Palper une arête</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_SimulatedCloud</name>
    <message>
      <source>Scan a part without a scanner, with the pitch, noise and probe you choose. Select an object with faces, or nothing to scan the core box of the case study.</source>
      <translation>Scanner une pièce sans scanner, avec le pas, le bruit et le palpeur de votre choix. Sélectionnez un objet ayant des faces, ou rien pour scanner la boîte à noyau de l'étude de cas.</translation>
    </message>
    <message>
      <source>Select a part, or nothing</source>
      <translation>Sélectionnez une pièce, ou rien</translation>
    </message>
    <message>
      <source>Simulated cloud…</source>
      <translation>Nuage simulé…</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_Sweep</name>
    <message>
      <source>Select a profile, then an edge</source>
      <translation>Sélectionnez un profil, puis une arête</translation>
    </message>
    <message>
      <source>Sweep a profile along an edge. Select the profile (a sketch, wire or edge), then the scanned edge.</source>
      <translation>Balayer un profil le long d'une arête. Sélectionnez le profil (une esquisse, un fil ou une arête), puis l'arête palpée.</translation>
    </message>
    <message>
      <source>Sweep along edge</source>
      <translation>Balayage le long d'une arête</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_SweptSurface</name>
    <message>
      <source>Select one or two rails, profiles in order, and a cloud</source>
      <translation>Sélectionnez un ou deux rails, des profils dans l'ordre, et un nuage</translation>
    </message>
    <message>
      <source>Sweep profiles along one or two rails, fitted to a cloud. Select the rails, then the profiles in order, and a cloud when there is one.</source>
      <translation>Balayer des profils le long d'un ou de deux rails, ajustés à un nuage. Sélectionnez les rails, puis les profils dans l'ordre, et un nuage s'il y en a un.</translation>
    </message>
    <message>
      <source>Swept surface</source>
      <translation>Surface balayée</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_ThinCloud</name>
    <message>
      <source>Keep fewer points, evenly spread over the surface. Select a cloud.</source>
      <translation>Garder moins de points, répartis également sur la surface. Sélectionnez un nuage.</translation>
    </message>
    <message>
      <source>Select a cloud</source>
      <translation>Sélectionnez un nuage</translation>
    </message>
    <message>
      <source>Thin cloud…</source>
      <translation>Éclaircir le nuage…</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_TrimmedShell</name>
    <message>
      <source>Select surfaces, and the edges at which they end</source>
      <translation>Sélectionnez des surfaces, et les arêtes où elles finissent</translation>
    </message>
    <message>
      <source>Trim and sew surfaces</source>
      <translation>Découper et coudre des surfaces</translation>
    </message>
    <message>
      <source>Trim surfaces where they meet, drop what sticks out, and sew the rest into a shell. Select the surfaces, and the edges at which they end.</source>
      <translation>Découper les surfaces là où elles se rencontrent, enlever ce qui dépasse et coudre le reste en une coque. Sélectionnez les surfaces, et les arêtes où elles finissent.</translation>
    </message>
  </context>
  <context>
    <name>EdgeScan_TryIt</name>
    <message>
      <source>Open the simulated scan of a core box and find its first edge in three steps. Nothing needs to be selected.</source>
      <translation>Ouvrir le scan simulé d'une boîte à noyau et trouver sa première arête en trois étapes. Rien n'a besoin d'être sélectionné.</translation>
    </message>
    <message>
      <source>Opens an example with a short guide</source>
      <translation>Ouvre un exemple avec un court guide</translation>
    </message>
    <message>
      <source>Try it</source>
      <translation>Essayer</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <source>EdgeScan clouds</source>
      <translation>EdgeScan : nuages</translation>
    </message>
    <message>
      <source>EdgeScan edges</source>
      <translation>EdgeScan : arêtes</translation>
    </message>
    <message>
      <source>EdgeScan results</source>
      <translation>EdgeScan : résultats</translation>
    </message>
    <message>
      <source>EdgeScan surfaces</source>
      <translation>EdgeScan : surfaces</translation>
    </message>
    <message>
      <source>EdgeScan sweeps</source>
      <translation>EdgeScan : balayages</translation>
    </message>
  </context>
</TS>

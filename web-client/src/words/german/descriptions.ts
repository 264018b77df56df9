import type { DescribedField } from '../described_field.ts';

export const descriptions: Readonly<Record<DescribedField, string>> = {
  'camera.projection':
    'Perspektivisch gilt das Sichtfeld in Grad, orthografisch die Höhe in Millimetern.',
  'camera.eye_mm': 'Wo der Betrachter ist; Patientenraum, mm. Darf im Volumen liegen.',
  'camera.target_mm': 'Was in der Bildmitte liegt; Patientenraum, mm. Nicht das Auge.',
  'camera.up': 'Was im Bild oben ist, im Patientenraum; nicht parallel zur Blickrichtung.',
  'camera.vertical_fov_degrees':
    'Sichtfeld vom unteren zum oberen Bildrand, in Grad; für die Perspektive.',
  'camera.view_height_mm': 'Was die Bildhöhe umfasst, mm; für die orthografische Projektion.',
  'preparation.hide_couch':
    'Ob bei CT weggelassen wird, was neben dem Körper liegt: Liege, Kopfstütze, Decken.',
  'preparation.fill_context':
    'Ob bei CT für den Kontext gefüllt wird, was der Körper umschließt: Lunge und Darm haben dann ' +
    'keine Oberfläche. Nicht, wo der Fokus unter dem Kontext beginnt.',
  'preparation.focus_islands_ml':
    'Teile des Fokusmaterials, die kleiner sind und an nichts hängen, werden weggelassen; 0 behält ' +
    'alle. Nicht mit oberem Ende.',
  'preparation.context_islands_ml': 'Dasselbe für das Material des Kontexts.',
  'surface.iso_value':
    'Unteres Ende des Bandes, in den Einheiten des Volumens (Hounsfield bei CT). Fehlt es, wird ' +
    'es für das Volumen gewählt.',
  'surface.upper_value':
    'Oberes Ende des Bandes. Fehlt es, so ist das Band nach oben offen und die Oberfläche eine ' +
    'Isofläche.',
  'surface.opacity':
    'Anteil des Lichts, den ein Millimeter des Materials aufnimmt; 1 ist von der Oberfläche an ' +
    'undurchsichtig, weniger lässt durchscheinen, was dahinter liegt.',
  'normals.scale':
    'Fest gilt die Breite in Millimetern, automatisch, was dieses Volumen beruhigt; für den Fokus ' +
    'die Hälfte davon.',
  'normals.scale_mm':
    'Standardabweichung der Gauß-Glocke, unter der die Richtung der Oberfläche bestimmt wird, mm; ' +
    '0: aus den Unterschieden benachbarter Voxel.',
  'normals.reconstruction':
    'Linear, oder kubisch (der annähernde B-Spline): ohne Ringe bei dicken Schichten, dünne Wände ' +
    'werden ein wenig weicher.',
  'occlusion.strength':
    'Wie dunkel Vertiefungen werden, weil andere Teile der Oberfläche Licht abhalten; 0 zeichnet ' +
    'ohne.',
  'occlusion.range_mm':
    'Was weiter weg liegt, hält kein Licht ab, mm. Fehlt sie: zwei Radien der Linse, oder 0,15 der ' +
    'Diagonale des Materials, wo das mehr ist.',
  'occlusion.near_share':
    'Anteil dessen, was im ersten Viertel der Reichweite liegt: mehr davon zeichnet kleine Formen, ' +
    'weniger große.',
  'occlusion.colour': 'Wohin kein Licht reicht, das behält diesen Anteil seiner Farbe.',
  'shadow.strength':
    'Wie dunkel der Schatten ist, den Fokus und Kontext werfen; 0 zeichnet ohne, bei 1 ist er vom ' +
    'Licht abgewandt.',
  'shadow.softness_degrees':
    'Der halbe Winkel, unter dem das Licht gesehen wird; 0 ist eine harte Kante.',
  'wall.strength':
    'Anteil der eigenen Farbe der Wand; bei 0 ist sie gezeichnet wie der übrige Kontext.',
  'wall.colour':
    'Sie muss sich in der Helligkeit von Haut und Fokus unterscheiden, sonst schließt sich das Loch.',
  'wall.deepening': 'Wie viel dunkler sie mit der Tiefe unter dem Rand wird; 0 gar nicht.',
  'wall.edge_mm': 'Breite des hellen Randes, wo die Linse die Haut schneidet, mm.',
  'wall.edge_colour': 'Die Farbe dieses Randes.',
  'lens.mode':
    'Keine zeigt den Kontext allein; Ausschnitt entfernt den Kontext in der Linse; Magisch blendet ' +
    'den ganzen Fokus über den Kontext, wo die Linse das Bild bedeckt.',
  'lens.centre_mm':
    'Patientenraum, mm. Fehlt sie, liegt sie auf der Oberfläche des Kontexts in der Bildmitte oder ' +
    'so nah daran, wie etwas vom Fokus zu sehen ist.',
  'lens.radius_mm': 'Größe der Linse, mm; bei 0 bleibt der Kontext ganz.',
  'lens.opening':
    'Beim Ausschnitt: geschlossen nimmt den Kontext nur in der Linse weg, Trichter auch zwischen ' +
    'Linse und Auge, sodass nichts vom Kontext den Fokus verdeckt.',
  'lens.funnel_degrees':
    'Wie weit sich die Seite des Trichters von seiner Achse neigt, in Grad; bei 0 ist er ein ' +
    'Zylinder, dessen Wand niemand sieht.',
  'lens.cap':
    'Wie das Innere gezeichnet wird, wo die Linse eine Oberfläche aufschneidet: flach mit der ' +
    'Normalen der Linse, nach dem Gradienten des Volumens, gar nicht, oder als Schnitt in den ' +
    'Farben der Gewebe.',
  'lens.strength':
    'Für die magische Linse: Anteil des Fokus in der Mitte; 0 zeigt nur den Kontext, 1 nur den ' +
    'Fokus.',
  'lens.softness':
    'Für die magische Linse: Anteil des Radius, über den der Fokus zum Rand hin ausläuft; 0 ist ' +
    'eine harte Kante.',
  'lens.strict':
    'Für die magische Linse: ob der Kontext auch dort ausgeblendet wird, wo der Fokus nichts ' +
    'zeigt, sodass der Hintergrund durchscheint.',
  'light.frame':
    'Mit der Kamera dreht sich das Licht mit dem Betrachter; mit dem Patienten bleibt es an ihm.',
  'light.direction': 'Richtung zum Licht.',
  'window.centre': 'Der Wert, der mittelgrau gezeichnet wird, in den Einheiten des Volumens.',
  'window.width': 'Von Schwarz bis Weiß, in denselben Einheiten.',
};

// The solids that the abdomen is made of. Patient space, mm: x = 0 is the midline, z = 0 the third
// lumbar vertebra's lower edge, y = 0 half way from belly to back. The liver is on the right (x <
// 0), the spleen on the left.
#pragma once

#include "volume/phantom/shape.h"

namespace cutaway::phantom {

// --- abdomen_wall.cpp
ShapePtr abdomen_skin();
ShapePtr
abdomen_muscles();  ///< a solid core with back, buttocks and thighs; the cavities lie within it
ShapePtr abdomen_cavity();  ///< what the wall encloses: fat, organs, spine
ShapePtr deep_muscles();    ///< psoas, quadratus lumborum and iliacus, within the cavity

// --- abdomen_organs.cpp
ShapePtr diaphragm_dome();
ShapePtr lung_bases();
ShapePtr heart();
ShapePtr liver();
ShapePtr gallbladder();
ShapePtr spleen();
ShapePtr kidneys();
ShapePtr kidney_pelves();
ShapePtr pancreas();
ShapePtr bladder();

// --- abdomen_bowel.cpp
ShapePtr stomach();
ShapePtr colon();
ShapePtr small_bowel();

// --- abdomen_bones.cpp
ShapePtr lumbar_spine();
ShapePtr discs();
ShapePtr ribs();
ShapePtr rib_cartilage();

// --- pelvis.cpp
ShapePtr pelvis();
ShapePtr sacrum();
ShapePtr thigh_bones();
ShapePtr thigh_marrow();

// --- abdomen_vessels.cpp
ShapePtr abdomen_arteries();
ShapePtr abdomen_veins();
ShapePtr portal_vein();

}  // namespace cutaway::phantom

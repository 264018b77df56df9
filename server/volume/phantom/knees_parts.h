// The solids that the knees are made of, given for the left leg (x > 0, lateral is +x) and
// reflected. Patient space, mm: z = 0 is the joint line, the kneecap faces -y.
#pragma once

#include "volume/phantom/shape.h"

namespace cutaway::phantom {

// --- knees_bones.cpp
ShapePtr femur();
ShapePtr tibia();
ShapePtr fibula();
ShapePtr patella();
ShapePtr knee_marrow();     ///< the cavities of the three shafts
ShapePtr knee_cartilage();  ///< reaches into the bones, which are painted over it
ShapePtr menisci();
ShapePtr bone_cyst();  ///< in the left tibia only: the marker of the left side

// --- knees_soft.cpp
ShapePtr leg_skin();
ShapePtr leg_muscles();
ShapePtr knee_ligaments();  ///< and tendons
ShapePtr joint_space();
ShapePtr leg_arteries();
ShapePtr leg_veins();

}  // namespace cutaway::phantom

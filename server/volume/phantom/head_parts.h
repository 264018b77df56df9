// The solids that the head is made of. Patient space, mm: the plane through ear canals and lower
// orbital rims is z = 0, the face looks to -y, the midline is x = 0. Measures follow an average
// adult.
#pragma once

#include "volume/phantom/shape.h"

namespace cutaway::phantom {

// --- head_skin.cpp
ShapePtr head_skin();  ///< with nose, lips, closed lids, ears and neck; no earring
ShapePtr neck_outline();
ShapePtr earring();  ///< metal, in the left ear lobe only: the marker of the left side

// --- head_skull.cpp
ShapePtr cranial_vault(float inset_mm);  ///< the skin of the calvaria, moved inwards
ShapePtr cranial_cavity();
ShapePtr skull();   ///< without the mandible, with its openings
ShapePtr orbits();  ///< the cones that hold the eyes

// --- head_jaw.cpp
ShapePtr mandible();
ShapePtr tooth_roots();
ShapePtr tooth_crowns();

// --- head_airways.cpp
ShapePtr sinuses();  ///< air cells of the skull; the frontal one is larger on the left
ShapePtr nasal_cavity();
ShapePtr nasal_walls();  ///< septum and turbinates, within the cavity
ShapePtr nostrils();
ShapePtr throat();  ///< from the nose to the trachea
ShapePtr ear_canals();

// --- head_soft.cpp
ShapePtr head_muscles();
ShapePtr eyeballs();
ShapePtr eye_lenses();
ShapePtr orbital_muscles();  ///< and the optic nerves
ShapePtr cerebrum();
ShapePtr cerebellum();
ShapePtr brainstem();  ///< and the spinal cord
ShapePtr ventricles();

// --- head_vessels.cpp
ShapePtr head_arteries();
ShapePtr head_veins();

// --- neck_bones.cpp
ShapePtr cervical_spine();
ShapePtr spinal_canal();
ShapePtr larynx_cartilage();
ShapePtr hyoid();

}  // namespace cutaway::phantom

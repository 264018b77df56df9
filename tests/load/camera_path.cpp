#include "load/camera_path.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace cutaway::load {

namespace {

glm::dvec3 vector_of(const nlohmann::json& list) { return {list.at(0), list.at(1), list.at(2)}; }

}  // namespace

CameraPath::CameraPath(const nlohmann::json& camera)
    : target_mm_(vector_of(camera.at("target_mm"))),
      offset_mm_(vector_of(camera.at("eye_mm")) - target_mm_),
      up_(glm::normalize(vector_of(camera.at("up")))) {
  if (camera.value("projection", "perspective") == "orthographic")
    view_height_mm_ = camera.at("view_height_mm");
}

glm::dvec3 CameraPath::eye_mm(const Pose& pose) const {
  const glm::dvec3 turned = glm::angleAxis(glm::radians(pose.azimuth_degrees), up_) * offset_mm_;
  const glm::dvec3 axis = glm::normalize(glm::cross(turned, up_));
  const glm::dvec3 raised = glm::angleAxis(glm::radians(pose.elevation_degrees), axis) * turned;
  return target_mm_ + pose.distance * raised;
}

// An orthographic picture does not grow by going nearer.
nlohmann::json CameraPath::message(const Pose& pose) const {
  const bool orthographic = view_height_mm_ > 0.0;
  Pose place = pose;
  if (orthographic) place.distance = 1.0;
  const glm::dvec3 eye = eye_mm(place);
  nlohmann::json camera = {{"eye_mm", {eye.x, eye.y, eye.z}}};
  if (orthographic) camera["view_height_mm"] = view_height_mm_ * pose.distance;
  return {{"type", "scene"}, {"scene", {{"camera", camera}}}};
}

}  // namespace cutaway::load

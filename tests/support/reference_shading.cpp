#include "support/reference_shading.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/colour.h"

namespace cutaway::reference {

namespace {

glm::dvec3 colour(const Json& parameters, const char* name) {
  const auto channels = parameters.at(name).get<std::vector<double>>();
  return {channels[0], channels[1], channels[2]};
}

double tone_lookup(const Json& parameters, double cosine) {
  if (parameters.at("lambert") == "clamped") return std::clamp(cosine, 0.0, 1.0);
  const double terminator = parameters.at("terminator").get<double>();
  const double u = cosine < terminator ? 0.5 * (cosine + 1.0) / (terminator + 1.0)
                                       : 0.5 + 0.5 * (cosine - terminator) / (1.0 - terminator);
  return std::clamp(u, 0.0, 1.0);
}

glm::dvec3 tone(const Json& parameters, double cosine, double light_share) {
  const double position = tone_position(tone_lookup(parameters, cosine) * light_share,
                                        parameters.at("detail").get<double>());
  return glm::mix(colour(parameters, "dark"), colour(parameters, "light"), position);
}

/// Of a square of side 1 whose middle has the value, which grows by `gradient`: the share where it
/// is positive. The square is cut into so many strips that each is as good as a line.
double lit_share(double value, glm::dvec2 gradient) {
  constexpr int kStrips = 400;
  const auto [along, across] = std::abs(gradient.x) > std::abs(gradient.y)
                                   ? std::pair(std::abs(gradient.x), gradient.y)
                                   : std::pair(std::abs(gradient.y), gradient.x);
  double sum = 0.0;
  for (int i = 0; i < kStrips; ++i) {
    const double middle = value + across * ((i + 0.5) / kStrips - 0.5);
    sum += std::clamp(0.5 + middle / along, 0.0, 1.0) / kStrips;
  }
  return sum;
}

double highlight(const Json& parameters, glm::dvec3 normal, glm::dvec3 to_light,
                 glm::dvec3 to_viewer) {
  const double exponent = parameters.at("exponent").get<double>();
  if (glm::dot(normal, to_light) <= 0.0) return 0.0;
  if (parameters.at("model") == "blinn") {
    if (glm::length(to_light + to_viewer) < 1e-6) return 0.0;
    return std::pow(std::max(0.0, glm::dot(normal, glm::normalize(to_light + to_viewer))),
                    4.0 * exponent);
  }
  return std::pow(std::max(0.0, glm::dot(glm::reflect(-to_light, normal), to_viewer)), exponent);
}

glm::dvec3 phong(const Json& parameters, glm::dvec3 normal, glm::dvec3 to_light,
                 glm::dvec3 to_viewer, double light_share) {
  const double lit = parameters.at("ambient").get<double>() +
                     parameters.at("diffuse").get<double>() * light_share *
                         std::max(0.0, glm::dot(normal, to_light));
  const double spot = parameters.at("specular").get<double>() * light_share *
                      highlight(parameters, normal, to_light, to_viewer);
  return glm::clamp(colour(parameters, "colour") * lit + spot, 0.0, 1.0);
}

glm::dvec3 gooch(const Json& parameters, double cosine, double light_share) {
  const auto value = [&](const char* name) { return parameters.at(name).get<double>(); };
  const glm::dvec3 surface = colour(parameters, "colour");
  const glm::dvec3 cool = glm::dvec3(0.0, 0.0, value("blue")) + value("alpha") * surface;
  const glm::dvec3 warm =
      glm::dvec3(value("yellow"), value("yellow"), 0.0) + value("beta") * surface;
  return glm::clamp(glm::mix(cool, warm, light_share * std::clamp((1.0 + cosine) / 2.0, 0.0, 1.0)),
                    0.0, 1.0);
}

/// A smooth step of the half-Lambert term's power mixed in, then along the six colours.
glm::dvec3 ramp(const Json& parameters, double cosine, double light_share) {
  const auto value = [&](const char* name) { return parameters.at(name).get<double>(); };
  const double term =
      light_share * std::pow(std::clamp(0.5 + 0.5 * cosine, 0.0, 1.0), value("gamma"));
  const double begin = value("step_at") - value("step_width") / 2.0;
  const double along = std::clamp((term - begin) / value("step_width"), 0.0, 1.0);
  const double stepped = along * along * (3.0 - 2.0 * along);
  const double at = 5.0 * (term + value("step") * (stepped - term));
  const char* const names[] = {"deepest", "deep", "middle", "light", "lighter", "lightest"};
  const int below = std::min(static_cast<int>(at), 4);
  return mix_colours(colour(parameters, names[below]), colour(parameters, names[below + 1]),
                     at - below);
}

}  // namespace

double tone_position(double u, double detail) {
  return u < 0.5 ? detail * u : 1.0 - detail * (1.0 - u);
}

glm::dvec3 shade(const Module& shading, glm::dvec3 normal, glm::dvec3 to_light,
                 glm::dvec3 to_viewer, double light_share) {
  const Json& parameters = shading.parameters;
  const double cosine = glm::dot(normal, to_light);
  if (shading.name == "tone") return tone(parameters, cosine, light_share);
  if (shading.name == "gooch") return gooch(parameters, cosine, light_share);
  if (shading.name == "ramp") return ramp(parameters, cosine, light_share);
  if (shading.name == "phong") return phong(parameters, normal, to_light, to_viewer, light_share);
  throw std::logic_error("the reference has no shading model " + shading.name);
}

glm::dvec3 shade_turning(const Module& shading, glm::dvec3 normal, glm::dvec3 to_light,
                         glm::dvec3 across, glm::dvec3 down, double rays_a_pixel,
                         double light_share) {
  const Json& parameters = shading.parameters;
  const double cosine = glm::dot(normal, to_light);
  const double step =
      parameters.at("lambert") == "half" ? parameters.at("terminator").get<double>() : 0.5;
  const glm::dvec2 a_ray(glm::dot(across, to_light), glm::dot(down, to_light));
  const double width = std::max(1.0, parameters.at("softness").get<double>() * rays_a_pixel);
  double lit = glm::length(a_ray) > 0.0 ? lit_share((cosine - step) / width, a_ray)
                                        : (cosine < step ? 0.0 : 1.0);
  const double u = tone_lookup(parameters, cosine) * light_share;
  if (light_share < 1.0) lit = std::min(lit, std::clamp(0.5 + 20.0 * (u - 0.5), 0.0, 1.0));
  const double detail = parameters.at("detail").get<double>();
  return glm::mix(colour(parameters, "dark"), colour(parameters, "light"),
                  glm::mix(detail * u, 1.0 - detail * (1.0 - u), lit));
}

}  // namespace cutaway::reference

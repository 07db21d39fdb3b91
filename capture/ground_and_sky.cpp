#include <glm/geometric.hpp>

#include "capture/cone_ray.h"
#include "capture/round_cone.h"

namespace posecoach {
namespace {

using namespace cone_ray;

// The same grain for a place on the ground whatever the camera sees of it.
float grain(float x, float z) {
  const auto cell = [](float v) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(v * 24.0F)));
  };
  std::uint32_t bits = cell(x) * 0x9E3779B1U ^ cell(z) * 0x85EBCA77U;
  bits ^= bits >> 15;
  bits *= 0x2C1B3C6DU;
  bits ^= bits >> 12;
  return static_cast<float>(bits & 0xFFU) / 255.0F - 0.5F;
}

}  // namespace

Image draw_ground_and_sky(const PinholeCamera& camera) {
  const View view(camera);
  Image image = Image::black(camera.width_px, camera.height_px);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Float3 ray = glm::normalize(
          view.direction_to_world(view.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F)));
      SurfaceColour colour;
      if (ray.y >= 0) {
        const float up = std::min(1.0F, ray.y * 2.2F);
        colour = {0.83F - 0.33F * up, 0.89F - 0.20F * up, 0.95F - 0.04F * up};
      } else {
        const float distance = std::min(60.0F, -view.eye.y / std::min(ray.y, -1e-4F));
        const float ground_x = view.eye.x + ray.x * distance, ground_z = view.eye.z + ray.z * distance;
        const float haze = distance / 60.0F;
        const float stripe =
            std::floor(ground_x * 0.5F) - 2.0F * std::floor(ground_x * 0.25F) > 0.5F ? 0.014F : -0.014F;
        const float speckle =
            distance < 14.0F ? 0.035F * grain(ground_x, ground_z) * (1.0F - distance / 14.0F) : 0.0F;
        const float near = 1.0F - haze;
        colour = {0.33F + 0.30F * haze + (speckle + stripe) * near,
                  0.52F + 0.22F * haze + (speckle + stripe) * near,
                  0.24F + 0.36F * haze + (speckle * 0.6F + stripe) * near};
      }
      for (std::size_t c = 0; c < 3; ++c) image.pixel(x, y)[c] = to_byte(colour[c]);
    }
  return image;
}

}  // namespace posecoach

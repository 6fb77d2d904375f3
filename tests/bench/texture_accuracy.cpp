// How true the textures of a finished `ostraka process` result are: baked from five photographs in
// six, they are compared with the sixth, which they have not seen.
//   texture_accuracy BATCH OUT [--threads N]
// Per sherd and in the mean: colour difference (CIE 1976, RMS over the texels that the photograph
// shows, after one gain a channel: its exposure), the share of the photograph's fine contrast that
// the texture has at the same places, the step across charts (the same difference, between both
// places where the page shows a point of a border), the share of texels from photographs, seconds.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "batch/photograph.h"
#include "cloud/ply.h"
#include "files/json.h"
#include "model/model.h"
#include "texture/seams.h"
#include "texture/sherd_views.h"
#include "texture/texture.h"

namespace {

using namespace ostraka;
namespace fs = std::filesystem;

constexpr double kDeviation_mm = 0.03;  // of the GLB
constexpr std::size_t kLeftOut = 6;

template <class T>
T orExit(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", result.error().sentence().english().c_str());
  std::exit(2);
}

std::vector<texture::Photograph> photographsOf(const fs::path& batch, const fs::path& out) {
  std::vector<texture::Photograph> photographs;
  for (rig::PosedImage& image : orExit(rig::readCameras(out / "work/rig/cameras.json"))) {
    const std::string side = batch::name(image.side), name = fs::path(image.file).filename();
    const fs::path mask = out / "work" / ("masks_" + side) / rig::maskName(image);
    image.file = batch / side / name;
    if (!fs::exists(mask)) continue;
    photographs.push_back({image, orExit(batch::readMask(mask))});
  }
  return photographs;
}

cv::Vec3f labOf(const cv::Vec3f& bgr) {
  const cv::Mat3f one(1, 1, cv::Vec3f(bgr / 255));
  cv::Mat3f lab;
  cv::cvtColor(one, lab, cv::COLOR_BGR2Lab);
  return lab(0, 0);
}

cv::Vec3f at(const cv::Mat3b& picture, const Eigen::Vector2d& pixel) {
  cv::Mat3b patch;
  cv::getRectSubPix(picture, {1, 1}, {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())},
                    patch);
  return patch(0, 0);
}

struct Sums {
  double lab2 = 0, both = 0, own2 = 0, step2 = 0;
  std::size_t texels = 0, places = 0;

  static double rms(double sum2, std::size_t count) {
    return std::sqrt(sum2 / std::max<double>(1, static_cast<double>(count)));
  }
};

struct Page {
  TriangleMesh mesh;
  texture::Atlas atlas;
  texture::Texels texels;
  texture::Texture texture;
};

// One photograph that was left out against the page.
void compare(const Page& page, const texture::View& view, Sums& sums) {
  const texture::DepthMap depth(page.mesh, view);
  cv::Mat1b inner;
  cv::erode(view.mask, inner, cv::Mat(), {-1, -1}, 4, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::Mat3b soft_view, soft_page;
  cv::GaussianBlur(view.picture, soft_view, {}, 3);
  cv::GaussianBlur(page.texture.picture, soft_page, {}, 3);
  struct One {
    cv::Vec3f texture, photograph;
    double fine_texture = 0, fine_photograph = 0;
  };
  std::vector<One> all;
  cv::Vec3d textures(0, 0, 0), shown(0, 0, 0);
  for (int y = 0; y < page.texels.face.rows; ++y)
    for (int x = 0; x < page.texels.face.cols; ++x) {
      if (page.texels.face(y, x) < 0 || page.texture.seen(y, x) == 0) continue;
      const auto& t = page.mesh.triangles[static_cast<std::size_t>(page.texels.face(y, x))];
      const cv::Vec2f& w = page.texels.weights(y, x);
      const auto mixed = [&](const std::vector<Eigen::Vector3f>& of) {
        return Eigen::Vector3f(w[0] * of[t[0]] + w[1] * of[t[1]] + (1 - w[0] - w[1]) * of[t[2]])
            .cast<double>()
            .eval();
      };
      const Eigen::Vector3d point = mixed(page.mesh.vertices);
      const double cosine =
          mixed(page.mesh.normals).normalized().dot((view.centre() - point).normalized());
      if (cosine < 0.6) continue;
      const Eigen::Vector2d pixel = view.project(point);
      const int px = cvRound(pixel.x()), py = cvRound(pixel.y());
      if (px < 1 || py < 1 || px >= inner.cols - 1 || py >= inner.rows - 1 || inner(py, px) == 0)
        continue;
      if (!depth.sees(pixel, (view.camera_from_mesh * point).z(), cosine)) continue;
      One one{cv::Vec3f(page.texture.picture(y, x)), at(view.picture, pixel)};
      one.fine_texture = one.texture[1] - soft_page(y, x)[1];
      one.fine_photograph = one.photograph[1] - at(soft_view, pixel)[1];
      textures += cv::Vec3d(one.texture);
      shown += cv::Vec3d(one.photograph);
      all.push_back(one);
    }
  for (One& one : all) {
    for (int k = 0; k < 3; ++k)
      one.photograph[k] *= static_cast<float>(textures[k] / std::max(shown[k], 1.0));
    const cv::Vec3f off = labOf(one.texture) - labOf(one.photograph);
    sums.lab2 += off.dot(off);
    sums.both += one.fine_texture * one.fine_photograph;
    sums.own2 += one.fine_photograph * one.fine_photograph;
  }
  sums.texels += all.size();
}

void addSteps(const Page& page, const std::vector<texture::Seam>& seams, Sums& sums) {
  const auto levelAt = [&](const Eigen::Vector2d& texel) {
    const Eigen::Vector2f place(static_cast<float>((texel.x() + 0.5) / page.atlas.width),
                                static_cast<float>((texel.y() + 0.5) / page.atlas.height));
    return texture::levelAt(page.texture.picture, place);
  };
  for (const texture::Seam& seam : seams)
    for (const auto& [one, other] : texture::placesAlong(seam)) {
      const cv::Vec3f off = labOf(levelAt(one)) - labOf(levelAt(other));
      sums.step2 += off.dot(off);
      ++sums.places;
    }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "texture_accuracy BATCH OUT [--threads N]\n");
    return 2;
  }
  const fs::path batch = argv[1], out = argv[2];
  const int threads = argc > 4 && std::strcmp(argv[3], "--threads") == 0 ? std::atoi(argv[4]) : 0;
  const std::vector<texture::Photograph> photographs = photographsOf(batch, out);
  const nlohmann::json pairs = orExit(readJson(out / "pairs.json"));
  std::printf("%-6s %8s %9s %8s %8s %8s %7s\n", "sherd", "dE RMS", "contrast", "step", "seen %",
              "texel mm", "s");
  Sums total;
  for (const auto& pair : pairs["pairs"]) {
    const std::string number = pair["front"].get<std::string>().substr(2);
    const fs::path ply = out / "sherds" / number / "model.ply";
    if (!fs::exists(ply)) continue;
    const TriangleMesh mesh = orExit(model::decimated(orExit(readPly(ply)).mesh, kDeviation_mm));
    const texture::Subject subject{
        mesh.vertices, orExit(isometryFromJson(pair["T_front_from_back"], "pairs.json"))};
    std::vector<texture::Photograph> kept, left_out;
    for (std::size_t i = 0; i < photographs.size(); ++i)
      (i % kLeftOut == kLeftOut / 2 ? left_out : kept).push_back(photographs[i]);
    texture::SherdViews views(kept, {subject}, threads), others(left_out, {subject}, threads);
    QuietProgress quiet;
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<texture::View>& shown = orExit(views.of(0, {})).views;
    const double texel_mm = texture::finestPixel_mm(mesh, shown);
    const std::vector<texture::Chart> charts = texture::chartsOf(mesh, texel_mm);
    const texture::Atlas atlas = texture::packed(charts, texel_mm);
    const Page page{mesh, atlas, texture::texelsOf(charts, atlas),
                    orExit(texture::bake(mesh, charts, atlas, shown, {}, threads, quiet, {}))};
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    Sums sums;
    for (const texture::View& view : orExit(others.of(0, {})).views) compare(page, view, sums);
    addSteps(page, texture::seamsOf(mesh, charts, atlas), sums);
    std::printf("%-6s %8.2f %9.3f %8.2f %8.2f %8.3f %7.1f\n", number.c_str(),
                Sums::rms(sums.lab2, sums.texels), sums.both / sums.own2,
                Sums::rms(sums.step2, sums.places), 100 * page.texture.seen_share, atlas.texel_mm,
                seconds);
    total.lab2 += sums.lab2;
    total.both += sums.both;
    total.own2 += sums.own2;
    total.texels += sums.texels;
    total.step2 += sums.step2;
    total.places += sums.places;
  }
  std::printf("%-6s %8.2f %9.3f %8.2f\n", "all", Sums::rms(total.lab2, total.texels),
              total.both / total.own2, Sums::rms(total.step2, total.places));
  return 0;
}

#include "texture/gains.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace ostraka::texture {
namespace {

constexpr float kDarkest = 4;   // darker levels say nothing of a ratio
constexpr double kAgree = 0.1;  // of logarithms: beyond it a sample is a highlight or a shadow
constexpr double kStay = 1e-3;  // pull of each photograph towards its own level
constexpr int kPasses = 4;

}  // namespace

Eigen::MatrixX3d gainsOf(const std::vector<std::vector<Sample>>& samples) {
  const auto views = static_cast<Eigen::Index>(samples.empty() ? 0 : samples.front().size());
  Eigen::MatrixX3d gains = Eigen::MatrixX3d::Ones(views, 3);
  for (int channel = 0; channel < 3; ++channel) {
    Eigen::VectorXd log_gain = Eigen::VectorXd::Zero(views);
    for (int pass = 0; pass < kPasses; ++pass) {
      Eigen::MatrixXd a = Eigen::MatrixXd::Zero(views, views);
      Eigen::VectorXd b = Eigen::VectorXd::Zero(views);
      double total = 0;
      std::vector<std::pair<Eigen::Index, double>> logs;  // photograph, logarithm of its level
      std::vector<double> weights;
      for (const std::vector<Sample>& place : samples) {
        logs.clear();
        weights.clear();
        double sum = 0, mean = 0;
        for (Eigen::Index v = 0; v < views; ++v) {
          const Sample& s = place[static_cast<std::size_t>(v)];
          if (s.weight <= 0 || s.level[channel] < kDarkest) continue;
          logs.emplace_back(v, std::log(static_cast<double>(s.level[channel])));
          weights.push_back(s.weight);
          sum += s.weight;
          mean += s.weight * (logs.back().second + log_gain[v]);
        }
        if (logs.size() < 2) continue;
        mean /= sum;
        sum = 0;
        for (std::size_t i = 0; i < logs.size(); ++i) {
          const double off = std::abs(logs[i].second + log_gain[logs[i].first] - mean);
          if (pass > 0) weights[i] /= 1 + off * off / (kAgree * kAgree);
          sum += weights[i];
        }
        // The place's own level is eliminated: min over it of sum w (log s + gain - level)^2.
        double all = 0;
        for (std::size_t i = 0; i < logs.size(); ++i) all += weights[i] * logs[i].second / sum;
        for (std::size_t i = 0; i < logs.size(); ++i) {
          a(logs[i].first, logs[i].first) += weights[i];
          b[logs[i].first] += weights[i] * (all - logs[i].second);
          for (std::size_t k = 0; k < logs.size(); ++k)
            a(logs[i].first, logs[k].first) -= weights[i] * weights[k] / sum;
          total += weights[i];
        }
      }
      if (total <= 0) break;
      a.diagonal().array() += kStay * total / static_cast<double>(views);
      log_gain = a.ldlt().solve(b);
    }
    double sum = 0, weight = 0;
    for (const std::vector<Sample>& place : samples)
      for (Eigen::Index v = 0; v < views; ++v) {
        const float w = place[static_cast<std::size_t>(v)].weight;
        sum += w * log_gain[v];
        weight += w;
      }
    if (weight > 0) gains.col(channel) = (log_gain.array() - sum / weight).exp();
  }
  return gains;
}

}  // namespace ostraka::texture

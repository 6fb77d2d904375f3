#include "ui/viewport/orientation_cube.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QTransform>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/look/state_colours.h"

namespace ostraka::ui {
namespace {

using Vector = std::array<double, 3>;

// Where a face looks, and where its text runs to and stands up.
struct Face {
  Vector normal, across, upright;
};
constexpr std::array<Face, 6> kFaces = {{
    {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
    {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
    {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
    {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
}};
constexpr double kHalf = 50;  // of an edge, in units of the text

double dot(const double a[3], const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

bool ViewAxes::operator==(const ViewAxes& other) const {
  return std::equal(right, right + 3, other.right) && std::equal(up, up + 3, other.up) &&
         std::equal(away, away + 3, other.away);
}

void paintOrientationCube(QPainter& painter, const QRectF& where, const ViewAxes& axes,
                          const QString& front, const QString& back) {
  const StateColours colours = StateColours::onMatte();
  const QString words[] = {front,
                           back,
                           QStringLiteral("x"),
                           QStringLiteral("−x"),
                           QStringLiteral("y"),
                           QStringLiteral("−y")};
  const double half = where.width() / 2 / std::sqrt(3.0);  // its corners stay inside
  const auto onScreen = [&](const Vector& v) {
    return QPointF(dot(axes.right, v), -dot(axes.up, v)) * half;
  };
  painter.save();
  const QTransform placed = painter.transform();
  const QFont usual = painter.font();
  for (std::size_t i = 0; i < kFaces.size(); ++i) {
    const Face& face = kFaces[i];
    const double towards = -dot(axes.away, face.normal);
    if (towards < 0.01) continue;
    const QPointF middle = where.center() + onScreen(face.normal);
    const QPointF across = onScreen(face.across) / kHalf, down = -onScreen(face.upright) / kHalf;
    painter.setTransform(
        QTransform(across.x(), across.y(), down.x(), down.y(), middle.x(), middle.y()) * placed);
    const QColor ground = i == 0   ? colours.of(State::Front)
                          : i == 1 ? colours.of(State::Back)
                                   : StateColours::inkOnMatte().darker(115);
    painter.setBrush(ground.darker(static_cast<int>(100 + 45 * (1 - towards))));
    painter.setPen(QPen(StateColours::matte(), 3));
    const QRectF square(-kHalf, -kHalf, 2 * kHalf, 2 * kHalf);
    painter.drawRect(square);
    if (towards < 0.25) continue;
    QFont font = usual;
    font.setPixelSize(40);
    font.setBold(true);
    const double wide = QFontMetricsF(font).horizontalAdvance(words[i]);
    if (wide > 1.8 * kHalf) font.setPixelSize(static_cast<int>(40 * 1.8 * kHalf / wide));
    painter.setFont(font);
    painter.setPen(StateColours::matte());
    painter.drawText(square, Qt::AlignCenter, words[i]);
  }
  painter.restore();
}

}  // namespace ostraka::ui

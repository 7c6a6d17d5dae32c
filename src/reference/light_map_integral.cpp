// Along a line a bilinear cell is a quadratic. Times the panel's polynomial of degree 7 five of
// Gauss's nodes are exact; where cells are much finer than the panel, two or three are good enough:
// for q p with q quadratic over a cell of width h in y, the rules' remainders f'''' h^5 / 4320 and
// f^(6) h^7 / 2016000 (Abramowitz & Stegun 25.4.30) are mainly 6 q'' p'' and 15 q'' p'''', and q''
// is at most 4 / h^2 of the texels' largest value.
#include "reference/light_map_integral.h"

#include <array>
#include <cmath>

#include "reference/walk_texels.h"

namespace ribalta {
namespace {

struct ShortGaussRule {
    int count;
    std::array<double, 5> nodes;  // of -1..1
    std::array<double, 5> weights;
};

constexpr ShortGaussRule kTwo = {
    2, {-0.577350269189625764509, 0.577350269189625764509}, {1.0, 1.0}};
constexpr ShortGaussRule kThree = {
    3, {-0.774596669241483377036, 0.0, 0.774596669241483377036}, {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0}};
constexpr ShortGaussRule kFive = {
    5,
    {-0.906179845938663992798, -0.538469310105683091036, 0.0, 0.538469310105683091036,
     0.906179845938663992798},
    {0.236926885056189087514, 0.478628670499366468041, 0.568888888888888888889,
     0.478628670499366468041, 0.236926885056189087514}};

/// The cheapest rule that is good enough for cells up to `width` wide in the panel's y.
const ShortGaussRule& ruleFor(const SmoothPanel& panel, double width, double relative) {
    const double allowed = relative * panel.largest;
    const double square = width * width;
    if (24.0 / 4320.0 * panel.secondDerivative() * square <= allowed) {
        return kTwo;
    }
    if (60.0 / 2016000.0 * panel.fourthDerivative() * square * square <= allowed) {
        return kThree;
    }
    return kFive;
}

}  // namespace

glm::dvec3 integrateOverLightMap(const SmoothPanel& panel, const LightMapTexture& map,
                                 const glm::dvec2& uvAt0, const glm::dvec2& uvAt1,
                                 double relative) {
    const glm::dvec2 from = uvAt0 * map.size() - 0.5;
    const glm::dvec2 to = uvAt1 * map.size() - 0.5;
    const glm::dvec2 along = to - from;
    const double centre = 0.5 * (panel.place.first + panel.place.last);
    const double perX = 2.0 / panel.place.length();
    const double fastest = std::max(std::abs(along.x), std::abs(along.y));
    const double width = std::min(fastest > 0.0 ? perX / fastest : 2.0, 2.0);
    const ShortGaussRule& rule = ruleFor(panel, width, relative);

    glm::dvec3 sum(0.0);
    walkCells(from, to, panel.place.first, panel.place.last,
              [&](int column, int row, double first, double last) {
                  if (map.isDark(column, row)) {
                      return;
                  }
                  const double middle = 0.5 * (first + last);
                  const double half = 0.5 * (last - first);
                  // The polynomial's weight on each corner of the cell.
                  double all = 0.0;
                  double right = 0.0;
                  double lower = 0.0;
                  double both = 0.0;
                  for (int i = 0; i < rule.count; ++i) {
                      const auto node = std::size_t(i);
                      const double x = middle + half * rule.nodes[node];
                      const double weight = rule.weights[node] * panel.at((x - centre) * perX);
                      const double across = from.x + x * along.x - column;
                      const double down = from.y + x * along.y - row;
                      all += weight;
                      right += weight * across;
                      lower += weight * down;
                      both += weight * across * down;
                  }
                  const auto corners = map.cell(column, row).corners;
                  const double weights[4] = {all - right - lower + both, right - both, lower - both,
                                             both};
                  for (std::size_t i = 0; i < 4; ++i) {
                      const double scaled = half * weights[i];
                      sum.x += scaled * double(corners[i]->x);
                      sum.y += scaled * double(corners[i]->y);
                      sum.z += scaled * double(corners[i]->z);
                  }
              });
    return sum;
}

}  // namespace ribalta

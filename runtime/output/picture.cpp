// SPDX-License-Identifier: BSD-3-Clause
// A z-buffer: every triangle of every body is rasterized into (depth, body, shade) samples at twice
// the resolution of the picture, outlines are drawn where neighboring samples belong to different
// bodies, and 2 x 2 samples are averaged into a pixel.
#include "runtime/output/picture.hpp"

#include "common/math/aabb.hpp"
#include "common/math/elementary.hpp"
#include "runtime/output/wall_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dem::runtime {

namespace {

constexpr std::size_t samples_per_pixel_side = 2;
constexpr std::uint32_t no_body = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t wall_line = no_body - 1;

/// Distinguishable with any color vision (Okabe & Ito 2008).
constexpr std::array<std::array<double, 3>, 7> palette{{{0.90, 0.62, 0.00},
                                                        {0.34, 0.71, 0.91},
                                                        {0.00, 0.62, 0.45},
                                                        {0.94, 0.89, 0.26},
                                                        {0.00, 0.45, 0.70},
                                                        {0.84, 0.37, 0.00},
                                                        {0.80, 0.47, 0.65}}};

struct Sample {
    float depth = std::numeric_limits<float>::infinity();
    std::uint32_t body = no_body;
    float shade = 0.0F;
};

/// Orthographic camera: rows of `axes` are right, up and away from the viewer.
struct Camera {
    Mat3 axes;
    Vec3 lower = Vec3::Zero();  ///< of the visible box, camera frame [m]
    double scale = 1.0;         ///< samples per meter
    std::size_t width = 0, height = 0;

    Vec3 sample_position(const Vec3& world) const {
        const Vec3 c = axes * world - lower;
        return {c.x() * scale, static_cast<double>(height) - c.y() * scale, c.z()};
    }
};

Aabb bounds(std::span<const PictureBody> bodies) {
    Aabb box;
    for (const PictureBody& body : bodies) {
        for (const Vec3& v : body.mesh->vertices) box.extend(body.position + body.orientation * v);
    }
    if (box.is_empty()) box.extend(Vec3(Vec3::Zero()));
    return box;
}

Vec3 towards_viewer(const PictureView& view) {
    const double ce = math::cos(view.elevation);
    return {ce * math::cos(view.azimuth), ce * math::sin(view.azimuth), math::sin(view.elevation)};
}

Camera make_camera(const PictureView& view, std::span<const PictureBody> bodies,
                   const Segments& lines) {
    const Vec3 back = towards_viewer(view);
    const Vec3 right = Vec3::UnitZ().cross(back).normalized();
    Camera camera;
    camera.axes.row(0) = right;
    camera.axes.row(1) = back.cross(right);
    camera.axes.row(2) = -back;

    Aabb seen;
    for (const PictureBody& body : bodies) {
        for (const Vec3& v : body.mesh->vertices) {
            seen.extend(Vec3(camera.axes * (body.position + body.orientation * v)));
        }
    }
    for (const auto& [from, to] : lines) {
        seen.extend(Vec3(camera.axes * from));
        seen.extend(Vec3(camera.axes * to));
    }
    if (seen.is_empty()) seen.extend(Vec3(Vec3::Zero()));
    const Vec3 size = seen.upper - seen.lower;
    const double longer = std::max({size.x(), size.y(), 1e-9});
    const double margin = 0.03 * longer;
    camera.lower = seen.lower - Vec3(margin, margin, 0.0);
    camera.scale =
        static_cast<double>(view.pixels * samples_per_pixel_side) / (longer + 2.0 * margin);
    const auto samples = [&](double length) {
        const auto pixels = static_cast<std::size_t>(
            std::ceil((length + 2.0 * margin) * camera.scale / samples_per_pixel_side));
        return std::max<std::size_t>(pixels, 1) * samples_per_pixel_side;
    };
    camera.width = samples(size.x());
    camera.height = samples(size.y());
    return camera;
}

class Canvas {
  public:
    explicit Canvas(const Camera& camera)
        : camera_(camera), samples_(camera.width * camera.height) {}

    void draw(const PictureBody& body, std::uint32_t id) {
        positions_.clear();
        for (const Vec3& v : body.mesh->vertices) {
            positions_.push_back(camera_.sample_position(body.position + body.orientation * v));
        }
        // Light and surface normal in sample coordinates (x right, y down, z away), which
        // are right-handed like the world's.
        const Vec3 light = Vec3(-0.45, -0.65, -0.9).normalized();
        for (const auto& t : body.mesh->triangles) {
            const Vec3& a = positions_[t[0]];
            const Vec3& b = positions_[t[1]];
            const Vec3& c = positions_[t[2]];
            Vec3 u = b - a;
            Vec3 v = c - a;
            u.z() *= camera_.scale;
            v.z() *= camera_.scale;
            const Vec3 normal = u.cross(v).normalized();
            if (normal.z() >= 0.0) continue;
            const double shade = 0.35 + 0.65 * std::max(0.0, normal.dot(light));
            fill(a, b, c, {0.0F, id, static_cast<float>(shade)});
        }
    }

    void draw_line(const Vec3& from, const Vec3& to) {
        const Vec3 a = camera_.sample_position(from);
        const Vec3 b = camera_.sample_position(to);
        const double length = (b - a).head<2>().norm();
        const auto steps = static_cast<int>(length) + 1;
        for (int k = 0; k <= steps; ++k) {
            const Vec3 p = a + (b - a) * (static_cast<double>(k) / steps);
            for (int dx = 0; dx < 2; ++dx) {
                put(static_cast<long>(p.x()) + dx, static_cast<long>(p.y()),
                    {static_cast<float>(p.z()), wall_line, 0.6F});
            }
        }
    }

    Image resolve(std::span<const PictureBody> bodies) const {
        constexpr std::size_t n = samples_per_pixel_side;
        Image image{camera_.width / n, camera_.height / n, {}};
        image.rgb.resize(3 * image.width * image.height);
        for (std::size_t y = 0; y < image.height; ++y) {
            for (std::size_t x = 0; x < image.width; ++x) {
                Vec3 color = Vec3::Zero();
                for (std::size_t k = 0; k < n * n; ++k) {
                    color += sample_color(n * x + k % n, n * y + k / n, bodies);
                }
                color *= 255.0 / (n * n);
                for (std::size_t c = 0; c < 3; ++c) {
                    image.rgb[3 * (y * image.width + x) + c] =
                        static_cast<std::uint8_t>(std::lround(color[static_cast<Eigen::Index>(c)]));
                }
            }
        }
        return image;
    }

  private:
    Vec3 sample_color(std::size_t x, std::size_t y, std::span<const PictureBody> bodies) const {
        const Sample& s = at(x, y);
        const bool outline = (x + 1 < camera_.width && at(x + 1, y).body != s.body) ||
                             (y + 1 < camera_.height && at(x, y + 1).body != s.body);
        if (s.body == wall_line) return Vec3::Constant(static_cast<double>(s.shade));
        if (outline) return Vec3::Constant(0.15);
        if (s.body == no_body) return Vec3::Ones();
        const auto& base = palette[bodies[s.body].color % palette.size()];
        return static_cast<double>(s.shade) * Vec3(base[0], base[1], base[2]);
    }

    const Sample& at(std::size_t x, std::size_t y) const { return samples_[y * camera_.width + x]; }

    void put(long x, long y, const Sample& sample) {
        if (x < 0 || y < 0 || x >= static_cast<long>(camera_.width) ||
            y >= static_cast<long>(camera_.height)) {
            return;
        }
        Sample& old =
            samples_[static_cast<std::size_t>(y) * camera_.width + static_cast<std::size_t>(x)];
        if (sample.depth < old.depth) old = sample;
    }

    void fill(const Vec3& a, const Vec3& b, const Vec3& c, Sample sample) {
        const double area = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
        if (area == 0.0) return;
        const auto low = [](double p) { return static_cast<long>(std::floor(p)); };
        const long x0 = low(std::min({a.x(), b.x(), c.x()}));
        const long x1 = low(std::max({a.x(), b.x(), c.x()}));
        const long y0 = low(std::min({a.y(), b.y(), c.y()}));
        const long y1 = low(std::max({a.y(), b.y(), c.y()}));
        for (long y = y0; y <= y1; ++y) {
            for (long x = x0; x <= x1; ++x) {
                const double px = static_cast<double>(x) + 0.5;
                const double py = static_cast<double>(y) + 0.5;
                const double wb =
                    ((px - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (py - a.y())) / area;
                const double wc =
                    ((b.x() - a.x()) * (py - a.y()) - (px - a.x()) * (b.y() - a.y())) / area;
                if (wb < 0.0 || wc < 0.0 || wb + wc > 1.0) continue;
                sample.depth =
                    static_cast<float>(a.z() + wb * (b.z() - a.z()) + wc * (c.z() - a.z()));
                put(x, y, sample);
            }
        }
    }

    Camera camera_;
    std::vector<Sample> samples_;
    std::vector<Vec3> positions_;
};

}  // namespace

Image render_picture(std::span<const PictureBody> bodies, std::span<const Wall> walls,
                     const MotionTime& time, const PictureView& view) {
    const Segments lines = wall_lines(walls, {time, bounds(bodies), towards_viewer(view)});
    Canvas canvas(make_camera(view, bodies, lines));
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        canvas.draw(bodies[k], static_cast<std::uint32_t>(k));
    }
    for (const auto& [from, to] : lines) canvas.draw_line(from, to);
    return canvas.resolve(bodies);
}

}  // namespace dem::runtime

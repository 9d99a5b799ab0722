# SPDX-License-Identifier: BSD-3-Clause
"""Loose packings of cuboids, cylinders and ellipsoids of five aspect ratios ([GC] Sec. 7): solid fractions, radial porosity, order."""
import concurrent.futures
import sys

import numpy as np

from packing import arguments, deposit
from validation import Page, cook, plt

R, D = 25.0, 3.0  # radius of the vessel and width of every body, mm
BATCH = 60
BATCHES = {0.25: 24, 0.5: 20, 1.0: 20, 2.0: 14, 3.0: 12}
SHAPES = {"cuboid": (lambda h: f"shape = cuboid\nlength = 3\nwidth = 3\nheight = {h}\n", lambda h: 9.0 * h),
          "cylinder": (lambda h: f"shape = cylinder\nradius = 1.5\nheight = {h}\n", lambda h: np.pi * 2.25 * h),
          "ellipsoid": (lambda h: f"shape = ellipsoid\na = 1.5\nb = 1.5\nc = {h / 2}\n", lambda h: 4 / 3 * np.pi * 2.25 * h / 2)}
DEEPER = {("ellipsoid", 1.0): 2, ("ellipsoid", 0.5): 1.5}  # times as many: the beds of the smallest bodies would be the shallowest
LAUNCH_SEEDS = {("cuboid", 2.0), ("cuboid", 3.0), ("cylinder", 2.0), ("cylinder", 3.0)}  # a second seed: ten packings at AR >= 2


def batches(shape, ratio):
    return int(BATCHES[ratio] * DEEPER.get((shape, ratio), 1))


def pack(shape, ratio, seed, reuse):
    """The runs of a packing, one per batch."""
    template = cook("units = mm\n" + SHAPES[shape][0](D * ratio), suffix="convex")
    runs, _ = deposit(f"convex_{shape}_{ratio}_{seed}", [template] * batches(shape, ratio), BATCH, 15 if ratio <= 1 else 30, seed, reuse,
                   radius=R, inner=R, end=1, divisor=20 if ratio == 1 and shape != "ellipsoid" else 10)
    return runs


class Bed:
    """Centers (mm) and directions of a finished packing; which points lie inside a body, by the formulas of the sharp shapes."""

    def __init__(self, runs, shape, ratio):
        final = runs[-1].final
        self.shape, self.half = shape, D * ratio / 2
        self.x = 1e3 * np.stack([final[c] for c in "xyz"], axis=1)
        w, a, b, c = (final[q] for q in ("qw", "qx", "qy", "qz"))
        self.axes = np.stack([np.stack([1 - 2 * (b * b + c * c), 2 * (a * b - w * c), 2 * (a * c + w * b)], 1),
                              np.stack([2 * (a * b + w * c), 1 - 2 * (a * a + c * c), 2 * (b * c - w * a)], 1),
                              np.stack([2 * (a * c - w * b), 2 * (b * c + w * a), 1 - 2 * (a * a + b * b)], 1)], 1)
        self.director = self.axes[:, :, 2]
        self.surface = 1e3 * runs[-1].history["height_surface"][-1]

    def layer(self):
        """Heights between which neither floor nor surface order the bodies [mm]."""
        return 0.2 * self.surface, 0.85 * self.surface

    def is_in_layer(self):
        low, high = self.layer()
        return (self.x[:, 2] > low) & (self.x[:, 2] < high)

    def inside(self, points):
        """Which of the points (n, 3), in mm, lie in a body."""
        result = np.zeros(len(points), bool)
        reach = np.hypot(self.half, {"cuboid": np.sqrt(2) * D / 2}.get(self.shape, D / 2))
        # Points by cells across the axis: a body asks those of nine.
        cells = np.floor(points[:, :2] / reach).astype(int) + 1000
        number = cells[:, 0] * 2000 + cells[:, 1]
        order = np.argsort(number, kind="stable")
        keys, begin = np.unique(number[order], return_index=True)
        lists = dict(zip(keys.tolist(), np.split(order, begin[1:])))
        nothing = np.zeros(0, int)
        for center, axes in zip(self.x, self.axes):
            cx, cy = (np.floor(center[:2] / reach).astype(int) + 1000).tolist()
            near = np.concatenate([lists.get((cx + k) * 2000 + cy + n, nothing) for k in (-1, 0, 1) for n in (-1, 0, 1)])
            near = near[abs(points[near, 2] - center[2]) < reach]
            local = np.abs((points[near] - center) @ axes)
            if self.shape == "cuboid":
                hit = (local <= (D / 2, D / 2, self.half)).all(axis=1)
            elif self.shape == "cylinder":
                hit = (np.hypot(local[:, 0], local[:, 1]) <= D / 2) & (local[:, 2] <= self.half)
            else:
                hit = ((local / (D / 2, D / 2, self.half))**2).sum(axis=1) <= 1
            result[near[hit]] = True
        return result

    def porosity(self, low, high):
        """Distances from the wall in widths, and the mean porosity on circles between two heights ([GC] App. A)."""
        distances = np.arange(0.0125, 8, 0.1)
        profile = []
        heights = np.linspace(low, high, 10)
        for distance in distances:
            radius = R - D * distance
            turn = np.arange(max(24, int(2 * np.pi * radius / 0.3))) * 2 * np.pi
            angle = turn / len(turn)
            points = np.concatenate([np.stack([radius * np.cos(angle), radius * np.sin(angle), np.full(len(angle), z)], 1) for z in heights])
            profile.append(1 - self.inside(points).mean())
        return distances, np.array(profile)

    def solid(self, inner, outer, low, high):
        """Solid fraction between two radii and two heights, by 60 000 points with a fixed seed."""
        random = np.random.default_rng(1)
        radius = np.sqrt(random.uniform(inner**2, outer**2, 60_000))
        angle = random.uniform(0, 2 * np.pi, len(radius))
        return self.inside(np.stack([radius * np.cos(angle), radius * np.sin(angle), random.uniform(low, high, len(radius))], 1)).mean()

    def along(self, direction):
        """S_2 and S_4 of the directors with one direction per body ([GC] eq. B.1), a value per body."""
        c = (self.director * direction).sum(axis=1)
        return (3 * c**2 - 1) / 2, (35 * c**4 - 30 * c**2 + 3) / 8

    def radial(self):
        radius = np.hypot(self.x[:, 0], self.x[:, 1])
        return radius, self.x * (1, 1, 0) / np.maximum(radius, 1e-9)[:, None]


def order_in_wall_plane(bed, angles):
    """S_2 and S_4 with a direction at an angle from the azimuthal one in the plane of azimuth and height ([GC] App. B)."""
    _, r = bed.radial()
    azimuth = np.stack([-r[:, 1], r[:, 0], np.zeros(len(r))], 1)
    layer = bed.is_in_layer()
    return np.array([[s[layer].mean() for s in bed.along(np.cos(a) * azimuth + np.sin(a) * np.array([0, 0, 1.0]))] for a in angles])


def main():
    options = arguments()
    jobs = [(shape, ratio, 1) for ratio in (1.0, 3.0, 0.25, 2.0, 0.5) for shape in SHAPES] + [(s, r, 2) for s, r in sorted(LAUNCH_SEEDS)]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        runs = dict(zip(jobs, pool.map(lambda job: pack(*job, options.reuse), jobs)))
    beds = {job: Bed(run, *job[:2]) for job, run in runs.items()}
    page = Page("convex_packings", "Loose packings of cuboids, cylinders and ellipsoids")
    page.text(f"""
Bodies {D:g} mm wide and 0.25 to 3 times as high in a cylinder of radius {R:g} mm, with the contact parameters of [GC] Table 7: k_n = 1e4
N/m, e_n = 0.8, e_t = 0.6, friction 0.1; density, which the paper does not give, 2500 kg/m^3; the time step is t_c / 50 for cubes and
cylinders of aspect ratio 1, else t_c / 25. Filled as in the paper: batches of {BATCH} fall onto the bed and are frozen there once they lie still, after a second at most, so
that the next one falls onto a bed that does not move. Aspect ratio 0.25: plates, coins and lenses; 3: rods and cigars. Solid fractions by 60 000
points from 0.2 to 0.85 of the bed's height, by the formulas of the sharp shapes and not by the program's own queries; order of the bodies
whose centers lie there.""")

    rows, solid = [], {}
    for shape in SHAPES:
        for ratio in BATCHES:
            packing, bed = runs[shape, ratio, 1], beds[shape, ratio, 1]
            low, high = bed.layer()
            solid[shape, ratio] = [bed.solid(0, R, low, high), bed.solid(R - D, R, low, high), bed.solid(0, R - D, low, high)]
            rows.append([shape, ratio, len(bed.x), f"{bed.surface:.1f}", *(f"{s:.3f}" for s in solid[shape, ratio]),
                         f"{sum(r.summary['end'] == 'at_rest' for r in packing)} of {len(packing)}",
                         f"{max(r.history['largest_relative_overlap'].max() for r in packing):.3f}", sum(r.summary["core_overlaps"] for r in packing)])
    page.table(["shape", "aspect ratio", "bodies", "mean surface [mm]", "solid fraction", "near the wall", "core", "batches that came to rest",
                "largest overlap / d_eq", "contacts with overlapping cores"], rows)

    inside = {job: (len(b.x) == BATCH * batches(*job[:2]) and b.x[:, 2].max() < b.surface + 15 and np.hypot(b.x[:, 0], b.x[:, 1]).max() < R and b.x[:, 2].min() > 0)
              for job, b in beds.items()}
    elongated = [job for job in jobs if job[1] >= 2]
    page.claim(f"no body is launched in {len(elongated)} packings of aspect ratio 2 or more ([GC] Sec. 7.1: about once or twice per run): all inside the "
               f"vessel and on the bed at the end; one that left the domain would have ended its run. {sum(j[2] == 2 for j in jobs)} of them are second "
               "seeds, which the table leaves out", all(inside[j] for j in elongated))
    page.claim(f"nor in the other {len(jobs) - len(elongated)}", all(inside[j] for j in jobs if j not in elongated))
    e = {ratio: solid["ellipsoid", ratio][2] for ratio in BATCHES}
    page.claim(f"ellipsoids: spheres pack loosest, [GC] Fig. 12 c (core {e[0.5]:.3f} at 0.5, {e[1.0]:.3f} at 1, {e[2.0]:.3f} at 2)", e[1.0] < min(e[0.5], e[2.0]))
    c = {ratio: solid["cylinder", ratio][0] for ratio in BATCHES}
    page.claim(f"cylinders: densest at aspect ratio 1 of the five, [GC] Fig. 12 b ({', '.join(f'{c[r]:.3f}' for r in BATCHES)})", max(c, key=c.get) == 1.0)
    q = {ratio: solid["cuboid", ratio][0] for ratio in BATCHES}
    page.claim(f"cuboids: looser beyond aspect ratio 2, [GC] Fig. 12 a ({', '.join(f'{q[r]:.3f}' for r in BATCHES)})", q[3.0] < q[2.0])

    figure, axes = plt.subplots(1, 3, figsize=(9, 3), sharey=True)
    for ax, shape in zip(axes, SHAPES):
        for k, label in enumerate(("all", "near the wall", "core")):
            ax.plot(list(BATCHES), [solid[shape, ratio][k] for ratio in BATCHES], "o-", label=label)
        ax.set(title=shape, xlabel="aspect ratio")
    axes[0].set(ylabel="solid fraction")
    axes[0].legend()
    page.plot(figure, "_solid", "Solid fraction against aspect ratio, [GC] Fig. 12")

    figure, axes = plt.subplots(5, 1, figsize=(6.4, 10), sharex=True, sharey=True)
    for ax, ratio in zip(axes, BATCHES):
        for shape, color in zip(SHAPES, ("C3", "C2", "C0")):
            bed = beds[shape, ratio, 1]
            distance, profile = bed.porosity(*bed.layer())
            ax.plot(distance, profile, color=color, label=shape)
        ax.set(ylabel=f"porosity, AR {ratio:g}", ylim=(0, 1))
    axes[0].legend()
    axes[-1].set(xlabel="distance from the wall / width")
    page.plot(figure, "_porosity", "Radial porosity, [GC] Fig. 10")

    figure, axes = plt.subplots(2, 3, figsize=(9, 5), sharex=True, sharey="row")
    near, core = {}, {}
    for column, shape in enumerate(SHAPES):
        for ratio, color in ((0.25, "C3"), (1.0, "C2"), (3.0, "C0")):
            bed = beds[shape, ratio, 1]
            radius, r = bed.radial()
            bins = np.arange(0, 8.5, 1.0)
            which = np.where(bed.is_in_layer(), np.digitize((R - radius) / D, bins), -1)
            for row, s in enumerate(bed.along(r)):
                means = [s[which == b].mean() if (which == b).any() else np.nan for b in range(1, len(bins))]
                near[shape, ratio, row] = means[0] if ratio < 3 else np.nanmean(means[:2])
                if ratio == 0.25 and row == 0:
                    core[shape] = s[which > 2].mean()
                axes[row, column].plot(bins[:-1] + 0.5, means, "o-", ms=3, color=color, label=f"AR {ratio:g}")
        axes[0, column].set(title=shape)
        axes[1, column].set(xlabel="distance from the wall / width")
    axes[0, 0].set(ylabel="S_2,r")
    axes[1, 0].set(ylabel="S_4,r")
    axes[0, 0].legend()
    page.plot(figure, "_order", "Order along the radius, [GC] Fig. 14")
    for shape in SHAPES:
        page.claim(f"{shape}s near the wall: rods (3) turn their axis across the radius (S_2,r below 0; found {near[shape, 3.0, 0]:.2f}), [GC] Sec. 7.3",
                   near[shape, 3.0, 0] < 0)
        page.shortfall(f"{shape}s near the wall: flat bodies (0.25) turn it to the radius (S_2,r above 0; found {near[shape, 0.25, 0]:.2f}, in the core "
                       f"{core[shape]:.2f})", near[shape, 0.25, 0] > 0)
    page.text("""
Flat bodies lie: their axes are upright, in the core more than at the wall. The paper finds them leaning flat against the wall; its beds were deeper by an unknown
amount.""")

    angles = np.radians(np.arange(0, 91, 5))
    figure, axes = plt.subplots(1, 3, figsize=(9, 3), sharey=True)
    for ax, shape in zip(axes, SHAPES):
        for ratio, color in ((0.25, "C3"), (1.0, "C2"), (3.0, "C0")):
            order = order_in_wall_plane(beds[shape, ratio, 1], angles)
            ax.plot(np.degrees(angles), order[:, 0], color=color, label=f"S_2, AR {ratio:g}")
            ax.plot(np.degrees(angles), order[:, 1], color=color, ls="--", label=f"S_4, AR {ratio:g}")
        ax.set(title=shape, xlabel="angle from the azimuth [deg]")
    axes[0].set(ylabel="order")
    axes[0].legend(fontsize=6)
    page.plot(figure, "_plane", "Order in the plane of azimuth and height, [GC] Fig. 16")
    for shape, expected in (("cylinder", "0.1 to 0.2, as the experiments and [GC] Fig. 16 e"), ("cuboid", "the largest, [GC] Fig. 16 b")):
        s4 = order_in_wall_plane(beds[shape, 1.0, 1], np.radians([0, 45, 90]))[:, 1]
        holds = s4[1] == max(s4) and (shape == "cuboid" or 0.1 <= s4[1] <= 0.2)
        page.claim(f"{shape}s of aspect ratio 1: S_4 at 45 degrees is {expected} ({s4[1]:.3f}; {s4[0]:.3f} at 0, {s4[2]:.3f} at 90)", holds)
    return page.finish()


if __name__ == "__main__":
    sys.exit(main())

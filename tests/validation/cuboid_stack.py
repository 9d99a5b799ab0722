# SPDX-License-Identifier: BSD-3-Clause
"""One hundred cubes, one above the other, dropped from small gaps ([GC] Sec. 5.3), and houses of cards."""
import numpy as np

from validation import Page, Run, cook, plt, write_bodies

EDGE, COUNT, STIFFNESS, RESTITUTION, DENSITY, GRAVITY = 0.01, 100, 1e6, 0.2, 1000.0, 9.81

CASE = """
[run]
end_time = {end} s
time_step_divisor = 7.2875  # t_c / 25: for this restitution the critical time is 0.2915 t_c
[material.stuff]
density = 1000
youngs_modulus = 50 MPa
poissons_ratio = 0.3
[contact]
model = linear
normal_stiffness = {stiffness}
restitution = {restitution}
tangential_restitution = 0.6
friction = {friction}
{bodies}
[wall.floor]
shape = plane
point = 0 0 0
normal = 0 0 1
material = stuff
[output]
frames_every = 20 ms
"""


def group(name, template, rows):
    return f"[particles.{name}]\ntemplate = {template}\nmaterial = stuff\ninsert = file\nfile = {write_bodies(name, rows)}\n"


def yaw(angle):
    return {"qw": np.cos(angle / 2), "qz": np.sin(angle / 2)}


def pitch(angle):
    return {"qw": np.cos(angle / 2), "qy": np.sin(angle / 2)}


def stack():
    random = np.random.default_rng(1)
    template = cook("units = mm\nshape = cuboid\nlength = 10\nwidth = 10\nheight = 10\nrounding = 0.2\n", suffix="convex")
    z = EDGE * (np.arange(COUNT) + 0.5) + np.cumsum(random.uniform(2e-6, 2e-5, COUNT))
    bodies = group("cubes", template, [{"z": h, **yaw(a)} for h, a in zip(z, random.uniform(-0.02, 0.02, COUNT))])
    return Run("cuboid_stack", CASE.format(end=10, stiffness=STIFFNESS, restitution=RESTITUTION, friction=0.3, bodies=bodies),
               "--threads", "1", reuse=True)


def damping_time(frequency):
    """Time constant of a mode [s]: all contacts have the same ratio of damping to stiffness."""
    mass = 0.5 * DENSITY * EDGE**3
    ratio = -np.log(RESTITUTION) / np.hypot(np.pi, np.log(RESTITUTION))
    return 2 * STIFFNESS / (2 * ratio * np.sqrt(STIFFNESS * mass) * frequency**2)


def sway_of_the_top(times, place):
    """Angular frequency [1/s] of the strongest sway of the top cube and its amplitude [m] in every second after the first: a least-squares fit of one
    frequency, an offset and a drift to each second."""
    late = times > 1

    def fit(frequency, which):
        t = times[which] - times[which].mean()
        columns = np.stack([np.ones_like(t), t, np.cos(frequency * t), np.sin(frequency * t)], axis=1)
        found, rest, *_ = np.linalg.lstsq(columns, place[which], rcond=None)
        return np.linalg.norm(found[2:]), rest.sum()

    frequencies = np.arange(3.0, 150.0, 0.05)
    best = frequencies[np.argmin([fit(w, late)[1] for w in frequencies])]
    return best, [fit(best, (times > s) & (times <= s + 1))[0] for s in np.arange(1, int(times[-1] + 0.01))]


def report_stack(page):
    run = stack()
    times, frames = run.frames()
    order = np.argsort(frames["id"][-1])
    position = frames["position"][:, order]
    weight = DENSITY * EDGE**3 * GRAVITY
    # Each contact is compressed by what stands on it.
    place = EDGE * (np.arange(COUNT) + 0.5) - np.cumsum(weight * (COUNT - np.arange(COUNT))) / STIFFNESS
    off = np.hypot(np.hypot(position[:, :, 0], position[:, :, 1]), position[:, :, 2] - place) / EDGE
    sideways = np.hypot(position[:, :, 0], position[:, :, 1]).max(axis=1) / EDGE
    vertical = abs(frames["velocity"][-1, :, 2]).max()
    sway = np.linalg.norm(frames["velocity"][:, :, :2], axis=2).max(axis=1)
    seconds = f"{times[-1]:.1f} s"
    page.claim(f"after {seconds} every center is within 1 % of an edge of its place ({100 * off[-1].max():.3f} %)",
               off[-1].max() < 0.01)
    page.claim(f"vertical velocities are below 1e-6 m/s after {seconds} ({vertical:.1e})", vertical < 1e-6)
    early, late = (sway[(times > a) & (times <= b)].max() for a, b in ((1, 2), (times[-1] - 1, times[-1])))
    slowest, amplitude = sway_of_the_top(times, position[:, -1, :2])
    page.claim(f"the sway decays, slowly: the largest horizontal velocity is {early:.1e} m/s in the second second and {late:.1e} in the last, the "
               f"strongest mode at the top, w = {slowest:.1f} 1/s, has an amplitude of {1e6 * amplitude[0]:.2f} um and of {1e6 * amplitude[-1]:.2f} um",
               late < early and amplitude[-1] < amplitude[0])
    lowest = np.pi / (2 * COUNT) * np.sqrt(STIFFNESS / (DENSITY * EDGE**3))
    page.text(f"""
Dashpots damp a mode of frequency w with the time constant 2 k_n / (eta_n w^2): they hardly damp what is slow. The lowest vertical mode of a chain of
100 equal springs, w = pi/200 sqrt(k_n/m) = {lowest:.0f} 1/s, is lost within {damping_time(lowest):.2f} s; a sway of the whole column with w = {slowest:.1f} 1/s
takes {damping_time(slowest):.0f} s by the same rule. Amplitudes of that mode in the seconds from the second on [um]: {', '.join(f'{1e6 * a:.2f}' for a in amplitude)}.""")
    figure, axes = plt.subplots(1, 2, figsize=(8, 3.4), layout="constrained")
    axes[0].semilogy(times, sway, label="horizontal")
    axes[0].semilogy(times, abs(frames["velocity"][:, :, 2]).max(axis=1), label="vertical")
    axes[0].set(xlabel="time [s]", ylabel="largest velocity [m/s]")
    axes[0].legend()
    axes[1].plot(times, 100 * sideways)
    axes[1].set(xlabel="time [s]", ylabel="largest sideways offset [% of an edge]")
    page.plot(figure, "", "One hundred cubes: velocities and sideways offset")
    page.text(f"Time step {run.summary['time_step']:.2e} s; {run.summary['microseconds_per_particle_step']:.2f} us per particle and "
              f"step (wall); cores overlapped in {run.summary.get('core_overlaps', 0)} contacts.")


def columns():
    """Two storeys: two cylinders and a slab each."""
    column = cook("units = mm\nshape = cylinder\ndiameter = 6\nheight = 20\nrounding = 0.1\n", suffix="convex")
    slab = cook("units = mm\nshape = cuboid\nlength = 40\nwidth = 10\nheight = 3\nrounding = 0.06\n", suffix="convex")
    storey = 0.02301
    posts = [{"x": x, "z": 0.010005 + k * storey} for k in range(2) for x in (-0.012, 0.012)]
    slabs = [{"z": 0.02151 + k * storey} for k in range(2)]
    return group("columns", column, posts) + group("slabs", slab, slabs)


def cards():
    """Two cards that lean against each other."""
    card = cook("units = mm\nshape = cuboid\nlength = 1\nwidth = 15\nheight = 25\nrounding = 0.1\n", suffix="convex")
    lean, height, thick = np.radians(20), 0.025, 0.001
    across, up = 0.5 * height * np.sin(lean) + 0.5 * thick * np.cos(lean), 0.5 * (height * np.cos(lean) + thick * np.sin(lean))
    return group("cards", card, [{"x": side * (across + 1e-6), "z": up + 1e-6, **pitch(-side * lean)} for side in (-1, 1)])


def report_houses(page):
    rows = []
    for name, bodies, friction in (("two storeys of cylinders and slabs", columns, 0.3), ("two leaning cards", cards, 0.6)):
        run = Run("house_" + name.split()[-1], CASE.format(end=2, stiffness=STIFFNESS, restitution=RESTITUTION, friction=friction, bodies=bodies()),
                  "--threads", "1", reuse=True)
        times, frames = run.frames()
        moved = np.linalg.norm(frames["position"][-1] - frames["position"][0], axis=1).max()
        fastest = np.linalg.norm(frames["velocity"][-1], axis=1).max()
        rows.append([name, frames["position"].shape[1], f"{1e6 * moved:.1f}", f"{fastest:.1e}"])
        page.claim(f"{name}: stands after 2 s (moved by at most {1e6 * moved:.0f} um)", moved < 2e-4)
    page.text("")
    page.table(["house", "bodies", "largest displacement [um]", "fastest after 2 s [m/s]"], rows)


def main():
    page = Page("cuboid_stack", "A stack of one hundred cubes, houses of cards")
    page.text("Cubes of 10 mm, rounded by 2 %, gaps of 2 to 20 um, turned by up to 1.1 degrees against each other; linear law, k_n = 1e6 "
              "N/m, e_n = 0.2, friction 0.3. The place of a cube is where it stands when every contact is compressed by the weight "
              "above it.")
    report_stack(page)
    page.text("## Houses")
    report_houses(page)
    return page.finish()


if __name__ == "__main__":
    raise SystemExit(main())

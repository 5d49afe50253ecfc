"""Closed forms of the sintering law (docs/theory.md), and the copper that the cases use."""
import math

BOLTZMANN, GAS = 1.380649e-23, 8.31446261815324
RADIUS = 5e-6
SURFACE_ENERGY, DIHEDRAL_ANGLE = 1.72, math.radians(146.0)
TEMPERATURE = 1050.0 + 273.15
DELTA_B = 1.18e-29 * 5.12e-15 * math.exp(-105e3 / (GAS * TEMPERATURE)) / (BOLTZMANN * TEMPERATURE)
EQUILIBRIUM = math.sin(DIHEDRAL_ANGLE / 2)


def equivalent(radius_1, radius_2):
    return 2 * radius_1 * radius_2 / (radius_1 + radius_2)


def time_scale(radius=RADIUS):
    """R^4/(gamma Delta_b) [s]."""
    return radius**4 / (SURFACE_ENERGY * DELTA_B)


def attraction(radius=RADIUS):
    """f_a [N] after Bouvard and McMeeking."""
    return 9 / 8 * math.pi * radius * SURFACE_ENERGY


def tau_of_neck(x, x0=0.0):
    return (x**6 - x0**6) / 54


def neck_of_tau(tau, x0=0.0):
    return (x0**6 + 54 * tau)**(1 / 6)


def neck_under_load(load, time, x0, radius=RADIUS):
    """x of two spheres pressed together by `load` [N] (negative: pulled) for `time` [s]."""
    growth = 48 * radius * DELTA_B * (attraction(radius) + load) * time / math.pi
    return (x0**6 + growth / radius**6)**(1 / 6)


def tau_parhami_mcmeeking(x, x0=0.0, panels=2000):
    """Dimensionless time from x0 to x with that attraction: Simpson's rule over dx."""
    def slope(y):
        return y**5 / (8 * (4 * (1 - math.cos(DIHEDRAL_ANGLE / 2)) + y * math.sin(DIHEDRAL_ANGLE / 2)))
    width = (x - x0) / panels
    inner = sum((4 if n % 2 else 2) * slope(x0 + n * width) for n in range(1, panels))
    return width / 3 * (slope(x0) + inner + slope(x))


def lattice_density(start_density, x, x0):
    """Density of spheres whose necks all grew from x0 (just touching) to x, by theory.md section 6."""
    return start_density * (1 - (x**2 - x0**2) / 4)**-3

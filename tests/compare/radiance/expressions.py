# SPDX-License-Identifier: BSD-3-Clause
"""Random expressions of function files.  Steep functions are avoided: a rounding error must not become a difference."""

VARIABLES = ["Px", "Py", "Pz", "Nx", "Ny", "Nz", "Dx", "Dy", "Dz", "Rdot", "U", "V"]


def number(rng, low, high):
    """A number of two digits, as people write them."""
    return float(f"{rng.uniform(low, high):.2g}")


def variable(rng):
    if rng.random() < .6:
        return rng.choice(["Px", "Py", "Pz"])
    return rng.choice(VARIABLES)


def term(rng):
    return f"{number(rng, .3, 3)}*{variable(rng)}+{number(rng, 0, 1)}"


def point(rng):
    k = number(rng, .5, 3)
    return f"{k}*Px,{k}*Py,{k}*Pz+{number(rng, 0, 1)}"


def wave(rng):
    """Something between -1 and 1.  Steps lie beside 0: what is 0 there is so but for rounding."""
    v = variable(rng)
    return rng.choice([
        lambda: f"sin({term(rng)})", lambda: f"cos({term(rng)})", lambda: f"noise3({point(rng)})",
        lambda: f"sgn(sin({term(rng)}))", lambda: f"(2*frac({term(rng)})-1)", lambda: f"bound(-1,{v},1)",
        lambda: f"noise3x({point(rng)})/2", lambda: f"(2*exp(-sq({v}))-1)", lambda: f"atan2({v},2)/PI",
        lambda: f"if({v}-.3,.8,-.6)", lambda: f"(tri({term(rng)},1)-.5)", lambda: f"tan(bound(-.7,{v},.7))",
        lambda: f"erf({v})", lambda: f"(2*fnoise3({point(rng)})-1)", lambda: f"mod({term(rng)},1)",
        lambda: f"Acos({v})/PI", lambda: f"(2*mod(floor(2*{v}+.013),2)-1)",
        lambda: f"hermite(-.5,.7,.2,.3,frac({v}+.013))",
        lambda: f"linterp(frac({v}+.013),-.7,.8)", lambda: f"select(floor(3*frac({v}+.013))+1,-.5,.2,.9)",
        lambda: f"turbulence({point(rng)},.2)/2", lambda: f"(1-2*Exp(-abs({v})))", lambda: f"min({v},max(-.5,Rdot))/4",
        lambda: f"Sqrt(abs({v}))/2", lambda: f"bezier(-.4,.1,.8,.2,frac({v}+.013))", lambda: f"clip({v})",
        lambda: f"fade(1,-.5,abs({v}))", lambda: f"and({v}-.013,.7-{v})/4", lambda: f"log10(1.5+abs({v}))",
        lambda: f"bspline(-.3,.9,.2,-.6,frac({v}+.013))", lambda: f"unif2norm(.2+.6*frac({v}+.013))",
    ])()


def share(rng):
    """Something between 0 and about 1.2, for colours and coefficients."""
    if rng.random() < .15:
        return str(number(rng, 0, 1))
    middle = number(rng, .3, .7)
    text = f"{middle}+{number(rng, .1, .3)}*{wave(rng)}"
    return f"{text}*{wave(rng)}" if rng.random() < .3 else text


def coefficient(rng):
    """A share within 0 and 1, sometimes one side only, sometimes beyond."""
    p = rng.random()
    if p < .1:
        return rng.choice(["0", "1", "-.2", "1.3"])
    if p < .4:
        return f"if({wave(rng)}-.013,1,0)"
    return f"clip({share(rng)})"


def bump(rng):
    return "0" if rng.random() < .2 else f"{number(rng, .05, .35)}*{wave(rng)}"

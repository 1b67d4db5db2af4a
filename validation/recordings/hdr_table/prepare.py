"""A published table of loops: nine tests of HDR3, one cycle each, with their dissipated energy, damping and modulus.

D. A. Nguyen, A rheology model of high damping rubber bearings for seismic analysis at room and low temperatures, dissertation, Table 4.1.
The tests at 5.5/s are held out. The amplitude is the nominal one; that of the tests in the cold was 1.64 to 1.75.
"""
LICENSED = True  # numbers of a published table
VARIANTS = {"rate_left_out": ("study.toml", None)}

# Temperature in degC, rate in 1/s, dissipated energy in MPa, damping, modulus in MPa.
TABLE = (
    (-30, 1.5, 11.1, 0.20, 2.94), (-30, 5.5, 12.7, 0.22, 3.28), (-30, 8.75, 11.2, 0.19, 3.43),
    (-10, 1.5, 7.61, 0.19, 2.08), (-10, 5.5, 8.67, 0.21, 2.28), (-10, 8.75, 7.79, 0.17, 2.36),
    (23, 1.5, 5.87, 0.16, 1.93), (23, 5.5, 6.28, 0.16, 2.02), (23, 8.75, 6.72, 0.17, 2.08),
)


def prepare(data, folder):
    for temperature, rate, energy, damping, modulus in TABLE:
        middle = 3.5 / rate
        text = f"time[s],D[MPa],h_eq[-],G_eq[MPa]\n{middle:.6g},{energy},{damping},{modulus}\n"
        (folder / f"{temperature}_degC_{rate}.csv").write_text(text)

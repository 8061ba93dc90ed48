// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a vessel's lumen is left under external pressure: the tube law of thin walls,
// p_outside - p_inside = K (a^-3/2 - a^10) for the area share a, with the bending stiffness of the
// wall K = E (h/R)^3 / (12 (1 - nu^2)) (Shapiro 1977; exponents of veins as in Brook, Falle and
// Pedley 1999).
#pragma once

namespace hepatica {

struct TubeWall {
    double young_modulus_pa = 0.62e6;  // > 0
    // About 0.6 mm at a radius of 5.5 mm in a portal vein; a guess for other vessels.
    double thickness_per_radius = 0.1;  // > 0
    double poisson_ratio = 0.5;
};

// Open share of the area, in (0, 1]; 1 where the external pressure does not exceed that of the
// blood. `excess_pa`: external minus blood pressure. No vessel closes completely: the share falls
// as excess^-2/3.
double open_share(double excess_pa, const TubeWall& wall);

// What blood holds open of a slit through the wall, of this length along the surface: 2 pi a^2
// sigma / E with the half length a and the wall's hoop stress sigma = p R / h, as of a crack in a
// sheet (Tada, Paris and Irwin, The Stress Analysis of Cracks). The wall bulges beside a long slit
// and opens it more. 0 where p <= 0.
double slit_mm2(double length_mm, double pressure_pa, const TubeWall& wall);

// Loss of a jet that leaves an opening with this area share and fills the vessel again, relative to
// the dynamic pressure in the opening: (1/c - a)^2 by Borda and Carnot, with Weisbach's contraction
// c = 0.62 + 0.38 a^3 before it. 0 at a = 1.
double jet_loss(double share);

}  // namespace hepatica

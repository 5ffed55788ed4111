// SPDX-License-Identifier: LGPL-2.1-or-later
// Which points of a cloud lie on feature edges, by CGAL's Voronoi covariance measure
// (Mérigot, Ovsjanikov and Guibas 2011). A peer that the bench builds; no part of the program.
//
// Called with the offset radius, the convolution radius and the threshold; reads points from
// standard input as triples of doubles, and answers one byte for each: 1 on an edge.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>
#include <CGAL/vcm_estimate_edges.h>
#include <CGAL/vcm_estimate_normals.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Covariance = std::array<double, 6>;

int main(int count, char** words) {
    if (count != 4) {
        std::fprintf(stderr, "usage: voronoi_covariance OFFSET CONVOLUTION THRESHOLD\n");
        return 2;
    }
    const double offset = std::atof(words[1]), convolution = std::atof(words[2]);
    const double threshold = std::atof(words[3]);

    std::vector<Kernel::Point_3> points;
    for (double row[3]; std::fread(row, sizeof(double), 3, stdin) == 3;) {
        points.emplace_back(row[0], row[1], row[2]);
    }
    std::vector<Covariance> covariances;
    CGAL::compute_vcm(
        points, covariances, offset, convolution,
        CGAL::parameters::point_map(CGAL::Identity_property_map<Kernel::Point_3>())
            .geom_traits(Kernel()));
    for (Covariance& covariance : covariances) {
        std::putchar(CGAL::vcm_is_on_feature_edge(covariance, threshold) ? 1 : 0);
    }
    return 0;
}

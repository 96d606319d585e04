// Measures one operation of CGAL in this process, and prints a line of JSON.
//
//   cgal OPERATION FILE SCRATCH RUNS        without a word: the operations

#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <unistd.h>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangles = std::vector<std::array<std::size_t, 3>>;

struct Soup {
    std::vector<Point> points;
    Triangles triangles;
};

using Figures = std::map<std::string, std::size_t>;
// Does an operation on its input, and gives what looks at the answer afterwards.
using Work = std::function<std::function<Figures()>()>;

// The binary PLY files of meshmend-bench: float x y z, then three int a face.
Soup load(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::size_t counts[2] = {0, 0};
    for (std::string line; std::getline(in, line) && line != "end_header";) {
        std::sscanf(line.c_str(), "element vertex %zu", &counts[0]);
        std::sscanf(line.c_str(), "element face %zu", &counts[1]);
    }
    Soup soup;
    soup.points.reserve(counts[0]);
    soup.triangles.reserve(counts[1]);
    for (std::size_t i = 0; i < counts[0]; ++i) {
        float point[3];
        in.read(reinterpret_cast<char*>(point), sizeof point);
        soup.points.emplace_back(point[0], point[1], point[2]);
    }
    for (std::size_t i = 0; i < counts[1]; ++i) {
        std::uint32_t corners[3];
        in.ignore(1);
        in.read(reinterpret_cast<char*>(corners), sizeof corners);
        soup.triangles.push_back({corners[0], corners[1], corners[2]});
    }
    return soup;
}

// Boundary, non-manifold and inconsistent edges, by sorting.
Figures edge_counts(const Triangles& triangles) {
    std::vector<std::array<std::size_t, 3>> sides;
    for (const auto& t : triangles)
        for (int i = 0; i < 3; ++i) {
            std::size_t a = t[i], b = t[(i + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), std::size_t(a < b)});
        }
    std::sort(sides.begin(), sides.end());
    Figures found{{"edges", 0}, {"boundary_edges", 0}, {"non_manifold_edges", 0}, {"inconsistent_edges", 0}};
    for (std::size_t i = 0, end; i < sides.size(); i = end) {
        std::size_t forward = 0;
        for (end = i; end < sides.size() && sides[end][0] == sides[i][0] && sides[end][1] == sides[i][1]; ++end)
            forward += sides[end][2];
        ++found["edges"];
        if (end - i == 1) ++found["boundary_edges"];
        if (end - i > 2) ++found["non_manifold_edges"];
        if (end - i == 2 && forward != 1) ++found["inconsistent_edges"];
    }
    return found;
}

// How many vertices have faces round them that do not all hang together: of a mesh without non-manifold edges those
// that more than one walk round has.
std::size_t non_manifold_vertices(const Mesh& mesh) {
    std::vector<Mesh::Halfedge_index> found;
    PMP::non_manifold_vertices(mesh, std::back_inserter(found));
    return found.size();
}

Work weld(const std::string& file, const std::string&) {
    auto soup = std::make_shared<Soup>(load(file));
    return [=] {
        PMP::merge_duplicate_points_in_polygon_soup(soup->points, soup->triangles);
        return [=] { return Figures{{"vertices", soup->points.size()}}; };
    };
}

Work connectivity(const std::string& file, const std::string&) {
    auto soup = std::make_shared<Soup>(load(file));
    return [=] {
        auto mesh = std::make_shared<Mesh>();
        PMP::polygon_soup_to_polygon_mesh(soup->points, soup->triangles, *mesh);
        return [=] { return Figures{{"edges", mesh->number_of_edges()}}; };
    };
}

Work orient(const std::string& file, const std::string&) {
    auto soup = std::make_shared<Soup>(load(file));
    return [=] {
        PMP::orient_polygon_soup(soup->points, soup->triangles);
        return [=] {
            Figures counts = edge_counts(soup->triangles);
            return Figures{{"faces", soup->triangles.size()}, {"inconsistent_edges", counts["inconsistent_edges"]}};
        };
    };
}

Work split(const std::string& file, const std::string&) {
    auto soup = std::make_shared<Soup>(load(file));
    return [=] {
        // Duplicates the points at which a soup is not manifold.
        PMP::orient_polygon_soup(soup->points, soup->triangles);
        return [=] {
            Figures counts = edge_counts(soup->triangles);
            Mesh mesh;
            PMP::polygon_soup_to_polygon_mesh(soup->points, soup->triangles, mesh);
            return Figures{{"faces", soup->triangles.size()},
                           {"non_manifold_edges", counts["non_manifold_edges"]},
                           {"non_manifold_vertices", non_manifold_vertices(mesh)}};
        };
    };
}

Work clean(const std::string& file, const std::string&) {
    auto soup = std::make_shared<Soup>(load(file));
    return [=] {
        // Its triangles are arrays, from which no corner can be taken: degenerate ones go by hand.
        auto is_degenerate = [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
        auto& triangles = soup->triangles;
        triangles.erase(std::remove_if(triangles.begin(), triangles.end(), is_degenerate), triangles.end());
        PMP::merge_duplicate_polygons_in_polygon_soup(
            soup->points, triangles, CGAL::parameters::require_same_orientation(true));
        PMP::remove_isolated_points_in_polygon_soup(soup->points, triangles);
        return [=] {
            return Figures{{"vertices", soup->points.size()}, {"faces", soup->triangles.size()}};
        };
    };
}

Work intersections(const std::string& file, const std::string&) {
    using Surface = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
    Soup soup = load(file);
    std::vector<Surface::Point> points;
    for (const auto& p : soup.points) points.emplace_back(p.x(), p.y(), p.z());
    auto mesh = std::make_shared<Surface>();
    PMP::polygon_soup_to_polygon_mesh(points, soup.triangles, *mesh);
    return [=] {
        std::vector<std::pair<Surface::Face_index, Surface::Face_index>> pairs;
        PMP::self_intersections(*mesh, std::back_inserter(pairs));
        return [=] {
            std::set<Surface::Face_index> faces;
            for (const auto& pair : pairs) faces.insert({pair.first, pair.second});
            return Figures{{"crossing_faces", faces.size()}};
        };
    };
}

Work process(const std::string& file, const std::string& scratch) {
    return [=] {
        std::string path = scratch + "/cgal.ply";
        {
            std::vector<Point> points;
            std::vector<std::vector<std::size_t>> polygons;
            CGAL::IO::read_polygon_soup(file, points, polygons);
            PMP::repair_polygon_soup(points, polygons);
            PMP::orient_polygon_soup(points, polygons);
            Mesh mesh;
            PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
            CGAL::IO::write_PLY(path, mesh, CGAL::parameters::use_binary_mode(true));
        }
        return [=] {
            std::vector<Point> points;
            std::vector<std::vector<std::size_t>> polygons;
            CGAL::IO::read_polygon_soup(path, points, polygons);
            Triangles triangles;
            for (const auto& polygon : polygons) triangles.push_back({polygon[0], polygon[1], polygon[2]});
            Figures counts = edge_counts(triangles);
            return Figures{{"vertices", points.size()},
                           {"faces", polygons.size()},
                           {"inconsistent_edges", counts["inconsistent_edges"]},
                           {"non_manifold_edges", counts["non_manifold_edges"]}};
        };
    };
}

const std::map<std::string, Work (*)(const std::string&, const std::string&)> operations = {
    {"weld", weld},   {"connectivity", connectivity}, {"orient", orient},      {"split", split},
    {"clean", clean},
    {"intersections", intersections}, {"intersections-crossed", intersections}, {"process-ply", process},       {"process-stl", process}};

std::size_t resident(const char* field) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == field) {
            std::size_t kilobytes;
            status >> kilobytes;
            return kilobytes * 1024;
        }
    return 0;
}

double processor_time() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return time.tv_sec + 1e-9 * time.tv_nsec;
}

std::string list(const std::vector<double>& times) {
    std::string text;
    for (double time : times) text += (text.empty() ? "" : ",") + std::to_string(time);
    return "[" + text + "]";
}

int main(int count, char** words) {
    if (count != 5) {
        for (const auto& operation : operations) std::cout << operation.first << "\n";
        return 0;
    }
    auto prepare = operations.at(words[1]);
    std::vector<double> cpu, wall;
    std::size_t growth = 0;
    Figures figures;
    for (int run = 0, runs = std::stoi(words[4]); run < runs; ++run) {
        Work work = prepare(words[2], words[3]);
        std::size_t before = resident("VmRSS:");
        std::ofstream("/proc/self/clear_refs") << "5" << std::flush;
        // Who takes longer is stopped, and the runner says so.
        alarm(120);
        double processor = processor_time();
        auto clock = std::chrono::steady_clock::now();
        auto answer = work();
        cpu.push_back(processor_time() - processor);
        wall.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count());
        alarm(0);
        std::size_t peak = resident("VmHWM:");
        if (run == 0 && peak > before) growth = peak - before;
        figures = answer();
    }
    std::string said;
    for (const auto& figure : figures)
        said += (said.empty() ? "\"" : ",\"") + figure.first + "\":" + std::to_string(figure.second);
    std::cout << "{\"version\":\"CGAL " << CGAL_VERSION_STR << "\",\"cpu\":" << list(cpu) << ",\"wall\":" << list(wall)
              << ",\"growth\":" << growth << ",\"figures\":{" << said << "}}\n";
}

// Runs the scenes in Siconos: siconos SCENES.json NAME…
//
// Moreau and Jean's scheme with theta 1/2. Bodies are Lagrangian with constant mass, contacts are given in advance: the
// corners of boxes and the discs with the planes and with the neighbour in the list of bodies. Prints one line of JSON
// a run, as compare.py reads them.

#include <SiconosKernel.hpp>
#include <SolverOptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

using nlohmann::json;
using Triple = std::array<double, 3>;
struct Vec {
    double x, z;
};

static Vec upright(const json& triple) { return {triple[0], triple[2]}; }
static double cross(Vec a, Vec b) { return a.x * b.z - a.z * b.x; }
static Vec turned(double angle, Vec p) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x - s * p.z, s * p.x + c * p.z};
}

// A contact in the plane: the subclasses say where it is. The bodies' coordinates are x, z, angle, one after the other.
class PlanarContact : public LagrangianScleronomousR {
    struct Place {
        double gap;
        Vec normal, arm, other_arm;  // normal towards the first body, arms from the centres of mass
    };

   protected:
    using Where = Place;
    virtual Where where(const BlockVector& q) const = 0;

   public:
    void computeh(const BlockVector& q, BlockVector&, SiconosVector& y) override {
        y.setValue(0, where(q).gap);
        y.setValue(1, 0.0);
    }

    void computeJachq(const BlockVector& q, BlockVector&) override {
        const auto at = where(q);
        const Vec rows[] = {at.normal, {-at.normal.z, at.normal.x}};
        for (unsigned row = 0; row < 2; ++row) {
            const Vec d = rows[row];
            const double entries[] = {d.x, d.z, cross(at.arm, d), -d.x, -d.z, -cross(at.other_arm, d)};
            for (unsigned column = 0; column < q.size(); ++column) _jachq->setValue(row, column, entries[column]);
        }
    }
};

// A point of a body, or a disc around it, on a plane.
class OnPlane : public PlanarContact {
    Vec local, point, normal;
    double radius;

    Where where(const BlockVector& q) const override {
        Vec arm = turned(q.getValue(2), local);
        const Vec from = {q.getValue(0) + arm.x - point.x, q.getValue(1) + arm.z - point.z};
        const double gap = normal.x * from.x + normal.z * from.z - radius;
        arm = {arm.x - radius * normal.x, arm.z - radius * normal.z};
        return {gap, normal, arm, {0, 0}};
    }

   public:
    OnPlane(Vec local, double radius, Vec point, Vec normal)
        : local(local), point(point), normal(normal), radius(radius) {}
};

// A corner of the first body on the top face of the second.
class OnTop : public PlanarContact {
    Vec corner;
    double height;

    Where where(const BlockVector& q) const override {
        const Vec arm = turned(q.getValue(2), corner), normal = turned(q.getValue(5), {0, 1});
        const Vec from = {q.getValue(0) + arm.x - q.getValue(3), q.getValue(1) + arm.z - q.getValue(4)};
        return {normal.x * from.x + normal.z * from.z - height, normal, arm, from};
    }

   public:
    OnTop(Vec corner, double height) : corner(corner), height(height) {}
};

class TwoDiscs : public PlanarContact {
    double radius, other_radius;

    Where where(const BlockVector& q) const override {
        const Vec from = {q.getValue(0) - q.getValue(3), q.getValue(1) - q.getValue(4)};
        const double distance = std::hypot(from.x, from.z);
        const Vec n = {from.x / distance, from.z / distance};
        const Vec arm = {-radius * n.x, -radius * n.z}, other_arm = {other_radius * n.x, other_radius * n.z};
        return {distance - radius - other_radius, n, arm, other_arm};
    }

   public:
    TwoDiscs(double radius, double other_radius) : radius(radius), other_radius(other_radius) {}
};

// A ball on the ground z = 0; coordinates x, y, z and the integrals of the spins, which a ball needs no other pose for.
class BallOnGround : public LagrangianScleronomousR {
    double radius;

   public:
    explicit BallOnGround(double radius) : radius(radius) {}

    void computeh(const BlockVector& q, BlockVector&, SiconosVector& y) override {
        y.zero();
        y.setValue(0, q.getValue(2) - radius);
    }

    void computeJachq(const BlockVector&, BlockVector&) override {
        _jachq->zero();
        _jachq->setValue(0, 2, 1);
        _jachq->setValue(1, 0, 1);
        _jachq->setValue(1, 4, -radius);
        _jachq->setValue(2, 1, 1);
        _jachq->setValue(2, 3, radius);
    }
};

class World {
    SP::NonSmoothDynamicalSystem system;
    SP::TimeStepping simulation;
    std::vector<std::shared_ptr<LagrangianLinearTIDS>> bodies;

    void add(const std::vector<double>& q, const std::vector<double>& v, const std::vector<double>& mass, Triple g) {
        const auto n = unsigned(q.size());
        auto q0 = std::make_shared<SiconosVector>(n), v0 = std::make_shared<SiconosVector>(n);
        auto force = std::make_shared<SiconosVector>(n);
        auto m = std::make_shared<SimpleMatrix>(n, n);
        for (unsigned i = 0; i < n; ++i) {
            q0->setValue(i, q[i]);
            v0->setValue(i, v[i]);
            m->setValue(i, i, mass[i]);
            force->setValue(i, i < 3 ? mass[i] * g[i] : 0.0);
        }
        bodies.push_back(std::make_shared<LagrangianLinearTIDS>(q0, v0, m));
        bodies.back()->setFExtPtr(force);
        system->insertDynamicalSystem(bodies.back());
    }

    void planar(const json& scene, SP::NonSmoothLaw law) {
        const auto link = [&](std::shared_ptr<PlanarContact> contact, std::size_t body, bool with_previous) {
            auto interaction = std::make_shared<Interaction>(law, contact);
            if (with_previous)
                system->link(interaction, bodies[body], bodies[body - 1]);
            else
                system->link(interaction, bodies[body]);
        };
        const Vec g = upright(scene["gravity"]);
        const json& all = scene["bodies"];
        for (std::size_t i = 0; i < all.size(); ++i) {
            const json& body = all[i];
            const Vec place = upright(body["pos"]), velocity = upright(body["vel"]);
            const double mass = body["mass"];
            add({place.x, place.z, body["th"]}, {velocity.x, velocity.z, body["om_planar"]},
                {mass, mass, body["I"][1]}, {g.x, g.z, 0});
            std::vector<Vec> points = {{0, 0}};
            double radius = 0;
            if (body["shape"] == "box") {
                const Vec half = upright(body["half"]);
                points = {{-half.x, -half.z}, {half.x, -half.z}, {half.x, half.z}, {-half.x, half.z}};
                for (std::size_t corner = 0; i > 0 && corner < 2; ++corner)
                    link(std::make_shared<OnTop>(points[corner], all[i - 1]["half"][2].get<double>()), i, true);
            } else if (body["shape"] == "sphere") {
                radius = body["r"];
                if (i > 0) link(std::make_shared<TwoDiscs>(radius, all[i - 1]["r"].get<double>()), i, true);
            } else {
                const double half = body["half"];
                points = {{-half, 0}, {half, 0}};
                radius = body["rho"];
            }
            // only the lowest of a pile reaches the ground
            for (const json& plane : scene["planes"])
                for (std::size_t p = 0; i == 0 && p < points.size(); ++p)
                    link(std::make_shared<OnPlane>(points[p], radius, upright(plane["point"]),
                                                   upright(plane["normal"])),
                         i, false);
        }
    }

    void spatial(const json& scene, SP::NonSmoothLaw law) {
        const json& body = scene["bodies"][0];
        const Triple p = body["pos"], v = body["vel"], w = body["om"], inertia = body["I"];
        const double m = body["mass"];
        add({p[0], p[1], p[2], 0, 0, 0}, {v[0], v[1], v[2], w[0], w[1], w[2]},
            {m, m, m, inertia[0], inertia[1], inertia[2]}, scene["gravity"]);
        auto contact = std::make_shared<BallOnGround>(body["r"].get<double>());
        system->link(std::make_shared<Interaction>(law, contact), bodies[0]);
    }

   public:
    World(const json& scene, int solver, double h) {
        const int dimension = scene["dim"] == "3d" ? 3 : 2;
        system = std::make_shared<NonSmoothDynamicalSystem>(0.0, 2 * scene["T"].get<double>());
        auto law = std::make_shared<NewtonImpactFrictionNSL>(scene["e"].get<double>(), 0.0, scene["mu"].get<double>(),
                                                             dimension);
        dimension == 3 ? spatial(scene, law) : planar(scene, law);
        auto problem = std::make_shared<FrictionContact>(dimension, solver);
        simulation = std::make_shared<TimeStepping>(system, std::make_shared<TimeDiscretisation>(0.0, h),
                                                    std::make_shared<MoreauJeanOSI>(0.5), problem);
        simulation->setWarnOnNonConvergence(false);
        // an unconverged solution is used as it is: the error of the run judges it
        simulation->setCheckSolverFunction([](int, Simulation*) {});
        simulation->initialize();
    }

    void step() {
        simulation->computeOneStep();
        simulation->nextStep();
    }

    std::vector<Triple> poses() const { return first_three([](auto& body) { return body.q(); }); }
    std::vector<Triple> velocities() const { return first_three([](auto& body) { return body.velocity(); }); }

   private:
    template <class Of>
    std::vector<Triple> first_three(Of of) const {
        std::vector<Triple> out;
        for (const auto& body : bodies) {
            const auto v = of(*body);
            out.push_back({v->getValue(0), v->getValue(1), v->getValue(2)});
        }
        return out;
    }
};

static double cpu_seconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// The CPU time of the run that others on the machine disturb least, of so many that they take a few hundredths of a
// second; one is enough if it is long.
static void measure(const json& scene, const std::string& peer, int solver, double h) {
    const auto steps = std::size_t(std::llround(scene["T"].get<double>() / h));
    if (std::abs(double(steps) * h - scene["T"].get<double>()) > 1e-9) return;  // no shorter last step
    json row = {{"peer", peer}, {"scene", scene["name"]}, {"h", h}, {"steps", steps}, {"way", json::array()}};
    std::vector<double> times;
    double total = 0;
    while ((times.size() < 5 || total < 0.03) && times.size() < 100 && total < 0.2) {
        World world(scene, solver, h);
        const double start = cpu_seconds();
        for (std::size_t i = 0; i < steps; ++i) world.step();
        times.push_back(cpu_seconds() - start);
        total += times.back();
        row["poses"] = world.poses();
        row["velocities"] = world.velocities();
    }
    row["cpu"] = *std::min_element(times.begin(), times.end());
    if (scene["name"] == "rocking_block" || scene["name"] == "popout_1mm") {
        World world(scene, solver, h);
        for (std::size_t i = 0; i < steps; ++i) {
            world.step();
            const Triple q = world.poses()[0];
            row["way"].push_back({q[1], q[2], world.velocities()[0][2]});
        }
    }
    std::cout << row.dump() << std::endl;
}

int main(int count, char** arguments) {
    if (count < 3) {
        std::cerr << "siconos SCENES.json NAME…\n";
        return 2;
    }
    const json all = json::parse(std::ifstream(arguments[1]));
    for (const json& scene : all["scenes"]) {
        const std::string name = scene["name"];
        if (std::find(arguments + 2, arguments + count, name) == arguments + count) continue;
        const bool spatial = scene["dim"] == "3d";
        const std::pair<const char*, int> planar_solvers[] = {{"Siconos NSGS", SICONOS_FRICTION_2D_NSGS},
                                                              {"Siconos Lemke", SICONOS_FRICTION_2D_LEMKE}};
        const std::pair<const char*, int> spatial_solvers[] = {{"Siconos NSGS", SICONOS_FRICTION_3D_NSGS},
                                                               {"Siconos Newton", SICONOS_FRICTION_3D_NSN_AC}};
        for (const auto& [peer, solver] : spatial ? spatial_solvers : planar_solvers)
            for (const double h : {5e-2, 2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4}) measure(scene, peer, solver, h);
    }
}

// SPDX-License-Identifier: MIT
#include "clients/racer/game/world.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "clients/racer/game/car.h"

namespace hedgehog::racer {

namespace {

constexpr double kEngineN = 5200.0;  // both rear wheels together
constexpr double kReverseN = 2600.0;
constexpr double kTopSpeed = 19.0;     // m/s, where the engine force falls to zero
constexpr double kBrakeN = 7000.0;     // all wheels together
constexpr double kSteerRadPerS = 1.5;  // maximum rate of the front wheels
constexpr double kStandstill = 0.8;    // m/s

btScalar real(double value) { return static_cast<btScalar>(value); }
btVector3 to_bullet(const Vec3& v) { return {real(v.x), real(v.y), real(v.z)}; }
Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btTransform to_bullet(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  return btTransform(btQuaternion(real(q.x), real(q.y), real(q.z), real(q.w)),
                     to_bullet(pose.position));
}
Pose from_bullet(const btTransform& transform) {
  const btQuaternion q = transform.getRotation();
  return {from_bullet(transform.getOrigin()), {q.w(), q.x(), q.y(), q.z()}};
}

std::unique_ptr<btCollisionShape> shape_of(const Obstacle& obstacle) {
  switch (obstacle.shape) {
    case Shape::kBox:
      return std::make_unique<btBoxShape>(to_bullet(obstacle.half_size));
    case Shape::kDrum:
      return std::make_unique<btCylinderShapeZ>(to_bullet(obstacle.half_size));
    case Shape::kBall:
      break;
  }
  return std::make_unique<btSphereShape>(real(obstacle.half_size.x));
}

std::unique_ptr<btCollisionShape> shape_of(const Ramp& ramp) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const double side : {-0.5, 0.5}) {
    hull->addPoint(to_bullet(Vec3{0, side * ramp.width, 0}), false);
    hull->addPoint(to_bullet(Vec3{ramp.length, side * ramp.width, 0}), false);
    hull->addPoint(to_bullet(Vec3{ramp.length, side * ramp.width, ramp.height}), false);
  }
  hull->recalcLocalAabb();
  return hull;
}

bool lies_on(const Patch& patch, const Vec3& point) {
  const Vec3 local = rotate(conjugate(patch.pose.orientation), point - patch.pose.position);
  return std::abs(local.x) < patch.half_length && std::abs(local.y) < patch.half_width;
}

}  // namespace

struct World::Bodies {
  explicit Bodies(const Track& track) : patches(track.patches), obstacles(track.obstacles) {
    world.setGravity({0, 0, real(-9.81)});
    world.getDispatchInfo().m_deterministicOverlappingPairs = true;
    add(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), real(0)), 0.0, {},
        Contact::kGround, 0.8);
    if (!track.walls.empty()) {
      // One body, so that sliding from one wall along the next is one contact.
      auto walls = std::make_unique<btCompoundShape>();
      for (const Wall& wall : track.walls) {
        shapes.push_back(std::make_unique<btBoxShape>(to_bullet(wall.half_size)));
        walls->addChildShape(to_bullet(wall.pose), shapes.back().get());
      }
      add(std::move(walls), 0.0, Pose{}, Contact::kWalls, 0.15);
    }
    for (const Ramp& ramp : track.ramps) add(shape_of(ramp), 0.0, ramp.pose, Contact::kRamps, 0.5);
    for (const Obstacle& obstacle : track.obstacles) {
      btRigidBody& body = add(shape_of(obstacle), obstacle.mass_kg, obstacle.pose,
                              static_cast<int>(movable.size()), 0.5);
      body.setLinearVelocity(to_bullet(obstacle.velocity_mps));
      movable.push_back(&body);
    }
    add_car(track.start);
  }

  ~Bodies() {
    world.removeVehicle(&*vehicle);
    for (const auto& body : bodies) world.removeRigidBody(body.get());
  }

  btRigidBody& add(std::unique_ptr<btCollisionShape> shape, double mass, const Pose& pose,
                   int number, double friction) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0.0) shape->calculateLocalInertia(real(mass), inertia);
    btRigidBody::btRigidBodyConstructionInfo info(real(mass), nullptr, shape.get(), inertia);
    info.m_startWorldTransform = to_bullet(pose);
    info.m_friction = real(friction);
    info.m_angularDamping = mass > 0.0 ? real(0.1) : real(0);
    bodies.push_back(std::make_unique<btRigidBody>(info));
    bodies.back()->setUserIndex(number);
    shapes.push_back(std::move(shape));
    world.addRigidBody(bodies.back().get());
    return *bodies.back();
  }

  void add_car(const Pose& start) {
    auto box = std::make_unique<btBoxShape>(to_bullet(kCarHalfSize));
    auto body = std::make_unique<btCompoundShape>();
    btTransform lift = btTransform::getIdentity();
    lift.setOrigin({0, 0, real(kCarBodyLift)});
    body->addChildShape(lift, box.get());
    shapes.push_back(std::move(box));
    Pose pose = start;
    pose.position.z += kCarStandsAt;
    chassis = &add(std::move(body), kCarMassKg, pose, 0, 0.3);
    chassis->setActivationState(DISABLE_DEACTIVATION);
    btRaycastVehicle::btVehicleTuning tuning;
    tuning.m_suspensionStiffness = 45;
    tuning.m_suspensionCompression = 4;
    tuning.m_suspensionDamping = 6;
    tuning.m_maxSuspensionTravelCm = 30;
    tuning.m_maxSuspensionForce = 30'000;
    tuning.m_frictionSlip = real(kGrip);
    vehicle.emplace(tuning, chassis, &rays);
    vehicle->setCoordinateSystem(1, 2, 0);
    for (int i = 0; i < 4; ++i) {
      const btVector3 at(real(i < 2 ? kAxleX : -kAxleX), real(i % 2 == 0 ? kAxleY : -kAxleY), 0);
      vehicle->addWheel(at, {0, 0, -1}, {0, -1, 0}, real(0.35), real(kWheelRadius), tuning, i < 2);
      vehicle->getWheelInfo(i).m_rollInfluence = real(0.25);
    }
    world.addVehicle(&*vehicle);
  }

  void apply(const Controls& controls) {
    const double speed = chassis->getLinearVelocity().dot(forward());
    const bool reverses = controls.brake > 0.0 && controls.throttle <= 0.0 && speed < kStandstill;
    const double engine =
        reverses ? (speed > -4.0 ? -kReverseN * controls.brake : 0.0)
                 : controls.throttle * kEngineN * std::clamp(1.0 - speed / kTopSpeed, 0.0, 1.0);
    // Bullet expects the maximum braking impulse of a wheel in one step.
    const double brake = reverses ? 0.0 : controls.brake * kBrakeN / 4.0 * kStepS;
    const double goal = -controls.steer * steering_lock(speed);
    steer += std::clamp(goal - steer, -kSteerRadPerS * kStepS, kSteerRadPerS * kStepS);
    for (int i = 0; i < 4; ++i) {
      vehicle->setBrake(real(brake), i);
      if (i < 2) vehicle->setSteeringValue(real(steer), i);
      if (i >= 2) vehicle->applyEngineForce(real(engine / 2.0), i);
      btWheelInfo& wheel = vehicle->getWheelInfo(i);
      const Vec3 place = from_bullet(wheel.m_worldTransform.getOrigin());
      const auto patch = std::find_if(patches.begin(), patches.end(),
                                      [&](const Patch& each) { return lies_on(each, place); });
      wheel.m_frictionSlip = real(patch == patches.end() ? kGrip : kGrip * patch->grip);
    }
  }

  btVector3 forward() const { return chassis->getWorldTransform().getBasis().getColumn(0); }

  std::vector<Patch> patches;
  std::vector<Obstacle> obstacles;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  std::vector<btRigidBody*> movable;
  btRigidBody* chassis = nullptr;
  double steer = 0.0;  // of the front wheels, to the left
  btDefaultVehicleRaycaster rays{&world};
  std::optional<btRaycastVehicle> vehicle;
};

World::World(const Track& track) : bodies_(std::make_unique<Bodies>(track)) {}
World::~World() = default;

void World::step(const Controls& controls) {
  bodies_->apply(controls);
  bodies_->world.stepSimulation(real(kStepS), 0);
}

void World::place(const Pose& pose) {
  Pose standing = pose;
  standing.position.z += kCarStandsAt;
  bodies_->chassis->setWorldTransform(to_bullet(standing));
  bodies_->chassis->setInterpolationWorldTransform(to_bullet(standing));
  bodies_->chassis->setLinearVelocity({0, 0, 0});
  bodies_->chassis->setAngularVelocity({0, 0, 0});
  bodies_->chassis->clearForces();
  bodies_->vehicle->resetSuspension();
}

void World::reset_objects(double away) {
  const btVector3 car = bodies_->chassis->getWorldTransform().getOrigin();
  for (std::size_t i = 0; i < bodies_->movable.size(); ++i) {
    btRigidBody& body = *bodies_->movable[i];
    const Obstacle& as_new = bodies_->obstacles[i];
    const btTransform home = to_bullet(as_new.pose);
    if (car.distance(home.getOrigin()) < real(away)) continue;
    if (car.distance(body.getWorldTransform().getOrigin()) < real(away)) continue;
    body.setWorldTransform(home);
    body.setInterpolationWorldTransform(home);
    body.setLinearVelocity(to_bullet(as_new.velocity_mps));
    body.setAngularVelocity({0, 0, 0});
    body.clearForces();
    body.activate();
  }
}

Pose World::car() const { return from_bullet(bodies_->chassis->getWorldTransform()); }
Vec3 World::velocity() const { return from_bullet(bodies_->chassis->getLinearVelocity()); }

std::array<Wheel, 4> World::wheels() const {
  std::array<Wheel, 4> wheels;
  for (int i = 0; i < 4; ++i) {
    const btWheelInfo& info = bodies_->vehicle->getWheelInfo(i);
    Wheel& wheel = wheels[static_cast<std::size_t>(i)];
    wheel.contact = info.m_raycastInfo.m_isInContact;
    wheel.skid =
        wheel.contact ? std::clamp(1.0 - static_cast<double>(info.m_skidInfo), 0.0, 1.0) : 0.0;
    // Last, because it resets the contact.
    bodies_->vehicle->updateWheelTransform(i, false);
    wheel.pose = from_bullet(info.m_worldTransform);
  }
  return wheels;
}

std::vector<Pose> World::obstacles() const {
  std::vector<Pose> poses;
  for (const btRigidBody* body : bodies_->movable)
    poses.push_back(from_bullet(body->getWorldTransform()));
  return poses;
}

std::vector<Contact> World::contacts() const {
  std::map<int, Contact> found;
  const btTransform car = bodies_->chassis->getWorldTransform();
  for (int i = 0; i < bodies_->dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& touch = *bodies_->dispatcher.getManifoldByIndexInternal(i);
    const bool first = touch.getBody0() == bodies_->chassis;
    if (!first && touch.getBody1() != bodies_->chassis) continue;
    Contact& contact = found[(first ? touch.getBody1() : touch.getBody0())->getUserIndex()];
    for (int k = 0; k < touch.getNumContacts(); ++k) {
      const btManifoldPoint& point = touch.getContactPoint(k);
      const btVector3 into = first ? -point.m_normalWorldOnB : point.m_normalWorldOnB;
      const double impulse = point.getAppliedImpulse();
      contact.impulse += impulse;
      contact.towards = contact.towards + impulse * from_bullet(into * car.getBasis());
      contact.point =
          contact.point + impulse * from_bullet(car.invXform(first ? point.getPositionWorldOnA()
                                                                   : point.getPositionWorldOnB()));
    }
  }
  std::vector<Contact> contacts;
  for (auto& [body, contact] : found) {
    if (contact.impulse <= 0.0) continue;
    contact.body = body;
    contact.point = (1.0 / contact.impulse) * contact.point;
    contact.towards = unit_or(contact.towards, {0, 0, -1});
    contacts.push_back(contact);
  }
  return contacts;
}

}  // namespace hedgehog::racer

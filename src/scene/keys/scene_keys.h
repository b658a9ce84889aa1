#pragma once
#include "scene/keys/builder.h"

/// The parts of a scene, each with its key tables in a file of its own. Every reader adds to
/// `builder.scene`; the
/// `*_tables` say what keys there are.
namespace flatray {

void read_film(Builder& builder, const Field& field, Scene& scene);
void read_camera(Builder& builder, const Field& field, Scene& scene);
std::vector<TableInfo> film_tables();

void read_groups(Builder& builder, const Field& field, Scene& scene);
std::vector<TableInfo> group_tables();

void read_collisions(Builder& builder, const Field& field, Scene& scene);
std::vector<TableInfo> collision_tables();

void read_entities(Builder& builder, const Field& field, Scene& scene);
std::vector<TableInfo> entity_tables();

void read_chambers(Builder& builder, const Field& field, Scene& scene);
/// What cannot be in a magnetic field.
void check_field(Builder& builder);
std::vector<TableInfo> chamber_tables();

void read_rays(Builder& builder, const Field& field, Scene& scene);
void read_edge_rays(Builder& builder, const Field& field, Scene& scene);
std::vector<TableInfo> ray_tables();

void read_lamps(Builder& builder, const Field& field, Scene& scene);
void read_light(Builder& builder, const Field& field, Scene& scene);
/// What no key shows alone: once all has been read.
void check_light(Builder& builder);
std::vector<TableInfo> lamp_tables();

void read_chains(Builder& builder, const Field& field, Scene& scene);
/// The state of a chain by name; an unknown one is a problem.
std::optional<StateId> find_state(Builder& builder, const MarkovChain& chain, const Place& where,
                                  const std::string& name);
std::vector<TableInfo> markov_tables();

}  // namespace flatray

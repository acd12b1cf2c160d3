#pragma once
// The tables of a scene that belong to no effect; only the sources of this folder include this. Each function
// reads its tables from the top level of the file into the scene, and adds what is wrong with them to the
// list of faults.

#include "model/scene/tables/reading.hpp"

namespace femsph::scene_reader {

void read_model(Fields& root, Reading& reading);
void read_materials(Fields& root, Reading& reading);
void read_bodies(Fields& root, Reading& reading);
void read_output(Fields& root, Reading& reading);
void read_probes(Fields& root, Reading& reading);
void read_sections(Fields& root, Reading& reading);
void read_time(Fields& root, Reading& reading);

}  // namespace femsph::scene_reader

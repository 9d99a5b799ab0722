// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/xdmf_series.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "common/progress.hpp"
#include "formats/number_text.hpp"

#include <system_error>

namespace dem::runtime {

namespace {

constexpr std::size_t always_written = 20;  // frames
constexpr double interval = 1.0;            // [s]

std::string data_item(const XdmfTable& table) {
    std::string text = "<DataItem Format=\"HDF\" NumberType=\"" + std::string(table.type) +
                       "\" Precision=\"" + std::to_string(table.bytes) + "\" Dimensions=\"" +
                       std::to_string(table.rows);
    if (table.columns > 1) text += " " + std::to_string(table.columns);
    return text + "\">" + table.path + "</DataItem>";
}

std::string grid_text(const XdmfGrid& grid, std::size_t number) {
    const char* topology = "Polyvertex\" NodesPerElement=\"1\"";
    if (grid.cells.columns == 2) topology = "Polyline\" NodesPerElement=\"2\"";
    if (grid.cells.columns == 3) topology = "Triangle\"";
    std::string text = "   <Grid Name=\"" + std::to_string(number) + "\" GridType=\"Uniform\">\n";
    text += "    <Time Value=\"" + number_text(grid.time) + "\"/>\n";
    text += std::string("    <Topology TopologyType=\"") + topology + " NumberOfElements=\"" +
            std::to_string(grid.cells.rows) + "\">" + data_item(grid.cells) + "</Topology>\n";
    text += "    <Geometry GeometryType=\"XYZ\">" + data_item(grid.points) + "</Geometry>\n";
    for (const XdmfAttribute& a : grid.attributes) {
        text += "    <Attribute Name=\"" + a.name + "\" AttributeType=\"" + a.kind +
                "\" Center=\"" + a.center + "\">" + data_item(a.table) + "</Attribute>\n";
    }
    return text + "   </Grid>\n";
}

}  // namespace

XdmfSeries::XdmfSeries(std::filesystem::path path, std::string name)
    : path_(std::move(path)), name_(std::move(name)), last_written_(Progress::steady_seconds()) {}

XdmfSeries::~XdmfSeries() {
    try {
        if (count_ > count_written_) write();
    } catch (const Error&) {  // the frames themselves are safe, and a destructor cannot tell
    }
}

std::string XdmfSeries::entry(const XdmfGrid& grid) const {
    return grid.points.rows == 0 || grid.cells.rows == 0 ? "" : grid_text(grid, count_);
}

void XdmfSeries::begin(const std::vector<std::string>& entries) {
    for (const std::string& entry : entries) {
        grids_ += entry;
        if (!entry.empty()) ++count_;
    }
    if (count_ > 0) {
        write();
        return;
    }
    std::error_code ignored;  // what cannot be removed cannot be replaced either, as write() says
    std::filesystem::remove(path_, ignored);
}

void XdmfSeries::append(const std::string& entry) {
    if (entry.empty()) return;
    grids_ += entry;
    ++count_;
    if (count_ <= always_written || Progress::steady_seconds() - last_written_ >= interval) write();
}

void XdmfSeries::write() {
    AtomicFile file(path_);
    file.write(
        "<?xml version=\"1.0\"?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n"
        "<Xdmf Version=\"3.0\">\n <Domain>\n  <Grid Name=\"" +
        name_ + "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n");
    file.write(grids_);
    file.write("  </Grid>\n </Domain>\n</Xdmf>\n");
    file.commit();
    count_written_ = count_;
    last_written_ = Progress::steady_seconds();
}

}  // namespace dem::runtime

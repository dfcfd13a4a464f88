#include "tests/print/gcode_reader.h"

#include <sstream>
#include <stdexcept>

namespace morphgrid {
namespace {

class GcodeReader {
 public:
  void read(const std::string& line) {
    if (line.rfind(";TYPE:", 0) == 0) {
      type_ = line.substr(6);
    } else if (line.rfind(";Z:", 0) == 0) {
      result_.passHeights.push_back(std::stod(line.substr(3)));
    } else if (line.rfind("; ", 0) == 0) {
      readComment(line.substr(2));
    } else if (!line.empty() && line[0] != ';') {
      readCommand(line);
    }
  }
  ReadGcode result() const { return result_; }

 private:
  void readComment(const std::string& comment) {
    const auto equals = comment.find(" = ");
    if (equals == comment.npos) {
      name_ = comment;
    } else {
      result_.totals[comment.substr(0, equals)] = std::stod(comment.substr(equals + 3));
    }
  }

  void readCommand(const std::string& line) {
    std::istringstream words(line);
    std::string command;
    words >> command;
    if (command == "M73") {
      std::string share;
      words >> share;
      result_.progress.push_back(std::stoi(share.substr(1)));
    } else if (command == "G0" || command == "G1") {
      std::map<char, double> values;
      for (std::string word; words >> word;) values[word[0]] = std::stod(word.substr(1));
      move(values);
    } else if (std::string("GM").find(command[0]) == std::string::npos &&
               command != "BED_MESH_CALIBRATE") {
      throw std::runtime_error("what is " + line);
    }
  }

  void move(const std::map<char, double>& values) {
    const auto valueOf = [&](char letter, double otherwise) {
      return values.count(letter) ? values.at(letter) : otherwise;
    };
    speed_ = valueOf('F', 60 * speed_) / 60;
    const double filament = valueOf('E', 0);
    result_.filament += filament;
    result_.lifts += values.count('Z') ? 1 : 0;
    z_ = valueOf('Z', z_);
    if (!values.count('X')) {
      if (values.count('E')) isDrawnBack_ = filament < 0;
      return;
    }
    const Eigen::Vector2d to(values.at('X'), values.at('Y'));
    (values.count('E') ? result_.laid : result_.travels)
        .push_back({at_, to, z_, filament, speed_, isDrawnBack_, name_, type_});
    at_ = to;
  }

  ReadGcode result_;
  Eigen::Vector2d at_{0, 0};
  double z_ = 0;
  double speed_ = 0;
  bool isDrawnBack_ = false;
  std::string name_, type_;
};

}  // namespace

ReadGcode readGcode(const std::string& text) {
  GcodeReader reader;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) reader.read(line);
  return reader.result();
}

}  // namespace morphgrid

#include <array>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

#include "io/point_file.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

std::string not_decimal(int line, int column, const std::string& text) {
  std::ostringstream message;
  message << ":" << line << ": column " << column << " is not a decimal number: " << text
          << "; correct or remove this line, or begin it with # if it is a comment";
  return message.str();
}

class Xyz : public testing::Test {
 protected:
  PointCloud read(const std::string& content) const {
    return read_points(folder.write("a.xyz", content));
  }
  std::string message(const std::string& content) const {
    const auto path = folder.write("a.xyz", content);
    return message_of<FileError>(path, [&] { read_points(path); });
  }

  TemporaryFolder folder;
  const std::vector<Point> two = {{1, 2, 3}, {4, 5, 6}};
};

TEST_F(Xyz, EverySeparatorAndLineEnd) {
  for (const char* content :
       {"1 2 3\n4 5 6\n", "1\t2\t3\r\n4 5\t 6 ", "1,2,3\r4,5,6\r", "1;2;3\n4 ; 5;6;",
        "1, 2, 3\n4 ,5,6\n", "# c\n\n1 2 3 # c\n// d\n4 5 6//\n",
        "\xEF\xBB\xBF+1 2. 3e0\n4 5 .6e1\n", "1 2 3 red\n4 5 6\n",
        "1,2,3,\"a,b\"\n4,5,6,\"c d\"\n"}) {
    EXPECT_EQ(read(content).points, two) << content;
  }
}

TEST_F(Xyz, CountsAndHeaders) {
  const PointCloud counted = read("2\n1 2 3 7\n4 5 6\n");
  EXPECT_EQ(counted.points, two);
  EXPECT_EQ(counted.announced, 2U);
  EXPECT_EQ(read("2 // points\n1 2 3\n4 5 6\n").announced, 2U);
  EXPECT_EQ(read("2 # points // or so\n1 2 3\n4 5 6\n").announced, 2U);
  EXPECT_EQ(counted.columns, 4U);
  EXPECT_EQ(counted.header, "");
  EXPECT_EQ(read("X Y Z Red\n1 2 3 7\n4 5 6 8\n").header, "X Y Z Red");
  EXPECT_EQ(read("\"x\",\"y\",\"z\"\n1,2,3\n4,5,6\n").points, two);
  EXPECT_EQ(read("x,y,z,\n1,2,3,\n4,5,6,\n").points, two);  // empty last columns
  EXPECT_EQ(read("//X Y Z\n2\n1 2 3\n4 5 6\n").points, two);
  EXPECT_EQ(read("east north height\n1 2 3\n4 5 6\n").points, two);
  EXPECT_EQ(read("1 2 3\n4 5 6\n").announced, std::nullopt);
  EXPECT_EQ(read("0\n").points.size(), 0U);
}

TEST_F(Xyz, ColumnsAreFoundByTheirNames) {
  for (const char* content :
       {"id,x,y,z\n7,1,2,3\n8,4,5,6\n", "\"y\",\"x\",\"z\"\n2,1,3\n5,4,6\n",
        "scalars,Points:0,Points:1,Points:2\n7,1,2,3\n8,4,5,6\n",
        "\"a, b\",\"Points:2\",\"Points:1\",\"Points:0\"\n7,3,2,1\n\"8,9\",6,5,4\n",
        "Name;Points_0;Points_1;Points_2\nan a;1;2;3\nb;4;5;6\n", "t Z Y X\n0 3 2 1 # c\n0 6 5 4\n",
        "return number, x [mm], y [mm], z(mm)\n7, 1, 2, 3\n8, 4, 5, 6\n",
        "//X Y Z R\n2\n1 2 3 7\n4 5 6 8\n", "# made by a scanner\n# id x y z\n7 1 2 3\n8 4 5 6\n",
        "# x y z are in mm\n1 2 3 7\n4 5 6 8\n", "# after z y x\n1 2 3\n4 5 6\n",
        "# columns: x y z\n1 2 3 7\n4 5 6 8\n", "x y z t # a;b\n1 2 3 7\n4 5 6 8\n",
        "1 2 3\n# z y x\n4 5 6\n"}) {
    EXPECT_EQ(read(content).points, two) << content;
  }
  const PointCloud told = read("id,Z,x,y\n7,3,1,2\n");
  EXPECT_TRUE(told.told_columns);
  EXPECT_EQ(told.coordinate_names, (std::array<std::string, 3>{"x", "y", "Z"}));
  const PointCloud others = read("scalars,u,v,w\n1,2,3,4\n");
  EXPECT_FALSE(others.told_columns);
  EXPECT_EQ(others.coordinate_names, (std::array<std::string, 3>{"scalars", "u", "v"}));
  EXPECT_EQ(read("1 2 3\n").coordinate_names, (std::array<std::string, 3>{}));
}

TEST_F(Xyz, NamesOfSurveysAndScannersTellTheColumns) {
  for (const char* content :
       {"Point ID,Easting,Northing,Elevation\n1,1,2,3\n2,4,5,6\n",
        "Point,Northing (m),Easting (m),Height (m),Code\nA,2,1,3,c\nB,5,4,6,\n",
        "height north east\n3 2 1\n6 5 4\n", "# north east elev\n2 1 3\n5 4 6\n",
        "fid,easting,northing,z\n9,1,2,3\n9,4,5,6\n", "id,pos_x,pos_y,pos_z\n9,1,2,3\n9,4,5,6\n",
        "t PositionX PositionY PositionZ\n9 1 2 3\n9 4 5 6\n",
        "t;\"x coordinate\";\"y coordinate\";\"z coordinate\"\n9;1;2;3\n9;4;5;6\n",
        "nx,ny,nz,x_coord [mm],y_coord [mm],z_coord [mm]\n0,0,1,1,2,3\n0,0,1,4,5,6\n",
        "t,\"Points_m_XYZ:0\",Points_m_XYZ:1,Points_m_XYZ:2\n9,1,2,3\n9,4,5,6\n"}) {
    const PointCloud cloud = read(content);
    EXPECT_EQ(cloud.points, two) << content;
    EXPECT_TRUE(cloud.told_columns) << content;
  }
  // Not all three, two heights, or not all in the same way: nothing is told.
  for (const char* content :
       {"a,easting,northing,b\n1,2,3,4\n", "a,east,north,up,height\n1,2,3,4,5\n",
        "a,easting,north,up\n1,2,3,4\n", "a,pos_x,pos_y,posz\n1,2,3,4\n",
        "a,pos_x,pos_y,pos\n1,2,3,4\n"}) {
    EXPECT_FALSE(read(content).told_columns) << content;
  }
}

TEST_F(Xyz, ValuesMayBeInQuotes) {
  for (const char* content : {"\"x\",\"y\",\"z\"\n\"1\",\"2\",\"3\"\n\"4\",\"5\",\"6\"\n",
                              "\"1\";\"2\";\"3\"\n\"4\";\"5\";\"6\"\n",
                              "a,x,y,z\n\"1,5\",'1',\"2\",3\n\"b\",4,\"5\",'6'\n"}) {
    EXPECT_EQ(read(content).points, two) << content;
  }
  EXPECT_EQ(message("x,y,z\n\"1,5\",\"2\",\"3\"\n"), not_decimal(2, 1, "'1,5'"));
  EXPECT_EQ(message("\"1\",\"2\"\n"),
            ":1: a row needs three numbers x y z, this one has 2; correct or remove this line");
  EXPECT_EQ(message("\"1\",\"2\",\"3\"\n\"1\",\"2\",\"3\",\"4\"\n"),
            ":2: has 4 columns, but earlier lines have 3; if the comma is a decimal comma, write a "
            "point instead");
}

// Names of rows, which the header does not name.
TEST_F(Xyz, TablesOfR) {
  for (const char* content : {"\"x\" \"y\" \"z\"\n\"1\" 1 2 3\n\"2\" 4 5 6\n",
                              "\"\",\"V1\",\"V2\",\"V3\"\n\"1\",1,2,3\n\"2\",4,5,6\n",
                              "\"V1\" \"V2\" \"V3\" \"V4\"\n\"a b\" 1 2 3 9\n\"c\" 4 5 6 9\n"}) {
    EXPECT_EQ(read(content).points, two) << content;
  }
}

TEST_F(Xyz, PandasNumbersRowsAndColumns) {
  EXPECT_EQ(read(",0,1,2\n0,1,2,3\n1,4,5,6\n").points, two);
  EXPECT_EQ(read("\"\";\"0\";\"1\";\"2\";\"3\"\n0;1;2;3;9\n1;4;5;6;9\n").points, two);
  EXPECT_EQ(message(",0,1,3\n0,1,2,3\n"), not_decimal(1, 1, "''"));
}

TEST_F(Xyz, TellsRowsAndColumnsThatAreCounted) {
  const PointCloud names = read("0,1,2\n1,2,3.5\n");
  EXPECT_EQ(names.points.size(), 2U);
  EXPECT_TRUE(names.first_row_counts_columns);
  for (const char* content : {"0 1 2\n1 2 3\n", "0 1 2.0\n1 2 3.5\n", "x y z\n0 1 2\n1 2 3.5\n"}) {
    EXPECT_FALSE(read(content).first_row_counts_columns) << content;
  }
  const auto counted = [this](double first, double step, int rows, const char* begin,
                              const char* end) {
    std::string text = begin;
    for (int i = 0; i < rows; ++i) text += std::to_string(first + step * i) + " 1 2" + end + "\n";
    return read(text).first_column_counts_rows;
  };
  EXPECT_TRUE(counted(1, 1, 10, "", " 3"));
  EXPECT_TRUE(counted(-7, 1, 20, "20\n# a comment\n", " 3 9"));
  EXPECT_FALSE(counted(1, 1, 9, "", " 3"));
  EXPECT_FALSE(counted(1, 1, 10, "", ""));
  EXPECT_FALSE(counted(1, 2, 10, "", " 3"));
  EXPECT_FALSE(counted(0.5, 1, 10, "", " 3"));
  EXPECT_FALSE(counted(1, 1, 10, "x y z n\n", " 3"));
}

TEST_F(Xyz, TheColumnThatNumbersTheRowsMayHaveNoName) {
  for (const char* content :
       {",x,y,z\n0,1,2,3\n1,4,5,6\n", "; x; y; z\n0; 1; 2; 3\n1; 4; 5; 6\n",
        ",id,x,y,z\n0,7,1,2,3\n1,8,4,5,6\n", "\tx\ty\tz\n0\t1\t2\t3\n1\t4\t5\t6\n",
        "\tz\ty\tx\tr\n0\t3\t2\t1\t9\n1\t6\t5\t4\t9\n", "\tx\ty\tz\n\t1\t2\t3\n\t4\t5\t6\n",
        "\"\",\"x\",\"y\",\"z\"\n\"1\",1,2,3\n\"2\",4,5,6\n"}) {
    const PointCloud cloud = read(content);
    EXPECT_EQ(cloud.points, two) << content;
    EXPECT_TRUE(cloud.told_columns) << content;
    EXPECT_EQ(cloud.named_columns, cloud.columns) << content;
  }
  for (const char* content :
       {",u,v,w\n0,1,2,3\n1,4,5,6\n", "\tu\tv\tw\n0\t1\t2\t3\n1\t4\t5\t6\n"}) {
    const PointCloud cloud = read(content);
    EXPECT_EQ(cloud.points, two) << content;
    EXPECT_FALSE(cloud.told_columns);
    EXPECT_EQ(cloud.coordinate_names, (std::array<std::string, 3>{"u", "v", "w"}));
  }
  EXPECT_EQ(message(",,x,y,z\n0,0,1,2,3\n"), not_decimal(1, 1, "''"));
  EXPECT_EQ(message(",x,y\n0,1,2\n"), not_decimal(1, 1, "''"));
}

TEST_F(Xyz, ValuesThatAreMissingBetweenTabsAreNoCoordinates) {
  const std::string header = "x\ty\tz\tr\n1\t2\t3\t0\n";
  EXPECT_EQ(message(header + "\t4\t5\t6\n"), ":3: column 1 is empty");
  EXPECT_EQ(message(header + "4\t\t5\t6\n"), ":3: column 2 is empty");
  EXPECT_EQ(message(header + "4\t5\t\t6\n"), ":3: column 3 is empty");
  EXPECT_EQ(read(header + "4\t5\t6\t\n").points, two);
  EXPECT_EQ(read(header + "4\t\t5\t6\t\t7\n").points, two);
  EXPECT_EQ(read(header + "\t4\t5\t6\t7\n").points, two);
  EXPECT_EQ(read("x\ty\tz\tr\tg\n1\t2\t3\t\t7\n4\t5\t6\t\t\n").points, two);
  EXPECT_EQ(read("1\t\t2\t3\n4\t5\t\t6\n").points, two);
}

TEST_F(Xyz, LastValuesMayBeMissing) {
  EXPECT_EQ(read("id,x,y,z,label\n0,1,2,3,\n1,4,5,6, \n").points, two);
  EXPECT_EQ(read("id;x;y;z;label\n0;1;2;3;a\n1;4;5;6;\n").points, two);
  EXPECT_EQ(message("id,x,y,z,a,b\n0,1,2,3,\n").substr(0, 39),
            ":2: has 4 columns, but the header names");
}

TEST_F(Xyz, ReadsAllRowsWhereMoreFollowThanAnnounced) {
  for (const char* content : {"1\n1 2 3\n4 5 6\n", "0\n1 2 3\n4 5 6\n"}) {
    const PointCloud cloud = read(content);
    EXPECT_EQ(cloud.points, two);
    ASSERT_TRUE(cloud.announced);
    EXPECT_LT(*cloud.announced, cloud.points.size());
  }
}

// Points with normals come as rows of six numbers, or as all points and then all normals.
TEST_F(Xyz, NormalsAfterAllPointsAreLeftOut) {
  const std::string points = "2\n1 2 3\n4 5 6\n";
  const auto path = folder.write("cloud.pwn", points + "0 0 1\n0.6 0.8 0\n");
  EXPECT_EQ(read_points(path).points, two);
  EXPECT_EQ(read_points(folder.write("rows.pwn", "2\n1 2 3 0 0 1\n4 5 6 1 0 0\n")).points, two);
  for (const char* more : {"0 0 1\n0 0 2\n", "0 0 1\n", "0 0 1\n1 0 0\n0 1 0\n"}) {
    const PointCloud cloud = read_points(folder.write("other.pwn", points + more));
    EXPECT_GT(cloud.points.size(), 2U) << more;
  }
  EXPECT_EQ(read(points + "0 0 1\n0.6 0.8 0\n").points.size(), 4U);  // .xyz
}

TEST_F(Xyz, AnglesBesideCoordinatesAreNoObstacle) {
  const std::vector<Point> expected{{1, 2, 3}};
  EXPECT_EQ(read("lat,lon,easting,northing,height\n50,8,1,2,3\n").points, expected);
  EXPECT_EQ(read("lat,lon,x,y,z\n50,8,1,2,3\n").points, expected);
}

TEST_F(Xyz, RefusesWhatItCannotBeSureOf) {
  const std::string decimal_comma = "if the comma is a decimal comma, write a point instead";
  EXPECT_EQ(message("1 2 3\n0,5 1 2\n"), ":2: mixes separators; " + decimal_comma);
  EXPECT_EQ(message("1 2 0,5\n"), ":1: mixes separators; " + decimal_comma);
  EXPECT_EQ(message("1;2;0,5\n"), ":1: mixes separators; " + decimal_comma);
  EXPECT_EQ(message("0,5,1,2\n0,5,1,2,5\n"),
            ":2: has 5 columns, earlier lines have 4; " + decimal_comma);
  EXPECT_EQ(message("x,y,z\n0,5,1,2\n"),
            ":2: has 4 columns, earlier lines have 3; " + decimal_comma);
  EXPECT_EQ(message("id,x,y,height\n1,2,3,4\n"),
            ":1: the header names some of x, y, z, but not all three; name the columns of all, or "
            "none");
  const std::string angles =
      ":1: the header names latitude and longitude, which are angles; project the points first (to "
      "UTM, say), with coordinates and heights in one unit";
  EXPECT_EQ(message("lat,lon,alt\n1,2,3\n"), angles);
  EXPECT_EQ(message("Id;Longitude [deg];Latitude [deg];z\n1;2;3;4\n"), angles);
  EXPECT_EQ(message("id;x;y;z\n1;0,5;1;2\n"), not_decimal(2, 2, "'0,5'"));
  EXPECT_EQ(message("id,x,y,z\n1,0,5,1,2\n"),
            ":2: has 5 columns, but the header names 4; " + decimal_comma);
  EXPECT_EQ(message("id x y z\n1 1 2 3\n2 4 5\n"),
            ":3: has 3 columns, but the header names 4; " + decimal_comma);
  EXPECT_EQ(message("# c\n3\n1 2 3\n4 5 6\n"),
            ":2: announces 3 points, but 2 follow; the file is cut off");
  EXPECT_EQ(message("1 2 3\n4 5\n"),
            ":2: a row needs three numbers x y z, this one has 2; correct or remove this line");
  EXPECT_EQ(message("1 2 3\n7\n4 5 6\n"),
            ":2: a row needs three numbers x y z, this one has 1; correct or remove this line");
  EXPECT_EQ(message("2\n7\n4 5 6\n"),
            ":2: a row needs three numbers x y z, this one has 1; correct or remove this line");
  EXPECT_EQ(message("2\n\nC 1 2 3\n"), not_decimal(3, 1, "'C'"));
  EXPECT_EQ(message("1 2 3\n1 0x1 3\n"), not_decimal(2, 2, "'0x1'"));
  EXPECT_EQ(message("1 2 3\n1,,3\n"), not_decimal(2, 2, "''"));
  EXPECT_EQ(message("# only\n"), ": holds no points; expected lines 'x y z'");
}

// As older programs on Windows write it: what follows the '#' is no comment.
TEST_F(Xyz, NotFiniteAsOldLibrariesPrintIt) {
  for (const char* row : {"1.#QNAN 2 3", "1 -1.#IND 3", "1 2 1.#INF", "1,2,-1.#IND00"}) {
    EXPECT_TRUE(message(std::string("1 2 3\n") + row + "\n")
                    .starts_with(":2: point 1 (counted from 0) has a coordinate that is not"))
        << row;
  }
}

TEST_F(Xyz, NonFiniteRowsAreNamedOrSkippedOnDemand) {
  const std::string content = "1 2 3\nnan 0 0\n4 5 6\n0 -inf 0\n0 0 1e400\n0 0 1e-400\n";
  EXPECT_EQ(
      message(content),
      ":2: point 1 (counted from 0) has a coordinate that is not a finite number, and so have "
      "2 more; remove or repair such points");
  const PointCloud cloud = read_points(folder.write("a.xyz", content), {.skip_non_finite = true});
  EXPECT_EQ(cloud.points, (std::vector<Point>{{1, 2, 3}, {4, 5, 6}, {0, 0, 0}}));
  EXPECT_EQ(cloud.skipped, (std::vector<std::size_t>{1, 3, 4}));
}

}  // namespace
}  // namespace cocoon

# Of the sources that it lies in: brew install --HEAD --formula ./packaging/homebrew/gcpw.rb
class Gcpw < Formula
  desc "Image stitching by Generalized Content-Preserving Warps, as an OpenCV module"
  license "Apache-2.0"
  head "file://#{File.expand_path("../..", __dir__)}", using: :git

  depends_on "cmake" => :build
  depends_on "eigen" => :build
  depends_on "opencv"

  def install
    system "cmake", "-S", ".", "-B", "build", "-DBUILD_SHARED_LIBS=ON", "-DGCPW_BUILD_TESTS=OFF",
           "-DGCPW_BUILD_SAMPLES=OFF", "-DGCPW_BUILD_PYTHON=OFF", "-DCMAKE_INSTALL_RPATH=#{rpath}", *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    (testpath/"test.cpp").write <<~CPP
      #include <opencv2/gcpw.hpp>
      int main() { cv::gcpw::Params().check(); }
    CPP
    flags = shell_output("pkg-config --cflags --libs gcpw").split
    system ENV.cxx, "-std=c++17", "test.cpp", "-o", "test", *flags
    system "./test"
  end
end

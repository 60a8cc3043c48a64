/** OpenCV's classes as Debian has them. */
module opencv {
    exports org.opencv.calib3d;
    exports org.opencv.core;
    exports org.opencv.imgcodecs;
    exports org.opencv.imgproc;
    exports org.opencv.videoio;
}

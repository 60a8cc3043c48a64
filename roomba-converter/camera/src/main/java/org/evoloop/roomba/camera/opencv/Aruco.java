package org.evoloop.roomba.camera.opencv;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.List;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.MarkerDictionary;
import org.jspecify.annotations.Nullable;
import org.opencv.core.CvType;
import org.opencv.core.Mat;

/**
 * OpenCV's ArUco. OpenCV 4.7 moved it from {@code org.opencv.aruco} to {@code org.opencv.objdetect} and changed it; no
 * source compiles against both, so it is called by reflection.
 */
final class Aruco {
    private static final boolean MOVED = isThere("org.opencv.objdetect.ArucoDetector");
    private static final String HOME = MOVED ? "org.opencv.objdetect." : "org.opencv.aruco.";
    private static final Class<?> FUNCTIONS = named(HOME + (MOVED ? "Objdetect" : "Aruco"));
    private static final Class<?> DICTIONARY = named(HOME + "Dictionary");
    private static final Class<?> PARAMETERS = named(HOME + "DetectorParameters");

    /**
     * Samples per cell in each direction. OpenCV's default of 4 is too low for a blurred marker whose cells are 5
     * pixels wide: with 8, twice as many are found from 2.5 m on, and four times as many at 2 m with motion blur.
     */
    private static final int SAMPLES_PER_CELL = 8;

    private final MarkerDictionary name;
    private final Object dictionary;

    private Aruco(MarkerDictionary name, Object dictionary) {
        this.name = name;
        this.dictionary = dictionary;
    }

    static Aruco of(MarkerDictionary name) {
        return new Aruco(name, invoke(method(FUNCTIONS, "getPredefinedDictionary", int.class), null, name.number()));
    }

    /** Finds markers with pixel precision. */
    interface Detector {
        /**
         * Finds all markers of the dictionary.
         *
         * @param corners receives a row of four points for each marker, to be released
         * @param ids receives the markers' ids
         */
        void detect(Mat gray, List<Mat> corners, Mat ids);
    }

    Detector detector() {
        Object parameters = MOVED ? create(PARAMETERS) : invoke(method(PARAMETERS, "create"), null);
        invoke(method(PARAMETERS, "set_perspectiveRemovePixelPerCell", int.class), parameters, SAMPLES_PER_CELL);
        if (MOVED) {
            Class<?> type = named(HOME + "ArucoDetector");
            Object detector = create(type, new Class<?>[] {DICTIONARY, PARAMETERS}, dictionary, parameters);
            Method detect = method(type, "detectMarkers", Mat.class, List.class, Mat.class);
            return (gray, corners, ids) -> invoke(detect, detector, gray, corners, ids);
        }
        Method detect = method(FUNCTIONS, "detectMarkers", Mat.class, DICTIONARY, List.class, Mat.class, PARAMETERS);
        return (gray, corners, ids) -> invoke(detect, null, gray, dictionary, corners, ids, parameters);
    }

    /** The marker's cells, border included; true is white. */
    boolean[][] cells(int id) {
        if (id < 0 || id >= name.size()) {
            throw new CameraException("marker id " + id + " is not in " + name.label());
        }
        int side = name.cells() + 2;
        Mat drawn = new Mat();
        try {
            String draw = MOVED ? "generateImageMarker" : "drawMarker";
            invoke(
                    method(FUNCTIONS, draw, DICTIONARY, int.class, int.class, Mat.class),
                    null,
                    dictionary,
                    id,
                    side,
                    drawn);
            byte[] pixels = new byte[side * side];
            if (drawn.type() != CvType.CV_8UC1 || drawn.get(0, 0, pixels) != pixels.length) {
                throw new IllegalStateException("OpenCV drew something else than a marker: " + drawn);
            }
            boolean[][] cells = new boolean[side][side];
            for (int i = 0; i < pixels.length; i++) {
                cells[i / side][i % side] = pixels[i] != 0;
            }
            return cells;
        } finally {
            drawn.release();
        }
    }

    private static boolean isThere(String type) {
        try {
            Class.forName(type, false, Aruco.class.getClassLoader());
            return true;
        } catch (ClassNotFoundException absent) {
            return false;
        }
    }

    private static Class<?> named(String type) {
        try {
            return Class.forName(type);
        } catch (ClassNotFoundException absent) {
            throw unknown(absent);
        }
    }

    private static Method method(Class<?> type, String name, Class<?>... parameters) {
        try {
            return type.getMethod(name, parameters);
        } catch (NoSuchMethodException absent) {
            throw unknown(absent);
        }
    }

    private static Object create(Class<?> type) {
        return create(type, new Class<?>[0]);
    }

    private static Object create(Class<?> type, Class<?>[] parameters, Object... arguments) {
        try {
            return type.getConstructor(parameters).newInstance(arguments);
        } catch (ReflectiveOperationException absent) {
            throw unknown(absent);
        }
    }

    /** Methods without a result return null, which no caller reads. */
    @SuppressWarnings("NullAway")
    private static Object invoke(Method method, @Nullable Object receiver, Object... arguments) {
        try {
            return method.invoke(receiver, arguments);
        } catch (InvocationTargetException failed) {
            throw new IllegalStateException("OpenCV's " + method.getName() + " failed", failed.getCause());
        } catch (IllegalAccessException absent) {
            throw unknown(absent);
        }
    }

    private static CameraException unknown(ReflectiveOperationException absent) {
        return new CameraException("this release of OpenCV has another ArUco than 4.6 to 4.10: " + absent, absent);
    }
}

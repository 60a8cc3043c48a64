package org.evoloop.roomba.camera.vision;

import java.net.URL;
import java.net.URLClassLoader;

/** Loads OpenCV and the classes that use it itself; delegates all other classes to the program's class loader. */
final class OpenCvLoader extends URLClassLoader {
    static {
        registerAsParallelCapable();
    }

    OpenCvLoader(URL[] places, ClassLoader program) {
        super("opencv", places, program);
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        if (!name.startsWith("org.opencv.") && !name.startsWith("org.evoloop.roomba.camera.opencv.")) {
            return super.loadClass(name, resolve);
        }
        synchronized (getClassLoadingLock(name)) {
            Class<?> known = findLoadedClass(name);
            return known != null ? known : findClass(name);
        }
    }
}

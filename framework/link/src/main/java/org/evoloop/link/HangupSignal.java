package org.evoloop.link;

import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.Platform;
import com.sun.jna.Pointer;
import java.io.IOException;
import org.evoloop.natives.NativeLibraries;

/**
 * Preserves the program's action for SIGHUP, the signal of a terminal or SSH session that ends. jSerialComm's native
 * part sets it to "ignore" when it is loaded. Then the shutdown hooks that leave a device safe would not run, and the
 * virtual machine does not restore its own handler.
 */
final class HangupSignal {
    private static final int SIGHUP = 1;

    /** Larger than a {@code struct sigaction} of any system. */
    private static final int ACTION_BYTES = 512;

    private HangupSignal() {}

    private static final class LibC {
        static {
            Native.register(NativeLibraries.C_LIBRARY);
        }

        private LibC() {}

        static native int sigaction(int signal, Pointer action, Pointer previous);
    }

    /** Code that may change the action. */
    @FunctionalInterface
    interface Change {
        void run() throws IOException;
    }

    static void keptDuring(Change change) throws IOException {
        NativeLibraries.loadJna();
        if (Platform.isWindows()) {
            change.run();
            return;
        }
        try (Memory action = new Memory(ACTION_BYTES)) {
            boolean known = LibC.sigaction(SIGHUP, Pointer.NULL, action) == 0;
            change.run();
            if (known) {
                LibC.sigaction(SIGHUP, action, Pointer.NULL);
            }
        }
    }
}

package org.evoloop.roomba.camera.live;

import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.NativeLong;
import com.sun.jna.Platform;
import com.sun.jna.Pointer;
import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import org.evoloop.natives.NativeLibraries;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Lowers the calling thread's priority, so that short work of other threads runs first. Processing a picture takes some
 * milliseconds, and events must not wait for it.
 *
 * <p>The thread requests long time slices, which are scheduled later, instead of short ones, which are scheduled
 * sooner. Its weight is a third of that of other threads on a busy processor; with less, no pictures would be processed
 * on a busy machine. It needs no privilege. Linux supports time slices per thread since 6.12; earlier versions ignore
 * them. Where none of this is permitted, nothing changes.
 *
 * <p>Source: the manual page sched_setattr(2); the C library of Debian 12 does not have that call yet.
 */
final class Background {
    private static final Logger LOG = LoggerFactory.getLogger(Background.class);

    /** The longest slice that Linux grants. */
    static final long SLICE_NANOS = 100_000_000;

    /** A third of the usual weight. */
    static final int NICE = 5;

    private static final long SET_ATTRIBUTES =
            Map.of("x86-64", 314L, "aarch64", 274L, "arm", 380L).getOrDefault(Platform.ARCH, 0L);

    private static final long GET_ATTRIBUTES = SET_ATTRIBUTES + 1;

    private static final int THIS_THREAD = 0;

    /** {@code struct sched_attr}: its size, the policy, flags, nice, priority, and the slice as the runtime. */
    private static final int ATTRIBUTES_BYTES = 48;

    private static final int NICE_OFFSET = 16;
    private static final int RUNTIME_OFFSET = 24;

    private Background() {}

    private static final class LibC {
        static {
            Native.register(NativeLibraries.C_LIBRARY);
        }

        private LibC() {}

        static native NativeLong syscall(NativeLong number, int thread, Pointer attributes, int sizeOrFlags, int flags);
    }

    /** A thread's scheduling parameters. */
    record Share(int nice, long sliceNanos) {}

    /** Makes the calling thread a background thread from now on; settings that are not permitted are skipped. */
    static void begin() {
        current().ifPresent(before -> become(new Share(Math.max(NICE, before.nice()), SLICE_NANOS)));
    }

    private static void become(Share share) {
        try (Memory attributes = new Memory(ATTRIBUTES_BYTES)) {
            read(attributes);
            attributes.setInt(NICE_OFFSET, share.nice());
            attributes.setLong(RUNTIME_OFFSET, share.sliceNanos());
            LibC.syscall(new NativeLong(SET_ATTRIBUTES), THIS_THREAD, attributes, 0, 0);
        }
    }

    /** The calling thread's scheduling parameters, as the kernel reports them; empty if it does not. */
    static Optional<Share> current() {
        if (!Platform.isLinux() || SET_ATTRIBUTES == 0) {
            return Optional.empty();
        }
        try {
            NativeLibraries.loadJna();
        } catch (IOException none) {
            LOG.debug("thread priorities cannot be changed: {}", none.getMessage());
            return Optional.empty();
        }
        try (Memory attributes = new Memory(ATTRIBUTES_BYTES)) {
            return read(attributes)
                    ? Optional.of(new Share(attributes.getInt(NICE_OFFSET), attributes.getLong(RUNTIME_OFFSET)))
                    : Optional.empty();
        }
    }

    private static boolean read(Memory attributes) {
        attributes.clear();
        return LibC.syscall(new NativeLong(GET_ATTRIBUTES), THIS_THREAD, attributes, ATTRIBUTES_BYTES, 0)
                        .longValue()
                == 0;
    }
}

package org.evoloop.natives;

import com.sun.jna.Native;
import com.sun.jna.NativeLong;
import com.sun.jna.Pointer;
import java.io.IOException;

/**
 * The functions of the C library for pseudo-terminals. The constants are Linux's; they are the same on x86_64, aarch64
 * and armhf. Signatures are those of the manual pages. If a result is negative, {@link Native#getLastError()} gives the
 * reason.
 */
final class LibC {
    static final int O_RDWR = 0x2;
    static final int O_NOCTTY = 0x100;
    static final int O_NONBLOCK = 0x800;
    static final int O_CLOEXEC = 0x80000;

    static final short POLLIN = 0x1;
    static final short POLLHUP = 0x10;

    static final int EINTR = 4;
    static final int EIO = 5;
    static final int EAGAIN = 11;

    static final int TCSANOW = 0;
    static final int B115200 = 0x1002;
    static final NativeLong TCGETS2 = new NativeLong(0x802C542AL, true);

    /** Larger than a {@code struct termios} of any C library, and than the kernel's {@code struct termios2}. */
    static final int TERMIOS_BYTES = 256;
    /** The offset of the output rate, in baud, in {@code struct termios2}. */
    static final int TERMIOS2_OUTPUT_SPEED_OFFSET = 40;

    static {
        Native.register(NativeLibraries.C_LIBRARY);
    }

    private LibC() {}

    static native int posix_openpt(int flags);

    static native int grantpt(int descriptor);

    static native int unlockpt(int descriptor);

    static native int ptsname_r(int descriptor, byte[] name, NativeLong size);

    static native int open(String path, int flags);

    static native int close(int descriptor);

    static native int tcgetattr(int descriptor, Pointer termios);

    static native void cfmakeraw(Pointer termios);

    static native int cfsetspeed(Pointer termios, int speed);

    static native int tcsetattr(int descriptor, int when, Pointer termios);

    static native int ioctl(int descriptor, NativeLong request, Pointer argument);

    static native int eventfd(int initial, int flags);

    static native int poll(Pointer descriptors, NativeLong count, int timeoutMillis);

    static native NativeLong read(int descriptor, byte[] buffer, NativeLong count);

    static native NativeLong write(int descriptor, byte[] buffer, NativeLong count);

    static int check(int result, String call) throws IOException {
        if (result < 0) {
            throw failure(call);
        }
        return result;
    }

    static IOException failure(String call) {
        return new IOException(call + " failed (error " + Native.getLastError() + ")");
    }
}

package org.evoloop.roomba.oi;

import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The version that the robot prints in its boot text, such as {@code r3_robot/tags/release-3.2.6:4975} or
 * {@code r3-robot/tags/release-stm32-3.7.7:6913}. Some packets are wrong before certain versions, see {@link Packet}.
 *
 * @since 0.1
 */
public record FirmwareVersion(int major, int minor, int patch) implements Comparable<FirmwareVersion> {
    private static final Pattern VERSION = Pattern.compile("(\\d{1,4})\\.(\\d{1,4})\\.(\\d{1,4})");
    private static final Pattern RELEASE =
            Pattern.compile("r3[_-]robot/tags/release-(?:stm32-)?" + VERSION + "(?!\\d)");

    /** The first version in this text, which is the wire's bytes read as ISO 8859-1; empty if there is none. */
    public static Optional<FirmwareVersion> find(String text) {
        Matcher release = RELEASE.matcher(text);
        return release.find() ? Optional.of(of(release)) : Optional.empty();
    }

    /**
     * The version in a text such as {@code 3.2.6}.
     *
     * @throws IllegalArgumentException if it is not a version
     */
    public static FirmwareVersion parse(String text) {
        Matcher version = VERSION.matcher(text);
        if (!version.matches()) {
            throw new IllegalArgumentException("'" + text + "' is not a firmware version; write one such as 3.2.6");
        }
        return of(version);
    }

    private static FirmwareVersion of(MatchResult release) {
        return new FirmwareVersion(number(release, 1), number(release, 2), number(release, 3));
    }

    private static int number(MatchResult release, int group) {
        return Integer.parseInt(release.group(group));
    }

    @Override
    public int compareTo(FirmwareVersion other) {
        int byMajor = Integer.compare(major, other.major);
        int byMinor = Integer.compare(minor, other.minor);
        return byMajor != 0 ? byMajor : byMinor != 0 ? byMinor : Integer.compare(patch, other.patch);
    }

    @Override
    public String toString() {
        return major + "." + minor + "." + patch;
    }
}

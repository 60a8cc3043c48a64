package org.evoloop.converter;

/**
 * Something that is wrong with a converter, its device or the connection, see {@link ConverterStatus#troubles}.
 *
 * <p>Threading: immutable.
 *
 * @param part what is affected: {@link #LINK}, {@link #RECORD}, {@link #DEVICE}, the name of a component, or a part
 *     such as {@code function Move} or {@code journal}
 * @param words what is wrong, for people
 * @param times grows each time that the part fails; 1 for what simply holds
 * @since 0.1
 */
public record Trouble(String part, String words, long times) {
    /** The part of a device that cannot be reached. */
    public static final String LINK = "link";

    /** The part of a record of the device's state that is in doubt. */
    public static final String RECORD = "record";

    /** The part of a device that reports an error of its own. */
    public static final String DEVICE = "device";

    /** A part that has failed, and has a message of the last time. */
    static Trouble failures(String part, long times, String last) {
        return new Trouble(part, times == 1 ? last : last + " (" + times + " times)", times);
    }
}

package org.evoloop.service;

import java.nio.charset.StandardCharsets;

/**
 * An answer on the control socket, in UTF-8: each line of the command's output after {@code out }, each of its errors
 * after {@code err }, and finally {@code end } with the exit status.
 */
final class Reply {
    static final String OUT = "out ";
    static final String ERR = "err ";
    static final String END = "end ";

    private Reply() {}

    static byte[] of(String output, String errors, int status) {
        StringBuilder text = new StringBuilder();
        output.lines().forEach(line -> text.append(OUT).append(line).append('\n'));
        errors.lines().forEach(line -> text.append(ERR).append(line).append('\n'));
        return text.append(END).append(status).append('\n').toString().getBytes(StandardCharsets.UTF_8);
    }

    /** The answer to an invalid request. */
    static byte[] refusal(String why) {
        return of("", "error: " + why, 2);
    }
}

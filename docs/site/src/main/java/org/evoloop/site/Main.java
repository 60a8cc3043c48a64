package org.evoloop.site;

import java.io.IOException;
import java.nio.file.Path;

/** {@code site ROOT OUT}: the project's documentation as a site, in the directory OUT. */
public final class Main {
    private Main() {}

    /** Exit status: 0 success, 1 a link leads nowhere or a file cannot be written, 2 wrong usage. */
    public static void main(String[] arguments) {
        if (arguments.length != 2) {
            System.err.println("usage: site ROOT OUT");
            System.exit(2);
        }
        try {
            new Site(Path.of(arguments[0]), Path.of(arguments[1])).write();
        } catch (IOException e) {
            System.err.println("the site cannot be written: " + e.getMessage());
            System.exit(1);
        }
    }
}

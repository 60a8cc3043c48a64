package org.evoloop.xmi;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.LinkedHashSet;
import java.util.Set;
import org.evoloop.statemachine.ModelException;

/**
 * Finds an application's model files, whatever the working directory is.
 *
 * @since 0.1
 */
public final class ModelFiles {
    private static final String HOME = "evoloop.home";

    private ModelFiles() {}

    /**
     * Looks for {@code file} in the working directory, then beside the application's jar, then in the directory that
     * the system property {@code evoloop.home} names.
     *
     * @param file a relative path, such as {@code models/light-bulb.xml}
     * @param application a class of the application
     * @throws ModelException if there is no such file; the message names the directories
     */
    public static Path find(String file, Class<?> application) {
        Set<Path> directories = new LinkedHashSet<>();
        directories.add(Path.of("").toAbsolutePath());
        CodeSource code = application.getProtectionDomain().getCodeSource();
        if (code != null && code.getLocation() != null) {
            Path jar = Path.of(URI.create(code.getLocation().toString()));
            directories.add(jar.resolveSibling(""));
        }
        String home = System.getProperty(HOME);
        if (home != null) {
            directories.add(Path.of(home).toAbsolutePath());
        }
        return directories.stream()
                .map(directory -> directory.resolve(file))
                .filter(Files::isRegularFile)
                .findFirst()
                .orElseThrow(() -> new ModelException("no file " + file + " in "
                        + String.join(
                                " or ", directories.stream().map(Path::toString).toList())
                        + "; start the program in its directory, or name that with -D" + HOME + "=DIRECTORY"));
    }
}

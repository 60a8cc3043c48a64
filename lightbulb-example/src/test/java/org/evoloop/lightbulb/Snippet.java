package org.evoloop.lightbulb;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/**
 * Java code in a guide: a file of its own, members of a class, or statements. What it takes for granted, such as the
 * converter that it goes on with, is in {@link Assumed}.
 *
 * @param place the page and the line
 */
record Snippet(String place, String code) {
    private static final String CLASSES = System.getProperty("java.class.path");

    /** The modules that a converter requires, and theirs; others of this program's libraries share packages. */
    private static final String MODULES = Stream.of(CLASSES.split(File.pathSeparator))
            .filter(entry -> entry.matches(".*[/-](?:core|xmi)[/-].*|.*/(?:slf4j-api|jakarta|jaxb|jspecify)[^/]*"))
            .collect(Collectors.joining(File.pathSeparator));

    private static final String PACKAGE = "org.evoloop.lightbulb.";
    private static final String DECLARATION = "package org.evoloop.lightbulb;\n";

    /** The package and the imports of a snippet without. */
    private static final String HEAD = Stream.of(
                    "java.nio.file.Path",
                    "java.time.DayOfWeek",
                    "java.time.Duration",
                    "java.time.Instant",
                    "java.time.LocalTime",
                    "java.time.ZoneId",
                    "java.util.*",
                    "java.util.regex.Pattern",
                    "org.evoloop.check.timing.*",
                    "org.evoloop.config.*",
                    "org.evoloop.console.*",
                    "org.evoloop.converter.*",
                    "org.evoloop.evolution.*",
                    "org.evoloop.function.*",
                    "org.evoloop.gpio.*",
                    "org.evoloop.homeassistant.*",
                    "org.evoloop.http.*",
                    "org.evoloop.journal.*",
                    "org.evoloop.line.*",
                    "org.evoloop.link.*",
                    "org.evoloop.loop.*",
                    "org.evoloop.mqtt.*",
                    "org.evoloop.mqtt.home.*",
                    "org.evoloop.page.*",
                    "org.evoloop.payload.*",
                    "org.evoloop.program.*",
                    "org.evoloop.roomba.oi.*",
                    "org.evoloop.roomba.simulator.robot.RobotActivity",
                    "org.evoloop.roomba.testkit.*",
                    "org.evoloop.service.*",
                    "org.evoloop.testkit.*",
                    "org.evoloop.time.*",
                    "org.evoloop.xmi.*",
                    "org.junit.jupiter.api.Test",
                    "org.junit.jupiter.api.extension.RegisterExtension")
            .map(name -> "import " + name + ";\n")
            .collect(Collectors.joining("", DECLARATION, ""));

    private static final Pattern BLOCK = Pattern.compile("(?ms)^```java\n(.*?)^```$");
    private static final Pattern TYPE = Pattern.compile("(?m)^(?:public |final )*(?:class|interface|record) (\\w+)");
    private static final Pattern MODULE = Pattern.compile("(?m)^module ");
    private static final Pattern MEMBER = Pattern.compile("(?m)^(?:@|private |final \\w+ \\w+ =)");

    /** All of a page. */
    static List<Snippet> in(Path root, String page) throws IOException {
        String text = Files.readString(root.resolve(page));
        List<Snippet> found = new ArrayList<>();
        Matcher block = BLOCK.matcher(text);
        while (block.find()) {
            long line = text.substring(0, block.start()).lines().count() + 1;
            found.add(new Snippet(page + ":" + line, block.group(1)));
        }
        return found;
    }

    /** Compiles it into a folder, as code of this package, and returns its class. Only what has no imports gets some. */
    String compile(Path folder) throws IOException {
        Matcher type = TYPE.matcher(code);
        if (MODULE.matcher(code).find()) {
            // Elsewhere, since it would make all that is compiled beside it part of a module.
            return compile(folder.resolve("module"), "module-info", code, "--module-path", MODULES);
        } else if (type.find()) {
            boolean hasImports = code.startsWith("import ");
            compile(folder, type.group(1), (hasImports ? DECLARATION : HEAD) + code, "--class-path", CLASSES);
            return PACKAGE + type.group(1);
        }
        String name = "Snippet" + place.replaceAll("\\W", "_");
        String members = MEMBER.matcher(code).find() ? code : "void code() {\nshown(() -> {\n" + code + "});\n}\n";
        compile(
                folder,
                name,
                HEAD + "class " + name + " extends Assumed {\n" + members + "}\n",
                "--class-path",
                CLASSES);
        return PACKAGE + name;
    }

    private String compile(Path folder, String name, String source, String option, String libraries)
            throws IOException {
        Path file = Files.writeString(
                Files.createTempDirectory(Files.createDirectories(folder), "source")
                        .resolve(name + ".java"),
                source);
        ByteArrayOutputStream messages = new ByteArrayOutputStream();
        int status = ToolProvider.getSystemJavaCompiler()
                .run(
                        null,
                        messages,
                        messages,
                        "--release",
                        "17",
                        "-proc:none",
                        "-d",
                        folder.toString(),
                        option,
                        libraries,
                        file.toString());
        assertThat(status)
                .as(place + ":\n" + messages.toString(StandardCharsets.UTF_8))
                .isZero();
        return name;
    }
}

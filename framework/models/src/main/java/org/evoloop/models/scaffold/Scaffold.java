package org.evoloop.models.scaffold;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.lang.model.SourceVersion;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.xmi.ModelReference;
import org.jspecify.annotations.Nullable;

/**
 * Generates a starter project for a converter.
 *
 * <p>Threading: one thread.
 */
public final class Scaffold {
    private static final List<String> CLASSES = List.of(
            "Main", "Models", "Conditions", "MonitorEvent", "ExecuteCommand", "SimulatedDevice", "KnowledgeState");

    private static final List<String> CLASSES_OF_FILE =
            List.of("Main", "KnowledgeState", "Connections", "Conditions", "Actions");

    /** Maps new states to their classes. */
    private static final String FUNCTIONS = "functions.txt";

    private final ProjectDirectory.Content content = new ProjectDirectory.Content();
    private final Request request;
    private final ModelPair pair;
    private final Map<String, String> values = new LinkedHashMap<>(Versions.all());

    /**
     * What to generate.
     *
     * @param pair has no errors that prevent a converter from being built
     * @param original the source of its original model
     * @param evolved the source of its new model
     * @param javaPackage see {@link #requirePackage}
     * @param directory see {@link #requireDirectory}
     * @param properties the text of the properties that the evolution must keep; null if there is none
     * @param written a device file, which says what is connected; null if only the models are known
     */
    public record Request(
            ModelPair pair,
            DeviceEvents device,
            ModelReference original,
            ModelReference evolved,
            String javaPackage,
            Path directory,
            @Nullable String properties,
            @Nullable WrittenFile written) {

        /** The same with this text of properties. */
        public Request withProperties(@Nullable String text) {
            return new Request(pair, device, original, evolved, javaPackage, directory, text, written);
        }
    }

    /** Where Java sources are, with a slash at the end. */
    private record Folders(String sources, String tests) {}

    private Scaffold(Request request) {
        this.request = request;
        this.pair = request.pair();
    }

    /**
     * Checks the name of a package.
     *
     * @throws IllegalArgumentException if it is not a valid package name, or not valid on every machine
     */
    public static void requirePackage(String javaPackage) {
        boolean good = SourceVersion.isName(javaPackage, SourceVersion.RELEASE_17)
                && javaPackage.chars().allMatch(next -> next < 128)
                && !javaPackage.startsWith("java.")
                && !javaPackage.equals("java");
        if (!good) {
            throw new IllegalArgumentException("--package: " + javaPackage
                    + " is not a valid Java package name; write ASCII letters and digits, with dots between the parts and no"
                    + " Java keyword, such as com.example.lamp");
        }
    }

    /**
     * Checks the directory.
     *
     * @param update whether it already contains a project
     * @throws IllegalArgumentException if there is no project to update, or if the directory for a new project is not
     *     empty
     * @throws IOException if it cannot be read
     */
    public static void requireDirectory(Path directory, boolean update) throws IOException {
        if (Files.exists(directory) && !Files.isDirectory(directory)) {
            throw new IllegalArgumentException("--out: " + directory + " is a file; name a new directory");
        }
        if (update) {
            if (!ProjectDirectory.isProject(directory)) {
                throw new IllegalArgumentException("--update: " + directory + " holds no project of scaffold (no "
                        + ProjectDirectory.GENERATED + " in it); name the one it was written to");
            }
        } else if (Files.isDirectory(directory)) {
            try (Stream<Path> inside = Files.list(directory)) {
                if (inside.findAny().isPresent()) {
                    throw new IllegalArgumentException("--out: " + directory
                            + " is not empty; name a new directory, or add --update to bring a project up to date");
                }
            }
        }
    }

    /**
     * Writes the project, or updates it. The owner's changes are kept.
     *
     * @return what the owner has to know about the files
     * @throws IllegalArgumentException if the project has another package, or a model was changed in it
     * @throws IOException if it cannot be written
     */
    public static List<String> write(Request request) throws IOException {
        return new Scaffold(request).write();
    }

    private List<String> write() throws IOException {
        ProjectDirectory project = new ProjectDirectory(request.directory());
        FunctionNames names = FunctionNames.parse(project.generated(FUNCTIONS));
        names.requirePackage(request.javaPackage());
        String javaPackage = request.javaPackage();
        values.put("package", javaPackage);
        values.put(
                "artifact",
                javaPackage.substring(javaPackage.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT));
        values.put("original", pair.original().name());
        values.put("evolved", pair.evolved().name());
        values.put("sendable", names(request.device().sendable()));
        values.put("spontaneous", names(request.device().spontaneous()));
        models();
        wrapper();
        String packageFolder = javaPackage.replace('.', '/') + "/";
        Folders folders = new Folders("src/main/java/" + packageFolder, "src/test/java/" + packageFolder);
        WrittenFile written = request.written();
        if (written == null) {
            withSimulation(folders, names);
        } else {
            withConnections(written, folders, names);
        }
        content.text(ProjectDirectory.GENERATED + "/" + FUNCTIONS, names.text(javaPackage));
        file("pom.xml", "pom.xml.txt");
        file("src/test/resources/logback-test.xml", "logback-test.xml.txt");
        return project.write(content.files());
    }

    private void withSimulation(Folders folders, FunctionNames names) {
        values.put("dependencies", dependency("evoloop-testkit", "test"));
        values.put("registrations", functions(folders.sources(), names) + bindings());
        file("README.md", "README.md.txt");
        Set<String> guards = guards();
        values.put("guards", guards.stream().map(JavaText::literal).collect(Collectors.joining(", ")));
        values.put("condition", guards.isEmpty() ? "" : Template.text("Condition.java.txt"));
        for (String name : CLASSES) {
            file(folders.sources() + name + ".java", name + ".java.txt");
        }
        values.put(
                "tests",
                new TestText(new Scenarios(pair, request.device()).all(), !guards.isEmpty()).methods(pair.evolved()));
        file(folders.tests() + "TransitionsTest.java", "TransitionsTest.java.txt");
    }

    private void withConnections(WrittenFile written, Folders folders, FunctionNames names) {
        values.put("converter", JavaText.literal(written.file().name()));
        StringBuilder registrations = new StringBuilder();
        written.functions().forEach((state, parts) -> {
            String name = names.of(new State(state));
            values.putAll(parts);
            values.put("className", name);
            values.put("stateComment", JavaText.comment(state));
            javaFile(folders.sources() + name, "device/Function");
            function(registrations, state, "new " + name + "(connections)");
        });
        written.functionsElsewhere().forEach((state, field) -> function(registrations, state, "connections." + field));
        written.withoutFunction().forEach(state -> function(registrations, state, "NewFunction.none()"));
        values.put("registrations", registrations + written.registrations());
        values.putAll(written.connections());
        values.put("tests", written.tests());
        file(folders.sources() + "Models.java", "Models.java.txt");
        for (String name : CLASSES_OF_FILE) {
            javaFile(folders.sources() + name, "device/" + name);
        }
        javaFile(folders.tests() + "ScenariosTest", "device/ScenariosTest");
        values.put(
                "dependencies",
                written.artifacts().stream()
                                .map(artifact -> dependency(artifact, "compile"))
                                .collect(Collectors.joining())
                        + dependency("evoloop-testkit", "compile"));
        file("README.md", "device/README.md.txt");
    }

    private static void function(StringBuilder registrations, String state, String function) {
        registrations.append("        function(").append(JavaText.literal(state));
        registrations.append(", ").append(function).append(");\n");
    }

    private static String dependency(String artifact, String scope) {
        return Template.fill("dependency.xml.txt", Map.of("artifactId", artifact, "scope", scope));
    }

    /** A class, with the imports that it turns out to need. */
    private void javaFile(String path, String template) {
        values.put("imports", "");
        values.put("imports", Imports.of(Template.fill(template + ".java.txt", values)));
        file(path + ".java", template + ".java.txt");
    }

    private void file(String path, String template) {
        content.text(path, Template.fill(template, values));
    }

    private Set<String> guards() {
        Set<String> guards = new LinkedHashSet<>(pair.original().guards());
        guards.addAll(pair.evolved().guards());
        return guards;
    }

    private static String names(Set<Event> events) {
        return events.stream()
                .sorted()
                .map(event -> JavaText.literal(event.name()))
                .collect(Collectors.joining(", "));
    }

    /** Copies the models under names that are valid on every machine. */
    private void models() throws IOException {
        boolean oneFile =
                Files.isSameFile(request.original().file(), request.evolved().file());
        String original = oneFile ? "models" : "original";
        String evolved = oneFile ? "models" : "new";
        values.put("originalFile", JavaText.literal(copy(request.original().file(), original)));
        values.put("evolvedFile", JavaText.literal(copy(request.evolved().file(), evolved)));
        values.put(
                "timeUnit",
                request.original()
                        .timeUnit()
                        .map(unit -> "Optional.of(ChronoUnit." + unit.name() + ")")
                        .orElse("Optional.empty()"));
        values.put("originalMachine", machine(request.original()));
        values.put("evolvedMachine", machine(request.evolved()));
        if (request.properties() != null) {
            // Named after the new model's file, so that the command check finds it.
            content.bytes(
                    "models/" + evolved + ".properties.txt",
                    request.properties().getBytes(StandardCharsets.UTF_8));
        }
    }

    private String copy(Path file, String name) throws IOException {
        String given = file.toString();
        String ending = given.substring(Math.max(given.lastIndexOf('.'), 0));
        String copied = name + (ending.matches("\\.[A-Za-z0-9]{1,8}") ? ending : ".xml");
        content.bytes("models/" + copied, Files.readAllBytes(file));
        return copied;
    }

    private static String machine(ModelReference reference) {
        return reference
                .machine()
                .map(name -> "Optional.of(" + JavaText.literal(name) + ")")
                .orElse("Optional.empty()");
    }

    private void wrapper() {
        content.bytes("mvnw", Template.bytes("wrapper/mvnw"));
        content.text(
                ".mvn/wrapper/maven-wrapper.properties",
                Template.text("wrapper/.mvn/wrapper/maven-wrapper.properties"));
        content.text(".gitignore", "target/\n");
    }

    /** Writes a class for each new state and returns the lines that register them. */
    private String functions(String sources, FunctionNames names) {
        StringBuilder registrations = new StringBuilder();
        for (State state : pair.evolved().states()) {
            if (pair.isNew(state)) {
                String name = names.of(state);
                values.put("className", name);
                values.put("stateComment", JavaText.comment(state.name()));
                values.put("leftBy", JavaText.comment(leftBy(state)));
                values.put("device", device(state));
                values.put("say", JavaText.literal(state.name()));
                values.put("ending", ending(state));
                file(sources + name + ".java", "Function.java.txt");
                function(registrations, state.name(), "new " + name + "()");
            }
        }
        return registrations.toString();
    }

    /** What the model says about the device while the function runs, as Javadoc; empty if it says nothing. */
    private String device(State state) {
        String where = pair.whereDeviceMustBe(state).stream()
                .map(State::name)
                .map(JavaText::comment)
                .collect(Collectors.joining(" or "));
        String sent = pair.evolved().sends(state).stream()
                .map(event -> JavaText.comment(event.name()))
                .collect(Collectors.joining(", "));
        return (where.isEmpty() ? "" : " The device is in " + where + " when it starts, without anything to send here.")
                + (sent.isEmpty() ? "" : " It may send " + sent + ".");
    }

    private String leftBy(State state) {
        String events = pair.evolved().transitionsFrom(state).stream()
                .map(transition ->
                        transition.event() + (transition.event().timeTrigger().isPresent() ? " (by itself)" : ""))
                .collect(Collectors.joining(", "));
        return events.isEmpty() ? "no event" : events;
    }

    /** A hint at how the new state's function can raise an event unknown to the device; empty if there is none. */
    private String ending(State state) {
        return pair.evolved().transitionsFrom(state).stream()
                .map(transition -> transition.event().trigger())
                .filter(event -> event.timeTrigger().isEmpty()
                        && !pair.original().triggers().contains(event))
                .findFirst()
                .map(event -> "        // When it is done: visit.finish("
                        + JavaText.comment(JavaText.literal(event.name())) + ");\n")
                .orElse("");
    }

    private String bindings() {
        StringBuilder lines = new StringBuilder();
        guards().stream()
                .map(JavaText::literal)
                .forEach(guard ->
                        lines.append("        guard(" + guard + ", () -> conditions.holds(" + guard + "));\n"));
        for (String effect : DecisionTable.compile(pair, request.device()).effects()) {
            lines.append("        effect(").append(JavaText.literal(effect));
            lines.append(", () -> System.out.println(")
                    .append(JavaText.literal("effect " + effect))
                    .append("));\n");
        }
        return lines.toString();
    }
}

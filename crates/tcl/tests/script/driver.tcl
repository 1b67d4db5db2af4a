# Runs the snippets of a file, which are separated by blank lines, and writes what each of them gives:
# return code, result and, for an error, the error code.
set driver(file) [open [lindex $argv 0]]
fconfigure $driver(file) -encoding utf-8
set driver(text) [read $driver(file)]
close $driver(file)
foreach driver(snippet) [split [string map {"\n\n" \x01} [string trim $driver(text)]] \x01] {
    puts "% $driver(snippet)"
    set driver(code) [catch {uplevel #0 $driver(snippet)} driver(result)]
    if {$driver(code) == 1} {
        puts "=> $driver(code) $driver(result) <$::errorCode>"
    } else {
        puts "=> $driver(code) $driver(result)"
    }
}
